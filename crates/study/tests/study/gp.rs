//! Formulas found by genetic programming: that they are found, what is told of them, and that the bits are
//! the same whatever the slices, threads and pauses.

use steadycut_core::base::formula::Formula;
use steadycut_core::base::math;
use steadycut_core::base::rng::Stream;
use steadycut_core::models::formula_model::FormulaModel;
use steadycut_core::run::job::{Budget, Job};
use steadycut_study::identify::gp::band::FormulaBand;
use steadycut_study::identify::gp::constants::fitted;
use steadycut_study::identify::gp::declared::declared_report;
use steadycut_study::identify::gp::inspect::FormulaInspection;
use steadycut_study::identify::gp::job::{GpJob, GpSettings};
use steadycut_study::identify::gp::model::fitted_model;
use steadycut_study::identify::gp::problem::GpProblem;
use steadycut_study::identify::gp::report::{
    FrontFormula, GpReport, OutlyingRow, ReportedConstant,
};
use steadycut_study::identify::gp::standing::{GpStage, GpStanding};
use steadycut_study::identify::gp::watched::WatchedSearch;
use steadycut_study::published::PaperId;

const CLEAN: &str = include_str!("../data/gp/k4_clean.csv");
const NOISE: &str = include_str!("../data/gp/k4_noise1.csv");
const NGUYEN_5: &str = include_str!("../data/gp/nguyen05.csv");
/// What searches of 15 batches, seed 1, must give; `web/test/digests.mjs` asks the same of the page's program.
const DIGESTS: &str = include_str!("../data/gp/digests.json");
const FORCE: [&str; 2] = ["feed_mm_min", "speed_rpm"];

fn problem(text: &str, target: &str, inputs: &[&str]) -> GpProblem {
    let inputs: Vec<String> = inputs.iter().map(|&input| input.to_owned()).collect();
    GpProblem::read(text, target, &inputs).unwrap()
}

fn job(problem: GpProblem, seed: u64, batches: u64) -> GpJob {
    GpJob::new(problem, &GpSettings { seed, batches, paper: None }).unwrap()
}

fn report(problem: GpProblem, seed: u64, batches: u64) -> GpReport {
    let mut job = job(problem, seed, batches);
    job.to_end();
    job.report()
}

fn chosen(report: &GpReport) -> &FrontFormula {
    report.chosen().unwrap()
}

/// A table from columns.
fn table(names: &[&str], rows: impl IntoIterator<Item = Vec<f64>>) -> String {
    let mut text = names.join(",");
    for row in rows {
        let cells: Vec<String> = row.iter().map(f64::to_string).collect();
        text.push('\n');
        text.push_str(&cells.join(","));
    }
    text
}

/// 286.44 - 5.82e-10 n^3 - 8973 ln(0.039 f) / f.
#[test]
fn k4_is_found_from_its_values() {
    let report = report(problem(CLEAN, "force_n", &FORCE), 1, 80);
    let found = chosen(&report);
    assert!(found.exact && found.certified && found.size <= 18, "{found:?}");
    let law = Formula::parse(&found.formula, &FORCE).unwrap();
    let truth = Formula::parse("286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f", &["f", "n"]).unwrap();
    // 30 % beyond the rows on both sides.
    for f in [69.7, 100.0, 150.0, 330.0, 600.0, 735.0] {
        for n in [290.0, 800.0, 1500.0, 2500.0, 3010.0] {
            let (law, truth) = (law.value(&[f, n]), truth.value(&[f, n]));
            assert!((law / truth - 1.0).abs() < 1e-9, "{f} {n}: {law} {truth}");
        }
    }
    for constant in &found.constants {
        assert!(constant.determined, "{constant:?}");
    }
}

#[test]
fn bits_are_those_that_they_were() {
    let clean = report(problem(CLEAN, "force_n", &FORCE), 1, 15);
    let nguyen = report(problem(NGUYEN_5, "y", &["x1"]), 1, 15);
    let known: serde_json::Value = serde_json::from_str(DIGESTS).unwrap();
    let found = [("k4_clean", &clean), ("nguyen05", &nguyen)];
    for (name, report) in found {
        assert_eq!(known[name], report.digest.as_str(), "{name}: {:?}", chosen(report));
    }
}

