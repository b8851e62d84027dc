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
use crate::base::language::{fixed, text, tr};
use crate::base::settings::{Kind, Value};
use crate::blocks::cutting::tool_path::{radial_depth_mm, wall_mm};
use crate::blocks::cutting::workpiece::Workpiece;
use crate::models::part::{DepthStep, MAX_SECTIONS, MAX_STEPS, MIN_SECTION_MM, Section};
use crate::models::tool::Outline;
use crate::run::scenario::{Scenario, param};

const STEPS: &str = "workpiece.depth_steps";
const RADIAL_STEPS: &str = "workpiece.radial_steps";
const AXIAL: &str = "workpiece.axial_depth_mm";
const LENGTH: &str = "workpiece.length_mm";
/// Least distance between two steps of the profile, mm.
const STEP_GAP_MM: f64 = 0.01;
/// Most stretches that a table shows.
const MOST_ROWS: usize = 64;
/// Most digits behind the point of a length.
const MOST_DIGITS: usize = 3;
/// Title of the column of numbers.
const NUMBER: &str = text!("No.");
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

/// Digits behind the point of a column: two, or three where one of its values has a third.
fn digits(column: impl IntoIterator<Item = f64>) -> usize {
    let third = |value: f64| ((1e3 * value).round() / 10.0).fract().abs() > 1e-6;
    if column.into_iter().any(third) { MOST_DIGITS } else { 2 }
}

/// A cell with a number of so many digits behind the point at least; whether it was changed.
fn cell(
    ui: &mut Ui,
    name: &str,
    value: &mut f64,
    (range, least): ([f64; 2], usize),
    said: &mut Option<String>,
) -> bool {
    // Some 400 points of dragging go over a usual depth or length.
    let speed = if range[1] > 100.0 { 0.25 } else { 0.01 };
    let decimals = MOST_DIGITS;
    let field = NumberField { name, unit: "mm", range, speed, decimals, least, suffix: "" };
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

/// A table with these titles, in English.
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
                        (title, true) => tr(title).trim_end_matches(" mm"),
                        (title, false) => tr(title),
                    };
                    ui.label(RichText::new(title).small().color(palette.weak));
                }
                ui.end_row();
                rows(ui);
            });
    });
}

/// Two buttons at the end of a row of a section: duplicate and remove.
fn row_buttons(ui: &mut Ui, number: usize, can_copy: bool, can_remove: bool) -> [bool; 2] {
    let copy = tr!("Duplicate section {number}", number = number);
    let remove = tr!("Remove section {number}", number = number);
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
    let titles = [NUMBER, text!("Length mm"), text!("Axial mm"), text!("Wall mm"), text!("R_D mm")];
    table(ui, "sections", &titles, |ui| {
        let several = sections.len() > 1;
        let [lengths, depths, walls] =
            [0, 1, 2].map(|k: usize| digits(sections.iter().map(|section| section[k])));
        for (i, [length, axial, wall]) in sections.iter_mut().enumerate() {
            let n = i + 1;
            ui.label(n.to_string());
            let name = tr!("Length of section {number}", number = n);
            cell(ui, &name, length, ([MIN_SECTION_MM, length_mm], lengths), said);
            let name = tr!("Axial depth of section {number}", number = n);
            cell(ui, &name, axial, ([0.0, depth_mm], depths), said);
            let name = tr!("Wall of section {number}", number = n);
            cell(ui, &name, wall, ([-depth_mm, depth_mm], walls), said);
            radial(ui, *axial, radial_depth_mm(outline, *axial, *wall));
            let [copy, remove] = row_buttons(ui, n, room, several);
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
    let add = ui.add_enabled(room, egui::Button::new(tr("Add a section")));
    let full = tr!("At most {n} sections in a cut", n = MAX_SECTIONS);
    if add.on_disabled_hover_text(full).clicked()
        && let Some(last) = sections.last().copied()
    {
        sections.push(last);
    }
    let text = tr(
        "Wall: place of the side wall across the cut, from the tool's axis. R_D: from the wall to where the cutter \
         meets the surface at that depth.",
    );
    ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
}

/// The radial depth as it follows.
fn radial(ui: &mut Ui, axial_mm: f64, radial_mm: f64) {
    if axial_mm > 0.0 && radial_mm > 0.0 {
        ui.label(format::number(radial_mm, "mm"));
    } else {
        let label = Standing::Watch.label(ui, tr("air"), |text| text);
        label.on_hover_text(tr("The tool meets no material here"));
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
        let said = tr!("Stretch {number}: {why}.", number = i + 1, why = tr(IS_CUT));
        return commands.push(Command::notify(said));
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
    text!("it is cut, and its depth stays; a change of it would act where the tool is now");

/// Whether stretch number `i`, from 0, is cut by a tool that has come to a place of the path.
fn is_cut(steps: &[DepthStep], i: usize, cut_to_mm: f64) -> bool {
    steps.get(i).is_some_and(|next| next[0] <= cut_to_mm)
}

/// Whether a stretch cannot be changed any more by a tool that has come to a place of the path.
#[must_use]
pub fn any_is_cut(workpiece: &Workpiece, cut_to_mm: f64) -> bool {
    is_cut(&workpiece.depth_steps, 0, cut_to_mm)
}

/// Whether a path has more stretches than a table is for, or a profile of its radial depth: it comes from a file.
#[must_use]
pub fn is_long(workpiece: &Workpiece) -> bool {
    workpiece.depth_steps.len() > MOST_ROWS || !workpiece.radial_steps.is_empty()
}

/// What stands in place of the table of such a path.
pub fn long(ui: &mut Ui, workpiece: &Workpiece, commands: &mut Vec<Command>) {
    let stretches = workpiece.places_mm().len();
    ui.label(tr!("{n} stretches, each with its axial and its radial depth", n = stretches));
    let help = tr("One axial and one radial depth along the whole path, those of its start");
    if ui.button(tr("Take the profiles away")).on_hover_text(help).clicked() {
        for path in [STEPS, RADIAL_STEPS] {
            commands.push(Command::set(path, Value::List(Vec::new())));
        }
    }
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
    let titles = [NUMBER, text!("From mm"), text!("Axial mm"), text!("R_D mm")];
    table(ui, "profile", &titles, |ui| {
        let places = digits(steps.iter().map(|step| step[0]));
        let depths = digits(steps.iter().map(|step| step[1]).chain([first_mm]));
        ui.label("1");
        ui.label(fixed(0.0, places));
        let set = steps.clone();
        let still = |ui: &mut Ui, i: usize, add: &mut dyn FnMut(&mut Ui)| {
            let part = ui.add_enabled_ui(!is_cut(&set, i, cut_to_mm), add);
            part.response.on_disabled_hover_text(tr(IS_CUT));
        };
        still(ui, 0, &mut |ui| {
            let name = tr!("Axial depth of stretch {number}", number = 1_usize);
            cell(ui, &name, &mut first_mm, ([0.0, deepest_mm], depths), said);
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
                let name = tr!("Start of stretch {number}", number = n);
                cell(ui, &name, from, ([low, high], places), said);
            });
            still(ui, i + 1, &mut |ui| {
                let name = tr!("Axial depth of stretch {number}", number = n);
                cell(ui, &name, axial, ([0.0, deepest_mm], depths), said);
            });
            radial(ui, *axial, radial_at(*axial));
            let name = tr!("Remove stretch {number}", number = n);
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
    if ui.add_enabled(room(&steps), egui::Button::new(tr("Add a stretch"))).clicked() {
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
