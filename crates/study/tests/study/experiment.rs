//! Design of experiments: what plans can tell, against textbooks and against fits; sheets; cuts on the simulator;
//! the way from cuts to a controller.

use steadycut_core::base::math;
use steadycut_core::base::rng::Stream;
use steadycut_core::base::stats;
use steadycut_core::run::digest::Digest;
use steadycut_core::run::job::Job;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_study::experiment::assess::{
    ExperimentAssessment, MeasuringNoise, TermVerdict, assess,
};
use steadycut_study::experiment::design::StarDistance;
use steadycut_study::experiment::factor::ExperimentFactor;
use steadycut_study::experiment::filled::FilledSheet;
use steadycut_study::experiment::fraction::RegularFraction;
use steadycut_study::experiment::measure::{MeasureJob, MeasuredCut};
use steadycut_study::experiment::plan::{ExperimentDesign, ExperimentPlan, PlanRequest};
use steadycut_study::experiment::sheet::{SheetHead, csv, html};
use steadycut_study::experiment::terms::{DeclaredModel, TermSet};
use steadycut_study::identify::gp::problem::GpProblem;
use steadycut_study::published::PaperId;

const UNIT: MeasuringNoise = MeasuringNoise { force_n: 1.0, ra_um: 0.1 };

fn plan(factors: &[&str], design: ExperimentDesign, centre: usize) -> ExperimentPlan {
    let scenario = Scenario::default();
    let read = |text: &&str| ExperimentFactor::read(text, &scenario).unwrap();
    let factors = factors.iter().map(read).collect();
    ExperimentPlan::new(&PlanRequest { factors, design, centre, replicates: 1, seed: 3 }).unwrap()
}

fn told(plan: &ExperimentPlan, model: DeclaredModel) -> ExperimentAssessment {
    assess(plan, &TermSet::declared(model, plan).unwrap(), UNIT)
}

fn close(a: f64, b: f64, by: f64) -> bool {
    (a - b).abs() <= by * b.abs().max(1e-12)
}

/// The 2^3 factorial: every standard error sigma / sqrt(8), no inflation, condition 1.
#[test]
fn a_factorial_is_orthogonal() {
    let all = plan(&["feed", "speed", "hardness"], ExperimentDesign::Full { levels: 2 }, 0);
    let told = told(&all, DeclaredModel::Interactions);
    assert_eq!((told.runs, told.rank, told.freedom, told.repeated), (8, 7, 1, 0));
    for term in &told.terms {
        assert!(close(term.standard_error_n.unwrap(), 1.0 / 8.0_f64.sqrt(), 1e-12), "{term:?}");
        assert!(term.inflation.is_none_or(|inflation| close(inflation, 1.0, 1e-12)), "{term:?}");
        assert_eq!(term.verdict, TermVerdict::Told);
    }
    assert!(close(told.condition, 1.0, 1e-12) && told.correlated.is_empty(), "{told:?}");
    assert!(told.leverages.iter().all(|leverage| close(*leverage, 7.0 / 8.0, 1e-12)));
    assert!(close(told.prediction.middle_n, 1.0 / 8.0_f64.sqrt(), 1e-12));
}

/// 2^(4-1) with D = ABC: AB = CD, AC = BD, AD = BC.
#[test]
fn what_a_fraction_mixes_up_is_said_of_the_terms() {
    let half = RegularFraction::new(4, &["D=ABC"]).unwrap();
    let factors = ["feed", "speed", "axial_depth", "hardness"];
    let told =
        told(&plan(&factors, ExperimentDesign::Fraction(half), 0), DeclaredModel::Interactions);
    let aliases: Vec<String> = told.aliases.iter().map(ToString::to_string).collect();
    assert_eq!(
        aliases,
        [
            "speed * axial_depth = feed * hardness",
            "speed * hardness = feed * axial_depth",
            "axial_depth * hardness = feed * speed"
        ]
    );
    assert_eq!((told.rank, told.terms.len()), (8, 11));
    for term in &told.terms {
        let mixed = term.term.contains('*');
        let expected = if mixed { TermVerdict::Aliased } else { TermVerdict::Told };
        assert_eq!(term.verdict, expected, "{term:?}");
        assert_eq!(term.standard_error_n.is_none(), mixed);
    }
}

