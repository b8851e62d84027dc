//! The plan of an experiment: its runs with the values of all factors, in standard and in random order.

use serde::Serialize;

use super::design::{
    DesignPoint, RunRole, StarDistance, centres, composite, full_factorial, hypercube, two_levels,
};
use super::factor::{ExperimentFactor, FactorKind, FactorSpan, FactorTold};
use super::fraction::RegularFraction;
use crate::base::language::tr;
use crate::base::math::extent;
use crate::base::rng::Stream;
use crate::base::settings::Value;
use crate::csv_table::CsvTable;
use crate::run::digest::Digest;
use crate::run::scenario::Scenario;

/// Most runs of a plan.
pub const MAX_PLANNED: usize = 10_000;
/// Most factors of a plan.
pub const MAX_FACTORS: usize = 7;

/// A design with what belongs to it.
#[derive(Clone, Debug, PartialEq)]
pub enum ExperimentDesign {
    /// All combinations of so many levels of every factor that has no number of its own.
    Full {
        /// Levels.
        levels: usize,
    },
    /// A regular fraction of the two-level factorial.
    Fraction(RegularFraction),
    /// A composite design about a two-level factorial or a fraction of it.
    Composite {
        /// The factorial.
        corners: RegularFraction,
        /// Where the stars stand.
        stars: StarDistance,
    },
    /// A Latin hypercube of so many points.
    Hypercube {
        /// Points.
        points: usize,
    },
}

impl ExperimentDesign {
    /// Its id.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::Full { .. } => "full",
            Self::Fraction(_) => "fraction",
            Self::Composite { .. } => "composite",
            Self::Hypercube { .. } => "latin",
        }
    }

    /// Whether it is repeated for every cutter, where cutters are a factor: they have no middle and no axis.
    #[must_use]
    pub fn repeats_for_cutters(&self) -> bool {
        match self {
            Self::Full { .. } | Self::Fraction(_) => false,
            Self::Composite { .. } | Self::Hypercube { .. } => true,
        }
    }
}

/// What a plan is made from.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanRequest {
    /// The factors.
    pub factors: Vec<ExperimentFactor>,
    /// The design.
    pub design: ExperimentDesign,
    /// Runs with all factors in the middle.
    pub centre: usize,
    /// How often the whole design is cut.
    pub replicates: usize,
    /// Seed of the order, and of a Latin hypercube.
    pub seed: u64,
}

/// A run of a plan.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlannedRun {
    /// Its number in standard order, from 1.
    pub run: usize,
    /// When it is cut, from 1.
    pub order: usize,
    /// What it is in the design.
    pub role: RunRole,
    /// The values of the factors; the number of the cutter, from 0, of the factor that they are.
    pub values: Vec<f64>,
}

/// A plan.
#[derive(Clone, Debug, PartialEq)]
pub struct ExperimentPlan {
    /// The factors.
    pub factors: Vec<ExperimentFactor>,
    /// The runs in standard order.
    pub runs: Vec<PlannedRun>,
    /// The fraction of a factorial that it is, or that stands in it.
    pub fraction: Option<RegularFraction>,
    /// Its name: a digest of all values and of their order.
    pub id: String,
}

