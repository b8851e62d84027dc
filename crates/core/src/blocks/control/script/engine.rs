//! The engine that runs scripts: bounded in steps and memory, without clock, files and chance, its functions from
//! [`base::math`](crate::base::math), so that a script gives the same bits natively and in the page.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

use rhai::packages::{
    ArithmeticPackage, BasicArrayPackage, BasicMapPackage, LanguageCorePackage, LogicPackage,
    Package,
};
use rhai::{Engine, FLOAT, INT};

use crate::base::math;
use crate::base::rng::Stream;
use crate::models::Valued;
use crate::models::genetic::GeneticModels;

/// Most steps of one call: an endless loop ends there (chosen: some thousand times those of a PID law).
pub const MAX_STEPS: u64 = 20_000;
/// Most numbers and texts in a list or a map (chosen).
const MAX_ITEMS: usize = 1_000;
/// Most bytes of a text (chosen).
const MAX_TEXT: usize = 1_000;
/// Most calls within each other (chosen).
const MAX_CALLS: usize = 16;
/// Deepest expression, at the top and within a function (chosen).
const MAX_DEPTH: usize = 48;

/// What a script can do no more than any other formula: words of Rhai that are refused.
/// `**` is the platform's power, which differs in its last bit between targets; `pow` is there.
const REFUSED: [&str; 6] = ["**", "**=", "eval", "print", "debug", "import"];

/// The controller's models, as a script asks them in one control period.
#[derive(Clone, Debug)]
pub struct ScriptModels {
    of: Arc<GeneticModels>,
    /// Whether models 2 and 3 were asked outside their ranges.
    outside: Arc<[AtomicBool; 2]>,
}

impl ScriptModels {
    /// Models that were not asked yet.
    pub fn new(of: Arc<GeneticModels>) -> Self {
        Self { of, outside: Arc::default() }
    }

    /// Whether models 2 and 3 were asked within their ranges alone.
    pub fn valid(&self) -> [bool; 2] {
        self.outside.each_ref().map(|outside| !outside.load(Ordering::Relaxed))
    }

    fn ask(&self, number: usize, model: fn(&GeneticModels, f64) -> Valued, force_n: f64) -> f64 {
        let answer = model(&self.of, force_n);
        self.outside[number].fetch_or(!answer.valid, Ordering::Relaxed);
        answer.value
    }
}

/// A stream of random numbers that a script begins with a seed of its own: the same numbers each time.
#[derive(Clone, Debug)]
pub struct ScriptRandom {
    stream: Stream,
    drawn: u64,
}

impl ScriptRandom {
    fn new(seed: INT) -> Self {
        Self { stream: Stream::new(seed as u64, "controller.script"), drawn: 0 }
    }

    /// The next number, from 0 to below 1.
    fn next(&mut self) -> FLOAT {
        let number = self.stream.uniform(self.drawn);
        self.drawn += 1;
        number
    }
}

/// The one engine; it has no state.
pub static ENGINE: LazyLock<Engine> = LazyLock::new(engine);

pub(super) fn engine() -> Engine {
    let mut engine = Engine::new_raw();
    engine
        .register_global_module(LanguageCorePackage::new().as_shared_module())
        .register_global_module(ArithmeticPackage::new().as_shared_module())
        .register_global_module(LogicPackage::new().as_shared_module())
        .register_global_module(BasicArrayPackage::new().as_shared_module())
        .register_global_module(BasicMapPackage::new().as_shared_module())
        .set_max_operations(MAX_STEPS)
        .set_max_call_levels(MAX_CALLS)
        .set_max_expr_depths(MAX_DEPTH, MAX_DEPTH)
        .set_max_string_size(MAX_TEXT)
        .set_max_array_size(MAX_ITEMS)
        .set_max_map_size(MAX_ITEMS)
        .set_max_modules(0)
        .set_optimization_level(rhai::OptimizationLevel::None);
    for word in REFUSED {
        engine.disable_symbol(word);
    }
    functions(&mut engine);
    models(&mut engine);
    engine
}

