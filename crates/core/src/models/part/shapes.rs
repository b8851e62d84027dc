//! What describes a part as settings: a depth profile, straight cuts, and what belongs to each cut.

use std::ops::{Deref, DerefMut};

use crate::base::language::tr;
use crate::base::settings::{Column, Editor, Numbers, Rows, Structure, Value};

/// A point of the depth profile: from `position_mm` along the path on, the axial depth of cut is
/// `axial_depth_mm`.
pub type DepthStep = [f64; 2];

/// A section of a straight cut: length along the cut, axial depth of cut and position y_e of the side
/// wall across the cut relative to the tool's axis, all in mm.
pub type Section = [f64; 3];

/// Most pairs in a profile of depths: so many that a part of one's own fits, so few that a link holds it.
pub const MAX_STEPS: usize = 2000;
/// Most straight cuts.
pub const MAX_CUTS: usize = 16;
/// Most sections of a cut.
pub const MAX_SECTIONS: usize = 32;
/// Shortest section, mm.
pub const MIN_SECTION_MM: f64 = 0.1;

crate::structured!(Vec<DepthStep>, RadialSteps, Vec<Vec<Section>>, Vec<f64>);

/// A profile of the radial depth: pairs as of a depth profile, with the radial depth of cut.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RadialSteps(pub Vec<DepthStep>);

impl Deref for RadialSteps {
    type Target = Vec<DepthStep>;

    fn deref(&self) -> &Vec<DepthStep> {
        &self.0
    }
}

impl DerefMut for RadialSteps {
    fn deref_mut(&mut self) -> &mut Vec<DepthStep> {
        &mut self.0
    }
}

/// Declared as a depth profile.
impl Structure for RadialSteps {
    const ID: &'static str = "radial_steps";

    fn bounds(range: [f64; 2]) -> Vec<(&'static str, f64)> {
        Vec::<DepthStep>::bounds(range)
    }
    fn allowed(range: [f64; 2], unit: &str) -> String {
        Vec::<DepthStep>::allowed(range, unit)
    }
    fn write(&self) -> Value {
        self.0.write()
    }
    fn read(value: &Value, range: [f64; 2]) -> Option<Self> {
        Vec::<DepthStep>::read(value, range).map(Self)
    }
    fn editor([max_depth_mm, max_position_mm]: [f64; 2]) -> Editor {
        steps_editor("radial step", " mm wide", [max_depth_mm, max_position_mm], 3.0)
    }
    fn example(range: [f64; 2], share: f64, pick: u32) -> Value {
        Vec::<DepthStep>::example(range, share, pick)
    }
}

/// Rows of positions and depths: what a row is called, what stands behind its depth, the largest depth and position, and
/// the depth of a new row, mm.
fn steps_editor(
    row: &'static str,
    behind: &'static str,
    [max_depth_mm, max_position_mm]: [f64; 2],
    depth_mm: f64,
) -> Editor {
    let column = |name, suffix, most, speed| Column { name, suffix, range: [0.0, most], speed };
    Editor::Rows(Rows {
        row,
        columns: vec![
            column("Position", " mm on:", max_position_mm, 0.5),
            column("Depth", behind, max_depth_mm, 0.01),
        ],
        most: MAX_STEPS,
        gap: 0.01,
        next: vec![20.0, depth_mm],
    })
}

/// A depth profile, declared with the largest depth and the largest position in mm: positions ascend,
/// both lie between 0 and their bound.
impl Structure for Vec<DepthStep> {
    const ID: &'static str = "steps";

    fn bounds([max_depth_mm, max_position_mm]: [f64; 2]) -> Vec<(&'static str, f64)> {
        vec![("max_position_mm", max_position_mm), ("max_depth_mm", max_depth_mm)]
    }
    fn allowed([max_depth_mm, max_position_mm]: [f64; 2], _: &str) -> String {
        tr!(
            "at most {n} pairs [position mm, depth mm], positions ascending from 0 to {position}, \
             depths from 0 to {depth}",
            n = MAX_STEPS,
            position = max_position_mm,
            depth = max_depth_mm
        )
    }
    fn write(&self) -> Value {
        self.clone().into()
    }
    fn read(value: &Value, [max_depth_mm, max_position_mm]: [f64; 2]) -> Option<Self> {
        let steps: Self = value.list()?.iter().map(Value::array).collect::<Option<_>>()?;
        let in_range = steps.iter().all(|[position, depth]| {
            (0.0..=max_position_mm).contains(position) && (0.0..=max_depth_mm).contains(depth)
        });
        let ascending = steps.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        (in_range && ascending && steps.len() <= MAX_STEPS).then_some(steps)
    }
    fn editor(range: [f64; 2]) -> Editor {
        steps_editor("depth step", " mm deep", range, 2.0)
    }
    fn example([max_depth_mm, max_position_mm]: [f64; 2], share: f64, pick: u32) -> Value {
        // Nearer and less deep ones too: a radial depth is at most the cutter's diameter.
        let part = [1.0, 0.2, 0.05][pick as usize % 3];
        let [position_mm, depth_mm] = [50.0, max_depth_mm].map(|most| part * most);
        Value::from([
            [share * position_mm, share * depth_mm],
            [share * position_mm + 1.0, (1.0 - share) * depth_mm],
            [max_position_mm, 1.0],
        ])
    }
}