#[test]
fn a_search_goes_on_from_its_file_with_the_same_bits() {
    let problem = problem(NOISE, "force_n", &FORCE);
    let whole = report(problem.clone(), 3, 8);
    let mut begun = job(problem.clone(), 3, 8);
    while begun.search().batches() < 3 {
        begun.advance(&Budget::steps(50));
    }
    let text = begun.state_text();
    let mut resumed = job(problem.clone(), 3, 8);
    resumed.resume(&text).unwrap();
    assert_eq!(resumed.search().batches(), begun.search().batches());
    resumed.to_end();
    assert_eq!(resumed.report(), whole);
    let error = job(problem, 4, 8).resume(&text).unwrap_err();
    assert!(error.contains("another seed"), "{error}");
    let mut other = job(self::problem(CLEAN, "force_n", &FORCE), 3, 8);
    assert!(other.resume(&text).unwrap_err().contains("another table"));
    let input = text.replace("{\"Input\":0}", "{\"Input\":7}");
    assert_ne!(input, text);
    let error = job(self::problem(NOISE, "force_n", &FORCE), 3, 8).resume(&input).unwrap_err();
    assert!(error.contains("cannot be"), "{error}");
}

/// What is told on the way is what the report tells at the end, but for what only the end knows.
#[test]
fn a_search_tells_its_front_on_the_way() {
    let problem = problem(NOISE, "force_n", &FORCE);
    let mut job = job(problem.clone(), 3, 6);
    let first = job.standing();
    assert_eq!((first.stage, first.batches, first.most_batches), (GpStage::Search, 0, 6));
    while job.search().batches() < 4 {
        job.advance(&Budget::steps(40));
    }
    let under_way = job.standing();
    assert_eq!((under_way.stage, under_way.batches), (GpStage::Search, 4));
    assert!(under_way.evaluations >= 4 * 128, "{}", under_way.evaluations);
    let least = |standing: &GpStanding| standing.front.last().unwrap().error;
    assert!(least(&under_way) < least(&first));
    let mut stages = vec![under_way.stage];
    while !job.advance(&Budget::steps(1)) {
        stages.push(job.standing().stage);
    }
    stages.dedup();
    assert_eq!(stages, [GpStage::Search, GpStage::LeftOut]);
    let (end, report) = (job.standing(), job.report());
    assert_eq!(end.stage, GpStage::Over);
    for standing in [&first, &under_way, &end] {
        for pair in standing.front.windows(2) {
            assert!(pair[0].size < pair[1].size && pair[0].error > pair[1].error, "{pair:?}");
        }
        for told in &standing.front {
            let law = Formula::parse(&told.formula, &FORCE).unwrap();
            let rows = &problem.rows;
            let squares: f64 = (0..rows.len())
                .map(|row| {
                    rows.target[row] - law.value(&[rows.inputs[0][row], rows.inputs[1][row]])
                })
                .map(|off| off * off)
                .sum();
            let error = (squares / rows.len() as f64).sqrt();
            assert!((error / told.error - 1.0).abs() < 1e-6, "{error} {told:?}");
            assert_eq!(law.size(), told.size, "{told:?}");
        }
    }
    let sizes = |front: &GpReport| front.front.iter().map(|entry| entry.size).collect::<Vec<_>>();
    let told: Vec<usize> = end.front.iter().map(|entry| entry.size).collect();
    assert!(sizes(&report).iter().filter(|size| told.contains(size)).count() >= told.len() - 1);
}

#[test]
fn noise_gives_a_small_formula_that_is_near_the_truth_in_the_box() {
    let report = report(problem(NOISE, "force_n", &FORCE), 2, 60);
    let found = chosen(&report);
    assert!(found.size <= 13 && !found.exact, "{found:?}");
    let law = Formula::parse(&found.formula, &FORCE).unwrap();
    let truth = Formula::parse("286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f", &["f", "n"]).unwrap();
    let mut squares = 0.0;
    for i in 0..20 {
        for j in 0..20 {
            let at = [150.0 + 22.5 * (f64::from(i) + 0.5), 800.0 + 85.0 * (f64::from(j) + 0.5)];
            let off = law.value(&at) - truth.value(&at);
            squares += off * off / 400.0;
        }
    }
    assert!(squares.sqrt() < 0.30, "{}", squares.sqrt());
    let ranges = report.ranges.unwrap();
    assert!(ranges.training.finite && ranges.widened.finite, "{ranges:?}");
    assert!(ranges.training.ranges[0][0] > 150.0);
}