/// Functions of one and two numbers, whole ones taken for numbers with a fraction.
fn functions(engine: &mut Engine) {
    type OfOne = fn(FLOAT) -> FLOAT;
    type OfTwo = fn(FLOAT, FLOAT) -> FLOAT;
    let of_one: [(&str, OfOne); 12] = [
        ("sin", math::sin),
        ("cos", math::cos),
        ("tanh", math::tanh),
        ("acos", math::acos),
        ("atan", math::atan),
        ("exp", math::exp),
        ("ln", math::ln),
        ("sqrt", f64::sqrt),
        ("floor", f64::floor),
        ("ceil", f64::ceil),
        ("round", f64::round),
        ("float", |x| x),
    ];
    for (name, function) in of_one {
        engine.register_fn(name, function);
        engine.register_fn(name, move |x: INT| function(x as FLOAT));
    }
    let of_two: [(&str, OfTwo); 3] = [("pow", math::power), ("min", f64::min), ("max", f64::max)];
    for (name, function) in of_two {
        engine.register_fn(name, function);
        engine.register_fn(name, move |x: INT, y: FLOAT| function(x as FLOAT, y));
        engine.register_fn(name, move |x: FLOAT, y: INT| function(x, y as FLOAT));
        engine.register_fn(name, move |x: INT, y: INT| function(x as FLOAT, y as FLOAT));
    }
    engine.register_fn("limit", |x: FLOAT, low: FLOAT, high: FLOAT| math::limit(x, low, high));
    engine.register_fn("is_nan", |x: FLOAT| x.is_nan());
    engine.register_type_with_name::<ScriptRandom>("random");
    engine.register_fn("random", ScriptRandom::new);
    engine.register_fn("next", ScriptRandom::next);
}

/// The believed models 1 to 3, of forces in N.
fn models(engine: &mut Engine) {
    engine.register_type_with_name::<ScriptModels>("models");
    engine.register_fn("feed", |of: &mut ScriptModels, force_n: FLOAT| {
        of.ask(0, GeneticModels::feed_from_force, force_n)
    });
    engine.register_fn("speed", |of: &mut ScriptModels, force_n: FLOAT| {
        of.ask(1, GeneticModels::speed_from_force, force_n)
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Result<f64, String> {
        ENGINE.eval::<f64>(text).map_err(|error| error.to_string())
    }

    #[test]
    fn chance_is_the_program_s_own_stream_in_its_order() {
        let mut random = ScriptRandom::new(7);
        let stream = Stream::new(7, "controller.script");
        for draw in 0..3 {
            assert_eq!(random.next(), stream.uniform(draw));
        }
    }

    /// A closure shares what it captures with every copy of the state: a snapshot would go on with the run.
    #[test]
    fn nothing_is_shared_between_copies_of_a_state() {
        assert_eq!(number("let f = |x| x + 1.0; f.call(1.0)"), Ok(2.0));
        assert!(ENGINE.eval::<f64>("let n = 0.0; let f = || { n += 1.0; n }; f.call()").is_err());
    }

    #[test]
    fn functions_are_those_of_the_program() {
        for x in [0.0, 0.3, 1.7] {
            assert_eq!(number(&format!("sin({x:?})")), Ok(math::sin(x)));
            assert_eq!(number(&format!("exp({x:?})")), Ok(math::exp(x)));
            assert_eq!(number(&format!("pow({x:?}, 0.3)")), Ok(math::power(x, 0.3)));
        }
        assert_eq!(number("sqrt(4)"), Ok(2.0));
        assert_eq!(number("max(2, 3.5) + limit(9.0, 0.0, 1.0)"), Ok(4.5));
    }

    #[test]
    fn what_could_differ_or_reach_out_is_refused() {
        for text in ["2.0 ** 0.5", "eval(\"1\")", "import \"a\" as b;", "timestamp()", "print(1)"] {
            assert!(ENGINE.eval::<rhai::Dynamic>(text).is_err(), "{text}");
        }
    }

    #[test]
    fn steps_and_memory_end() {
        let over = |text: &str| ENGINE.eval::<rhai::Dynamic>(text).unwrap_err().to_string();
        assert!(over("let x = 0; loop { x += 1; }").contains("Too many operations"));
        assert!(over("let x = []; loop { x.push(1); }").contains("too large"));
        assert!(over("let x = \"a\"; loop { x += x; }").contains("too large"));
        assert!(over("fn f(x) { f(x + 1) } f(0)").contains("Stack overflow"));
    }
}
