//! A script as a setting: its text, read and checked once.

use std::sync::Arc;

use rhai::{AST, Dynamic, ParseError, Position, Scope};
use serde::Serialize;

use super::engine::ENGINE;
use crate::base::language::tr;
use crate::base::settings::{Editor, Structure, Value};

/// Longest text, bytes: it has to go into a link (chosen).
pub const MAX_CODE: usize = 4_000;

/// A script that can be run: its text and what it was read to. Shared, so that a scenario is copied quickly.
#[derive(Clone)]
pub struct ScriptProgram {
    text: Arc<str>,
    read: Arc<AST>,
}

impl std::fmt::Debug for ScriptProgram {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("ScriptProgram").field(&self.text).finish()
    }
}

impl PartialEq for ScriptProgram {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

/// What is wrong with a script, or went wrong in it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScriptProblem {
    /// Line, from 1; none where the problem has no place.
    pub line: Option<usize>,
    /// What.
    pub what: String,
}

impl ScriptProblem {
    pub(super) fn nowhere(what: String) -> Self {
        Self { line: None, what }
    }

    pub(super) fn at(position: Position, what: String) -> Self {
        Self { line: position.line(), what }
    }
}

/// In words.
impl std::fmt::Display for ScriptProblem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            Some(line) => f.write_str(&tr!("line {line}: {what}", line = line, what = &self.what)),
            None => f.write_str(&self.what),
        }
    }
}

impl From<ParseError> for ScriptProblem {
    fn from(error: ParseError) -> Self {
        let ParseError(what, position) = &error;
        Self::at(*position, what.to_string())
    }
}

impl ScriptProgram {
    /// Reads a script.
    ///
    /// # Errors
    /// Says what is wrong, with its line: a text that is too long, that cannot be read, without a function
    /// `update(now)`, or with anything but functions at its top.
    pub fn read(text: &str) -> Result<Self, ScriptProblem> {
        if text.len() > MAX_CODE {
            return Err(ScriptProblem::nowhere(tr!(
                "it has {n} bytes: at most {most} are allowed",
                n = text.len(),
                most = MAX_CODE
            )));
        }
        // The same script whatever a system ends its lines with.
        let text = text.replace("\r\n", "\n");
        let read = ENGINE.compile(&text)?;
        for (name, parameters) in [("init", "start"), ("restart", "start"), ("update", "now")] {
            let found = read.iter_functions().find(|function| function.name == name);
            match found {
                Some(function) if function.params.len() != 1 => {
                    return Err(ScriptProblem::nowhere(tr!(
                        "function `{name}` has {n} parameters: one is allowed, `{name}({parameter})`",
                        name = name,
                        n = function.params.len(),
                        parameter = parameters
                    )));
                }
                None if name == "update" => {
                    return Err(ScriptProblem::nowhere(
                        tr("there is no function `update(now)`, which gives the command")
                            .to_owned(),
                    ));
                }
                Some(_) | None => {}
            }
        }
        // What stands outside of functions would never be done: it is refused rather than dropped.
        let mut scope = Scope::new();
        let top = ENGINE.eval_ast_with_scope::<Dynamic>(&mut scope, &read);
        if !(scope.is_empty() && top.is_ok_and(|value| value.is_unit())) {
            return Err(ScriptProblem::nowhere(
                tr("something stands outside of its functions: nothing but functions is allowed")
                    .to_owned(),
            ));
        }
        Ok(Self { text: text.into(), read: Arc::new(read) })
    }

    /// Its text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    pub(super) fn code(&self) -> &AST {
        &self.read
    }

    /// The line at which a function begins.
    pub(super) fn begins(&self, name: &str) -> Option<usize> {
        let found = self.read.iter_fn_def().find(|function| function.name == name)?;
        found.body.start_position().line()
    }

    /// Whether it has a function.
    pub(super) fn has(&self, name: &str) -> bool {
        self.read.iter_functions().any(|function| function.name == name)
    }
}

impl Structure for ScriptProgram {
    const ID: &'static str = "script";

    fn bounds(_: [f64; 2]) -> Vec<(&'static str, f64)> {
        vec![("max_bytes", MAX_CODE as f64)]
    }
    fn allowed(_: [f64; 2], _: &str) -> String {
        tr!("a script with a function `update(now)`, at most {n} bytes", n = MAX_CODE)
    }
    fn write(&self) -> Value {
        Value::Text(self.text.to_string())
    }
    fn read(value: &Value, _: [f64; 2]) -> Option<Self> {
        let Value::Text(text) = value else { return None };
        Self::read(text).ok()
    }
    fn parse(text: &str) -> Option<Value> {
        Some(Value::Text(text.to_owned()))
    }
    fn fault(value: &Value) -> Option<String> {
        let Value::Text(text) = value else { return None };
        let problem = Self::read(text).err()?;
        Some(tr!("this script ({problem})", problem = problem.to_string()))
    }
    fn editor(_: [f64; 2]) -> Editor {
        Editor::Script
    }
    fn example(_: [f64; 2], share: f64, pick: u32) -> Value {
        let templates = super::TEMPLATES;
        let (_, text) = templates[pick as usize % templates.len()];
        Value::Text(text.replace("0.5", &format!("{share:?}")))
    }
}

crate::structured!(ScriptProgram);

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(text: &str) -> String {
        ScriptProgram::read(text).unwrap_err().to_string()
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        assert!(problem("fn update(now) {\n  100.0 +\n}").starts_with("line 3: "));
        assert_eq!(problem(""), "there is no function `update(now)`, which gives the command");
        let two = problem("fn update(a, b) { 1 }");
        assert_eq!(two, "function `update` has 2 parameters: one is allowed, `update(now)`");
        let top = "something stands outside of its functions: nothing but functions is allowed";
        for outside in ["let x = 1;", "const K = 2.0;", "1 + 1"] {
            assert_eq!(problem(&format!("fn update(now) {{ 1 }}\n{outside}")), top, "{outside}");
        }
        let long = format!("fn update(now) {{ 1 }} // {}", "x".repeat(MAX_CODE));
        assert!(problem(&long).contains("at most 4000 are allowed"), "{}", problem(&long));
    }

    #[test]
    fn every_template_is_read_and_comes_back_as_it_was() {
        for (name, text) in crate::blocks::control::script::TEMPLATES {
            let program = ScriptProgram::read(text).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(Structure::write(&program), Value::Text(text.to_owned()));
            assert_eq!(ScriptProgram::read(&text.replace('\n', "\r\n")), Ok(program));
        }
    }
}