impl ExperimentPlan {
    /// Makes a plan.
    ///
    /// # Errors
    /// Says what does not go together, with names, values and what is allowed.
    pub fn new(request: &PlanRequest) -> Result<Self, String> {
        let PlanRequest { factors, design, centre, replicates, seed } = request;
        check(factors)?;
        let cutter = factors.iter().position(|factor| factor.kind == FactorKind::Cutter);
        let repeated = cutter.filter(|_| design.repeats_for_cutters());
        let varied: Vec<&ExperimentFactor> = factors
            .iter()
            .enumerate()
            .filter(|(place, _)| repeated != Some(*place))
            .map(|(_, factor)| factor)
            .collect();
        if varied.is_empty() {
            return Err("a factor with a range is needed, for example `feed`".to_owned());
        }
        if *centre > 0 && repeated.is_none() && cutter.is_some() {
            return Err("tool: cutters have no middle: leave out the centre points".to_owned());
        }
        let mut points = designed(design, &varied, *seed)?;
        points.extend(centres(varied.len(), *centre));
        let cutters = repeated.map_or(1, |place| factors[place].range()[1] as usize + 1);
        let count = points.len().saturating_mul(cutters).saturating_mul(*replicates);
        if count == 0 || count > MAX_PLANNED {
            return Err(format!("{count} runs: allowed are 1 to {MAX_PLANNED}"));
        }
        let mut runs = Vec::with_capacity(count);
        for _ in 0..*replicates {
            for cutter in 0..cutters {
                for DesignPoint { coded, role } in &points {
                    let mut values: Vec<f64> =
                        varied.iter().zip(coded).map(|(factor, x)| factor.value(*x)).collect();
                    if let Some(place) = repeated {
                        values.insert(place, cutter as f64);
                    }
                    runs.push((values, *role));
                }
            }
        }
        let fraction = match design {
            ExperimentDesign::Fraction(fraction)
            | ExperimentDesign::Composite { corners: fraction, .. } => Some(fraction.clone()),
            ExperimentDesign::Full { .. } | ExperimentDesign::Hypercube { .. } => None,
        };
        Ok(Self::of(factors.clone(), runs, fraction, *seed))
    }

    /// A plan of runs with these values.
    #[must_use]
    pub fn of(
        factors: Vec<ExperimentFactor>,
        runs: Vec<(Vec<f64>, RunRole)>,
        fraction: Option<RegularFraction>,
        seed: u64,
    ) -> Self {
        let stream = Stream::new(seed, "experiment.order");
        let mut drawn: Vec<(u64, usize)> =
            (0..runs.len()).map(|run| (stream.bits(run as u64), run)).collect();
        drawn.sort_unstable();
        let mut orders = vec![0; runs.len()];
        for (order, (_, run)) in drawn.into_iter().enumerate() {
            orders[run] = order + 1;
        }
        let runs: Vec<PlannedRun> = runs
            .into_iter()
            .zip(orders)
            .enumerate()
            .map(|(number, ((values, role), order))| PlannedRun {
                run: number + 1,
                order,
                role,
                values,
            })
            .collect();
        let id = name(&factors, &runs);
        Self { factors, runs, fraction, id }
    }

    /// The runs of a table with columns of factors, in the order of its rows.
    ///
    /// # Errors
    /// No column of a factor with a range varies, or names the line and value that do not do.
    pub fn given(text: &str) -> Result<Self, String> {
        let (header, table) = CsvTable::whole(text)?;
        let mut columns: Vec<(FactorKind, Vec<f64>)> = Vec::new();
        for kind in FactorKind::ALL.iter().copied().filter(|kind| *kind != FactorKind::Cutter) {
            let place = header.iter().position(|name| kind.columns().contains(&name.as_str()));
            let Some(place) = place else { continue };
            let mut values = Vec::new();
            for row in &table.rows {
                let cell = &row.cells[place];
                let value = table.number(cell).filter(|x| x.is_finite());
                values.push(value.ok_or_else(|| {
                    let (line, name) = (row.line, &header[place]);
                    format!("line {line}: `{name}` cannot be `{cell}`: allowed is a number")
                })?);
            }
            columns.push((kind, values));
        }
        columns.retain(|(_, values)| values.iter().any(|value| *value != values[0]));
        if columns.is_empty() {
            let known = FactorKind::ALL.iter().flat_map(|kind| kind.columns()).copied();
            let known: Vec<&str> = known.filter(|name| *name != "tool").collect();
            return Err(format!(
                "no column of a factor varies: the columns are {}, known are {}",
                header.join(", "),
                known.join(", ")
            ));
        }
        let factors = columns.iter().map(|(kind, values)| ExperimentFactor {
            kind: *kind,
            span: FactorSpan::Range(extent(values.iter().copied())),
            levels: None,
        });
        let factors: Vec<ExperimentFactor> = factors.collect();
        let runs = (0..table.rows.len()).map(|row| {
            let values = columns.iter().map(|(_, values)| values[row]).collect();
            (values, RunRole::Given)
        });
        let mut plan = Self::of(factors, runs.collect(), None, 0);
        plan.runs.iter_mut().for_each(|run| run.order = run.run);
        plan.id = name(&plan.factors, &plan.runs);
        Ok(plan)
    }

