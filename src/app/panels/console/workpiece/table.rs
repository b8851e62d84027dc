//! The tables of the workpiece: sections of a cut, and the depth profile of the one path.

use egui::{RichText, Ui, WidgetInfo};

use super::hand::{EdgeKind, Moved};
use crate::app::command::Command;
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::number::NumberField;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::settings::{Kind, Value};
use crate::blocks::cutting::tool_path::{radial_depth_mm, wall_mm};
use crate::blocks::cutting::workpiece::Workpiece;
use crate::models::part::{DepthStep, MAX_SECTIONS, MAX_STEPS, MIN_SECTION_MM, Section};
use crate::models::tool::Outline;
use crate::run::scenario::{Scenario, param};

const STEPS: &str = "workpiece.depth_steps";
const AXIAL: &str = "workpiece.axial_depth_mm";
const LENGTH: &str = "workpiece.length_mm";
/// Least distance between two steps of the profile, mm.
const STEP_GAP_MM: f64 = 0.01;
/// Title of the column of numbers.
const NUMBER: &str = "No.";
/// Width below which a table is drawn closer, points.
const NARROW: f32 = 380.0;
/// Distance behind the last step of the profile at which one is added, mm.
const NEXT_STEP_MM: f64 = 20.0;

/// Largest length of a section, and largest depth, mm.
pub fn limits() -> (f64, f64) {
    (bound("workpiece.cuts", "max_length_mm"), bound("workpiece.cuts", "max_depth_mm"))
}

/// A bound of a setting of the part.
fn bound(path: &str, name: &str) -> f64 {
    let bound = param(path).ok().and_then(|param| param.spec.allowed.bound(name));
    bound.expect("the settings of the part have these bounds")
}

/// A cell with a number; whether it was changed.
fn cell(
    ui: &mut Ui,
    name: &str,
    value: &mut f64,
    range: [f64; 2],
    said: &mut Option<String>,
) -> bool {
    // Some 400 points of dragging go over a usual depth or length.
    let speed = if range[1] > 100.0 { 0.25 } else { 0.01 };
    let field = NumberField { name, unit: "mm", range, speed, decimals: 3, suffix: "" };
    let mut now = None;
    let response = field.show(ui, value, &mut now);
    response.widget_info(|| WidgetInfo {
        label: Some(name.to_owned()),
        ..WidgetInfo::drag_value(true, *value)
    });
    if now.is_some() || response.changed() {
        *said = now;
    }
    response.changed()
}

/// A table with these titles.
fn table(ui: &mut Ui, id: &str, titles: &[&str], rows: impl FnOnce(&mut Ui)) {
    let palette = Palette::at(ui);
    // On a phone the buttons at the end of a row fit beside its numbers, all of one unit.
    let narrow = ui.available_width() < NARROW;
    let (cell, gap) = if narrow { (46.0, 4.0) } else { (56.0, 6.0) };
    ui.scope(|ui| {
        ui.spacing_mut().interact_size.x = cell;
        ui.spacing_mut().button_padding.x = 4.0;
        touch::grid(ui, id)
            .num_columns(titles.len() + 2)
            .min_col_width(0.0)
            .spacing([gap, 4.0])
            .striped(true)
            .show(ui, |ui| {
                for title in titles {
                    let title = match (*title, narrow) {
                        (NUMBER, true) => "mm",
                        (title, true) => title.trim_end_matches(" mm"),
                        (title, false) => title,
                    };
                    ui.label(RichText::new(title).small().color(palette.weak));
                }
                ui.end_row();
                rows(ui);
            });
    });
}

/// Two buttons at the end of a row: duplicate and remove.
fn row_buttons(ui: &mut Ui, what: &str, can_copy: bool, can_remove: bool) -> [bool; 2] {
    let [copy, remove] = [format!("Duplicate {what}"), format!("Remove {what}")];
    [
        icon::button(ui, Icon::Copy, &copy, &copy, can_copy).clicked(),
        icon::button(ui, Icon::Close, &remove, &remove, can_remove).clicked(),
    ]
}

