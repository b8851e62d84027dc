//! The settings of the plan, and those of target and workpiece that it is made for. A change is
//! one of the scenario itself, from the start of the cut on: a plan is made before the cut.

use egui::{CollapsingHeader, RichText, Ui};

use crate::app::command::{Command, SessionCommand};
use crate::app::session::Session;
use crate::app::theme::{self, Palette};
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::target::target;
use crate::base::language::{text, tr};
use crate::models::plan::{ForceLimit, PlanSettings};
use crate::study::uses::Screen;

const WEIGHTS: [&str; 4] =
    ["plan.weight_force", "plan.weight_removal_rate", "plan.weight_time", "plan.weight_cost"];
const SEARCH: [&str; 4] = ["plan.particles", "plan.iterations", "plan.stop_after", "plan.seed"];
const COSTS: [&str; 3] = ["plan.machine_cost_per_min", "plan.tool_cost", "plan.tool_change_min"];
/// What is cut, as far as the force depends on it.
const CUT: [&str; 10] = [
    "workpiece.axial_depth_mm",
    "workpiece.radial_depth_mm",
    "workpiece.length_mm",
    "workpiece.depth_steps",
    "workpiece.radial_steps",
    "plan.section",
    "plan.network",
    "plant.material",
    "plant.hardness_hb",
    "plant.wear_factor",
];
/// Groups of settings that a plan depends on.
const GROUPS: [&str; 5] = ["plan", "plant", "workpiece", "target", "belief"];
/// Settings of the limit and of the speed that is searched, shown with or without their values.
const LIMITS: [&str; 4] =
    ["plan.force_limit", "plan.force_max_n", "plan.free_speed", "plan.cutting_speed_m_min"];

/// Whether a setting has a say in this plan.
fn matters(path: &str, plan: &PlanSettings) -> bool {
    match path {
        "plan.force_max_n" => plan.force_limit == ForceLimit::Fixed,
        "plan.cutting_speed_m_min" => !plan.free_speed,
        _ => true,
    }
}

/// What was changed during the cut and has a say in the plan: a plan is made for its start, and
/// one click makes it for the cut as it is now.
fn changed_in_the_cut(ui: &mut Ui, session: &Session, commands: &mut Vec<Command>) {
    let changed = session.current().difference(session.scenario());
    let changed: Vec<_> =
        changed.into_iter().filter(|(param, _)| GROUPS.contains(&param.group)).collect();
    if changed.is_empty() {
        return;
    }
    let palette = Palette::at(ui);
    let names: Vec<&str> = changed.iter().map(|(param, _)| tr(param.spec.label)).collect();
    theme::card(palette).stroke(egui::Stroke::new(1.0, palette.warn)).show(ui, |ui| {
        let text =
            tr!("Changed during the cut, after its start: {names}.", names = names.join(", "),);
        ui.label(RichText::new(text).small());
        let help = tr("Makes the values at the playhead those of the start, and plans for them");
        if ui.button(tr("Plan for the values now")).on_hover_text(help).clicked() {
            let values = changed.into_iter().map(|(param, value)| (param.path.clone(), value));
            commands.push(Command::Session(SessionCommand::SetUp(values.collect())));
        }
    });
    ui.add_space(4.0);
}

/// All of them.
pub fn show(ui: &mut Ui, session: &Session, commands: &mut Vec<Command>) {
    let scenario = session.scenario();
    changed_in_the_cut(ui, session, commands);
    let mut changes = Vec::new();
    let plan = &scenario.plan;
    let out = &mut changes;
    let by_target = plan.force_limit == ForceLimit::TargetRa;
    if by_target {
        target(ui, Screen::Plan, scenario, out);
    }
    for path in LIMITS.into_iter().filter(|path| matters(path, plan)) {
        setting(ui, Screen::Plan, path, scenario, Size::Large, out);
    }
    ui.add_space(4.0);
    ui.strong(tr("What is sought"));
    for path in WEIGHTS {
        setting(ui, Screen::Plan, path, scenario, Size::Large, out);
    }
    let note = tr(
        "The heavier a weight beside the others, the more the plan goes that way: a large force is one \
                   near its limit, and takes a larger feed. A weight that stands alone changes nothing by its size.",
    );
    ui.label(RichText::new(note).small().color(Palette::at(ui).weak));
    let mut fold = |ui: &mut Ui, title: &str, paths: &[&str]| {
        CollapsingHeader::new(tr(title)).id_salt(("plan", title)).show(ui, |ui| {
            for path in paths {
                setting(ui, Screen::Plan, path, scenario, Size::Small, out);
            }
        });
    };
    ui.add_space(4.0);
    fold(ui, text!("The cut"), &CUT);
    fold(ui, text!("Swarm"), &SEARCH);
    fold(ui, text!("Costs and times"), &COSTS);
    ui.add_space(4.0);
    let note = tr("A plan is made before the cut: changes here hold from its start on.");
    ui.label(RichText::new(note).small().color(Palette::at(ui).weak));
    commands.extend(changes.into_iter().map(|command| {
        if let Command::Session(SessionCommand::Set { path, value }) = command {
            Command::Session(SessionCommand::SetUp(vec![(path, value)]))
        } else {
            command
        }
    }));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::scenario::table;

    #[test]
    fn every_setting_of_the_plan_has_its_place() {
        let shown: Vec<&str> =
            [&WEIGHTS[..], &SEARCH, &COSTS, &CUT, &LIMITS].into_iter().flatten().copied().collect();
        for param in table().iter().filter(|param| param.group == "plan") {
            assert!(shown.contains(&param.path.as_str()), "`{}` is not shown", param.path);
        }
        for param in table() {
            let path = param.path.as_str();
            let here = shown.contains(&path) || ["target.ra_um", "target.force_n"].contains(&path);
            assert_eq!(here, Screen::Plan.offers(param), "`{path}`");
        }
        for path in shown {
            assert!(table().iter().any(|param| param.path == path), "`{path}` is no setting");
        }
    }
}