    /// The runs in the order in which they are cut.
    #[must_use]
    pub fn in_order(&self) -> Vec<&PlannedRun> {
        let mut runs: Vec<&PlannedRun> = self.runs.iter().collect();
        runs.sort_by_key(|run| run.order);
        runs
    }

    /// The factors as they are told.
    #[must_use]
    pub fn told(&self) -> Vec<FactorTold> {
        self.factors.iter().map(ExperimentFactor::told).collect()
    }

    /// A scenario with the values of a run.
    ///
    /// # Errors
    /// A value that does not go with the scenario, as a path wider than the cutter.
    pub fn scenario(&self, base: &Scenario, run: &PlannedRun) -> Result<Scenario, String> {
        let mut changes = Vec::new();
        for (factor, value) in self.factors.iter().zip(&run.values) {
            let value = match factor.cutters() {
                Some(_) => Value::Text(factor.text(*value)),
                None => Value::Float(*value),
            };
            changes.push((factor.kind.path().to_owned(), value));
        }
        let mut scenario = base.clone();
        scenario
            .set_all(&changes)
            .map_err(|error| tr!("run {run}: {error}", run = run.run, error = error.to_string()))?;
        Ok(scenario)
    }
}

fn check(factors: &[ExperimentFactor]) -> Result<(), String> {
    if factors.is_empty() || factors.len() > MAX_FACTORS {
        return Err(format!("{} factors: allowed are 1 to {MAX_FACTORS}", factors.len()));
    }
    for (place, factor) in factors.iter().enumerate() {
        if factors[..place].iter().any(|other| other.kind == factor.kind) {
            return Err(format!("the factor `{}` is named twice", factor.kind.id()));
        }
    }
    Ok(())
}

fn designed(
    design: &ExperimentDesign,
    factors: &[&ExperimentFactor],
    seed: u64,
) -> Result<Vec<DesignPoint>, String> {
    let own = factors.iter().find(|factor| factor.levels.is_some());
    if let (Some(factor), false) = (own, matches!(design, ExperimentDesign::Full { .. })) {
        let (name, design) = (factor.kind.id(), design.id());
        return Err(format!("{name}: levels are for a full factorial, not for `{design}`"));
    }
    Ok(match design {
        ExperimentDesign::Full { levels } => {
            let levels: Vec<usize> = factors
                .iter()
                .map(|factor| match factor.cutters() {
                    Some(all) => all.len(),
                    None => factor.levels.unwrap_or(*levels),
                })
                .collect();
            let runs = levels.iter().fold(1_usize, |runs, levels| runs.saturating_mul(*levels));
            if runs > MAX_PLANNED {
                return Err(format!("{runs} runs: allowed are 1 to {MAX_PLANNED}"));
            }
            full_factorial(&levels)
        }
        ExperimentDesign::Fraction(fraction) => {
            if let Some(all) = factors.iter().find_map(|factor| factor.cutters())
                && all.len() != 2
            {
                let count = all.len();
                return Err(format!("tool: {count} cutters: a two-level design takes two"));
            }
            two_levels(fraction)
        }
        ExperimentDesign::Composite { corners, stars } => composite(corners, *stars, 0),
        ExperimentDesign::Hypercube { points } => hypercube(*points, factors.len(), seed),
    })
}

/// A word, so that no spreadsheet takes it for a number.
fn name(factors: &[ExperimentFactor], runs: &[PlannedRun]) -> String {
    let mut digest = Digest::default();
    for factor in factors {
        digest.word(factor.kind as u64);
        factor.range().iter().for_each(|end| digest.word(end.to_bits()));
        for tool in factor.cutters().unwrap_or_default() {
            digest.word(*tool as u64);
        }
    }
    for run in runs {
        digest.word(run.order as u64);
        run.values.iter().for_each(|value| digest.word(value.to_bits()));
    }
    format!("plan-{}", &digest.hex()[..8])
}
