//! The factors of an experiment: what of a cut is varied, and from where to where.

use serde::Serialize;

use crate::base::settings::Kind;
use crate::models::tool::{ShippedTool, Tool};
use crate::run::scenario::{Scenario, param};

steadycut_core::choice! {
    /// What of a cut can be varied.
    pub enum FactorKind {
        /// Programmed feed.
        Feed = "feed", "Feed";
        /// Programmed spindle speed.
        Speed = "speed", "Spindle speed";
        /// Axial depth of cut.
        AxialDepth = "axial_depth", "Axial depth";
        /// Radial depth of cut.
        RadialDepth = "radial_depth", "Radial depth";
        /// Brinell hardness of the workpiece.
        Hardness = "hardness", "Hardness";
        /// Factor of tool wear on the force.
        Wear = "wear", "Wear factor";
        /// The cutter, one of the shipped ones.
        Cutter = "tool", "Cutter";
    }
}

/// The corner of least feed and speed, and that of the largest, of the box that is cut in by default with the
/// papers' cutter, mm/min and 1/min: start and final values of 2007 Table 3, rounded outwards. Its diagonal from
/// (240, 2600) to (600, 800) lies within 2.1 % of the speeds of the final values, but for that of
/// simulation 8, which is 5 % below it.
pub const PAPERS_BOX: [[f64; 2]; 2] = [[240.0, 600.0], [800.0, 2600.0]];
/// Default range of a depth over the scenario's value (chosen).
const DEPTHS: [f64; 2] = [0.5, 1.25];
/// Default range of the hardness over the scenario's value, and of the wear factor: those of `robust`.
const HARDNESS: [f64; 2] = [0.8, 1.2];
const WEAR: [f64; 2] = [1.0, 1.3];
/// Most levels of a factor.
pub const MAX_LEVELS: usize = 20;