/// Noise of 0.01 %: the true form is found, whatever fits as well within the rows.
#[test]
fn noise_of_a_ten_thousandth_gives_the_true_form() {
    let truth = Formula::parse("286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f", &["f", "n"]).unwrap();
    for seed in [1, 2] {
        let stream = Stream::new(seed, "noise of a ten-thousandth");
        let rows = (0..400).map(|row| {
            let (f, n) = (
                150.0 + 450.0 * stream.uniform(3 * row),
                800.0 + 1700.0 * stream.uniform(3 * row + 1),
            );
            vec![f, n, truth.value(&[f, n]) + 0.0215 * stream.normal(3 * row + 2)]
        });
        let problem =
            problem(&table(&["feed", "speed", "force"], rows), "force", &["feed", "speed"]);
        let report = report(problem, seed, 120);
        let found = chosen(&report);
        assert!(found.size <= 17 && found.error < 1.02 * 0.0215, "{found:?}");
        let law = Formula::parse(&found.formula, &["feed", "speed"]).unwrap();
        // Up to 30 % beyond the rows.
        for f in [69.7, 100.0, 150.0, 330.0, 600.0, 735.0] {
            for n in [290.0, 800.0, 1500.0, 2500.0, 3010.0] {
                let (law, truth) = (law.value(&[f, n]), truth.value(&[f, n]));
                assert!((law / truth - 1.0).abs() < 0.005, "{f} {n}: {law} {truth}: {found:?}");
            }
        }
        let part = |n: f64| law.value(&[300.0, n]) - law.value(&[300.0, 800.0]);
        let share = |p: f64| {
            let part = |n: f64| math::pow(n, p) - math::pow(800.0, p);
            part(1650.0) / part(2500.0)
        };
        let ratio = part(1650.0) / part(2500.0);
        // The share falls with the exponent.
        assert!(share(3.02) < ratio && ratio < share(2.98), "{found:?}");
    }
}

/// Keijzer 4, a product of several factors: x^3 e^-x cos x sin x (sin^2 x cos x - 1).
#[test]
fn a_damped_swing_of_several_factors_is_found() {
    let value = |x: f64| {
        let (sin, cos) = (math::sin(x), math::cos(x));
        x * x * x * math::exp(-x) * cos * sin * (sin * sin * cos - 1.0)
    };
    let rows = (0..=200).map(|i| 0.05 * f64::from(i)).map(|x| vec![x, value(x)]);
    let report = report(problem(&table(&["x", "y"], rows), "y", &["x"]), 3, 250);
    let found = chosen(&report);
    let law = Formula::parse(&found.formula, &["x"]).unwrap();
    for i in 0..100 {
        let x = 0.025 + 0.1 * f64::from(i);
        assert!((law.value(&[x]) - value(x)).abs() < 1e-6, "{x}: {found:?}");
    }
}

/// A grid that is laid out through 0 belongs to an input of any sign: no formula of it stops at 0. A column that tells
/// its unit is as positive as its rows.
#[test]
fn an_input_that_passes_zero_has_whole_powers_only() {
    let rows = |name: &str| {
        let rows = (0..40).map(|i| 0.05 + 0.1 * f64::from(i)).map(|x| vec![x, x * x.sqrt()]);
        problem(&table(&[name, "y"], rows), "y", &[name])
    };
    assert_eq!(rows("x").positive(), [false]);
    assert_eq!(rows("depth_mm").positive(), [true]);
    let report = report(rows("x"), 1, 20);
    let beyond = &report.ranges.as_ref().unwrap().widened;
    assert!(beyond.ranges[0][0] < -1.0, "{beyond:?}");
    let law = Formula::parse(&chosen(&report).formula, &["x"]).unwrap();
    assert!([-1.0, -0.1, 0.0].iter().all(|x| law.value(&[*x]).is_finite()), "{law}");
    let report = self::report(rows("depth_mm"), 1, 20);
    assert!(chosen(&report).exact, "{:?}", chosen(&report));
    // Nor are few or random values a grid.
    for levels in [vec![0.05, 0.1, 0.2, 0.3, 0.4, 0.5], vec![0.1, 0.2, 0.3, 0.4, 0.5]] {
        let rows = levels.iter().map(|x| vec![*x, x * x]);
        assert_eq!(problem(&table(&["x", "y"], rows), "y", &["x"]).positive(), [true]);
    }
}

