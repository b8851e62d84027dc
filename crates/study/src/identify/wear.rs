//! Taylor's constants from readings of the wear land (`steadycut identify wear`).
//!
//! ```text
//! v T^n = C                                                    F. W. Taylor, On the art of cutting metals, 1907
//! ln T  = ln T_r - 1/n ln(v/v_r) - p_f ln(f_z/f_r) - p_a ln(a_p/a_r)      extended by feed and depth
//! ```
//!
//! The life T of every tool is the time at which its wear land VB comes to the limit, on the line between two readings (ISO
//! 8688-2); tools that were not worn so far are left out and told. The logarithms of the lives give the constants by linear
//! least squares; the exponents of feed and depth where these were varied. References are the geometric means of the cuts,
//! where the life is told best. Intervals are those of 95 % (`estimate.rs`).

use std::fmt::Write as _;

use nalgebra::{DMatrix, DVector};

use super::EstimatedValue;
use super::estimate::LinearisedFit;
use crate::base::language::tr;
use crate::base::math;
use crate::base::settings::{SettingError, Value};
use crate::csv_table::CsvCells;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;

/// Least difference of logarithms for a quantity to count as varied: 2 %.
const VARIED: f64 = 0.02;
/// Condition from which on exponents cannot be told apart.
const NOT_APART: f64 = 100.0;
/// Step of differences; the fit is linear.
const DIFFERENCE: f64 = 1e-4;

/// Names of the columns of readings.
#[derive(Clone, Debug, PartialEq)]
pub struct WearColumns {
    /// Cutting speed, m/min.
    pub speed: String,
    /// Time in the cut, min.
    pub time: String,
    /// Width of the wear land, mm.
    pub land: String,
    /// Feed per tooth, mm, where there is such a column.
    pub feed: Option<String>,
    /// Axial depth, mm, where there is such a column.
    pub depth: Option<String>,
    /// Number of the tool, where several tools made the same cut.
    pub tool: Option<String>,
}

/// The life of a tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredLife {
    /// Cutting speed, m/min.
    pub speed_m_min: f64,
    /// Feed per tooth, mm.
    pub feed_mm: Option<f64>,
    /// Axial depth, mm.
    pub depth_mm: Option<f64>,
    /// Life, min.
    pub life_min: f64,
    /// Life by the fit, min.
    pub fitted_min: f64,
}

/// What was identified.
#[derive(Clone, Debug, PartialEq)]
pub struct TaylorFit {
    /// The limit of the wear land, mm.
    pub land_mm: f64,
    /// Speed of the reference life, m/min.
    pub speed_m_min: f64,
    /// The reference life T_r, min.
    pub life_min: EstimatedValue,
    /// Exponent n.
    pub exponent: EstimatedValue,
    /// Constant C of v T^n = C at the reference feed and depth, m/min: the speed for a life of a minute.
    pub constant_m_min: EstimatedValue,
    /// Reference feed in mm, and exponent p_f where the feed was varied.
    pub feed: Option<(f64, Option<EstimatedValue>)>,
    /// Reference depth in mm, and exponent p_a where the depth was varied.
    pub depth: Option<(f64, Option<EstimatedValue>)>,
    /// Lives of the tools.
    pub lives: Vec<MeasuredLife>,
    /// Standard deviation of the logarithms of the lives about the fit; none where nothing is left to tell it.
    pub spread: Option<f64>,
    /// What a person should know.
    pub notes: Vec<String>,
}

/// Readings of the wear land, one after the other; all of one length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WearReadings {
    /// Cutting speed, m/min.
    pub speed_m_min: Vec<f64>,
    /// Time in the cut, min.
    pub time_min: Vec<f64>,
    /// Width of the wear land, mm.
    pub land_mm: Vec<f64>,
    /// Feed per tooth, mm, where it was read.
    pub feed_mm: Option<Vec<f64>>,
    /// Axial depth, mm, where it was read.
    pub depth_mm: Option<Vec<f64>>,
    /// Number of the tool, where several tools made the same cut.
    pub tool: Option<Vec<f64>>,
}