impl FactorKind {
    /// The setting that it varies.
    #[must_use]
    pub fn path(self) -> &'static str {
        match self {
            Self::Feed => "program.feed_mm_min",
            Self::Speed => "program.spindle_rpm",
            Self::AxialDepth => "workpiece.axial_depth_mm",
            Self::RadialDepth => "workpiece.radial_depth_mm",
            Self::Hardness => "plant.hardness_hb",
            Self::Wear => "plant.wear_factor",
            Self::Cutter => "tool.name",
        }
    }

    /// Its column in a table, which ends with its unit.
    #[must_use]
    pub fn column(self) -> &'static str {
        match self {
            Self::Feed => "feed_mm_min",
            Self::Speed => "speed_rpm",
            Self::AxialDepth => "axial_depth_mm",
            Self::RadialDepth => "radial_depth_mm",
            Self::Hardness => "hardness_hb",
            Self::Wear => "wear_factor",
            Self::Cutter => "tool",
        }
    }

    /// Other names of its column, in the papers' tables.
    #[must_use]
    pub fn columns(self) -> &'static [&'static str] {
        match self {
            Self::Feed => &["feed_mm_min", "feed_final_mm_min"],
            Self::Speed => &["speed_rpm", "spindle_rpm", "spindle_final_rpm"],
            Self::AxialDepth => &["axial_depth_mm"],
            Self::RadialDepth => &["radial_depth_mm"],
            Self::Hardness => &["hardness_hb"],
            Self::Wear => &["wear_factor"],
            Self::Cutter => &["tool"],
        }
    }

    /// Its unit; empty where it has none.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Feed => "mm/min",
            Self::Speed => "1/min",
            Self::AxialDepth | Self::RadialDepth => "mm",
            Self::Hardness => "HB",
            Self::Wear | Self::Cutter => "",
        }
    }

    /// The step in which a shop sets it: values between the ends of a range are multiples of it.
    #[must_use]
    pub fn step(self) -> f64 {
        match self {
            Self::Feed => 0.1,
            Self::Speed => 1.0,
            Self::AxialDepth | Self::RadialDepth => 0.001,
            Self::Hardness => 0.1,
            Self::Wear => 0.001,
            Self::Cutter => 1.0,
        }
    }

    /// What is allowed of it: the range of its setting.
    #[must_use]
    pub fn allowed(self) -> [f64; 2] {
        match param(self.path()).map(|param| &param.spec.allowed) {
            Ok(Kind::Float { min, max }) => [*min, *max],
            Ok(
                Kind::Int { .. }
                | Kind::Bool
                | Kind::Choice { .. }
                | Kind::Text { .. }
                | Kind::Structured(_),
            )
            | Err(_) => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// The range over which it is varied where none is given.
    fn default_range(self, scenario: &Scenario) -> [f64; 2] {
        let around = |value: f64, shares: [f64; 2]| shares.map(|share| share * value);
        let range = match self {
            Self::Feed => scaled_box(&scenario.tool)[0],
            Self::Speed => scaled_box(&scenario.tool)[1],
            Self::AxialDepth => around(scenario.workpiece.axial_depth_mm, DEPTHS),
            Self::RadialDepth => {
                let [low, high] = around(scenario.workpiece.radial_depth_mm, DEPTHS);
                [low, high.min(scenario.tool.diameter_mm)]
            }
            Self::Hardness => around(scenario.plant.hardness_hb, HARDNESS),
            Self::Wear => WEAR,
            Self::Cutter => [0.0, 0.0],
        };
        let [least, most] = self.allowed();
        range.map(|end| rounded(end, self.step()).max(least).min(most))
    }
}

/// [`PAPERS_BOX`] at the same cutting speeds and feeds per tooth with another cutter.
#[must_use]
pub fn scaled_box(tool: &Tool) -> [[f64; 2]; 2] {
    let papers = Tool::default();
    let turns = papers.diameter_mm / tool.diameter_mm;
    let teeth = f64::from(tool.teeth) / f64::from(papers.teeth);
    let [feeds, speeds] = PAPERS_BOX;
    [
        feeds.map(|feed| rounded(feed * turns * teeth, FactorKind::Feed.step())),
        speeds.map(|speed| rounded(speed * turns, FactorKind::Speed.step())),
    ]
}

/// The nearest multiple of a step; steps below one are given as one over a whole number.
#[must_use]
pub fn rounded(x: f64, step: f64) -> f64 {
    let parts = (1.0 / step).round();
    if parts >= 1.0 { (x * parts).round() / parts } else { (x / step).round() * step }
}

/// From where to where a factor goes.
#[derive(Clone, Debug, PartialEq)]
pub enum FactorSpan {
    /// From the first to the second value.
    Range([f64; 2]),
    /// One of these cutters.
    Cutters(Vec<ShippedTool>),
}

/// A factor of an experiment.
#[derive(Clone, Debug, PartialEq)]
pub struct ExperimentFactor {
    /// What is varied.
    pub kind: FactorKind,
    /// From where to where.
    pub span: FactorSpan,
    /// Number of its levels in a full factorial, where it has one of its own.
    pub levels: Option<usize>,
}

/// A factor as it is told.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FactorTold {
    /// Its id.
    pub factor: FactorKind,
    /// Its column.
    pub column: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its range.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 2]>,
    /// The cutters, of the factor that they are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cutters: Option<Vec<&'static str>>,
}

impl ExperimentFactor {
    /// Reads `NAME`, `NAME=LOW..HIGH`, `NAME=LOW..HIGH:LEVELS` or `tool=CUTTER,CUTTER`. What is not given comes
    /// from the scenario.
    ///
    /// # Errors
    /// Names the factor, the value and what is allowed.
    pub fn read(text: &str, scenario: &Scenario) -> Result<Self, String> {
        let (name, rest) = match text.split_once('=') {
            Some((name, rest)) => (name.trim(), Some(rest.trim())),
            None => (text.trim(), None),
        };
        let names: Vec<&str> = FactorKind::ALL.iter().map(|kind| kind.id()).collect();
        let kind = FactorKind::from_id(name).ok_or_else(|| {
            format!("`{name}` is no factor: allowed is one of {}", names.join(", "))
        })?;
        let (rest, levels) = match rest.and_then(|rest| rest.rsplit_once(':')) {
            Some((rest, levels)) => (Some(rest), Some(levels_of(kind, levels)?)),
            None => (rest, None),
        };
        let span = match (kind, rest) {
            (FactorKind::Cutter, Some(list)) if levels.is_none() => cutters(list)?,
            (FactorKind::Cutter, _) => {
                return Err(format!("tool: allowed is tool={}, one or more", cutter_ids(",")));
            }
            (_, Some(range)) => FactorSpan::Range(range_of(kind, range)?),
            (_, None) => FactorSpan::Range(kind.default_range(scenario)),
        };
        let factor = Self { kind, span, levels };
        factor.check(scenario)?;
        Ok(factor)
    }