#[test]
fn leverages_sum_to_the_number_of_terms_that_are_told() {
    let full = RegularFraction::full(3).unwrap();
    let stars = StarDistance::Rotatable;
    let designs = [
        (ExperimentDesign::Full { levels: 3 }, 2),
        (ExperimentDesign::Composite { corners: full.clone(), stars }, 4),
        (ExperimentDesign::Composite { corners: full, stars: StarDistance::Faced }, 1),
        (ExperimentDesign::Hypercube { points: 17 }, 0),
    ];
    for (design, centre) in designs {
        let plan = plan(&["feed", "speed", "wear"], design, centre);
        for model in DeclaredModel::ALL {
            let told = told(&plan, *model);
            let sum: f64 = told.leverages.iter().sum();
            assert!(close(sum, told.rank as f64, 1e-9), "{model:?}: {sum} {}", told.rank);
            assert!(told.leverages.iter().all(|leverage| (0.0..=1.0 + 1e-9).contains(leverage)));
        }
    }
}

/// With two terms the inflation is 1 / (1 - r^2).
#[test]
fn inflation_is_what_the_correlation_makes_of_it() {
    let text = "feed_mm_min,speed_rpm\n100,1000\n200,1150\n300,1100\n400,1300\n500,1350\n";
    let plan = ExperimentPlan::given(text).unwrap();
    let told = told(&plan, DeclaredModel::Linear);
    let column = |place: usize| plan.runs.iter().map(|run| run.values[place]).collect::<Vec<_>>();
    let r = stats::correlation(&column(0), &column(1)).unwrap();
    for term in &told.terms[1..] {
        assert!(close(term.inflation.unwrap(), 1.0 / (1.0 - r * r), 1e-9), "{term:?}");
    }
    assert!(close(told.correlated[0].2, r, 1e-12));
}

/// 2007 Table 3: final feeds and speeds lie on one line, r = -0.995.
#[test]
fn the_papers_table_hardly_tells_feed_from_speed() {
    let plan = ExperimentPlan::given(PaperId::Sdnrp2007.text()).unwrap();
    for model in [DeclaredModel::Papers, DeclaredModel::Linear] {
        let told = told(&plan, model);
        for term in &told.terms[1..] {
            assert_eq!(term.verdict, TermVerdict::Hardly, "{term:?}");
            assert!(term.inflation.unwrap() > 100.0 && term.nearest.is_some());
        }
    }
    // Cut over the box, the same terms are told.
    let beside = plan_of_box(40);
    let told = told(&beside, DeclaredModel::Papers);
    assert!(told.terms.iter().all(|term| term.verdict == TermVerdict::Told), "{told:?}");
}

fn plan_of_box(points: usize) -> ExperimentPlan {
    plan(&["feed", "speed"], ExperimentDesign::Hypercube { points }, 0)
}

/// Least squares by the normal equations, on their own: Gauss with pivots.
fn fitted(rows: &[Vec<f64>], y: &[f64]) -> Vec<f64> {
    let count = rows[0].len();
    let scale: Vec<f64> =
        (0..count).map(|j| rows.iter().map(|row| row[j].abs()).fold(0.0, f64::max)).collect();
    let mut m: Vec<Vec<f64>> = (0..count)
        .map(|i| {
            let at = |row: &Vec<f64>, j: usize| row[j] / scale[j];
            let normal = (0..count).map(|j| rows.iter().map(|row| at(row, i) * at(row, j)).sum());
            let right = rows.iter().zip(y).map(|(row, y)| at(row, i) * y).sum::<f64>();
            normal.chain([right]).collect()
        })
        .collect();
    for k in 0..count {
        let pivot = (k..count).max_by(|a, b| m[*a][k].abs().total_cmp(&m[*b][k].abs())).unwrap();
        m.swap(k, pivot);
        let row = m[k].clone();
        for (_, other) in m.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = other[k] / row[k];
            other.iter_mut().zip(&row).skip(k).for_each(|(x, taken)| *x -= factor * taken);
        }
    }
    (0..count).map(|k| m[k][count] / m[k][k] / scale[k]).collect()
}

