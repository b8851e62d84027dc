//! Templates: a formula of which a part is known, as `a + b*n^3 + T(f)`. Names that are neither inputs nor
//! functions are constants to be fitted; T stands for what is searched for, a formula of the inputs in its
//! brackets. Without T only the constants are fitted.

use super::constants::is_named as is_fitted;
use super::rows::DataRows;
use crate::base::formula::{
    CompiledFormula, Formula, Function, NamedConstant, Node as Tree, Operator,
};
use crate::base::language::tr;

/// Name under which T is read.
const FREE: &str = "T_";
/// Most constants of a template.
const MOST: usize = 12;

/// A template that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Template {
    /// The formula with its constants by name.
    pub formula: Formula,
    /// Parts that are multiplied by a constant each.
    pub parts: Vec<Formula>,
    /// Numbers of the inputs that T may read; none without T.
    pub free: Option<Vec<u8>>,
}

/// Names in a text with their places.
fn names(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut chars = text.char_indices().peekable();
    let mut quoted = false;
    let part = |c: char| c.is_alphanumeric() || c == '_';
    while let Some((at, c)) = chars.next() {
        quoted ^= c == '"';
        if quoted {
            continue;
        }
        if c.is_ascii_digit() || c == '.' {
            // A number, perhaps with an exponent.
            while chars.next_if(|(_, c)| part(*c) || *c == '.').is_some() {}
        } else if part(c) {
            let mut end = at + c.len_utf8();
            while let Some((at, c)) = chars.next_if(|(_, c)| part(*c)) {
                end = at + c.len_utf8();
            }
            found.push((at, &text[at..end]));
        }
    }
    found
}

/// The text with T as a name, and what stands in its brackets.
fn without_brackets(text: &str) -> Result<(String, Option<Vec<String>>), String> {
    let mut places = names(text)
        .into_iter()
        .filter(|(at, name)| *name == "T" && text[at + 1..].trim_start().starts_with('('));
    let Some((at, _)) = places.next() else { return Ok((text.to_owned(), None)) };
    if places.next().is_some() {
        return Err(tr("T stands there twice: allowed is once").to_owned());
    }
    let rest = &text[at + 1..];
    let open = rest.find('(').unwrap_or(0);
    let close = rest.find(')').ok_or_else(|| tr("the bracket of T is not closed"))?;
    let inputs = rest[open + 1..close].split(',');
    let inputs = inputs.map(|name| name.trim().trim_matches('"').to_owned()).collect();
    Ok((format!("{}{FREE}{}", &text[..at], &rest[close + 1..]), Some(inputs)))
}

fn summands(node: &Tree, found: &mut Vec<Tree>) {
    match node {
        Tree::Binary(Operator::Add | Operator::Subtract, pair) => {
            summands(&pair[0], found);
            summands(&pair[1], found);
        }
        Tree::Unary(Function::Negative, inner) => summands(inner, found),
        Tree::Number(_)
        | Tree::Input(_)
        | Tree::Constant(_)
        | Tree::Unary(..)
        | Tree::Binary(..) => {
            found.push(node.clone());
        }
    }
}

fn count(node: &Tree) -> usize {
    usize::from(is_fitted(node)) + node.operands().iter().map(count).sum::<usize>()
}

/// A product without its one constant factor.
fn without_constant(node: &Tree) -> Option<Tree> {
    if is_fitted(node) {
        return Some(Tree::Number(1.0));
    }
    match node {
        Tree::Binary(Operator::Multiply, pair) => {
            let [a, b] = &**pair;
            let (a, b) = match count(a) {
                0 => (a.clone(), without_constant(b)?),
                _ => (without_constant(a)?, b.clone()),
            };
            Some(Tree::binary(Operator::Multiply, a, b))
        }
        Tree::Binary(Operator::Divide, pair) if count(&pair[1]) == 0 => {
            Some(Tree::binary(Operator::Divide, without_constant(&pair[0])?, pair[1].clone()))
        }
        Tree::Number(_)
        | Tree::Input(_)
        | Tree::Constant(_)
        | Tree::Unary(..)
        | Tree::Binary(..) => None,
    }
}

