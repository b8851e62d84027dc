//! Taylor's constants from readings of the wear land.

use std::fmt::Write as _;

use super::outcome::{FitEstimate, FitOutcome, FitPlot, FitTable, nothing_yet};
use super::request::{FitFault, FitOption, FitOptionKind, FitRequest, FitRole};
use super::{FitAbout, FitAtWork, MeasuredFit};
use crate::base::language::{fixed, in_english, text, tr};
use crate::base::math;
use crate::base::rng::Stream;
use crate::base::stats;
use crate::identify::estimate::explained;
use crate::identify::wear::{WearReadings, identify_wear_of, worn_scenario};
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;

/// The fit.
#[derive(Debug)]
pub struct WearFromData;

/// The wear land at which a life ends where nothing else is said, mm (ISO 8688-2).
pub const USUAL_LIMIT_MM: f64 = 0.3;

const SPEED: FitRole = FitRole {
    option: "speed",
    label: text!("Cutting speed"),
    about: text!("The column with the cutting speed, m/min."),
    what: text!("a cutting speed"),
    unit: "m/min",
    needed: true,
    names: &["speed_m_min", "speed", "v", "vc", "v_c"],
    words: &["speed", "cutting_speed", "schnittg", "rezaln", "vc"],
};
const TIME: FitRole = FitRole {
    option: "time",
    label: text!("Time in the cut"),
    about: text!("The column with the time in the cut, min."),
    what: text!("a time"),
    unit: "min",
    needed: true,
    names: &["time_min", "time", "t"],
    words: &["time", "zeit", "čas", "cas"],
};
const LAND: FitRole = FitRole {
    option: "land",
    label: text!("Wear land VB"),
    about: text!("The column with the width of the flank wear land VB, mm."),
    what: text!("a width"),
    unit: "mm",
    needed: true,
    names: &["vb_mm", "vb", "land"],
    words: &["vb", "wear", "land", "verschleiß", "obraba"],
};
const FEED: FitRole = FitRole {
    option: "feed",
    label: text!("Feed per tooth"),
    about: text!("The column with the feed per tooth, mm, where that was varied."),
    what: text!("a feed per tooth"),
    unit: "mm",
    needed: false,
    names: &["feed_mm", "fz", "f_z", "fz_mm"],
    words: &["feed", "fz", "f_z", "vorschub", "podaj"],
};
const DEPTH: FitRole = FitRole {
    option: "depth",
    label: text!("Axial depth"),
    about: text!("The column with the axial depth, mm, where that was varied."),
    what: text!("a depth"),
    unit: "mm",
    needed: false,
    names: &["depth_mm", "ap", "a_p", "ap_mm"],
    words: &["depth", "ap", "a_p", "tiefe", "globin"],
};
const TOOL_NUMBER: FitRole = FitRole {
    option: "tool-number",
    label: text!("Number of the tool"),
    about: text!("The column with the number of the tool, where several made the same cut."),
    what: text!("a number"),
    unit: "",
    needed: false,
    names: &["tool", "tool_number", "number"],
    words: &["tool", "werkzeug", "orodje"],
};
const LIMIT: FitOption = FitOption {
    option: "limit",
    label: text!("Wear land at the end"),
    about: text!("The wear land at which a tool's life ends, mm."),
    unit: "mm",
    kind: FitOptionKind::Number {
        range: [0.001, 10.0],
        default: Some(USUAL_LIMIT_MM),
        whole: false,
    },
};

/// The fit while it is worked at.
#[derive(Clone, Debug)]
pub struct WearAtWork {
    readings: WearReadings,
    limit_mm: f64,
    file: String,
    scenario: Scenario,
    edits: Edits,
    begun: bool,
}

impl MeasuredFit for WearFromData {
    const ABOUT: FitAbout = FitAbout {
        title: text!("Wear"),
        finds: text!(
            "Taylor's constants n and C of the tool's life, and the exponents of feed and depth where these were varied."
        ),
        needs: text!(
            "A table with a reading of the wear land in every row, in order of time: cutting speed, time in the cut, width of the wear land; tools at two cutting speeds at least that were worn to the limit."
        ),
        sample: "speed_m_min,time_min,vb_mm",
        timed: false,
        roles: &[SPEED, TIME, LAND, FEED, DEPTH, TOOL_NUMBER],
        options: &[LIMIT],
        most_steps: 1,
    };
    type Work = WearAtWork;

    fn begin(request: &FitRequest) -> Result<WearAtWork, FitFault> {
        let readings = WearReadings {
            speed_m_min: request.needed_cells(&SPEED)?,
            time_min: request.needed_cells(&TIME)?,
            land_mm: request.needed_cells(&LAND)?,
            feed_mm: request.cells(&FEED)?,
            depth_mm: request.cells(&DEPTH)?,
            tool: request.cells(&TOOL_NUMBER)?,
        };
        let limit_mm = request.number(&LIMIT)?.unwrap_or(USUAL_LIMIT_MM);
        let FitRequest { file, scenario, edits, .. } = request;
        let (file, scenario, edits) = (file.clone(), scenario.clone(), edits.clone());
        Ok(WearAtWork { readings, limit_mm, file, scenario, edits, begun: false })
    }