/// Readings of a tool.
struct Series {
    /// Speed, feed, depth.
    cut: [f64; 3],
    tool: f64,
    /// Time in min and wear land in mm, in order.
    readings: Vec<[f64; 2]>,
}

fn column(cells: &CsvCells<'_>, numbers: &[Vec<f64>], name: &str) -> Result<Vec<f64>, String> {
    let place = cells.names().iter().position(|other| other == name);
    place.map(|place| numbers[place].clone()).ok_or_else(|| {
        tr!(
            "there is no column `{name}`; there are {names}",
            name = name,
            names = cells.names().join(", ")
        )
    })
}

impl WearReadings {
    /// Reads a table.
    ///
    /// # Errors
    /// A column is missing or has what is no number.
    pub fn read(text: &str, columns: &WearColumns) -> Result<Self, String> {
        let cells = CsvCells::whole(text)?;
        let numbers = cells.numbers()?;
        let of = |name: &str| column(&cells, &numbers, name);
        let maybe = |name: &Option<String>| name.as_ref().map(|name| of(name)).transpose();
        Ok(Self {
            speed_m_min: of(&columns.speed)?,
            time_min: of(&columns.time)?,
            land_mm: of(&columns.land)?,
            feed_mm: maybe(&columns.feed)?,
            depth_mm: maybe(&columns.depth)?,
            tool: maybe(&columns.tool)?,
        })
    }
}

/// The readings, tool by tool.
fn series(readings: &WearReadings) -> Result<Vec<Series>, String> {
    let WearReadings { speed_m_min: speed, time_min: time, land_mm: land, .. } = readings;
    let WearReadings { feed_mm: feed, depth_mm: depth, tool, .. } = readings;
    let at = |column: &Option<Vec<f64>>, i: usize| column.as_ref().map_or(1.0, |x| x[i]);
    let mut all: Vec<Series> = Vec::new();
    for i in 0..speed.len() {
        let cut = [speed[i], at(feed, i), at(depth, i)];
        if cut.iter().any(|x| *x <= 0.0) || time[i] < 0.0 || land[i] < 0.0 {
            return Err(tr!(
                "reading {number}: expected are a speed, feed and depth above 0, a time and a wear land of at least 0",
                number = i + 1
            ));
        }
        let tool = at(tool, i);
        let place = all.iter().position(|series| series.cut == cut && series.tool == tool);
        let place = place.unwrap_or_else(|| {
            all.push(Series { cut, tool, readings: Vec::new() });
            all.len() - 1
        });
        let readings = &mut all[place].readings;
        if readings.last().is_some_and(|[before, _]| time[i] <= *before) {
            return Err(tr!(
                "reading {number}: its time, {time} min, is not behind that of the reading before it at {speed} m/min: give a column with the tool's number",
                number = i + 1,
                time = time[i],
                speed = speed[i]
            ));
        }
        readings.push([time[i], land[i]]);
    }
    Ok(all)
}

impl Series {
    /// The time at which the wear land comes to a limit, on the line between two readings; a new tool has none.
    fn life_min(&self, land_mm: f64) -> Option<f64> {
        let begun = [[0.0, 0.0]];
        let all: Vec<[f64; 2]> = match self.readings.first() {
            Some([time, _]) if *time > 0.0 => begun.iter().chain(&self.readings).copied().collect(),
            Some(_) | None => self.readings.clone(),
        };
        all.windows(2).find_map(|pair| {
            let &[[from, low], [to, high]] = pair else { return None };
            let crosses = low < land_mm && high >= land_mm;
            crosses.then(|| from + (to - from) * (land_mm - low) / (high - low))
        })
    }

    fn told(&self) -> String {
        tr!("{speed} m/min", speed = self.cut[0])
    }
}

