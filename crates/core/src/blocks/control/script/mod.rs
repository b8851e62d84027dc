//! A controller of a user's own: a script in Rhai (<https://rhai.rs>), read once and called every control period.
//!
//! ```text
//! fn init(start) { #{ sum: 0.0 } }          // the state, a map; may be left out
//! fn update(now) {                          // every control period; `this` is the state
//!     this.sum += now.a * (1.0 - now.y);
//!     #{ feed_percent: 100.0 * this.sum }   // or feed_mm_min and speed_rpm, or the feed override alone
//! }
//! fn restart(start) { this.sum = 0.0; }     // between two cuts; left out, `init` begins anew
//! ```
//!
//! `now` and `start` hold what every controller sees ([`ControlInput`]), the control period and the settings `a` to
//! `d`. A script is bounded in steps and memory, and has no clock, file or chance but a stream with a seed of its own
//! (`engine.rs`). What it cannot do, an endless loop, a number that is not finite, is a fault: the run ends there with
//! the line, and what was recorded stays.

mod endless;
mod engine;
mod program;

use std::sync::Arc;

use rhai::{CallFnOptions, Dynamic, EvalAltResult, FLOAT, INT, Map, Scope};

pub use self::engine::MAX_STEPS;
use self::engine::{ENGINE, ScriptModels};
pub use self::program::{MAX_CODE, ScriptProblem, ScriptProgram};
use super::law::{AtRest, ControlLaw, ControlMoment, Explained, Held};
use super::{ControlInput, ControlOutput, ControlSetup, FeedSpeed, Running};
use crate::base::equation::{Live, number};
use crate::base::language::{text, tr};
use crate::base::units::{percent_from_ratio, ratio_from_percent};
use crate::models::genetic::{GeneticModels, ModelSet};
use crate::models::printed::Printed;

/// Scripts to begin with: name and text.
pub const TEMPLATES: [(&str, &str); 3] = [
    ("P", include_str!("p.rhai")),
    ("PI", include_str!("pi.rhai")),
    ("SDNRP", include_str!("sdnrp.rhai")),
];

impl Default for ScriptProgram {
    /// The law of the 2007 paper.
    fn default() -> Self {
        let [.., (_, sdnrp)] = TEMPLATES;
        Self::read(sdnrp).expect("a test reads every template")
    }
}

crate::settings! {
    /// Settings of the script.
    pub struct ScriptSettings {
        /// The script, in Rhai: a function `update(now)` that gives the command of a control period, and, if wanted,
        /// `init(start)` and `restart(start)`.
        code: ScriptProgram = ScriptProgram::default(), [], "", live, "Script";
        /// The number `now.a` of the script; what it means the script says.
        a: f64 = 0.5, [-1e6, 1e6], "", live, "Number a";
        /// The number `now.b` of the script.
        b: f64 = 0.0, [-1e6, 1e6], "", live, "Number b";
        /// The number `now.c` of the script.
        c: f64 = 0.0, [-1e6, 1e6], "", live, "Number c";
        /// The number `now.d` of the script.
        d: f64 = 0.0, [-1e6, 1e6], "", live, "Number d";
    }
}

/// The controller; its state is what the script's `init` gave.
#[derive(Clone, Debug)]
pub struct Script {
    settings: ScriptSettings,
    period_s: f64,
    /// What the script keeps between two control periods.
    state: Dynamic,
    /// The models of the last control period, for the script to hold.
    models: Option<Arc<GeneticModels>>,
    /// Feed and speed that the machine runs at, and those that are programmed: what a new script begins with.
    runs_at: [FeedSpeed; 2],
    /// What went wrong: the controller does nothing from then on.
    problem: Option<Box<ScriptProblem>>,
}

/// What a script is given: numbers by name.
fn put(map: &mut Map, name: &str, value: f64) {
    map.insert(name.into(), Dynamic::from_float(value));
}

impl Script {
    fn begun(settings: &ScriptSettings, period_s: f64, runs_at: [FeedSpeed; 2]) -> Self {
        let mut this = Self {
            settings: settings.clone(),
            period_s,
            state: Dynamic::from_map(Map::new()),
            models: None,
            runs_at,
            problem: None,
        };
        this.begin();
        this
    }

    /// The state at the beginning, as the script gives it.
    fn begin(&mut self) {
        self.state = Dynamic::from_map(Map::new());
        if self.settings.code.has("init") {
            match self.call("init", self.start(), |this| this.start()) {
                Ok(state) => self.state = state,
                Err(problem) => self.problem = Some(Box::new(problem)),
            }
        }
    }