/// The sections of cut number `cut`.
pub fn sections(
    ui: &mut Ui,
    outline: &Outline,
    (cut, cuts): (usize, &mut [Vec<Section>]),
    said: &mut Option<String>,
) {
    let Some(sections) = cuts.get_mut(cut) else { return };
    let (length_mm, depth_mm) = limits();
    let room = sections.len() < MAX_SECTIONS;
    let mut act = None;
    let titles = [NUMBER, "Length mm", "Axial mm", "Wall mm", "R_D mm"];
    table(ui, "sections", &titles, |ui| {
        let several = sections.len() > 1;
        for (i, [length, axial, wall]) in sections.iter_mut().enumerate() {
            let n = i + 1;
            ui.label(n.to_string());
            cell(ui, &format!("Length of section {n}"), length, [MIN_SECTION_MM, length_mm], said);
            cell(ui, &format!("Axial depth of section {n}"), axial, [0.0, depth_mm], said);
            cell(ui, &format!("Wall of section {n}"), wall, [-depth_mm, depth_mm], said);
            radial(ui, *axial, radial_depth_mm(outline, *axial, *wall));
            let [copy, remove] = row_buttons(ui, &format!("section {n}"), room, several);
            if copy || remove {
                act = Some((i, copy));
            }
            ui.end_row();
        }
    });
    match act {
        Some((i, true)) => sections.insert(i, sections[i]),
        Some((i, false)) => drop(sections.remove(i)),
        None => {}
    }
    let add = ui.add_enabled(room, egui::Button::new("Add a section"));
    let full = format!("At most {MAX_SECTIONS} sections in a cut");
    if add.on_disabled_hover_text(full).clicked()
        && let Some(last) = sections.last().copied()
    {
        sections.push(last);
    }
    let text = "Wall: place of the side wall across the cut, from the tool's axis. R_D: from the wall \
                to where the cutter meets the surface at that depth.";
    ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
}

/// The radial depth as it follows.
fn radial(ui: &mut Ui, axial_mm: f64, radial_mm: f64) {
    if axial_mm > 0.0 && radial_mm > 0.0 {
        ui.label(format::number(radial_mm, "mm"));
    } else {
        let label = Standing::Watch.label(ui, "air", |text| text);
        label.on_hover_text("The tool meets no material here");
    }
}

/// Takes over what was dragged in the picture of a cut, within what its table allows.
pub fn move_section(sections: &mut [Section], moved: Moved) {
    let (longest_mm, deepest_mm) = limits();
    let begin_mm = |i: usize, sections: &[Section]| sections[..i].iter().map(|s| s[0]).sum::<f64>();
    match moved.kind {
        EdgeKind::Depth(i) => sections[i][1] = moved.to_mm.clamp(0.0, deepest_mm),
        EdgeKind::Wall(i) => sections[i][2] = moved.to_mm.clamp(-deepest_mm, deepest_mm),
        EdgeKind::End(i) => {
            let length_mm = moved.to_mm - begin_mm(i, sections);
            sections[i][0] = length_mm.clamp(MIN_SECTION_MM, longest_mm);
        }
    }
}

/// Takes over what was dragged in the picture of the one path, within what its table allows.
pub fn move_stretch(
    workpiece: &Workpiece,
    cut_to_mm: f64,
    moved: Moved,
    commands: &mut Vec<Command>,
) {
    if let EdgeKind::Depth(i) = moved.kind
        && is_cut(&workpiece.depth_steps, i, cut_to_mm)
    {
        return commands.push(Command::notify(format!("Stretch {}: {IS_CUT}.", i + 1)));
    }
    let mut set = |path: &str, value| commands.push(Command::set(path, value));
    let deepest_mm = bound(STEPS, "max_depth_mm");
    let mut steps = workpiece.depth_steps.clone();
    match moved.kind {
        EdgeKind::Depth(0) => {
            set(AXIAL, Value::Float(moved.to_mm.clamp(0.0, deepest_mm)));
        }
        EdgeKind::Depth(i) => {
            steps[i - 1][1] = moved.to_mm.clamp(0.0, deepest_mm);
            set(STEPS, Value::from(steps));
        }
        // The last of those in sight ends with the path.
        EdgeKind::End(i) if steps.get(i).is_none_or(|step| step[0] >= workpiece.length_mm) => {
            let least_mm = if i == 0 { 0.0 } else { steps[i - 1][0] + STEP_GAP_MM };
            if let Ok(Kind::Float { min, max }) = param(LENGTH).map(|param| &param.spec.allowed) {
                set(LENGTH, Value::Float(moved.to_mm.clamp(min.max(least_mm), *max)));
            }
        }
        EdgeKind::End(i) => {
            let low_mm = if i == 0 { 0.0 } else { steps[i - 1][0] + STEP_GAP_MM };
            let next_mm = steps.get(i + 1).map_or(workpiece.length_mm, |next| next[0]);
            steps[i][0] = moved.to_mm.clamp(low_mm, (next_mm - STEP_GAP_MM).max(low_mm));
            set(STEPS, Value::from(steps));
        }
        EdgeKind::Wall(_) => {}
    }
}