/// Standard errors that are expected before a chip is cut are those of many fits to noisy cuts.
#[test]
fn standard_errors_are_those_of_many_noisy_experiments() {
    let corners = RegularFraction::full(2).unwrap();
    let stars = StarDistance::Given(1.5);
    let composite = ExperimentDesign::Composite { corners, stars };
    let cases = [
        (plan(&["feed", "speed"], composite, 3), DeclaredModel::Quadratic),
        (plan_of_box(15), DeclaredModel::Papers),
    ];
    for (plan, model) in cases {
        let terms = TermSet::declared(model, &plan).unwrap();
        let noise = MeasuringNoise { force_n: 2.0, ra_um: 0.0 };
        let told = assess(&plan, &terms, noise);
        let rows: Vec<Vec<f64>> =
            plan.runs.iter().map(|run| terms.row(&plan, &run.values)).collect();
        let middle =
            terms.row(&plan, &plan.factors.iter().map(|f| f.value(0.0)).collect::<Vec<_>>());
        let stream = Stream::new(17, "test");
        let trials = 4000;
        let mut constants = vec![Vec::new(); terms.names.len()];
        let mut predictions = Vec::new();
        for trial in 0..trials {
            let draw = |run: usize| 2.0 * stream.normal(trial * rows.len() as u64 + run as u64);
            let y: Vec<f64> = (0..rows.len()).map(draw).collect();
            let fit = fitted(&rows, &y);
            predictions.push(fit.iter().zip(&middle).map(|(c, x)| c * x).sum());
            constants.iter_mut().zip(fit).for_each(|(all, c)| all.push(c));
        }
        // 4000 trials tell a standard deviation to 1.1 %.
        for (term, found) in told.terms.iter().zip(&constants) {
            let found = stats::deviation(found).unwrap();
            let expected = term.standard_error_n.unwrap();
            assert!(close(found, expected, 0.045), "{}: {found} {expected}", term.term);
        }
        let found = stats::deviation(&predictions).unwrap();
        assert!(close(found, told.prediction.middle_n, 0.045), "{found} {:?}", told.prediction);
    }
}

/// In a rotatable design the error of a prediction is the same at the same distance from the middle.
#[test]
fn a_rotatable_design_predicts_as_well_in_every_direction() {
    let error = |stars: StarDistance, angle: f64| {
        let corners = RegularFraction::full(2).unwrap();
        let plan = plan(
            &["feed=0100..1100", "speed=1000..2000"],
            ExperimentDesign::Composite { corners, stars },
            4,
        );
        let terms = TermSet::declared(DeclaredModel::Quadratic, &plan).unwrap();
        let rows: Vec<Vec<f64>> =
            plan.runs.iter().map(|run| terms.row(&plan, &run.values)).collect();
        let at: Vec<f64> = [math::cos(angle), math::sin(angle)]
            .iter()
            .zip(&plan.factors)
            .map(|(x, factor)| {
                let [low, high] = factor.range();
                0.5 * (low + high) + 0.4 * x * (high - low)
            })
            .collect();
        let row = terms.row(&plan, &at);
        // x' C x is the sum of squares of the weights of all runs in the prediction.
        let weight = |run: usize| {
            let mut y = vec![0.0; rows.len()];
            y[run] = 1.0;
            fitted(&rows, &y).iter().zip(&row).map(|(c, x)| c * x).sum::<f64>()
        };
        (0..rows.len()).map(|run| weight(run) * weight(run)).sum::<f64>()
    };
    let angles = [0.0, 0.4, 0.785, 1.2, 1.571];
    let [spread, faced] = [StarDistance::Rotatable, StarDistance::Faced].map(|stars| {
        let [least, most] = math::extent(angles.into_iter().map(|angle| error(stars, angle)));
        most / least - 1.0
    });
    // Levels are rounded to what a shop can set.
    assert!(spread < 2e-3 && faced > 0.05, "{spread} {faced}");
}

