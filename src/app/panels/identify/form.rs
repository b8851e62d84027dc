//! What is asked for: table, target, inputs, units, and how to search.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::base::formula::Unit;
use crate::base::language::{text, tr};
use crate::study::identify::gp::columns::OfferedTable;
use crate::study::identify::gp::job::{BATCHES, GpSettings};
use crate::study::identify::gp::problem::GpProblem;
use crate::study::published::PaperId;

/// What one looks for in the shipped tables at first: the feed that belongs to a force.
const FIRST_TARGET: &str = "feed_final_mm_min";
const FIRST_INPUT: &str = "force_final_n";

/// Where nothing is left to be searched for.
const WITHOUT_T: &str = text!(
    "known part: nothing is left to be searched for; write T(...) with the columns that the rest may read (the \
     constants alone are fitted by `steadycut identify gp --template`)"
);

/// A table with its columns.
#[derive(Debug, PartialEq)]
pub struct LoadedTable {
    /// What it is called.
    pub name: String,
    /// The paper that it was printed in, where it was.
    pub paper: Option<PaperId>,
    /// Its text.
    pub text: String,
    /// What it offers.
    pub offered: OfferedTable,
}

impl LoadedTable {
    fn read(name: &str, paper: Option<PaperId>, text: &str) -> Result<Arc<Self>, String> {
        let offered = OfferedTable::read(text).map_err(|problem| format!("{name}: {problem}"))?;
        Ok(Arc::new(Self { name: name.to_owned(), paper, text: text.to_owned(), offered }))
    }
}

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// The table; none where no table could be read.
    pub table: Option<Arc<LoadedTable>>,
    /// The column that the formula is to give.
    pub target: Option<String>,
    /// The columns that it may read, in the order of the table.
    pub inputs: Vec<String>,
    /// Units that differ from those that the names of the columns tell.
    pub units: BTreeMap<String, String>,
    /// Whether formulas must be right in their units.
    pub strict: bool,
    /// The part of the formula that is known, as `a + b*n^3 + T(f)`; empty where none is.
    pub template: String,
    /// Seed of all draws.
    pub seed: u64,
    /// Most batches.
    pub batches: u64,
    /// The paper whose own search runs beside.
    pub paper: Option<PaperId>,
}

impl Asked {
    /// The unit of a column as it is written; empty for none.
    pub fn unit(&self, column: &str) -> String {
        let own = || {
            let table = self.table.as_ref()?;
            let offered = table.offered.columns.iter().find(|offered| offered.name == column)?;
            Some(offered.unit.clone())
        };
        self.units.get(column).cloned().or_else(own).unwrap_or_default()
    }

    /// Target and inputs.
    pub fn columns(&self) -> impl Iterator<Item = &String> {
        self.target.iter().chain(&self.inputs)
    }

    /// The units of target and inputs.
    ///
    /// # Errors
    /// Names every column whose unit cannot be read, or is not known where formulas must be right in their units.
    pub fn given(&self) -> Result<Vec<(String, Unit)>, String> {
        let one = |column: &String| {
            let text = self.unit(column);
            if self.strict && text.trim().is_empty() {
                return Err(tr!(
                    "the unit of `{column}` is not known: write it beside its name, `1` for none, or let formulas \
                     be of any units",
                    column = column
                ));
            }
            let unit = Unit::parse(text.trim());
            let unit = unit.map_err(|problem| {
                let problem = problem.to_string();
                tr!("unit of `{column}`: {problem}", column = column, problem = problem)
            })?;
            Ok((column.clone(), unit))
        };
        let (known, faults): (Vec<_>, Vec<_>) = self.columns().map(one).partition(Result::is_ok);
        let faults: Vec<String> = faults.into_iter().filter_map(Result::err).collect();
        if !faults.is_empty() {
            return Err(faults.join("; "));
        }
        Ok(known.into_iter().flatten().collect())
    }

    /// How to search.
    pub fn settings(&self) -> GpSettings {
        GpSettings { seed: self.seed, batches: self.batches, paper: self.paper }
    }