impl Template {
    /// Reads a template of these inputs.
    ///
    /// # Errors
    /// Says what does not fit, and where.
    pub fn read(text: &str, inputs: &[String]) -> Result<Self, String> {
        let (text, free) = without_brackets(text)?;
        let known = ["pi", "e"].into_iter().chain(Function::ALL.map(Function::name));
        let known: Vec<&str> = known.collect();
        let mut constants: Vec<NamedConstant> = Vec::new();
        for (_, name) in names(&text) {
            let new = !known.contains(&name) && !inputs.iter().any(|input| input == name);
            if new && !constants.iter().any(|constant| constant.name == name) {
                constants.push(NamedConstant { name: name.to_owned(), value: 1.0 });
            }
        }
        if constants.len() > MOST + 1 {
            return Err(tr!(
                "{count} constants: allowed are {most}",
                count = constants.len(),
                most = MOST
            ));
        }
        let formula = Formula::parse_with(&text, inputs, &constants).map_err(|e| e.to_string())?;
        let Some(free) = free else {
            return match count(formula.root()) {
                0 => Err(tr("there is neither a constant to fit nor T to search for").to_owned()),
                _ => Ok(Self { formula, parts: Vec::new(), free: None }),
            };
        };
        let number = |name: &String| {
            inputs.iter().position(|input| input == name).map(|at| at as u8).ok_or_else(|| {
                tr!(
                    "T({name}): `{name}` is no input; inputs are {list}",
                    name = name,
                    list = inputs.join(", ")
                )
            })
        };
        let free = free.iter().map(number).collect::<Result<Vec<u8>, String>>()?;
        let mut terms = Vec::new();
        summands(formula.root(), &mut terms);
        let mut parts = Vec::new();
        let mut found = false;
        for term in terms {
            let told =
                Formula::new(term.clone(), inputs).map(|f| f.to_string()).unwrap_or_default();
            if matches!(&term, Tree::Constant(constant) if constant.name == FREE) {
                found = true;
                continue;
            }
            if is_fitted(&term) {
                continue;
            }
            let part = without_constant(&term).filter(|_| count(&term) == 1).ok_or_else(|| {
                tr!(
                    "`{part}`: beside T, every part needs one constant that multiplies it, and no other",
                    part = told
                )
            })?;
            parts.push(Formula::new(part, inputs)?.simplified());
        }
        if !found {
            let problem = tr("T has to stand in the sum by itself, as in `a + b*n^3 + T(f)`");
            return Err(problem.to_owned());
        }
        Ok(Self { formula, parts, free: Some(free) })
    }

    /// The rows with the values of the parts as further inputs.
    ///
    /// # Errors
    /// A part has no finite value on a row.
    pub fn extended(&self, rows: &DataRows) -> Result<DataRows, String> {
        let mut rows = rows.clone();
        let programs: Vec<CompiledFormula> = self.parts.iter().map(Formula::compile).collect();
        extend(&mut rows.inputs, &programs);
        let whole = rows.inputs.iter().flatten().all(|x| x.is_finite());
        whole
            .then_some(rows)
            .ok_or_else(|| tr("a part of the template has no finite value on some row").to_owned())
    }
}

/// Appends the values of formulas of the columns.
pub fn extend(columns: &mut Vec<Vec<f64>>, programs: &[CompiledFormula]) {
    let (count, rows) = (columns.len(), columns.first().map_or(0, Vec::len));
    let mut at = vec![0.0; count];
    for program in programs {
        let column = (0..rows).map(|row| {
            at.iter_mut().zip(&columns[..count]).for_each(|(at, column)| *at = column[row]);
            program.value(&at)
        });
        let column = column.collect();
        columns.push(column);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Template, String> {
        Template::read(text, &["f".to_owned(), "n".to_owned()])
    }

    #[test]
    fn parts_and_inputs_of_t_are_told_apart() {
        let template = read("a + b*n^3 - 2*c/sqrt(n) + T(f)").unwrap();
        let parts: Vec<String> = template.parts.iter().map(Formula::to_string).collect();
        assert_eq!(parts, ["n^3", "2 / sqrt(n)"]);
        assert_eq!(template.free, Some(vec![0]));
        let fitted = read("a - b*n^p - c*ln(0.039*f)/f + 2e-3").unwrap();
        assert_eq!((fitted.free, count(fitted.formula.root())), (None, 4));
    }

    #[test]
    fn what_cannot_be_a_template_is_refused_with_its_part() {
        for (text, part) in [
            ("a + n^b + T(f)", "n^b"),
            ("a + n^3 + T(f)", "n^3"),
            ("a + b*T(f)", "beside T"),
            ("a*T(g)", "`g` is no input"),
            ("T(f) + T(n)", "twice"),
            ("n^3 + f", "neither"),
            ("a + b*(n", "column"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