#[test]
fn composite_and_hypercube_are_cut_with_every_cutter_and_names_tell_plans_apart() {
    let factors = ["feed", "speed", "tool=ball-6-2,ball-10-2,square-12-4"];
    let corners = RegularFraction::full(2).unwrap();
    let stars = StarDistance::Faced;
    let composite = plan(&factors, ExperimentDesign::Composite { corners, stars }, 2);
    assert_eq!(composite.runs.len(), 3 * (4 + 4 + 2));
    let told = told(&composite, DeclaredModel::Interactions);
    // 1, feed, speed, two cutters, feed speed, and both with two cutters.
    assert_eq!((told.terms.len(), told.rank), (10, 10));
    assert!(told.terms.iter().all(|term| term.verdict == TermVerdict::Told), "{told:?}");
    let hypercube = plan(&factors, ExperimentDesign::Hypercube { points: 5 }, 0);
    assert_eq!(hypercube.runs.len(), 15);
    let full = plan(&factors, ExperimentDesign::Full { levels: 2 }, 0);
    assert_eq!(full.runs.len(), 12);
    let names = [&composite.id, &hypercube.id, &full.id];
    assert!(names[0] != names[1] && names[1] != names[2] && names[0] != names[2]);
    let mut order: Vec<usize> = full.runs.iter().map(|run| run.order).collect();
    assert!(!order.iter().copied().eq(1..=12), "the order is random");
    order.sort_unstable();
    assert!(order.into_iter().eq(1..=12));
}

fn noise() -> MeasuringNoise {
    MeasuringNoise { force_n: 1.5, ra_um: 0.02 }
}

fn cut(plan: &ExperimentPlan, preset: &str, seed: u64) -> Vec<MeasuredCut> {
    let mut job = MeasureJob::new(plan, &load(preset).unwrap(), noise(), seed).unwrap();
    job.to_end();
    job.measured().to_vec()
}

/// K4 restored and K5 are what the simulator cuts by: what is measured is that and the noise asked for.
#[test]
fn cuts_measure_the_plant_with_the_noise_asked_for() {
    let plan = plan_of_box(300);
    let cuts = cut(&plan, "table3-5", 5);
    let truth = load("table3-5").unwrap().of_plant();
    let mut off = [Vec::new(), Vec::new()];
    for (run, cut) in plan.runs.iter().zip(&cuts) {
        let force = truth.force(run.values[0], run.values[1]).value;
        off[0].push((cut.force_n.unwrap() - force) / noise().force_n);
        off[1].push((cut.ra_um.unwrap() - truth.ra_from_force(force).value) / noise().ra_um);
    }
    for off in &off {
        let (mean, deviation) =
            (stats::mean(off.iter().copied()).unwrap(), stats::deviation(off).unwrap());
        assert!(mean.abs() < 0.2 && (0.9..1.1).contains(&deviation), "{mean} {deviation}");
    }
    let both = stats::correlation(&off[0], &off[1]).unwrap();
    assert!(both.abs() < 0.2, "noises of their own: {both}");
    assert_eq!(cut(&plan, "table3-5", 5), cuts);
    assert_ne!(cut(&plan, "table3-5", 6), cuts);
}

/// Names of plans are digests of all their values, and cuts are measured to the bit.
#[test]
fn bits_of_an_experiment_are_those_that_they_were() {
    let plan = plan(&["feed", "speed", "hardness"], ExperimentDesign::Hypercube { points: 12 }, 0);
    let cuts = cut(&plan, "table3-5-noise", 4);
    let mut digest = Digest::default();
    for value in cuts.iter().flat_map(|cut| [cut.force_n, cut.ra_um]) {
        digest.word(value.unwrap().to_bits());
    }
    let told = told(&plan, DeclaredModel::Quadratic);
    told.leverages.iter().for_each(|leverage| digest.word(leverage.to_bits()));
    digest.word(told.condition.to_bits());
    assert_eq!([plan.id, digest.hex()], ["plan-6de567ae", "43896a0ccfb4b29d"]);
}

/// A crash and a force beyond K5 are told, not measured.
#[test]
fn what_cannot_be_measured_is_said() {
    let text = "feed_mm_min,speed_rpm\n5000,100\n300,2000\n70,3900\n";
    let cuts = cut(&ExperimentPlan::given(text).unwrap(), "table3-5", 1);
    assert!(
        cuts[0].force_n.is_none() && cuts[0].problem.as_ref().unwrap().contains("5000"),
        "{cuts:?}"
    );
    assert!(cuts[1].is_whole() && cuts[1].problem.is_none());
    assert!(cuts[2].force_n.is_some() && cuts[2].ra_um.is_none() && cuts[2].problem.is_some());
}