    fn check(&self, scenario: &Scenario) -> Result<(), String> {
        let FactorSpan::Range([low, high]) = self.span else { return Ok(()) };
        let (name, unit) = (self.kind.id(), self.kind.unit());
        let [least, most] = self.kind.allowed();
        for value in [low, high] {
            if !(least..=most).contains(&value) {
                return Err(format!(
                    "{name}: {value} is not possible: allowed is {least} to {most} {unit}"
                ));
            }
        }
        if low >= high {
            return Err(format!(
                "{name}: {low}..{high} is no range: allowed is LOW..HIGH with LOW below HIGH"
            ));
        }
        let widest = scenario.tool.diameter_mm;
        if self.kind == FactorKind::RadialDepth && high > widest {
            return Err(format!(
                "{name}: {high} is not possible: allowed is up to the cutter's diameter, {widest} mm"
            ));
        }
        Ok(())
    }

    /// Its range; 0 to the number of cutters less one of the factor that they are.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        match &self.span {
            FactorSpan::Range(range) => *range,
            FactorSpan::Cutters(all) => [0.0, all.len().saturating_sub(1) as f64],
        }
    }

    /// The cutters, of the factor that they are.
    #[must_use]
    pub fn cutters(&self) -> Option<&[ShippedTool]> {
        match &self.span {
            FactorSpan::Range(_) => None,
            FactorSpan::Cutters(all) => Some(all),
        }
    }

    /// The value at a coded level, -1 at the low end and 1 at the high one: in steps that a shop can set.
    #[must_use]
    pub fn value(&self, coded: f64) -> f64 {
        let [low, high] = self.range();
        if coded == -1.0 {
            low
        } else if coded == 1.0 {
            high
        } else {
            rounded(0.5 * (low + high) + 0.5 * coded * (high - low), self.kind.step())
        }
    }

    /// The coded level of a value.
    #[must_use]
    pub fn coded(&self, value: f64) -> f64 {
        let [low, high] = self.range();
        if high == low { 0.0 } else { (2.0 * value - low - high) / (high - low) }
    }

    /// A value as it is written in a table.
    #[must_use]
    pub fn text(&self, value: f64) -> String {
        match self.cutters() {
            Some(all) => all.get(value as usize).map_or("", |tool| tool.id()).to_owned(),
            None => value.to_string(),
        }
    }

    /// The factor as it is told.
    #[must_use]
    pub fn told(&self) -> FactorTold {
        let cutters = self.cutters().map(|all| all.iter().map(|tool| tool.id()).collect());
        FactorTold {
            factor: self.kind,
            column: self.kind.column(),
            unit: self.kind.unit(),
            range: cutters.is_none().then(|| self.range()),
            cutters,
        }
    }
}

fn cutter_ids(between: &str) -> String {
    ShippedTool::ALL.iter().map(|tool| tool.id()).collect::<Vec<_>>().join(between)
}

fn cutters(list: &str) -> Result<FactorSpan, String> {
    let mut all: Vec<ShippedTool> = Vec::new();
    for id in list.split(',').map(str::trim) {
        let tool = ShippedTool::from_id(id).ok_or_else(|| {
            format!("tool: `{id}` is no cutter: allowed is one of {}", cutter_ids(", "))
        })?;
        if all.contains(&tool) {
            return Err(format!("tool: `{id}` is named twice"));
        }
        all.push(tool);
    }
    Ok(FactorSpan::Cutters(all))
}

