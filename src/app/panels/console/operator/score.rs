//! The score of a cut driven by hand against every way of control, as a table with a sentence of what it comes to.

use std::sync::Arc;

use egui::{Button, ProgressBar, RichText, Role, TextWrapMode, Ui, WidgetInfo};

use super::super::super::View;
use super::CUT_BY_HAND;
use crate::app::command::{Command, HandCommand};
use crate::app::format;
use crate::app::jobs::Work;
use crate::app::theme::{self, Palette};
use crate::app::widgets::spoken::read_aloud;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::{scaffold, touch};
use crate::base::language::{fixed, text, tr};
use crate::blocks::reference::Reference;
use crate::run::metrics::HELD_PERCENT;
use crate::study::compare::by_hand::{ByHandJob, HandScore, Scored};

/// Plant steps of the first slice.
const FIRST: u64 = 20_000;

/// The score with the cut that it belongs to.
#[derive(Default)]
pub struct ScoreView {
    /// The change of the session that was scored, and the work.
    scored: Option<(u64, Work<ByHandJob>)>,
    latest: Option<Arc<HandScore>>,
}

impl ScoreView {
    /// Scores a cut that was driven by hand once it is over; a score of before goes when another cut is driven.
    pub fn follow(&mut self, view: &View<'_>) {
        let session = view.session;
        if let Some((_, work)) = &self.scored {
            self.latest = Some(work.partial());
        }
        let now = session.changes();
        let is_scored = self.scored.as_ref().is_some_and(|(of, _)| *of == now);
        if session.finished().is_none() || !session.is_by_hand() || is_scored {
            return;
        }
        let script = session.script_beside_hand();
        let job = ByHandJob::against(session.scenario(), session.edits(), script);
        let work = view.jobs.begin_brief(text!("Score of the cut by hand"), job, FIRST);
        (self.scored, self.latest) = (Some((now, work)), None);
    }

    /// The score that there is for what is cut: that of this cut at its end, or of the last one by hand while another
    /// one cuts the same part.
    fn of_now(&self, view: &View<'_>) -> Option<&HandScore> {
        let session = view.session;
        let stays =
            self.is_of_this(view) && session.finished().is_some() || session.hand_trace().is_some();
        let rows = self.latest.as_deref().filter(|score| !score.rows.is_empty());
        rows.filter(|_| stays)
    }

    fn is_of_this(&self, view: &View<'_>) -> bool {
        self.scored.as_ref().is_some_and(|(of, _)| *of == view.session.changes())
    }

    /// What it comes to, alone.
    pub fn sentence(&self, ui: &mut Ui, view: &View<'_>) {
        match self.of_now(view) {
            Some(score) => self.verdict(ui, score),
            None => self.nothing(ui, view),
        }
    }

    fn verdict(&self, ui: &mut Ui, score: &HandScore) {
        match &score.verdict {
            Some(verdict) => {
                let held = score.rows.first().is_some_and(|row| row.holds);
                read_aloud(&Standing::either(held).label(ui, verdict, |text| text));
            }
            None => self.progress(ui),
        }
    }

    /// Shows it; `whole` is set where a controller is to be watched.
    pub fn show(
        &self,
        ui: &mut Ui,
        view: &View<'_>,
        whole: &mut bool,
        commands: &mut Vec<Command>,
    ) {
        let Some(score) = self.of_now(view) else { return self.nothing(ui, view) };
        let title = match self.is_of_this(view) {
            true => tr("Your hand against every controller"),
            false => tr("Your last cut by hand against every controller"),
        };
        ui.label(RichText::new(title).strong());
        self.verdict(ui, score);
        scaffold::across(ui, "score", |ui| table(ui, view, score, whole, commands));
        let text = tr!(
            "The same part and noise for everybody. Ranked by time is who holds the tolerance on {percent:.0} % of \
             the length.",
            percent = HELD_PERCENT
        );
        ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
    }

    fn progress(&self, ui: &mut Ui) {
        if let Some((_, work)) = &self.scored {
            let bar = ProgressBar::new(work.progress().share() as f32).show_percentage();
            ui.add(bar.desired_height(16.0));
        }
    }