#[test]
fn a_sheet_goes_out_and_comes_back() {
    let plan = plan(&["feed", "tool=ball-6-2,ball-10-2"], ExperimentDesign::Full { levels: 3 }, 0);
    let empty = csv(&plan, None);
    let read = FilledSheet::read(&empty, &plan).unwrap();
    assert_eq!(read.missing(), [1, 2, 3, 4, 5, 6]);
    // Filled in by a spreadsheet of another country, one cut forgotten.
    let mut lines: Vec<String> = empty.lines().map(|line| line.replace(',', ";")).collect();
    for (number, line) in lines.iter_mut().enumerate().skip(1) {
        let filled = if number == 3 { ";;;".to_owned() } else { format!(";18{number},5;0,7;") };
        *line = line.replace(";;;", &filled);
    }
    let text = lines.join("\r\n");
    let read = FilledSheet::read(&text, &plan).unwrap();
    let forgotten = plan.in_order()[2].run;
    assert_eq!(read.missing(), [forgotten]);
    let first = plan.in_order()[0].run;
    assert_eq!(read.cuts[first - 1].force_n, Some(181.5));
    assert_eq!(read.cuts[first - 1].ra_um, Some(0.7));
    // The same table goes to the search as it is, once it is whole.
    let measured: Vec<MeasuredCut> = (0..6)
        .map(|i| MeasuredCut {
            force_n: Some(170.0 + f64::from(i)),
            ra_um: Some(0.5),
            problem: None,
        })
        .collect();
    let whole = csv(&plan, Some(&measured));
    let problem = GpProblem::read(&whole, "force_n", &["feed_mm_min".to_owned()]).unwrap();
    assert_eq!(problem.rows.len(), 6);
    assert_eq!(FilledSheet::read(&whole, &plan).unwrap().cuts, measured);
}

#[test]
fn a_sheet_that_is_not_the_plan_s_is_refused_with_line_and_value() {
    let plan = plan(&["feed", "speed"], ExperimentDesign::Full { levels: 2 }, 0);
    let sheet = csv(&plan, None);
    let other = plan_of_box(4);
    let first = sheet.lines().nth(1).unwrap();
    let cases: [(String, &[&str]); 6] = [
        (csv(&other, None), &["line 2", &other.id, &plan.id]),
        (
            sheet.replacen(first, &first.replace("600", "610"), 1),
            &["line 2", "`feed_mm_min`", "600"],
        ),
        (sheet.replacen(first, &first.replace(",,,", ",x,,"), 1), &["line 2", "`force_n`", "`x`"]),
        (sheet.replacen(first, &first.replace(",,,", ",,-1,"), 1), &["`ra_um`", "positive"]),
        (format!("{sheet}{first}\n"), &["line 6", "twice"]),
        (sheet.replacen(first, &format!("1,9{}", &first[3..]), 1), &["line 2", "`run`", "1 to 4"]),
    ];
    for (text, parts) in cases {
        let error = FilledSheet::read(&text, &plan).unwrap_err();
        assert!(parts.iter().all(|part| error.contains(part)), "{parts:?}: {error}");
    }
}

#[test]
fn the_page_needs_nothing_besides_and_has_a_line_for_every_cut() {
    let plan = plan(&["feed", "hardness"], ExperimentDesign::Full { levels: 3 }, 0);
    let head = SheetHead {
        title: "A <cut> & more".to_owned(),
        fixed: vec![("Material".to_owned(), "\"ck45\"".to_owned())],
        command: "steadycut experiment --factor 'feed'".to_owned(),
    };
    let page = html(&plan, &head);
    assert_eq!(page.matches("<tr>").count(), 9 + 1);
    assert_eq!(page.matches("class=\"fill\"").count(), 3 * 9);
    for part in
        ["A &lt;cut&gt; &amp; more", "&quot;ck45&quot;", &plan.id, "mm/min", "HB", "@media print"]
    {
        assert!(page.contains(part), "{part}");
    }
    for foreign in ["http", "src=", "<script", "url(", "<cut>"] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    // In the order of cutting.
    let orders: Vec<usize> = page
        .split("<tr><td>")
        .skip(1)
        .map(|row| row.split('<').next().unwrap().parse().unwrap())
        .collect();
    assert!(orders.into_iter().eq(1..=9));
}