fn levels_of(kind: FactorKind, text: &str) -> Result<usize, String> {
    let levels = text.trim().parse::<usize>().ok().filter(|n| (2..=MAX_LEVELS).contains(n));
    levels.ok_or_else(|| {
        format!("{}: {text} levels are not possible: allowed are 2 to {MAX_LEVELS}", kind.id())
    })
}

fn range_of(kind: FactorKind, text: &str) -> Result<[f64; 2], String> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let ends = text.split_once("..");
    let ends = ends.and_then(|(low, high)| Some([number(low)?, number(high)?]));
    let [least, most] = kind.allowed();
    ends.ok_or_else(|| {
        let (name, unit) = (kind.id(), kind.unit());
        format!(
            "{name}: `{text}` is no range: allowed is LOW..HIGH within {least} to {most} {unit}"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<ExperimentFactor, String> {
        ExperimentFactor::read(text, &Scenario::default())
    }

    #[test]
    fn factors_are_read_with_ranges_levels_and_cutters() {
        let feed = read("feed").unwrap();
        assert_eq!((feed.range(), feed.levels), ([240.0, 600.0], None));
        let feed = read("feed=100..300:5").unwrap();
        assert_eq!((feed.range(), feed.levels), ([100.0, 300.0], Some(5)));
        assert_eq!([-1.0, 0.0, 0.3333, 1.0].map(|x| feed.value(x)), [100.0, 200.0, 233.3, 300.0]);
        assert_eq!(feed.coded(250.0), 0.5);
        let tool = read("tool=ball-6-2,square-12-4").unwrap();
        assert_eq!((tool.text(1.0).as_str(), tool.range()), ("square-12-4", [0.0, 1.0]));
        assert_eq!(read("hardness").unwrap().range(), [160.0, 240.0]);
        assert_eq!(read("axial_depth").unwrap().range(), [1.0, 2.5]);
    }

    #[test]
    fn what_cannot_be_is_refused_with_factor_value_and_range() {
        for (text, parts) in [
            ("fed", ["`fed`", "feed, speed"]),
            ("feed=100", ["feed: `100`", "LOW..HIGH"]),
            ("feed=300..100", ["feed: 300..100", "LOW below HIGH"]),
            ("feed=1..100", ["feed: 1 ", "10 to 5000 mm/min"]),
            ("speed=nan..100", ["speed: `nan..100`", "100 to 20000 1/min"]),
            ("radial_depth=1..17", ["radial_depth: 17", "16 mm"]),
            ("feed=100..200:1", ["feed: 1 levels", "2 to 20"]),
            ("tool=ball-7", ["`ball-7`", "ball-6-2"]),
            ("tool=ball-6-2,ball-6-2", ["`ball-6-2`", "twice"]),
            ("tool", ["tool=", "square-12-4"]),
        ] {
            let error = read(text).unwrap_err();
            assert!(parts.iter().all(|part| error.contains(part)), "{text}: {error}");
        }
    }

    #[test]
    fn another_cutter_has_the_same_cutting_speeds_and_feeds_per_tooth() {
        let papers = Tool::default();
        let tool = ShippedTool::Square12.load().tool;
        let [[feed, _], [_, speed]] = scaled_box(&tool);
        let [[feed_16, _], [_, speed_16]] = PAPERS_BOX;
        let off = tool.cutting_speed_m_min(speed) / papers.cutting_speed_m_min(speed_16) - 1.0;
        assert!(off.abs() < 1e-3, "{off}");
        let [per_tooth, per_tooth_16] = [(&tool, feed, 800.0 / 0.75), (&papers, feed_16, 800.0)]
            .map(|(tool, feed, speed)| tool.feed_per_tooth_mm(feed, speed));
        assert!((per_tooth / per_tooth_16 - 1.0).abs() < 1e-3, "{per_tooth} {per_tooth_16}");
    }
}