/// What is said of a stretch that the tool has left behind.
const IS_CUT: &str =
    "it is cut, and its depth stays; a change of it would act where the tool is now";

/// Whether stretch number `i`, from 0, is cut by a tool that has come to a place of the path.
fn is_cut(steps: &[DepthStep], i: usize, cut_to_mm: f64) -> bool {
    steps.get(i).is_some_and(|next| next[0] <= cut_to_mm)
}

/// The depth profile of the one path: its first row is the axial depth at the start. What the tool has left behind by
/// `cut_to_mm` cannot be changed.
pub fn profile(
    ui: &mut Ui,
    scenario: &Scenario,
    cut_to_mm: f64,
    commands: &mut Vec<Command>,
    said: &mut Option<String>,
) {
    let workpiece = &scenario.workpiece;
    let (most_mm, deepest_mm) = (bound(STEPS, "max_position_mm"), bound(STEPS, "max_depth_mm"));
    let outline = scenario.tool.outline();
    let wall_mm = wall_mm(&outline, workpiece.axial_depth_mm, workpiece.radial_depth_mm);
    let by_teeth = scenario.plant.force_model.tooth_by_tooth();
    // Formula and networks take the radial depth as it is set; the teeth meet a wall that stays.
    let radial_at = |axial_mm: f64| {
        if by_teeth {
            radial_depth_mm(&outline, axial_mm, wall_mm)
        } else {
            workpiece.radial_depth_mm
        }
    };
    let mut first_mm = workpiece.axial_depth_mm;
    let mut steps = workpiece.depth_steps.clone();
    let room = |steps: &[DepthStep]| {
        let last_mm = steps.last().map_or(0.0, |step| step[0]);
        steps.len() < MAX_STEPS && last_mm + NEXT_STEP_MM <= most_mm
    };
    let mut act = None;
    table(ui, "profile", &[NUMBER, "From mm", "Axial mm", "R_D mm"], |ui| {
        ui.label("1");
        ui.label("0");
        let set = steps.clone();
        let still = |ui: &mut Ui, i: usize, add: &mut dyn FnMut(&mut Ui)| {
            let part = ui.add_enabled_ui(!is_cut(&set, i, cut_to_mm), add);
            part.response.on_disabled_hover_text(IS_CUT);
        };
        still(ui, 0, &mut |ui| {
            cell(ui, "Axial depth of stretch 1", &mut first_mm, [0.0, deepest_mm], said);
        });
        radial(ui, first_mm, radial_at(first_mm));
        ui.end_row();
        for i in 0..steps.len() {
            let n = i + 2;
            // Between the neighbours: positions stay in order while they are dragged.
            let low = if i == 0 { 0.0 } else { steps[i - 1][0] + STEP_GAP_MM };
            let high = steps.get(i + 1).map_or(most_mm, |next| next[0] - STEP_GAP_MM);
            let [from, axial] = &mut steps[i];
            ui.label(n.to_string());
            still(ui, i + 1, &mut |ui| {
                cell(ui, &format!("Start of stretch {n}"), from, [low, high], said);
            });
            still(ui, i + 1, &mut |ui| {
                cell(ui, &format!("Axial depth of stretch {n}"), axial, [0.0, deepest_mm], said);
            });
            radial(ui, *axial, radial_at(*axial));
            let name = format!("Remove stretch {n}");
            let left = !is_cut(&set, i + 1, cut_to_mm);
            if icon::button(ui, Icon::Close, &name, &name, left).clicked() {
                act = Some(i);
            }
            ui.end_row();
        }
    });
    if let Some(i) = act {
        steps.remove(i);
    }
    if ui.add_enabled(room(&steps), egui::Button::new("Add a stretch")).clicked() {
        let [last_mm, depth_mm] = steps.last().copied().unwrap_or([0.0, first_mm]);
        steps.push([last_mm + NEXT_STEP_MM, depth_mm]);
    }
    let mut set = |path: &str, value| commands.push(Command::set(path, value));
    if first_mm != workpiece.axial_depth_mm {
        set(AXIAL, Value::Float(first_mm));
    }
    if steps != workpiece.depth_steps {
        set(STEPS, Value::from(steps));
    }
}