/// An input without a unit may be negative, however the rows lie: a formula that stops at 0 is chosen only where none
/// that goes on is nearly as good. One whose unit is told is as positive as its rows.
#[test]
fn where_an_input_may_be_negative_a_formula_that_goes_on_is_chosen() {
    let stream = Stream::new(5, "goes on");
    let rows = |name: &str| {
        let rows = (0..60).map(|row| {
            let x = 0.2 + 3.8 * stream.uniform(2 * row);
            vec![x, 3.0 * math::pow(x, 0.7) + 0.02 * stream.normal(2 * row + 1)]
        });
        problem(&table(&[name, "y"], rows), "y", &[name])
    };
    let free = report(rows("x"), 1, 30);
    let law = Formula::parse(&chosen(&free).formula, &["x"]).unwrap();
    let wide = &free.ranges.as_ref().unwrap().widened;
    assert!(wide.finite && wide.ranges[0][0] < -0.8, "{wide:?}");
    for i in 0..=59 {
        let x = -0.8 + 0.1 * f64::from(i);
        assert!(law.value(&[x]).is_finite(), "{x}: {law}");
    }
    assert!(chosen(&free).error < 0.03, "{:?}", chosen(&free));
    // The others stay on the front.
    let stops = |found: &FrontFormula| {
        Formula::parse(&found.formula, &["x"]).unwrap().value(&[-0.8]).is_nan()
    };
    assert!(free.front.iter().any(stops), "{:?}", free.front);
    for pair in free.front.windows(2) {
        assert!(pair[0].size <= pair[1].size, "{pair:?}");
    }
    let length = report(rows("x_mm"), 1, 30);
    assert!(length.ranges.as_ref().unwrap().widened.ranges[0][0] > 0.0);
    assert!(chosen(&length).formula.contains('^'), "{:?}", chosen(&length));
    let mm = steadycut_core::base::formula::Unit::parse("mm").unwrap();
    let told = rows("x").told(&[("x".to_owned(), mm)]);
    assert_eq!((rows("x").surely_positive(), told.surely_positive()), (vec![false], vec![true]));
    // Far from 0, nothing is to be told.
    let far = (0..40).map(|i| vec![5.0 + 0.1 * f64::from(i), f64::from(i)]);
    assert_eq!(problem(&table(&["x", "y"], far), "y", &["x"]).surely_positive(), [true]);
}

/// Of many rows a sample is searched, and the front is judged by it; the formula chosen has its constants from all.
#[test]
fn many_rows_are_searched_by_a_sample_and_fitted_at_the_end() {
    let stream = Stream::new(8, "many rows");
    let rows = (0..2500).map(|row| {
        let x = 1.0 + 4.0 * stream.uniform(2 * row);
        vec![x, 2.0 * x + 1.5 * x * x + 0.1 * stream.normal(2 * row + 1)]
    });
    let problem = problem(&table(&["x_mm", "y"], rows), "y", &["x_mm"]);
    let settings = GpSettings { seed: 4, batches: 4, paper: None };
    let mut job = GpJob::new(problem.clone(), &settings).unwrap();
    job.to_end();
    let report = job.report();
    assert_eq!((report.rows, report.searched_rows, report.seed), (2500, 2000, 4));
    assert_eq!((report.residuals.len(), report.bands.len()), (2500, 2500));
    for found in &report.front {
        let formula = Formula::parse(&found.formula, &["x_mm"]).unwrap();
        let rows = if found.chosen { problem.rows.clone() } else { problem.sample(4) };
        let fit = fitted(&formula, &rows).unwrap();
        assert!((fit.rms() / found.error - 1.0).abs() < 1e-9, "{found:?}");
        for (own, again) in found.constants.iter().zip(&fit.constants) {
            assert!((own.value / again.value - 1.0).abs() < 1e-5, "{found:?} {again:?}");
        }
    }
    // Whichever is looked at has its constants from all rows, too.
    let other = report.front.iter().find(|found| !found.chosen && found.size > 3).unwrap();
    let seen = FormulaInspection::of(&problem, other, &[], String::new()).unwrap();
    let all = fitted(&Formula::parse(&other.formula, &["x_mm"]).unwrap(), &problem.rows).unwrap();
    assert_ne!(seen.formula.to_string(), other.formula);
    assert_eq!(seen.formula.to_string(), all.formula.to_string());
}