    fn problem(&self) -> Result<GpProblem, String> {
        let table = self.table.as_ref().ok_or(tr("open a table, or choose one of the papers'"))?;
        // All that is missing at once.
        let mut missing = Vec::new();
        if self.target.is_none() {
            missing.push(tr("choose the column that the formula is to give").to_owned());
        }
        if self.inputs.is_empty() {
            missing.push(tr("choose at least one column that the formula may read").to_owned());
        }
        missing.extend(self.given().err());
        let target = match &self.target {
            Some(target) if missing.is_empty() => target,
            Some(_) | None => return Err(missing.join("; ")),
        };
        let problem = GpProblem::read(&table.text, target, &self.inputs)
            .map_err(|problem| format!("{}: {problem}", tr(&table.name)))?;
        let given = self.given()?;
        let problem = if self.strict { problem.strict(&given)? } else { problem };
        let told = given.into_iter().filter(|(name, _)| !self.unit(name).trim().is_empty());
        let problem = problem.told(&told.collect::<Vec<_>>());
        let template = self.template.trim();
        if !template.is_empty() {
            let problem = problem
                .with_template(template)
                .map_err(|problem| tr!("known part: {problem}", problem = problem))?;
            let free = problem.template.as_ref().is_some_and(|template| template.free.is_some());
            return if free { Ok(problem) } else { Err(tr(WITHOUT_T).to_owned()) };
        }
        match problem.collinear() {
            None => Ok(problem),
            Some(collinear) => {
                Err(tr!("{collinear}; leave one of them out", collinear = collinear.to_string()))
            }
        }
    }

    /// What is another than in `other`, in English words.
    pub fn differs(&self, other: &Self) -> Vec<&'static str> {
        // Of columns that both read: one that was added is told as an input.
        let has = |name: &str| other.columns().any(|column| column.as_str() == name);
        let units = self.columns().any(|name| has(name) && self.unit(name) != other.unit(name));
        let pairs = [
            (text!("data"), self.table != other.table),
            (text!("target"), self.target != other.target),
            (text!("inputs"), self.inputs != other.inputs),
            (text!("units"), self.strict != other.strict || units),
            (text!("known part"), self.template.trim() != other.template.trim()),
            (text!("seed"), self.seed != other.seed),
            (text!("batches"), self.batches != other.batches),
            (text!("paper"), self.paper != other.paper),
        ];
        pairs.into_iter().filter(|(_, differs)| *differs).map(|(name, _)| name).collect()
    }
}

/// The form.
pub struct IdentifyForm {
    /// What is asked for.
    pub asked: Asked,
    /// The tables on offer: the papers', and the one that was brought last.
    pub tables: Vec<Arc<LoadedTable>>,
    /// Why a table was not taken.
    pub refused: Option<String>,
    /// What there is to say about a number that was typed.
    pub said: Option<String>,
    /// A saved search that was brought: its name and its text.
    pub to_resume: Option<(String, String)>,
    /// What was checked last, and what came of it.
    checked: Option<(Asked, Result<GpProblem, String>)>,
}

impl Default for IdentifyForm {
    fn default() -> Self {
        let printed =
            |paper: &PaperId| LoadedTable::read(paper.label(), Some(*paper), paper.text());
        let tables: Vec<Arc<LoadedTable>> =
            PaperId::ALL.iter().filter_map(|paper| printed(paper).ok()).collect();
        let GpSettings { seed, .. } = GpSettings::default();
        let asked = Asked {
            table: None,
            target: None,
            inputs: Vec::new(),
            units: BTreeMap::new(),
            strict: false,
            template: String::new(),
            seed,
            batches: BATCHES,
            paper: None,
        };
        let mut form =
            Self { asked, tables, refused: None, said: None, to_resume: None, checked: None };
        if let Some(first) = form.tables.first().cloned() {
            form.choose(&first);
        }
        form
    }
}

impl IdentifyForm {
    /// Chooses a table, with target and inputs where the papers' are meant.
    pub fn choose(&mut self, table: &Arc<LoadedTable>) {
        self.refused = None;
        let has = |name: &str| {
            table.offered.columns.iter().any(|column| column.name == name && column.range.is_ok())
        };
        // What the new table has too stays chosen.
        self.asked.target = self.asked.target.take().filter(|target| has(target));
        self.asked.inputs.retain(|input| has(input));
        if table.paper.is_some() && self.asked.target.is_none() && self.asked.inputs.is_empty() {
            self.asked.target = Some(FIRST_TARGET.to_owned());
            self.asked.inputs = vec![FIRST_INPUT.to_owned()];
        }
        self.asked.units.clear();
        self.asked.table = Some(Arc::clone(table));
    }

