//! Recommended conditions for the workpiece and the cutter, from the shipped cutting-data table,
//! and their way into the programmed values.

use egui::{CollapsingHeader, ComboBox, RichText, Role, Ui, WidgetInfo};

use crate::app::command::{Command, SessionCommand};
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::standing::Standing;
use crate::base::language::tr;
use crate::base::settings::Value;
use crate::run::scenario::Scenario;
use crate::study::recommend::table::{NOTE as TABLE_NOTE, Table};
use crate::study::recommend::{Advisor, EngagementCode, NOTE, Recommendation};

/// The section and what it keeps: what it learned when it was first opened, and the engagement
/// chosen.
#[derive(Default)]
pub struct RecommendedCard {
    advisor: Option<Advisor>,
    /// None: by the radial depth.
    engagement: Option<EngagementCode>,
}

impl RecommendedCard {
    /// Folded away until it is opened.
    pub fn show(&mut self, ui: &mut Ui, scenario: &Scenario, commands: &mut Vec<Command>) {
        let header = CollapsingHeader::new(tr("Recommended conditions"));
        header.id_salt(("plan", "recommended")).show(ui, |ui| {
            let tool = &scenario.tool;
            let radial_mm = scenario.workpiece.radial_depth_mm;
            let by_depth = EngagementCode::of(radial_mm, tool.diameter_mm);
            self.choose(ui, by_depth);
            let engagement = self.engagement.unwrap_or(by_depth);
            let advisor = self.advisor.get_or_insert_with(|| Advisor::new(&Table::shipped()));
            let hardness_hb = scenario.plant.hardness_hb;
            match advisor.recommend(hardness_hb, tool, engagement) {
                Ok(found) => answer(ui, engagement, &found, commands),
                Err(error) => {
                    Standing::Bad.label(ui, &error.to_string(), |text| text);
                }
            }
        });
    }

    fn choose(&mut self, ui: &mut Ui, by_depth: EngagementCode) {
        let auto = tr!("by R_D: {engagement}", engagement = tr(by_depth.label()));
        let shown = self.engagement.map_or(auto.clone(), |one| tr(one.label()).to_owned());
        let response = ComboBox::from_id_salt("engagement")
            .selected_text(shown)
            .show_ui(ui, |ui| {
                let by_itself = ui.selectable_value(&mut self.engagement, None, auto);
                let mut chosen = by_itself.clicked();
                for one in EngagementCode::ALL {
                    let label = tr(one.label());
                    let choice = ui.selectable_value(&mut self.engagement, Some(*one), label);
                    chosen |= choice.clicked();
                }
                if chosen {
                    ui.close();
                }
            })
            .response;
        response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr("Engagement")));
        response.on_hover_text(tr("Engagement: how the cutter stands in the material"));
    }
}

fn answer(
    ui: &mut Ui,
    engagement: EngagementCode,
    found: &Recommendation,
    commands: &mut Vec<Command>,
) {
    let palette = Palette::at(ui);
    let (speed, feed) = (&found.cutting_speed_m_min, &found.feed_per_tooth_mm);
    let asked = tr!(
        "For {hardness:.0} HB, a cutter of {diameter}, {engagement}:",
        hardness = found.hardness_hb,
        diameter = format::quantity(found.diameter_mm, "mm"),
        engagement = tr(engagement.label()),
    );
    ui.label(RichText::new(asked).small().color(palette.weak));
    let values = tr!(
        "{speed}, {feed} a tooth",
        speed = format::quantity(speed.value, "m/min"),
        feed = format::fine(feed.value, "mm"),
    );
    ui.strong(values);
    let (feed, rpm) = (found.feed_mm_min, found.speed_rpm);
    ui.label(format!("{}, {}", format::quantity(rpm, "1/min"), format::quantity(feed, "mm/min")));
    let (text, standing) = match found.inside_table() {
        true => (tr("inside the table"), Standing::Good),
        false => (tr("outside the table: its edge answers"), Standing::Watch),
    };
    standing.label(ui, text, RichText::small);
    let help = tr("Programs these values, as a start for the plan and the cut. One step of undo.");
    if ui.button(tr("Start from it")).on_hover_text(help).clicked() {
        let changes = [("program.feed_mm_min", feed), ("program.spindle_rpm", rpm)];
        let changes = changes.map(|(path, value)| (path.to_owned(), Value::Float(value)));
        commands.push(Command::Session(SessionCommand::SetUp(changes.to_vec())));
    }
    let table = tr!("The table: {note}.", note = tr(TABLE_NOTE));
    let note = format!("{} {table}", tr(NOTE));
    ui.label(RichText::new(note).small().color(palette.weak));
}
