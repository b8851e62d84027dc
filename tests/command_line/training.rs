//! The neural force model: the shipped networks keep what is said of them, training repeats, and
//! the commands answer.

use steadycut::base::network::parse;
use steadycut::models::neural_force::{NeuralForce, NeuralKind};
use steadycut::study::train::TrainingSession;
use steadycut::study::train::data::{RowsJob, TrainingRow};
use steadycut::study::train::errors::{TrainingErrors, of_components};
use steadycut::study::train::formula::fit_all;
use steadycut::study::train::recipe::{RecipeKind, TrainingRecipe};

use super::program::{json, steadycut};

fn errors(kind: NeuralKind, rows: &[TrainingRow]) -> TrainingErrors {
    let force = NeuralForce::shipped(kind);
    of_components(rows, |row| force.components(&row.cut))
}

#[test]
fn shipped_networks_err_as_stated_on_rows_never_seen() {
    // Another seed than the one that the recipes were chosen with.
    let rows: Vec<TrainingRow> = RowsJob::fresh(250, 77).complete();
    let improved = errors(NeuralKind::Improved, &rows);
    assert!(improved.mean_percent < 3.2, "{improved:?}");
    assert!(improved.median_percent < 2.3, "{improved:?}");
    assert!(improved.mean_above_200_n_percent < 2.9, "{improved:?}");
    let literal = errors(NeuralKind::Literal, &rows);
    assert!((5.9..8.2).contains(&literal.mean_percent), "{literal:?}");
    for row in &rows {
        let at = NeuralForce::shipped(NeuralKind::Improved).at(&row.cut);
        assert!(at.peak(row.cut.feed_mm_min, row.cut.speed_rpm).valid, "{row:?}");
    }
}

#[test]
fn the_network_beats_every_formula_fitted_to_such_rows() {
    let measured: Vec<TrainingRow> = RowsJob::measured(300, 78).complete();
    let fresh: Vec<TrainingRow> = RowsJob::fresh(100, 78).complete();
    let formulas = fit_all(&measured, &fresh).unwrap();
    assert!(formulas.windows(2).all(|p| p[0].errors.mean_percent <= p[1].errors.mean_percent));
    let network = errors(NeuralKind::Improved, &fresh).mean_percent;
    assert!(network < formulas[0].errors.mean_percent, "{network} {formulas:?}");
}

#[test]
fn shipped_files_say_how_they_were_made() {
    for kind in RecipeKind::ALL {
        let Some(shipped) = kind.shipped() else { continue };
        let recipe = kind.recipe();
        let force = NeuralForce::shipped(shipped);
        let made = force.provenance();
        assert!(made.note.contains("never published") && made.note.contains("mechanistic"));
        assert_eq!((made.rows, made.seed, made.epochs), (recipe.rows, recipe.seed, recipe.epochs));
        let learning = recipe.learning;
        assert_eq!(
            [made.rate, made.momentum, made.decay],
            [learning.rate, learning.momentum, learning.decay]
        );
        assert_eq!(force.network().network.sizes(), recipe.sizes());
        assert_eq!(force.network().scaling.ln_inputs, recipe.ln_inputs);
    }
}

#[test]
fn training_repeats_to_the_bit_and_its_file_is_its_network() {
    let recipe = TrainingRecipe { rows: 150, epochs: 20, ..RecipeKind::Improved.recipe() };
    let measured: Vec<TrainingRow> = RowsJob::measured(recipe.rows, recipe.seed).complete();
    let train = |recipe: &TrainingRecipe| {
        let mut session = TrainingSession::new(recipe, &measured).unwrap();
        let errors: Vec<f64> = (0..recipe.epochs).map(|_| session.epoch()).collect();
        (errors, session)
    };
    let (errors, session) = train(&recipe);
    assert!(errors[19] < 0.5 * errors[0], "{errors:?}");
    assert_eq!(session.file(), train(&recipe).1.file());
    assert_eq!(parse(&session.file()).unwrap().0, session.network());
    let other = TrainingRecipe { seed: 3, ..recipe };
    assert_ne!(session.file(), train(&other).1.file());
}

#[test]
fn the_grid_of_bits_is_finite_and_not_of_one_value() {
    let words = NeuralForce::output_bits();
    assert!(words.len() >= 500 && words.iter().all(|word| f64::from_bits(*word).is_finite()));
    let mut different = words.clone();
    different.sort_unstable();
    different.dedup();
    assert!(different.len() > words.len() / 2);
    assert_eq!(words, NeuralForce::output_bits());
}

#[test]
fn train_force_prints_what_it_made() {
    let args = ["train", "force", "--rows", "200", "--epochs", "3", "--hidden", "5,3,7", "--no-ln"];
    let printed = json(&[&args[..], &["--activation", "tanh", "--json"]].concat());
    assert_eq!(printed["equals_shipped"], false);
    let report = &printed["report"];
    assert_eq!(report["sizes"], serde_json::json!([8, 5, 3, 7, 3]));
    assert_eq!((&report["activation"], &report["ln_inputs"][0]), (&"tanh".into(), &false.into()));
    assert_eq!(report["training"]["rows"], 160);
    assert_eq!(report["hold_out"]["rows"], 40);
    assert_eq!(report["fresh"]["rows"], 1000);
    assert_eq!(report["paper_claims_percent"], serde_json::json!([4.0, 6.0]));
    assert!(report["data"].as_str().unwrap().contains("never published"));
}

#[test]
fn the_force_table_stands_beside_the_reference() {
    let table = json(&["force", "--json"]);
    let rows = table["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 7);
    for row in rows {
        let [computed, reference] =
            ["computed_n", "reference_n"].map(|name| row[name][3].as_f64().unwrap());
        assert!((computed / reference - 1.0).abs() < 5e-3, "{row}");
    }
    assert!((rows[0]["limit_percent"].as_f64().unwrap() + 3.0).abs() < 1.0);
}

#[test]
fn faulty_arguments_are_answered_by_name() {
    for (args, named) in [
        (&["train", "force", "--rate", "NaN"][..], "0 to 1"),
        (&["train", "force", "--rows", "5"], "100..=20000"),
        (&["train", "force", "--activation", "relu"], "arctan, tanh, sine, sigmoid"),
        (&["train", "force", "--recipe", "best"], "improved, literal, 2005"),
        (&["train", "force", "--rows", "100", "--hidden", "33"], "`sizes`"),
        (&["train", "force", "--check", "--seed", "3"], "--check"),
        (&["train"], "--study"),
    ] {
        let output = steadycut(args);
        assert!(!output.status.success(), "{args:?}");
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(error.contains(named), "{args:?}: {error}");
    }
}