    /// Readings of four tools that wear by the scenario's own constants, each life a little off.
    fn sample(scenario: &Scenario, seed: u32) -> Result<String, String> {
        const SPEEDS: [f64; 4] = [0.8, 1.0, 1.25, 1.5];
        const SHARES: [f64; 6] = [0.1, 0.3, 0.5, 0.7, 0.9, 1.1];
        /// Deviation of the lives, as a share.
        const NOISE: f64 = 0.03;
        let wear = &scenario.wear;
        let stream = Stream::new(u64::from(seed), "read wear lands");
        let mut text = "speed_m_min,time_min,vb_mm\n".to_owned();
        for (k, ratio) in SPEEDS.into_iter().enumerate() {
            let off = 1.0 + NOISE * stream.normal(k as u64);
            let life_min =
                off * wear.taylor_life_min * math::pow(ratio, -1.0 / wear.taylor_exponent);
            for share in SHARES {
                let speed = ratio * wear.taylor_speed_m_min;
                let land_mm = USUAL_LIMIT_MM * share;
                // Into memory: it does not fail.
                let _ = writeln!(text, "{speed:.2},{:.3},{land_mm:.3}", share * life_min);
            }
        }
        Ok(text)
    }
}

impl FitAtWork for WearAtWork {
    fn step(&mut self) -> bool {
        self.begun = true;
        false
    }

    fn outcome(&self) -> Result<FitOutcome, FitFault> {
        if !self.begun {
            return Err(nothing_yet());
        }
        // Made here, so that its notes are in the language of now; lives are few.
        let fit = identify_wear_of(&self.readings, self.limit_mm)?;
        let at = tr!("life at {speed:.2} m/min", speed = fit.speed_m_min);
        let mut estimates = vec![
            FitEstimate::new(at, fit.life_min, 3, "min"),
            FitEstimate::new("n", fit.exponent, 4, ""),
            FitEstimate::new(tr("C of v T^n = C"), fit.constant_m_min, 2, "m/min"),
        ];
        for (name, found) in
            [(tr("exponent of the feed"), fit.feed), (tr("exponent of the depth"), fit.depth)]
        {
            if let Some((_, Some(exponent))) = found {
                estimates.push(FitEstimate::new(name, exponent, 4, ""));
            }
        }
        let cell = |x: Option<f64>| x.map_or("-".to_owned(), |x| fixed(x, 3));
        let rows = fit.lives.iter().map(|life| {
            vec![
                fixed(life.speed_m_min, 1),
                cell(life.feed_mm),
                cell(life.depth_mm),
                fixed(life.life_min, 2),
                fixed(life.fitted_min, 2),
            ]
        });
        let heads = ["v [m/min]", "f_z [mm]", "a_p [mm]"].map(str::to_owned).into_iter();
        let table = FitTable {
            title: tr("Lives of the tools").to_owned(),
            heads: heads
                .chain([tr("life [min]").to_owned(), tr("by the fit [min]").to_owned()])
                .collect(),
            rows: rows.collect(),
            taken: None,
        };
        let logs = |of: fn(&[f64; 2]) -> f64| -> Vec<f64> {
            let pairs = fit.lives.iter().map(|life| [life.life_min, life.fitted_min]);
            pairs.map(|pair| of(&pair)).collect()
        };
        let left = logs(|[life, fitted]| math::ln(life / fitted));
        let r2 = explained(&logs(|[life, _]| math::ln(*life)), &left);
        let percent = 100.0 * stats::rms(left.iter().copied()).unwrap_or(0.0);
        let mut told = vec![(
            tr("left over, rms").to_owned(),
            tr!("{share} % of the life", share = fixed(percent, 2)),
        )];
        match fit.spread {
            Some(spread) => told.push((
                tr("deviation of the lives").to_owned(),
                tr!("{share} % of the life", share = fixed(100.0 * spread, 2)),
            )),
            None => told.push((
                tr("deviation of the lives").to_owned(),
                tr("not told: as many constants as lives").to_owned(),
            )),
        }
        told.push((tr("R² of the logarithms").to_owned(), fixed(r2, 5)));
        let mut points: Vec<[f64; 3]> = fit
            .lives
            .iter()
            .map(|life| [life.speed_m_min, life.life_min, life.fitted_min])
            .collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let plot = FitPlot {
            title: tr("Life").to_owned(),
            over: (tr("cutting speed").to_owned(), "m/min"),
            unit: "min".to_owned(),
            points,
            joined: false,
            logarithmic: true,
        };
        let source = format!("from {}", self.file);
        let made = in_english(|| worn_scenario(&self.scenario, &self.edits, &fit, &source));
        let (settings, file) = FitOutcome::accepted(made);
        Ok(FitOutcome {
            summary: tr!(
                "{count} lives to a wear land of {land} mm",
                count = fit.lives.len(),
                land = fit.land_mm
            ),
            estimates,
            table: Some(table),
            left: told,
            notes: fit.notes,
            plots: vec![plot],
            settings,
            file,
        })
    }
}