    /// What stands there before there is a score.
    fn nothing(&self, ui: &mut Ui, view: &View<'_>) {
        let (session, is_scored) = (view.session, self.is_of_this(view));
        let target = &session.current().target;
        let tolerance = format::number(target.tolerance_percent, "-");
        let tolerance = tolerance.trim_end_matches('0').trim_end_matches(['.', ',']);
        let asked = match target.reference {
            Reference::Ra => {
                let of = format::beside(tolerance.to_owned(), "%");
                format!("Ra {} ± {of}", format::quantity(target.ra_um, "um"))
            }
            Reference::Force => {
                let force = format::quantity(target.force_n, "N");
                let text =
                    tr!("a force of {force} ± {tolerance} %", force = force, tolerance = tolerance);
                format::typeset(&text)
            }
        };
        let text = match (session.finished().is_some(), session.is_by_hand()) {
            (true, true) if is_scored => tr("Everybody else cuts the same part now.").to_owned(),
            (true, _) => tr!(
                "This cut was not driven by hand. {button} begins it from its start: turn the knob while it cuts.",
                button = tr(CUT_BY_HAND)
            ),
            (false, _) => tr!(
                "Asked for is {asked}. Hold the force at its mark: slower where the part gets deeper or harder, \
                 faster where it gets easier. The knob answers after the dead time. When the cut is over it is scored \
                 against every controller on the same part.",
                asked = asked
            ),
        };
        theme::card(Palette::at(ui)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.label(text);
            if is_scored {
                self.progress(ui);
            }
        });
    }
}

fn table(
    ui: &mut Ui,
    view: &View<'_>,
    score: &HandScore,
    whole: &mut bool,
    commands: &mut Vec<Command>,
) {
    let weak = Palette::at(ui).weak;
    let inside = match view.session.current().target.reference {
        Reference::Ra => tr("Ra in tol. %"),
        Reference::Force => tr("force in tol. %"),
    };
    ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
    let grid = touch::grid(ui, "score").num_columns(7).min_col_width(0.0).striped(true);
    grid.spacing([10.0, 4.0]).show(ui, |ui| {
        for (title, help) in [
            (tr("rank"), tr("By time, among those who hold the tolerance")),
            (tr("who"), tr("Your hand, and every way of control")),
            (inside, tr("Share of the length on which what is asked for is held")),
            (tr("time s"), tr("Time of the cut; none if it did not come to its end")),
            (tr("peak N"), tr("Greatest force")),
            (tr("travel %/s"), tr("Way of the feed override in a second")),
            ("", ""),
        ] {
            let title = ui.label(RichText::new(title).small().color(weak));
            if !help.is_empty() {
                title.on_hover_text(help);
            }
        }
        ui.end_row();
        for row in score.in_order() {
            line(ui, row, whole, commands);
            ui.end_row();
        }
    });
}

fn line(ui: &mut Ui, row: &Scored, whole: &mut bool, commands: &mut Vec<Command>) {
    let own = row.id.is_none();
    let text = |text: String| {
        let text = RichText::new(text);
        if own { text.strong() } else { text }
    };
    let outcome = &row.outcome;
    let or_none = |value: Option<String>| value.unwrap_or_else(|| "-".to_owned());
    ui.label(text(or_none(row.rank.map(|rank| rank.to_string()))));
    ui.label(text(tr(&row.name).to_owned()));
    let share = or_none(outcome.in_tolerance_percent.map(|share| fixed(share, 1)));
    Standing::either(row.holds).label(ui, &share, |text| if own { text.strong() } else { text });
    ui.label(text(or_none(outcome.time_s.map(|time_s| fixed(time_s, 1)))));
    ui.label(text(format!("{:.0}", 1000.0 * outcome.force_kn)));
    ui.label(text(fixed(outcome.override_travel_percent_s, 1)));
    if let Some(id) = row.id {
        let button = ui.add(touch::small(ui, Button::new(tr("Cut"))));
        let name = tr!("Cut by {controller}", controller = tr(&row.name));
        button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
        let help = tr("Cuts the part this way, with your hand drawn in the plots");
        if button.on_hover_text(help).clicked() {
            *whole = true;
            commands.push(Command::hand(HandCommand::CutBy(id)));
        }
    }
}
