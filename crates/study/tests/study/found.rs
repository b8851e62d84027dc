//! Models found by this program's own genetic programming: that the shipped ones are what the search gives, and
//! how far they meet the papers' tables and the claim of 2013.

use steadycut_core::base::formula::{Interval, Trend};
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::models::genetic::{Calibration, GeneticModels, found};
use steadycut_core::run::job::Job;
use steadycut_study::identify::genetic::GeneticJob;
use steadycut_study::papers::{CalibrationsJob, table};
use steadycut_study::published::PaperId;
use steadycut_study::train::claim::ForceClaimJob;
use steadycut_study::train::data::{RowsJob, TrainingRow, fxy_n};
use steadycut_study::train::genetic;
use steadycut_study::train::recipe::RecipeKind;
use steadycut_study::train::split;
use steadycut_study::verdict::Verdict;

#[test]
fn the_search_gives_the_shipped_models() {
    for paper in PaperId::ALL {
        let mut job = GeneticJob::new(*paper, &paper.rows());
        job.to_end();
        assert_eq!(job.refusal(), None);
        let file = job.partial().file();
        assert_eq!(file.as_deref(), paper.model_set().found_file(), "{paper:?}");
    }
}

#[test]
fn another_table_gives_other_models() {
    let mut rows = PaperId::Strategy2013.rows();
    rows[3].force_final_n += 1.0;
    let mut job = GeneticJob::new(PaperId::Strategy2013, &rows).of_batches(2);
    job.to_end();
    let shipped = PaperId::Strategy2013.model_set().found_file().map(str::to_owned);
    assert!(job.refusal().is_some() || job.partial().file() != shipped);
}

#[test]
fn shipped_commands_are_certain_to_be_monotone_on_their_ranges() {
    for paper in PaperId::ALL {
        let own = found::parse(paper.model_set().found_file().unwrap()).unwrap();
        for (model, trends) in [
            (own.force_of_ra, vec![Trend::Rising]),
            (own.feed, vec![Trend::Rising]),
            (own.speed, vec![Trend::Falling]),
            (own.ra, vec![Trend::Rising]),
            (own.force, vec![Trend::Rising, Trend::Falling]),
        ] {
            let model = model.unwrap();
            let ranges: Vec<Interval> = model.inputs().iter().map(|input| input.range).collect();
            assert_eq!(model.formula().certify(&ranges).unwrap().trends, trends, "{model:?}");
            assert!(model.source().contains("seed 1") && model.units().is_ok(), "{model:?}");
        }
    }
}

#[test]
fn the_loop_meets_every_row_of_both_tables_with_them() {
    for paper in PaperId::ALL {
        let table = table(*paper, Calibration::Genetic, ForceModel::Formula);
        assert!(table.all_met(), "{table:?}");
        let mut all = CalibrationsJob::new(*paper);
        all.to_end();
        for (calibration, met) in Calibration::PUBLISHED.iter().zip(all.partial()) {
            let [met, of] = met.met();
            assert_eq!(of, 4 * paper.rows().len());
            let fitted = [Calibration::Identified, Calibration::Genetic].contains(calibration);
            assert_eq!(met == of, fitted, "{calibration:?} {met}");
        }
    }
}

/// Not the identified models under another name.
#[test]
fn they_are_models_of_their_own() {
    for paper in PaperId::ALL {
        let set = paper.model_set();
        let [found, fitted] = [Calibration::Genetic, Calibration::Identified]
            .map(|calibration| GeneticModels::new(set, calibration));
        let force_n = 180.0;
        assert_ne!(found.feed_from_force(force_n), fitted.feed_from_force(force_n));
        assert_ne!(found.ra_from_force(force_n), fitted.ra_from_force(force_n));
        let inverse_n = found.force_from_ra(found.ra_from_force(force_n).value).value;
        assert!((inverse_n - force_n).abs() < 2.5, "model 5 beside model 1: {inverse_n}");
    }
}

#[test]
fn the_claim_of_2013_is_judged_over_rows_that_nobody_was_trained_on() {
    let mut job = ForceClaimJob::default();
    job.to_end();
    let claim = job.partial();
    let errors: Vec<f64> =
        claim.contenders.iter().map(|contender| contender.errors.mean_percent).collect();
    let claimed: Vec<f64> =
        claim.contenders.iter().map(|contender| contender.claimed_percent).collect();
    assert_eq!(claimed, [4.0, 4.0, 6.0]);
    // As README has them.
    for (error, stated) in errors.iter().zip(STATED_PERCENT) {
        assert!((error - stated).abs() < 0.05, "{errors:?}");
    }
    let found: Vec<Verdict> = claim.statements.iter().map(|statement| statement.verdict).collect();
    let [yes, no] = [Verdict::Holds, Verdict::Not];
    assert_eq!(found, [no, yes, no, no, yes], "{:?}", claim.statements);
    // The formula by its own file, over the rows that it was found on: as good there as on fresh ones.
    let recipe = RecipeKind::Literal.recipe();
    let rows: Vec<TrainingRow> = RowsJob::measured(recipe.rows, recipe.seed).complete();
    let (training, _) = split(&rows);
    let model = genetic::shipped();
    let off = training.iter().map(|row| {
        let force_n = fxy_n(&row.forces_n);
        (genetic::force_n(&model, row) / force_n - 1.0).abs()
    });
    let mean_percent = 100.0 * off.sum::<f64>() / training.len() as f64;
    assert!((mean_percent - errors[2]).abs() < 1.5, "{mean_percent} {errors:?}");
}

/// Mean errors of the literal network, the improved one and the formula, percent.
const STATED_PERCENT: [f64; 3] = [6.7, 2.5, 6.2];