/// Fits Taylor's equation to readings of the wear land up to a limit in mm.
///
/// # Errors
/// A column is missing or has what is no number; too few tools came to the limit; the speed was not varied, or only
/// together with feed or depth; the life does not fall with the speed.
pub fn identify_wear(text: &str, columns: &WearColumns, land_mm: f64) -> Result<TaylorFit, String> {
    checked_limit(land_mm)?;
    identify_wear_of(&WearReadings::read(text, columns)?, land_mm)
}

/// A limit of the wear land that can be one.
fn checked_limit(land_mm: f64) -> Result<(), String> {
    if !(land_mm > 0.0 && land_mm.is_finite()) {
        return Err(tr!("a limit of {land} mm: expected is a number above 0", land = land_mm));
    }
    Ok(())
}

/// The same of readings.
///
/// # Errors
/// As [`identify_wear`].
pub fn identify_wear_of(readings: &WearReadings, land_mm: f64) -> Result<TaylorFit, String> {
    checked_limit(land_mm)?;
    let all = series(readings)?;
    let mut notes = Vec::new();
    let mut lives: Vec<([f64; 3], f64)> = Vec::new();
    for series in &all {
        match series.life_min(land_mm) {
            Some(life_min) => {
                if series.readings[0][1] >= land_mm {
                    notes.push(tr!(
                        "at {cut} the first reading is already above the limit: its life is on the line from a new tool",
                        cut = series.told()
                    ));
                }
                lives.push((series.cut, life_min));
            }
            None => notes.push(tr!(
                "at {cut} the wear land does not come to {land} mm: left out",
                cut = series.told(),
                land = land_mm
            )),
        }
    }
    // Logarithms of speed, feed and depth about their means, where they vary.
    let count = lives.len() as f64;
    let mean_log = |i: usize| lives.iter().map(|(cut, _)| math::ln(cut[i])).sum::<f64>() / count;
    let middle = [0, 1, 2].map(mean_log);
    let varies = |i: usize| {
        let [low, high] = math::extent(lives.iter().map(|(cut, _)| math::ln(cut[i])));
        high - low > VARIED
    };
    let varied: Vec<usize> = (0..3).filter(|i| varies(*i)).collect();
    if !varied.contains(&0) {
        return Err(tr!(
            "{count} tools came to {land} mm, all at one cutting speed: expected are at least two speeds",
            count = lives.len(),
            land = land_mm
        ));
    }
    let parameters = varied.len() + 1;
    if lives.len() < parameters {
        return Err(tr!(
            "{count} tools came to {land} mm: expected are at least {least}, one for each constant",
            count = lives.len(),
            land = land_mm,
            least = parameters
        ));
    }
    let row = |cut: &[f64; 3]| {
        let mut row = vec![1.0];
        row.extend(varied.iter().map(|i| -(math::ln(cut[*i]) - middle[*i])));
        row
    };
    let residuals = |x: &[f64]| -> Vec<f64> {
        let of = |(cut, life_min): &([f64; 3], f64)| {
            let fitted: f64 = row(cut).iter().zip(x).map(|(a, x)| a * x).sum();
            fitted - math::ln(*life_min)
        };
        lives.iter().map(of).collect()
    };
    let matrix = DMatrix::from_fn(lives.len(), parameters, |i, j| row(&lives[i].0)[j]);
    let right = DVector::from_iterator(lives.len(), lives.iter().map(|(_, life)| math::ln(*life)));
    let normal = matrix.transpose() * &matrix;
    let solved = normal.cholesky().map(|factor| factor.solve(&(matrix.transpose() * right)));
    let zero = vec![0.0; parameters];
    let x = solved.map_or(zero, |x| x.as_slice().to_vec());
    let fit = LinearisedFit::new(&x, &vec![DIFFERENCE; parameters], &residuals);
    if fit.weakest().0 > NOT_APART {
        return Err(tr(
            "speed, feed and depth were varied only together: expected are cuts in which one of them changes alone",
        )
        .to_owned());
    }
    let place = |i: usize| varied.iter().position(|other| *other == i).map(|place| place + 1);
    let slope = x[1];
    if slope <= 0.0 {
        return Err(tr(
            "the life does not fall with the cutting speed: expected are the columns of speed, time and wear land",
        )
        .to_owned());
    }
    let speed_m_min = math::exp(middle[0]);
    let exponent_of = |i: usize, given: bool| {
        given.then(|| {
            let exponent = place(i).map(|place| fit.estimated(&|x| x[place]));
            (math::exp(middle[i]), exponent)
        })
    };
    let (feed, depth) =
        (exponent_of(1, readings.feed_mm.is_some()), exponent_of(2, readings.depth_mm.is_some()));
    let names = [(&feed, tr("feed")), (&depth, tr("depth"))];
    for (found, name) in names {
        if found.is_none_or(|(_, exponent)| exponent.is_none()) {
            notes.push(tr!(
                "the {name} was not varied: its exponent stays as it is in the scenario",
                name = name
            ));
        }
    }
    let left = residuals(&x);
    let squares: f64 = left.iter().map(|r| r * r).sum();
    let freedom = lives.len() - parameters;
    let told = lives.iter().zip(&left).map(|((cut, life_min), left)| MeasuredLife {
        speed_m_min: cut[0],
        feed_mm: readings.feed_mm.as_ref().map(|_| cut[1]),
        depth_mm: readings.depth_mm.as_ref().map(|_| cut[2]),
        life_min: *life_min,
        fitted_min: life_min * math::exp(*left),
    });
    Ok(TaylorFit {
        land_mm,
        speed_m_min,
        life_min: fit.estimated(&|x| math::exp(x[0])),
        exponent: fit.estimated(&|x| 1.0 / x[1]),
        constant_m_min: fit.estimated(&|x| speed_m_min * math::exp(x[0] / x[1])),
        feed,
        depth,
        lives: told.collect(),
        spread: (freedom > 0).then(|| (squares / freedom as f64).sqrt()),
        notes,
    })
}