    /// Takes a table that was opened or dropped, and chooses it.
    pub fn bring(&mut self, name: &str, text: &str) {
        match LoadedTable::read(name, None, text) {
            Ok(table) => {
                self.tables.retain(|other| other.paper.is_some());
                self.tables.push(Arc::clone(&table));
                self.choose(&table);
            }
            Err(because) => self.refused = Some(tr!("not opened: {because}", because = because)),
        }
    }

    /// Takes a saved search, to go on with it in the next frame.
    pub fn resume(&mut self, name: &str, text: &str) {
        self.to_resume = Some((name.to_owned(), text.to_owned()));
    }

    /// What is to be searched, or what is missing.
    pub fn problem(&mut self) -> Result<&GpProblem, String> {
        if self.checked.as_ref().is_none_or(|(asked, _)| *asked != self.asked) {
            self.checked = Some((self.asked.clone(), self.asked.problem()));
        }
        match &self.checked {
            Some((_, Ok(problem))) => Ok(problem),
            Some((_, Err(because))) => Err(because.clone()),
            None => Err(tr("nothing was checked").to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_that_is_brought_keeps_what_it_has_too_and_asks_for_the_rest() {
        let mut form = IdentifyForm::default();
        assert!(form.problem().is_ok());
        form.bring("mine.csv", "force_final_n,x,word\n1,2,a\n2,3,b\n3,5,c\n4,7,d\n5,9,e\n");
        assert_eq!(form.asked.target, None);
        assert_eq!(form.asked.inputs, ["force_final_n"]);
        assert!(form.problem().unwrap_err().starts_with("choose the column"));
        form.asked.target = Some("x".to_owned());
        assert_eq!(form.problem().unwrap().rows.len(), 5);
        form.asked.strict = true;
        assert!(form.problem().unwrap_err().starts_with("the unit of `x` is not known"));
        form.asked.units.insert("x".to_owned(), "furlong".to_owned());
        assert!(form.problem().unwrap_err().starts_with("unit of `x`: "));
        form.asked.units.insert("x".to_owned(), "1".to_owned());
        assert!(form.problem().is_ok());
        // Another one takes its place beside the papers'.
        form.bring("other.csv", "a,b\n1,2\n2,3\n3,5\n4,7\n5,9\n");
        assert_eq!(form.tables.len(), PaperId::ALL.len() + 1);
        let said = form.problem().unwrap_err();
        assert!(
            said.contains("choose the column") && said.contains("choose at least one"),
            "{said}"
        );
        assert!(form.asked.inputs.is_empty());
        form.bring("bad.csv", "a,b\n1,x\n");
        let said = form.refused.clone().unwrap();
        assert!(
            said.starts_with("not opened: bad.csv: 1 row: at least 5")
                && said.contains("line 2: `b`"),
            "{said}"
        );
        assert_eq!(form.asked.table.as_ref().unwrap().name, "other.csv", "it stays");
    }

    #[test]
    fn what_is_another_than_before_is_named() {
        let first = IdentifyForm::default().asked;
        let mut next = first.clone();
        assert_eq!(next.differs(&first), [""; 0]);
        next.seed += 1;
        next.strict = true;
        next.inputs.push("spindle_final_rpm".to_owned());
        assert_eq!(next.differs(&first), ["inputs", "units", "seed"]);
    }

    #[test]
    fn a_known_part_is_read_and_its_faults_are_told() {
        let mut form = IdentifyForm::default();
        form.asked.inputs.push("spindle_final_rpm".to_owned());
        form.asked.template = "a + b*spindle_final_rpm^3 + T(force_final_n)".to_owned();
        let problem = form.problem().unwrap();
        assert_eq!(problem.template.as_ref().unwrap().free, Some(vec![0]));
        for (template, part) in [
            ("a + b*force_final_n", "known part: nothing is left"),
            ("a + T(force_final_n", "known part: the bracket of T"),
            ("a + T(feed)", "known part: "),
        ] {
            form.asked.template = template.to_owned();
            let said = form.problem().unwrap_err();
            assert!(said.starts_with(part), "{template}: {said}");
        }
        assert_eq!(form.asked.differs(&IdentifyForm::default().asked), ["inputs", "known part"]);
    }

    #[test]
    fn inputs_on_one_line_are_refused() {
        let mut form = IdentifyForm::default();
        form.asked.inputs.push("spindle_final_rpm".to_owned());
        let said = form.problem().unwrap_err();
        assert!(
            said.contains("lie on one line") && said.ends_with("leave one of them out"),
            "{said}"
        );
    }
}