/// The band that a model file carries covers the truth as often as it says, over redraws of the noise.
#[test]
fn the_band_of_a_model_file_covers_the_truth() {
    let truth = Formula::parse("286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f", &["f", "n"]).unwrap();
    let law = "286 - 5.8e-10*speed_rpm^3.001 - 8970*ln(0.04*feed_mm_min)/feed_mm_min";
    let law = Formula::parse(law, &FORCE).unwrap();
    let draws = Stream::new(9, "band of a file");
    let (redraws, count) = (200_u64, 60_u64);
    let places: Vec<[f64; 2]> = (0..5)
        .flat_map(|i| {
            (0..5).map(move |j| [160.0 + 107.0 * f64::from(i), 820.0 + 412.0 * f64::from(j)])
        })
        .collect();
    let mut covered = vec![0_u32; places.len()];
    for redraw in 0..redraws {
        let noise = Stream::new(redraw, "noise of the band");
        let rows = (0..count).map(|row| {
            let corner = |x: f64, share: f64| if row < 4 { x } else { share };
            let at = [
                corner([150.0, 600.0][row as usize % 2], 150.0 + 450.0 * draws.uniform(2 * row)),
                corner(
                    [800.0, 2500.0][row as usize / 2 % 2],
                    800.0 + 1700.0 * draws.uniform(2 * row + 1),
                ),
            ];
            vec![at[0], at[1], truth.value(&at) + 0.1 * noise.normal(row)]
        });
        let problem =
            problem(&table(&["feed_mm_min", "speed_rpm", "force_n"], rows), "force_n", &FORCE);
        let fit = fitted(&law, &problem.rows).unwrap();
        let constants: Vec<ReportedConstant> =
            fit.constants.iter().map(ReportedConstant::from).collect();
        let model = fitted_model(&problem, &fit.formula, &constants, &[], String::new()).unwrap();
        let model = FormulaModel::parse(&model.write()).unwrap();
        let band = FormulaBand::of(&model).unwrap();
        for (place, covered) in places.iter().zip(&mut covered) {
            let half = band.half_width(place).unwrap();
            // The same as that of the fit itself.
            assert!((half / fit.band(place).unwrap() - 1.0).abs() < 1e-4, "{place:?}");
            let off = model.at(place).value - truth.value(place);
            *covered += u32::from(off.abs() <= half);
        }
    }
    let share = |count: u32| f64::from(count) / redraws as f64;
    let whole = covered.iter().map(|count| share(*count)).sum::<f64>() / places.len() as f64;
    assert!((0.92..=0.98).contains(&whole), "{whole}: {covered:?}");
    // 200 redraws tell a share of 95 % to 1.5 % (one standard deviation).
    assert!(covered.iter().all(|count| (0.90..=1.0).contains(&share(*count))), "{covered:?}");
}

/// A product of powers beside an input that says nothing.
#[test]
fn a_law_of_powers_is_found_and_an_idle_input_left_out() {
    let rows = (0..60).map(|i| {
        let i = f64::from(i);
        let share = |by: f64| (i * by).fract();
        let (b, h, v) = (0.5 + 2.5 * share(0.618), 0.05 + 0.35 * share(0.414), 20.0 + share(0.732));
        vec![b, h, v, 1750.0 * b * math::pow(h, 0.737)]
    });
    let names = ["depth_mm", "feed_mm", "temperature", "force_n"];
    let report = report(problem(&table(&names, rows), "force_n", &names[..3]), 1, 30);
    let found = chosen(&report);
    assert!(found.exact && !found.formula.contains("temperature"), "{found:?}");
    let exponent = found.constants.iter().any(|constant| (constant.value - 0.737).abs() < 1e-9);
    assert!(exponent && found.size <= 9, "{found:?}");
}

#[test]
fn strict_units_let_only_consistent_formulas_through() {
    use steadycut_core::base::formula::{NumberUnits, Unit};
    let strict = problem(NOISE, "force_n", &FORCE).strict(&[]).unwrap();
    let report = report(strict, 1, 12);
    let units = ["mm/min", "1/min"].map(|unit| Unit::parse(unit).unwrap());
    for entry in &report.front {
        let formula = Formula::parse(&entry.formula, &FORCE).unwrap();
        let force = Unit::parse("N").unwrap();
        assert!(formula.check_units(&units, &force, NumberUnits::Solved).is_ok(), "{entry:?}");
        assert!(entry.units.as_ref().is_some_and(|units| !units.is_empty()), "{entry:?}");
    }
    assert!(report.front.len() > 3);
    let unknown = problem(NGUYEN_5, "y", &["x1"]).strict(&[]).unwrap_err();
    assert!(unknown.contains("`x1`") && unknown.contains("--unit"), "{unknown}");
}