/// A value with its interval, as a comment has it.
fn told(x: EstimatedValue) -> String {
    let half = x.half.map_or("not told".to_owned(), |half| format!("+- {half:.4}"));
    format!("{:.4} {half}", x.value)
}

/// A scenario with what was identified, in which the tool wears over its life: the settings, and the text of its file.
///
/// # Errors
/// A value that the program does not take, as an exponent outside its range.
pub fn worn_scenario(
    scenario: &Scenario,
    edits: &Edits,
    fit: &TaylorFit,
    source: &str,
) -> Result<(Vec<(String, Value)>, String), SettingError> {
    let float = |path: &str, value: f64| (path.to_owned(), Value::Float(value));
    let mut changes = vec![
        ("wear.model".to_owned(), Value::Text("life".to_owned())),
        ("wear.life_curve".to_owned(), Value::Text(String::new())),
        float("wear.flank_end_mm", fit.land_mm),
        float("wear.taylor_life_min", fit.life_min.value),
        float("wear.taylor_speed_m_min", fit.speed_m_min),
        float("wear.taylor_exponent", fit.exponent.value),
        float("wear.tool_life_factor", 1.0),
    ];
    for (found, reference, power) in [
        (&fit.feed, "wear.reference_feed_mm", "wear.feed_exponent"),
        (&fit.depth, "wear.reference_depth_mm", "wear.depth_exponent"),
    ] {
        if let Some((middle, exponent)) = found {
            changes.push(float(reference, *middle));
            changes.extend(exponent.map(|exponent| float(power, exponent.value)));
        }
    }
    let mut worn = scenario.clone();
    worn.set_all(&changes)?;
    let mut text = format!(
        "# Taylor's constants identified by `steadycut identify wear`: {source}.\n\
         # {} lives to a wear land of {} mm; +- is half a 95 % interval.\n\
         # T = {} min at {:.2} m/min; n = {}; C = {} m/min\n",
        fit.lives.len(),
        fit.land_mm,
        told(fit.life_min),
        fit.speed_m_min,
        told(fit.exponent),
        told(fit.constant_m_min)
    );
    for (found, name) in [(&fit.feed, "feed per tooth"), (&fit.depth, "axial depth")] {
        if let Some((middle, Some(exponent))) = found {
            // Into memory: it does not fail.
            let _ = writeln!(
                text,
                "# exponent of the {name}: {} about {middle:.4} mm",
                told(*exponent)
            );
        }
    }
    for note in &fit.notes {
        let _ = writeln!(text, "# {note}");
    }
    text.push_str(&scenario_file::write(&worn, edits));
    Ok((changes, text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::rng::Stream;
    use crate::models::wear::{WearCut, WearSettings};

    fn columns() -> WearColumns {
        let name = |name: &str| name.to_owned();
        WearColumns {
            speed: name("speed_m_min"),
            time: name("time_min"),
            land: name("vb_mm"),
            feed: Some(name("feed_mm")),
            depth: Some(name("depth_mm")),
            tool: None,
        }
    }

    /// Readings of tools that wear by the program's own law, so many to a life, with noise of a share of the reading.
    fn readings(wear: &WearSettings, cuts: &[[f64; 3]], count: u32, noise: f64) -> String {
        let stream = Stream::new(3, "readings");
        let mut text = "speed_m_min,feed_mm,depth_mm,time_min,vb_mm\n".to_owned();
        let mut draw = 0;
        for [speed, feed, depth] in cuts {
            let cut = WearCut {
                cutting_speed_m_min: *speed,
                feed_per_tooth_mm: *feed,
                axial_depth_mm: *depth,
            };
            let life_min = wear.life_min(&cut);
            for k in 1..=count {
                let share = 1.1 * f64::from(k) / f64::from(count);
                let land = wear.flank_mm(wear.wear(share)) * (1.0 + noise * stream.normal(draw));
                draw += 1;
                let time_min = share * life_min;
                let _ = writeln!(text, "{speed},{feed},{depth},{time_min},{land}");
            }
        }
        text
    }

    fn cuts() -> Vec<[f64; 3]> {
        let mut cuts = Vec::new();
        for speed in [130.0, 160.0, 200.0, 240.0] {
            for (feed, depth) in [(0.1, 1.0), (0.2, 1.0), (0.1, 3.0)] {
                cuts.push([speed, feed, depth]);
            }
        }
        cuts
    }

    fn law() -> WearSettings {
        WearSettings {
            taylor_exponent: 0.31,
            taylor_life_min: 22.0,
            feed_exponent: 0.55,
            depth_exponent: 0.2,
            ..WearSettings::default()
        }
    }

    #[test]
    fn the_program_s_own_law_comes_back_out_of_its_wear() {
        for (count, noise, off) in [(2000, 0.0, 1e-4), (20, 0.02, 0.03)] {
            let text = readings(&law(), &cuts(), count, noise);
            let fit = identify_wear(&text, &columns(), 0.3).unwrap();
            let close = |found: f64, known: f64| (found / known - 1.0).abs() < off;
            assert!(close(fit.exponent.value, 0.31), "{fit:?}");
            let (feed_mm, feed) = fit.feed.unwrap();
            let (depth_mm, depth) = fit.depth.unwrap();
            assert!((feed.unwrap().value - 0.55).abs() < off, "{fit:?}");
            assert!((depth.unwrap().value - 0.2).abs() < off, "{fit:?}");
            let reference = WearCut {
                cutting_speed_m_min: fit.speed_m_min,
                feed_per_tooth_mm: feed_mm,
                axial_depth_mm: depth_mm,
            };
            assert!(close(fit.life_min.value, law().life_min(&reference)), "{fit:?}");
            // C is the speed for a life of a minute.
            let of_a_minute =
                WearCut { cutting_speed_m_min: fit.constant_m_min.value, ..reference };
            assert!((law().life_min(&of_a_minute) - 1.0).abs() < 10.0 * off, "{fit:?}");
            assert!(fit.lives.len() == 12 && fit.notes.is_empty());
            if noise > 0.0 {
                let half = fit.exponent.half.unwrap();
                assert!((fit.exponent.value - 0.31).abs() < 1.5 * half && half < 0.02, "{fit:?}");
            }
        }
    }

    /// Two lives by hand: 60 min at 100 m/min and 7.5 min at 200 m/min are n = 1/3, C = 100 60^(1/3) = 391.5 m/min.
    #[test]
    fn two_lives_give_the_textbook_s_constants() {
        let text = "v;t;VB\n100;50;0,25\n100;70;0,35\n200;5;0,2\n200;10;0,4\n";
        let columns = WearColumns {
            speed: "v".to_owned(),
            time: "t".to_owned(),
            land: "VB".to_owned(),
            feed: None,
            depth: None,
            tool: None,
        };
        let fit = identify_wear(text, &columns, 0.3).unwrap();
        assert_eq!(
            [fit.lives[0].life_min, fit.lives[1].life_min].map(|x| (x * 1e9).round()),
            [60e9, 7.5e9]
        );
        assert!((fit.exponent.value - 1.0 / 3.0).abs() < 1e-9, "{fit:?}");
        assert!((fit.constant_m_min.value - 391.487).abs() < 1e-3, "{fit:?}");
        assert_eq!((fit.exponent.half, fit.spread), (None, None), "nothing is left to tell it");
        assert_eq!(fit.notes.len(), 2, "feed and depth: {:?}", fit.notes);
    }

    #[test]
    fn the_scenario_wears_as_the_readings_did() {
        let fit = identify_wear(&readings(&law(), &cuts(), 2000, 0.0), &columns(), 0.3).unwrap();
        let (settings, text) =
            worn_scenario(&Scenario::default(), &Edits::none(), &fit, "from a test").unwrap();
        assert_eq!(settings.len(), 11);
        let (read, _) = scenario_file::parse(&text).unwrap();
        for [speed, feed, depth] in cuts() {
            let cut = WearCut {
                cutting_speed_m_min: speed,
                feed_per_tooth_mm: feed,
                axial_depth_mm: depth,
            };
            let ratio = read.wear.life_min(&cut) / law().life_min(&cut);
            assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
        }
        assert!(text.contains("# T = ") && text.contains("n = 0.31"), "{}", &text[..400]);
    }

    #[test]
    fn readings_that_tell_nothing_are_refused() {
        let header = "speed_m_min,feed_mm,depth_mm,time_min,vb_mm\n";
        let error =
            |rows: &str| identify_wear(&format!("{header}{rows}"), &columns(), 0.3).unwrap_err();
        let one = "100,0.1,2,5,0.1\n100,0.1,2,10,0.4\n";
        let told = error(one);
        assert!(told.contains("at least two speeds"), "{told}");
        let told = error(&format!("{one}200,0.2,2,1,0.1\n200,0.2,2,2,0.4\n150,0.1414,2,1,0.1\n"));
        assert!(told.contains("at least 3"), "{told}");
        // Feed in step with the speed.
        let told = error(&format!(
            "{one}200,0.2,2,1,0.1\n200,0.2,2,2,0.4\n400,0.4,2,0.1,0.1\n400,0.4,2,0.3,0.4\n"
        ));
        assert!(told.contains("only together"), "{told}");
        let told = error(&format!("{one}200,0.1,2,20,0.1\n200,0.1,2,90,0.4\n"));
        assert!(told.contains("does not fall"), "{told}");
        let told = error("100,0.1,2,5,0.1\n100,0.1,2,5,0.4\n");
        assert!(told.contains("reading 2") && told.contains("tool's number"), "{told}");
        let told = error("100,0.1,2,5,nan\n");
        assert!(told.contains("`vb_mm` is `nan`"), "{told}");
        let told = error("-100,0.1,2,5,0.1\n");
        assert!(told.contains("above 0"), "{told}");
        let other = WearColumns { land: "VB".to_owned(), ..columns() };
        let told = identify_wear(header, &other, 0.3).unwrap_err();
        assert!(told.contains("no column `VB`; there are speed_m_min"), "{told}");
    }
}