/// Straight cuts, declared with the largest depth and the largest length of a section in mm; walls lie
/// between minus and plus the largest depth.
impl Structure for Vec<Vec<Section>> {
    const ID: &'static str = "cuts";

    fn bounds([max_depth_mm, max_length_mm]: [f64; 2]) -> Vec<(&'static str, f64)> {
        vec![("max_length_mm", max_length_mm), ("max_depth_mm", max_depth_mm)]
    }
    fn allowed([max_depth_mm, max_length_mm]: [f64; 2], _: &str) -> String {
        tr!(
            "at most {n} cuts of 1 to {sections} sections [length mm, axial depth mm, wall mm], lengths \
             from {shortest} to {length}, depths from 0 to {depth}, walls from -{depth} to {depth}",
            n = MAX_CUTS,
            sections = MAX_SECTIONS,
            shortest = MIN_SECTION_MM,
            length = max_length_mm,
            depth = max_depth_mm
        )
    }
    fn write(&self) -> Value {
        self.clone().into()
    }
    fn read(value: &Value, [max_depth_mm, max_length_mm]: [f64; 2]) -> Option<Self> {
        let cut = |value: &Value| value.list()?.iter().map(Value::array).collect();
        let cuts: Self = value.list()?.iter().map(cut).collect::<Option<_>>()?;
        let fits = |[length, depth, wall]: &Section| {
            (MIN_SECTION_MM..=max_length_mm).contains(length)
                && (0.0..=max_depth_mm).contains(depth)
                && (-max_depth_mm..=max_depth_mm).contains(wall)
        };
        let cut_fits =
            |cut: &Vec<Section>| (1..=MAX_SECTIONS).contains(&cut.len()) && cut.iter().all(fits);
        (cuts.len() <= MAX_CUTS && cuts.iter().all(cut_fits)).then_some(cuts)
    }
    fn editor(_: [f64; 2]) -> Editor {
        Editor::Count("cut")
    }
    fn example([max_depth_mm, max_length_mm]: [f64; 2], share: f64, _: u32) -> Value {
        Value::from(vec![
            vec![[0.1 + share * 20.0, share * max_depth_mm, -share * max_depth_mm]],
            vec![[3.0, 2.0, 1.5], [max_length_mm, (1.0 - share) * max_depth_mm, 0.0]],
        ])
    }
}

/// One number for each cut, declared with its range.
impl Structure for Vec<f64> {
    const ID: &'static str = "numbers";

    fn bounds([min, max]: [f64; 2]) -> Vec<(&'static str, f64)> {
        vec![("min", min), ("max", max)]
    }
    fn allowed([min, max]: [f64; 2], unit: &str) -> String {
        let unit_behind = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        tr!(
            "at most {n} numbers, one for each cut, from {min} to {max}{unit}",
            n = MAX_CUTS,
            min = min,
            max = max,
            unit = unit_behind
        )
    }
    fn write(&self) -> Value {
        self.clone().into()
    }
    fn read(value: &Value, [min, max]: [f64; 2]) -> Option<Self> {
        let numbers = value.numbers()?;
        let fit = numbers.iter().all(|x| (min..=max).contains(x));
        // + 0.0 turns -0.0 into 0.0, so that equal settings have equal bits.
        (fit && numbers.len() <= MAX_CUTS).then(|| numbers.iter().map(|x| x + 0.0).collect())
    }
    fn editor(range: [f64; 2]) -> Editor {
        Editor::Numbers(Numbers { each: "cut", range, most: MAX_CUTS })
    }
    fn example([min, max]: [f64; 2], share: f64, pick: u32) -> Value {
        Value::from(vec![min + share * (max - min); pick as usize % 3])
    }
}
