//! The line of an endless loop. Rhai ends one at the limit of steps and does not say where; so the call is done once more
//! with a mark before every loop that tells when it is begun. A run without a fault has nothing of it.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use rhai::{AST, ASTNode, CallFnOptions, Dynamic, Engine, EvalAltResult, INT, Map, Scope, Stmt};

use super::ScriptProgram;
use super::engine::{MAX_STEPS, engine};

/// From this step on no loop is begun that is endless: one that is belongs to what is within it.
const TAIL: u64 = MAX_STEPS / 2;
/// The function that marks call.
const MARK: &str = "steadycut_loop_begins";

/// Whether a call ended at the limit of steps.
pub(super) fn is_that(error: &EvalAltResult) -> bool {
    if let EvalAltResult::ErrorInFunctionCall(_, _, inner, _) = error {
        return is_that(inner);
    }
    matches!(error, EvalAltResult::ErrorTooManyOperations(_))
}

/// Lines of loops in the order in which they were begun last, each with the step at which it was.
#[derive(Default)]
struct Begun(Vec<(usize, u64)>);

impl Begun {
    fn see(&mut self, line: usize, step: u64) {
        self.0.retain(|(known, _)| *known != line);
        self.0.push((line, step));
    }

    /// The loop that was begun last and goes on to the end: none that is begun again and again.
    fn endless(&self) -> Option<usize> {
        let before = self.0.iter().rfind(|(_, step)| *step <= TAIL);
        before.or(self.0.last()).map(|(line, _)| *line)
    }
}

/// The line of the loop that does not end in a call of `name`, done again with what it was given; where that ends now, or
/// there is none, the line at which the function begins.
pub(super) fn line(
    program: &ScriptProgram,
    name: &str,
    given: Map,
    state: &mut Dynamic,
) -> Option<usize> {
    let begun = Arc::new(Mutex::new(Begun::default()));
    let engine = watching(&begun);
    let again = engine.compile(marked(program)).ok().map(|code| {
        let options = CallFnOptions::new().eval_ast(false).bind_this_ptr(state);
        engine.call_fn_with_options::<Dynamic>(options, &mut Scope::new(), &code, name, (given,))
    });
    let found = match again {
        Some(Err(error)) if is_that(&error) => begun.lock().ok().and_then(|begun| begun.endless()),
        Some(Ok(_) | Err(_)) | None => None,
    };
    found.or_else(|| program.begins(name))
}

/// An engine like the one of the runs that notes the marks.
fn watching(begun: &Arc<Mutex<Begun>>) -> Engine {
    let mut engine = engine();
    let step = Arc::new(AtomicU64::new(0));
    let (now, begun) = (Arc::clone(&step), Arc::clone(begun));
    engine.on_progress(move |steps| {
        step.store(steps, Ordering::Relaxed);
        None
    });
    engine.register_fn(MARK, move |line: INT| {
        if let Ok(mut begun) = begun.lock() {
            begun.see(line as usize, now.load(Ordering::Relaxed));
        }
    });
    engine
}

/// The text with a mark before every loop that is a statement, in its line.
fn marked(program: &ScriptProgram) -> String {
    let mut places = loops(program.code());
    places.sort_unstable();
    places.dedup();
    let lines = program.text().split('\n').enumerate().map(|(i, text)| {
        let mut marked = String::new();
        for (column, letter) in text.chars().enumerate() {
            if places.binary_search(&(i + 1, column + 1)).is_ok() {
                marked.push_str(&format!("{MARK}({}); ", i + 1));
            }
            marked.push(letter);
        }
        marked
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Line and column of every loop that is a statement and no value.
fn loops(code: &AST) -> Vec<(usize, usize)> {
    let mut places = Vec::new();
    code.walk(&mut |path: &[ASTNode<'_>]| {
        let is_value = matches!(path, [.., ASTNode::Expr(_), _]);
        if let Some(ASTNode::Stmt(stmt @ (Stmt::While(..) | Stmt::Do(..) | Stmt::For(..)))) =
            path.last()
            && !is_value
        {
            let place = stmt.position();
            places.extend(place.line().zip(place.position()));
        }
        true
    });
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The line of what is endless in a script's `update(now)`.
    fn told(text: &str) -> Option<usize> {
        let program = ScriptProgram::read(text).unwrap();
        let mut state = Dynamic::from_map(Map::new());
        line(&program, "update", Map::new(), &mut state)
    }

    #[test]
    fn it_is_the_loop_that_does_not_end_and_none_that_does() {
        for (text, line) in [
            ("fn update(now) {\n  let x = 1.0;\n  loop {\n    x += 1.0;\n  }\n}", 3),
            ("fn update(now) {\n  let x = 1;\n\n  while true { }\n}", 4),
            (
                "fn update(now) {\n  let e = \"{ loop {\";\n  /* \u{10d} */ while 1 < 2 { e = 1; }\n}",
                3,
            ),
            (
                "fn update(now) {\n  for i in [1, 2, 3] { }\n  let n = 0;\n  do {\n    n += 1;\n  } while n > 0;\n}",
                4,
            ),
            // One within it that ends every time is not to blame; nor is one in what is called.
            (
                "fn sum(n) {\n  let s = 0;\n  for i in n { s += i; }\n  s\n}\nfn update(now) {\n  let n = 0;\n  \
                 while n >= 0 {\n    if n > 5 {\n      for i in [1] { n = sum([1, 2]); }\n    }\n    n += 1;\n  }\n}",
                8,
            ),
            (
                "fn search(x) {\n  loop {\n    x += 1.0;\n  }\n}\nfn update(now) {\n  for i in [1, 2] {\n    search(1.0);\n  }\n}",
                2,
            ),
        ] {
            assert_eq!(told(text), Some(line), "{text}");
        }
    }

    #[test]
    fn without_a_loop_it_is_where_the_function_begins() {
        let many = "fn f(n) { if n < 2 { 1 } else { f(n - 1) + f(n - 2) } }\n\nfn update(now) {\n  f(14) + f(14) + f(14) + f(14)\n}";
        assert_eq!(told(many), Some(3));
        assert_eq!(told("\nfn update(now) { 1 }"), Some(2));
        // A loop that is a value has no room for a mark.
        let value = "fn update(now) {\n  let x = loop { now.n = 1; };\n  x\n}";
        assert!(told(value).is_some());
    }

    #[test]
    fn marks_stand_before_the_loops_alone() {
        let text = "fn update(now) {\n  // \u{10d}: while\n  let a = \"while\"; while now.x { for i in [1] { } }\n}";
        let program = ScriptProgram::read(text).unwrap();
        let lines: Vec<String> = marked(&program).lines().map(str::to_owned).collect();
        let mark = format!("{MARK}(3); ");
        assert_eq!(
            lines[2],
            format!("  let a = \"while\"; {mark}while now.x {{ {mark}for i in [1] {{ }} }}")
        );
        assert_eq!(lines[1], "  // \u{10d}: while");
    }
}