    /// What every call is given.
    fn start(&self) -> Map {
        let mut map = Map::new();
        let [actual, programmed] = self.runs_at;
        put(&mut map, "period_s", self.period_s);
        put(&mut map, "programmed_feed_mm_min", programmed.feed_mm_min);
        put(&mut map, "programmed_speed_rpm", programmed.speed_rpm);
        put(&mut map, "feed_mm_min", actual.feed_mm_min);
        put(&mut map, "speed_rpm", actual.speed_rpm);
        let ratio = actual.feed_mm_min / programmed.feed_mm_min;
        put(&mut map, "feed_percent", percent_from_ratio(ratio));
        let ScriptSettings { a, b, c, d, .. } = self.settings;
        for (name, value) in [("a", a), ("b", b), ("c", c), ("d", d)] {
            put(&mut map, name, value);
        }
        map
    }

    /// The same with what a control period brings.
    fn now(&mut self, input: &ControlInput) -> (Map, ScriptModels) {
        self.runs_at = [input.applied, input.programmed];
        let known = self.models.take().filter(|models| **models == *input.models);
        let models = known.unwrap_or_else(|| Arc::new(input.models.clone()));
        self.models = Some(Arc::clone(&models));
        let mut map = self.start();
        put(&mut map, "force_n", input.force_measured_n);
        put(&mut map, "force_ref_n", input.force_ref_n);
        put(&mut map, "y", input.force_measured_n / input.force_ref_n);
        put(&mut map, "x_mm", input.x_mm);
        put(&mut map, "by_hand", input.by_hand);
        let [feed, speed] = [input.limits.feed_mm_min, input.limits.speed_rpm];
        put(&mut map, "feed_min_mm_min", feed[0]);
        put(&mut map, "feed_max_mm_min", feed[1]);
        put(&mut map, "speed_min_rpm", speed[0]);
        put(&mut map, "speed_max_rpm", speed[1]);
        map.insert("cut".into(), Dynamic::from_int(input.cut as INT));
        let models = ScriptModels::new(models);
        map.insert("models".into(), Dynamic::from(models.clone()));
        (map, models)
    }

    /// Calls a function of the script with a map; its state is `this`.
    fn call(
        &mut self,
        name: &str,
        given: Map,
        again: impl FnOnce(&mut Self) -> Map,
    ) -> Result<Dynamic, ScriptProblem> {
        let options = CallFnOptions::new().eval_ast(false).bind_this_ptr(&mut self.state);
        let code = self.settings.code.code();
        let called = ENGINE.call_fn_with_options::<Dynamic>(
            options,
            &mut Scope::new(),
            code,
            name,
            (given,),
        );
        called.map_err(|error| {
            let mut problem = problem_of(&error);
            if endless::is_that(&error) {
                // Rhai does not say where: the call is done again, watched, with what it was given before.
                let given = again(self);
                problem.line = endless::line(&self.settings.code, name, given, &mut self.state);
            }
            problem
        })
    }

    /// The command that the script gives.
    fn ask(&mut self, input: &ControlInput) -> Result<ControlOutput, ScriptProblem> {
        let (given, models) = self.now(input);
        let told = self.call("update", given, |this| this.now(input).0)?;
        let [feed_model_valid, speed_model_valid] = models.valid();
        let mut output = ControlOutput {
            request: input.programmed,
            force_setpoint_n: input.force_ref_n,
            gain_estimate: 1.0,
            feed_model_valid,
            speed_model_valid,
            exceeded: None,
            switched_off: false,
        };
        let of_percent = |percent: f64, full: f64| full * ratio_from_percent(percent);
        if let Some(percent) = as_number(&told) {
            let percent = finite("update", percent)?;
            output.request.feed_mm_min = of_percent(percent, input.programmed.feed_mm_min);
            return Ok(output);
        }
        let kind = told.type_name();
        let Some(map) = told.read_lock::<Map>() else {
            return Err(ScriptProblem::nowhere(tr!(
                "`update` gave `{kind}`: allowed is a number, the feed override in percent, or a map of {names}",
                kind = kind,
                names = GIVEN.join(", ")
            )));
        };
        for (name, value) in map.iter() {
            let Some(value) = as_number(value) else {
                return Err(ScriptProblem::nowhere(tr!(
                    "`{name}` that `update` gave is no number",
                    name = name.as_str()
                )));
            };
            let value = finite(name, value)?;
            let request = &mut output.request;
            match name.as_str() {
                "feed_percent" => {
                    request.feed_mm_min = of_percent(value, input.programmed.feed_mm_min);
                }
                "speed_percent" => {
                    request.speed_rpm = of_percent(value, input.programmed.speed_rpm);
                }
                "feed_mm_min" => request.feed_mm_min = value,
                "speed_rpm" => request.speed_rpm = value,
                "force_setpoint_n" => output.force_setpoint_n = value,
                "gain_estimate" => output.gain_estimate = value,
                other => {
                    return Err(ScriptProblem::nowhere(tr!(
                        "`update` gave `{name}`, which nothing takes: allowed are {names}",
                        name = other,
                        names = GIVEN.join(", ")
                    )));
                }
            }
        }
        Ok(output)
    }
}