#[test]
fn a_known_part_stays_and_the_rest_is_found() {
    let text = "a + b*speed_rpm^3 + T(feed_mm_min)";
    let template = problem(CLEAN, "force_n", &FORCE).with_template(text).unwrap();
    let report = report(template, 1, 40);
    for entry in &report.front {
        let formula = Formula::parse(&entry.formula, &FORCE).unwrap();
        let part = |n: f64| formula.value(&[300.0, n]) - formula.value(&[300.0, 1000.0]);
        let ratio = part(2000.0) / part(1500.0);
        assert!((ratio - 7e9 / 2.375e9).abs() < 1e-9, "{entry:?}");
    }
    assert!(chosen(&report).exact, "{:?}", chosen(&report));
}

/// The constants of a declared structure have intervals; two inputs on one line leave theirs undetermined.
#[test]
fn a_declared_structure_has_its_constants_fitted_with_intervals() {
    let declared = |problem: GpProblem, text: &str| {
        let problem = problem.with_template(text).unwrap();
        let template = problem.template.clone().unwrap();
        declared_report(&problem, &template, 1).unwrap()
    };
    let law = "a - b*speed_rpm^p - c*ln(k*feed_mm_min)/feed_mm_min";
    let noisy = declared(problem(NOISE, "force_n", &FORCE), law);
    let truth = [286.44, 5.82e-10, 3.0, 8973.0, 0.039];
    for (constant, truth) in chosen(&noisy).constants.iter().zip(truth) {
        let [low, high] = constant.interval.unwrap();
        assert!(low < truth && truth < high, "{constant:?} {truth}");
    }
    assert_eq!(chosen(&noisy).constants.len(), 5);
    let inputs = ["feed_final_mm_min", "spindle_final_rpm"];
    let table = problem(PaperId::Sdnrp2007.text(), "force_final_n", &inputs);
    let law = "a + b*spindle_final_rpm^3 + c*ln(0.039*feed_final_mm_min)/feed_final_mm_min";
    let determined: Vec<bool> = chosen(&declared(table, law))
        .constants
        .iter()
        .map(|constant| constant.determined)
        .collect();
    assert_eq!(determined, [true, false, false]);
}

#[test]
fn the_search_of_a_paper_runs_beside_and_is_told_apart() {
    let settings = GpSettings { seed: 1, batches: 10, paper: Some(PaperId::Strategy2013) };
    let rows = (1..30).map(|i| vec![f64::from(i), 3.0 + f64::from(i) * f64::from(i)]);
    let mut job = GpJob::new(problem(&table(&["x", "y"], rows), "y", &["x"]), &settings).unwrap();
    job.to_end();
    let report = job.report();
    let paper = report.paper.unwrap();
    assert!(paper.reached && paper.fitness > 0.98 && paper.formula.is_some(), "{paper:?}");
    assert_eq!((paper.paper, report.found_by), ("2013", "default"));
    assert_eq!((paper.population, paper.most_generations), (850, 100));
    assert_eq!((paper.shares, paper.stop, paper.constants), ([0.17, 0.7, 0.2], 0.98, 1000.0));
    assert_eq!(paper.functions, "+ - * ^ ln exp");
}

/// 2007, with two inputs: the larger population, no exp.
#[test]
fn the_report_gives_the_setting_of_the_paper_that_was_set() {
    let settings = GpSettings { seed: 1, batches: 1, paper: Some(PaperId::Sdnrp2007) };
    let mut job = GpJob::new(problem(NOISE, "force_n", &FORCE), &settings).unwrap();
    for _ in 0..60 {
        job.advance(&Budget::steps(50));
    }
    let paper = job.report().paper.unwrap();
    assert_eq!((paper.paper, paper.population, paper.most_generations), ("2007", 1500, 100));
    assert_eq!((paper.shares, paper.stop, paper.constants), ([0.15, 0.5, 0.1], 0.97, 10.0));
    assert_eq!(paper.functions, "+ - * ^ ln");
    assert!(paper.generations < 100);
}

