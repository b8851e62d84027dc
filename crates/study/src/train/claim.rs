//! The 2013 paper's claim about its network and its best formula, 4 % against 6 % off the measurements, repeated:
//! the network trained as the paper does, an improved one, and the formula that genetic programming finds on the
//! same rows, all judged over the same fresh rows.

use serde::Serialize;

use super::data::{FRESH_ROWS, NOTE, RowsJob, TrainingRow};
use super::errors::{TrainingErrors, of_components, of_fxy};
use super::genetic;
use super::recipe::RecipeKind;
use super::report::CLAIM_PERCENT;
use crate::base::language::{text, tr};
use crate::models::neural_force::{NeuralForce, NeuralKind};
use crate::run::job::{Budget, Job, Progress};
use crate::verdict::Verdict;

/// Errors that differ by no more than this from the claimed one are taken for it, percentage points (chosen: half
/// of what lies between the two claims).
pub const NEAR_PERCENT: f64 = 1.0;

/// One of the models compared.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForceContender {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub what: &'static str,
    /// The error that the paper claims for a model of this kind, percent.
    pub claimed_percent: f64,
    /// Errors over the fresh rows.
    pub errors: TrainingErrors,
}

/// A part of the claim, as it is tested.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForceStatement {
    /// The statement.
    pub statement: String,
    /// Whether it holds here.
    pub verdict: Verdict,
}

/// The claim with what is found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForceClaim {
    /// As the paper says it.
    pub paper: &'static str,
    /// What the data are.
    pub data: &'static str,
    /// Rows that judge.
    pub fresh_rows: usize,
    /// The models.
    pub contenders: Vec<ForceContender>,
    /// The parts of the claim.
    pub statements: Vec<ForceStatement>,
    /// The formula of the genetic contender, F_xy in N.
    pub formula: String,
}

const PAPER: &str = text!(
    "\"neural network predictions were by 4 % closer to the measurements, compared to 6 %\" of the best formula, read \
     as mean errors"
);

fn contenders(rows: &[TrainingRow]) -> Vec<ForceContender> {
    let [network, formula] = CLAIM_PERCENT;
    let of = |kind: NeuralKind| {
        let force = NeuralForce::shipped(kind);
        of_components(rows, |row| force.components(&row.cut))
    };
    let model = genetic::shipped();
    vec![
        ForceContender {
            name: text!("literal network"),
            what: text!("inputs, activation and learning as the paper has them"),
            claimed_percent: network,
            errors: of(NeuralKind::Literal),
        },
        ForceContender {
            name: text!("improved network"),
            what: text!("logarithms of the inputs, other learning"),
            claimed_percent: network,
            errors: of(NeuralKind::Improved),
        },
        ForceContender {
            name: text!("genetic programming"),
            what: text!("a formula of the same inputs, found here"),
            claimed_percent: formula,
            errors: of_fxy(rows, |row| genetic::force_n(&model, row)),
        },
    ]
}

fn statements(contenders: &[ForceContender]) -> Vec<ForceStatement> {
    let [literal, improved, formula] = contenders else { return Vec::new() };
    let mean = |contender: &ForceContender| contender.errors.mean_percent;
    let closer = |network: &ForceContender| ForceStatement {
        statement: tr!(
            "the {network} is closer than the formula: {own:.1} % against {formula:.1} %",
            network = tr(network.name),
            own = mean(network),
            formula = mean(formula)
        ),
        verdict: Verdict::from(mean(network) < mean(formula)),
    };
    let near = |contender: &ForceContender| ForceStatement {
        statement: tr!(
            "{name}: {own:.1} % where the paper has {paper} %, within {near} percentage point",
            name = tr(contender.name),
            own = mean(contender),
            paper = contender.claimed_percent,
            near = NEAR_PERCENT
        ),
        verdict: Verdict::from((mean(contender) - contender.claimed_percent).abs() <= NEAR_PERCENT),
    };
    vec![closer(literal), closer(improved), near(literal), near(improved), near(formula)]
}

/// The contenders judged, row by row.
#[derive(Clone, Debug)]
pub struct ForceClaimJob {
    rows: RowsJob,
}

impl Default for ForceClaimJob {
    fn default() -> Self {
        Self::new(FRESH_ROWS)
    }
}

impl ForceClaimJob {
    /// A comparison over so many fresh rows, those that `steadycut train force` judges by.
    #[must_use]
    pub fn new(rows: u32) -> Self {
        Self { rows: RowsJob::fresh(rows, RecipeKind::Literal.recipe().seed) }
    }
}

/// A step is a row.
impl Job for ForceClaimJob {
    /// The claim over the rows so far; without rows it has no contenders.
    type Partial = ForceClaim;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        self.rows.advance(budget)
    }

    fn progress(&self) -> Progress {
        self.rows.progress()
    }

    fn partial(&self) -> ForceClaim {
        let rows = self.rows.rows();
        let contenders = if rows.is_empty() { Vec::new() } else { contenders(rows) };
        ForceClaim {
            paper: PAPER,
            data: NOTE,
            fresh_rows: rows.len(),
            statements: statements(&contenders),
            contenders,
            formula: genetic::shipped().formula().to_string(),
        }
    }

    fn refusal(&self) -> Option<&str> {
        self.rows.refusal()
    }
}