/// What `update` may give in a map.
const GIVEN: [&str; 6] = [
    "feed_percent",
    "speed_percent",
    "feed_mm_min",
    "speed_rpm",
    "force_setpoint_n",
    "gain_estimate",
];

fn as_number(value: &Dynamic) -> Option<f64> {
    let whole = || value.as_int().ok().map(|x: INT| x as FLOAT);
    value.as_float().ok().or_else(whole)
}

fn finite(name: &str, value: f64) -> Result<f64, ScriptProblem> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(ScriptProblem::nowhere(tr!(
        "`{name}` came to {value}, which is no finite number",
        name = name,
        value = value.to_string()
    )))
}

/// What went wrong in a call, at the innermost place.
fn problem_of(error: &EvalAltResult) -> ScriptProblem {
    if let EvalAltResult::ErrorInFunctionCall(_, _, inner, position) = error {
        let inner = problem_of(inner);
        return ScriptProblem { line: inner.line.or(position.line()), ..inner };
    }
    let what = if endless::is_that(error) {
        tr!("more than {n} steps in one control period: an endless loop?", n = MAX_STEPS)
    } else {
        let told = error.to_string();
        let place = told.rfind(" (line ");
        place.map_or(told.clone(), |place| told[..place].to_owned())
    };
    ScriptProblem::at(error.position(), what)
}

impl ControlLaw for Script {
    type Settings = ScriptSettings;
    const ABOUT: &'static str = "A script of one's own in Rhai: feed and speed from all that a controller sees, with four numbers as settings.";
    const HELD: Held = Held::Roughness;
    const ALLOCATES: bool = true;

    fn new(settings: &ScriptSettings, setup: &ControlSetup, programmed: FeedSpeed) -> Self {
        Self::begun(settings, setup.period_s, [programmed, programmed])
    }

    fn take_over(settings: &ScriptSettings, setup: &ControlSetup, running: &Running) -> Self {
        Self::begun(settings, setup.period_s, [running.actual, running.programmed])
    }

    fn configure(&mut self, settings: &ScriptSettings, setup: &ControlSetup) {
        let another = settings.code != self.settings.code;
        self.settings = settings.clone();
        self.period_s = setup.period_s;
        if another {
            self.problem = None;
            self.begin();
        }
    }

    fn restart(&mut self, programmed: FeedSpeed) {
        self.runs_at = [programmed, programmed];
        if !self.settings.code.has("restart") {
            return self.begin();
        }
        let start = self.start();
        if let Err(problem) = self.call("restart", start, |this| this.start()) {
            self.problem = Some(Box::new(problem));
        }
    }

    fn update(&mut self, input: &ControlInput) -> ControlOutput {
        let asked = match &self.problem {
            Some(_) => Err(None),
            None => self.ask(input).map_err(Some),
        };
        asked.unwrap_or_else(|problem| {
            self.problem = problem.map(Box::new).or(self.problem.take());
            ControlOutput {
                request: input.applied,
                force_setpoint_n: input.force_ref_n,
                gain_estimate: 1.0,
                feed_model_valid: true,
                speed_model_valid: true,
                exceeded: None,
                switched_off: true,
            }
        })
    }

    fn problem(&self) -> Option<&ScriptProblem> {
        self.problem.as_deref()
    }

    fn at_rest(_: &ScriptSettings) -> AtRest {
        AtRest::Unknown
    }

    fn printed(_: &ScriptSettings, _: ModelSet) -> Vec<Printed> {
        vec![Printed::new(
            "f_c, n_c = update(F_m, F_d, a, b, c, d)",
            text!("a script of one's own"),
        )]
    }

    fn explain(settings: &ScriptSettings, moment: &ControlMoment) -> Explained {
        let ScriptSettings { a, b, c, d, .. } = settings;
        let numbers = [a, b, c, d].map(|value| number(*value)).join(", ");
        let line = Live::everywhere(
            "f_c, n_c = update(F_m, F_d, a, b, c, d)".to_owned(),
            format!(
                "update({} N, {} N, {numbers}) = {} mm/min, {} 1/min",
                number(moment.force_measured_n),
                number(moment.force_ref_n),
                number(moment.command.feed_mm_min),
                number(moment.command.speed_rpm)
            ),
        );
        Explained { lines: vec![line], models_at_n: None, beside_name: String::new() }
    }
}