/// Targets of the papers' tables: name, rows, and the least error at rows left out of the simple families
/// that the comparison is with (linear to cubic, 1/x, 1/sqrt x, ln x, powers, exponentials).
fn tables() -> Vec<(&'static str, String, f64)> {
    let columns = |paper: PaperId, x: &str, y: &str| -> Vec<Vec<f64>> {
        let lines: Vec<Vec<&str>> = paper
            .text()
            .lines()
            .filter(|line| !line.starts_with('#'))
            .map(|line| line.split(',').collect())
            .collect();
        let place = |name: &str| lines[0].iter().position(|cell| *cell == name).unwrap();
        let (x, y) = (place(x), place(y));
        let number = |cell: &str| cell.parse::<f64>().unwrap();
        lines[1..].iter().map(|line| vec![number(line[x]), number(line[y])]).collect()
    };
    let (old, new) = (PaperId::Sdnrp2007, PaperId::Strategy2013);
    let restored = |mut rows: Vec<Vec<f64>>| {
        rows[9][0] = 190.2;
        rows
    };
    let text = |rows: Vec<Vec<f64>>| table(&["x", "y"], rows);
    let mut both = columns(old, "ra_desired_um", "f_desired_n");
    let mut final_forces = columns(old, "ra_produced_um", "force_final_n");
    final_forces[9][1] = 190.2;
    both.extend(final_forces);
    let force = "force_final_n";
    vec![
        ("F_d(Ra) 2007", text(columns(old, "ra_desired_um", "f_desired_n")), 0.273),
        ("F(Ra) 2007, row 10 as 190.2 N", text(both), 0.306),
        ("f(F) 2007", text(columns(old, force, "feed_final_mm_min")), 6.03),
        (
            "f(F) 2007, row 10 as 190.2 N",
            text(restored(columns(old, force, "feed_final_mm_min"))),
            3.94,
        ),
        ("n(F) 2007", text(columns(old, force, "spindle_final_rpm")), 25.7),
        (
            "n(F) 2007, row 10 as 190.2 N",
            text(restored(columns(old, force, "spindle_final_rpm"))),
            5.31,
        ),
        ("F_d(Ra) 2013", text(columns(new, "ra_desired_um", "force_initial_n")), 1.15),
        ("f(F) 2013", text(columns(new, force, "feed_final_mm_min")), 7.28),
        ("n(F) 2013", text(columns(new, force, "spindle_final_rpm")), 52.4),
    ]
}

#[test]
fn small_tables_give_small_formulas_that_hold_for_rows_left_out() {
    for (name, text, least) in tables() {
        let report = report(problem(&text, "y", &["x"]), 1, 6);
        let found = chosen(&report);
        let left_out = found.loo_error.unwrap();
        assert!(left_out <= 1.1 * least, "{name}: {left_out} against {least}: {found:?}");
        assert!(found.size <= 11 && found.loo_worst_share.unwrap() < 0.15, "{name}: {found:?}");
        assert!(!found.greyed || report.front.iter().any(|other| other.size > 11), "{name}");
        // As printed, 195.2 N of the tenth row fits neither feed nor speed.
        if ["f(F) 2007", "n(F) 2007"].contains(&name) {
            assert!(
                report.outliers.iter().any(|row| row.row == 10),
                "{name}: {:?}",
                report.outliers
            );
        }
    }
}

#[test]
fn inputs_on_one_line_are_refused_with_their_correlation() {
    for (paper, correlation) in [(PaperId::Sdnrp2007, "-0.995"), (PaperId::Strategy2013, "-0.937")]
    {
        let inputs = ["feed_final_mm_min", "spindle_final_rpm"];
        let problem = problem(paper.text(), "force_final_n", &inputs);
        let error = GpJob::new(problem, &GpSettings::default()).err().unwrap();
        for part in [correlation, "feed_final_mm_min", "spindle_final_rpm"] {
            assert!(error.contains(part), "{error}");
        }
    }
}

#[test]
fn what_is_asked_wrongly_is_refused_with_its_name() {
    let read = |text: &str, target: &str, inputs: &[&str]| {
        let inputs: Vec<String> = inputs.iter().map(|&input| input.to_owned()).collect();
        GpProblem::read(text, target, &inputs).unwrap_err()
    };
    let rows = "x,z,y\n1,1,1\n2,1,4\n3,1,9\n4,1,16\n5,1,25\n";
    for (error, parts) in [
        (read(rows, "w", &["x"]), ["missing are w", "x, z, y"]),
        (read(rows, "y", &["y"]), ["`y`", "target"]),
        (read(rows, "y", &["x", "x"]), ["`x`", "twice"]),
        (read(rows, "y", &["z"]), ["`z` is 1 in every row", ""]),
        (read(&rows[..18], "y", &["x"]), ["rows: at least 5", ""]),
        (read(&rows.replace('9', "nine"), "y", &["x"]), ["line 4: `y` is `nine`", "finite number"]),
        (read(&rows.replace("25", "1e101"), "y", &["x"]), ["`y`", "1e100"]),
    ] {
        assert!(parts.iter().all(|part| error.contains(part)), "{error}");
    }
}

/// What a screen shows of the chosen formula is what the report says of it; of the others it is told by the same
/// rules.
#[test]
fn a_formula_looked_at_closely_is_the_one_of_the_report() {
    let problem = problem(PaperId::Sdnrp2007.text(), "feed_final_mm_min", &["force_final_n"]);
    let report = report(problem.clone(), 1, 20);
    for found in &report.front {
        let seen = FormulaInspection::of(&problem, found, &[], "a test".to_owned()).unwrap();
        assert_eq!(seen.formula.to_string(), found.formula);
        let squares: f64 = seen.residuals.iter().map(|residual| residual * residual).sum();
        let rms = (squares / problem.rows.len() as f64).sqrt();
        assert!((rms / found.error - 1.0).abs() < 1e-12, "{rms} {}", found.error);
        for (row, value) in seen.predicted.iter().enumerate() {
            assert_eq!(problem.rows.target[row] - value, seen.residuals[row]);
        }
        assert_eq!(seen.constants, found.constants);
        // A free search may take the logarithm of a force; the one chosen does not.
        assert!(seen.units.is_ok() || !found.chosen, "{found:?}");
        let units = seen.units.unwrap_or(vec![None; found.constants.len()]);
        assert_eq!(units.len(), found.constants.len());
        assert_eq!(seen.model.is_ok(), found.certified);
        if found.chosen {
            assert_eq!(Some(&seen.ranges), report.ranges.as_ref());
            assert_eq!(seen.residuals, report.residuals);
            let rows = |rows: &[OutlyingRow]| rows.iter().map(|row| row.row).collect::<Vec<_>>();
            assert_eq!(rows(&seen.outliers), rows(&report.outliers));
            for (seen, told) in seen.outliers.iter().zip(&report.outliers) {
                assert!((seen.studentised - told.studentised).abs() < 1e-4);
            }
            // a - b / F: feed, and feed times force.
            assert_eq!(units[0].as_deref(), Some("mm/min"));
            assert_eq!(units[1].as_deref(), Some("N mm/min"));
        }
    }
    assert!(report.chosen().is_some());
}

/// Before the end too: constants fitted to all rows, with their intervals.
#[test]
fn a_formula_of_a_search_under_way_is_looked_at_with_fitted_constants() {
    let problem = problem(PaperId::Sdnrp2007.text(), "feed_final_mm_min", &["force_final_n"]);
    let mut job = WatchedSearch::new(job(problem.clone(), 1, 20));
    assert!(!job.advance(&Budget::steps(300)));
    let so_far = job.partial();
    assert!(so_far.report.is_none() && so_far.standing.front.len() >= 3);
    for found in &so_far.standing.front {
        let seen = FormulaInspection::on_the_way(&problem, found, &[], String::new()).unwrap();
        let squares: f64 = seen.residuals.iter().map(|residual| residual * residual).sum();
        let rms = (squares / problem.rows.len() as f64).sqrt();
        assert!(rms <= found.error * (1.0 + 1e-9), "{rms} {}", found.error);
        assert!(seen.constants.iter().any(|constant| constant.interval.is_some()));
    }
    job.to_end();
    assert_eq!(job.partial().report.as_deref(), Some(&job.job().report()));
}

#[test]
fn a_search_that_is_ended_early_is_one_of_so_many_batches() {
    let problem = problem(PaperId::Sdnrp2007.text(), "feed_final_mm_min", &["force_final_n"]);
    let mut ended = job(problem.clone(), 3, 400);
    while ended.search().batches() < 3 {
        assert!(!ended.advance(&Budget::steps(50)));
    }
    ended.end_here();
    ended.to_end();
    assert_eq!(ended.progress().share(), 1.0);
    let short = report(problem.clone(), 3, 3);
    assert_eq!(ended.report(), short);
    // What is over stays as it is.
    ended.end_here();
    assert_eq!(ended.report(), short);
    // Ended before it began, it has its first batch.
    let mut none = job(problem.clone(), 3, 400);
    none.end_here();
    none.to_end();
    assert_eq!(none.report(), report(problem, 3, 1));
}
