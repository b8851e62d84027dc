//! How the loop answers to the last change before the playhead: the error that remains, settling and
//! overshoot, or that it is unstable, or was before.

use crate::app::format;
use crate::app::panels::View;
use crate::app::widgets::standing::Standing;
use crate::blocks::reference::Reference;
use crate::run::story::{EventKind, ResponseEnd, StepResponse, Story};

/// What its card says.
pub struct LoopAnswer {
    /// The number.
    pub value: String,
    /// How it stands.
    pub standing: Standing,
    /// The lines below it.
    pub below: [String; 2],
}

impl LoopAnswer {
    /// The answer at the playhead.
    pub fn of(view: &View<'_>) -> Self {
        let session = view.session;
        let now_s = session.row().time_s + 1e-9;
        let tolerance = session.current().target.tolerance_percent;
        let Some((_, response)) = session.story().response_at(now_s) else {
            let below = [String::new(), String::new()];
            return Self { value: "-".to_owned(), standing: Standing::Plain, below };
        };
        let held = match session.current().target.reference {
            Reference::Ra => "Ra",
            Reference::Force => "force",
        };
        let found = Self::after(response, (held, tolerance), view.narrow);
        let Some([word, stretch]) = was(session.story(), response, now_s) else { return found };
        // The last step alone is no verdict on a cut that swung or chattered.
        let standing = match found.standing {
            Standing::Good | Standing::Best | Standing::Plain => Standing::Watch,
            standing @ (Standing::Watch | Standing::Bad) => standing,
        };
        let [settled, _] = found.below;
        let below = match view.narrow {
            true => [word, stretch],
            false => [format!("{word} {stretch}"), settled],
        };
        Self { value: found.value, standing, below }
    }

    /// The answer to one change; what is held, and its tolerance in percent.
    fn after(response: &StepResponse, held: (&str, f64), narrow: bool) -> Self {
        let words = |value: &str, below: [&str; 2]| Self {
            value: value.to_owned(),
            standing: Standing::Plain,
            below: below.map(str::to_owned),
        };
        match response.ends {
            ResponseEnd::TooShort => words("-", ["too short to judge", ""]),
            ResponseEnd::Moving => words("not at rest", ["still on its way", ""]),
            ResponseEnd::Unstable => {
                let of = |swing: Option<f64>, word: &str| {
                    swing.map_or(String::new(), |size| {
                        format!("{word} ±{}", format::quantity(size, "%"))
                    })
                };
                let swing = response.oscillation;
                let period = swing.map_or(String::new(), |swing| {
                    format!("period {}, no rest", format::quantity(swing.period_s, "s"))
                });
                let below = [of(swing.map(|swing| swing.force_percent), "force"), period];
                Self { value: "unstable".to_owned(), standing: Standing::Bad, below }
            }
            ResponseEnd::AtRest => Self::at_rest(response, held, narrow),
        }
    }

    fn at_rest(response: &StepResponse, (held, tolerance): (&str, f64), narrow: bool) -> Self {
        let below = transient(response, narrow);
        let Some(error) = response.remaining_error_percent else {
            let value = if narrow { "no Ra" } else { "not judged" }.to_owned();
            let [settled, _] = below;
            let below = ["outside the model".to_owned(), settled];
            return Self { value, standing: Standing::Plain, below };
        };
        let swing = response.swing_percent.unwrap_or_default();
        let inside = error.abs() <= tolerance;
        let word = match (inside, narrow) {
            (true, false) => " within",
            (false, false) if error.abs() < 100.0 => " outside",
            // The sign says it, and so much is outside anyway.
            (false, false) | (_, true) => "",
        };
        let standing = match (inside, error.abs() + swing <= tolerance) {
            (true, true) => Standing::Good,
            (true, false) => Standing::Watch,
            (false, _) => Standing::Bad,
        };
        let [settled, overshoot] = below;
        let swings = if narrow { "±" } else { "swings by ±" };
        let second = response
            .told_swing_percent()
            .map_or(overshoot, |swing| format!("{held} {swings}{}", format::quantity(swing, "%")));
        let below = [settled, second];
        Self { value: format!("{}{word}", format::deviation(error)), standing, below }
    }
}

/// What the cut was before, from when to when, where that is not what it is now.
fn was(story: &Story, response: &StepResponse, now_s: f64) -> Option<[String; 2]> {
    if response.is_unstable() {
        return None;
    }
    let kinds = [(EventKind::LimitCycle, "unstable"), (EventKind::Chatter, "chattered")];
    let each = kinds.map(|(kind, word)| (word, story.stretches_until(kind, now_s)));
    let (word, stretches) = each.into_iter().find(|(_, stretches)| !stretches.is_empty())?;
    let [from_s, to_s] = stretches.last()?;
    let more = if stretches.len() > 1 { ", and before" } else { "" };
    Some([word.to_owned(), format!("{from_s:.1} to {to_s:.1} s{more}")])
}

/// How it came to rest: settling and overshoot, or that there was nothing of the kind.
fn transient(response: &StepResponse, narrow: bool) -> [String; 2] {
    let settling = match response.settling_time_s {
        Some(settling_s) if !response.is_without_transient() => {
            let word = if narrow { "force rests" } else { "force settles in" };
            format!("{word} {}", format::quantity(settling_s, "s"))
        }
        Some(_) | None if narrow => "force steady".to_owned(),
        Some(_) | None => "force settles at once".to_owned(),
    };
    let band = format::quantity(response.settling_band_percent.unwrap_or_default(), "%");
    let settled = if narrow { settling } else { format!("{settling} (±{band})") };
    let overshoot = response.overshoot_percent.filter(|_| !response.is_without_transient());
    let overshoot = overshoot.map_or("no transient".to_owned(), |overshoot| {
        let word = if narrow { "over" } else { "its overshoot" };
        format!("{word} {}", format::quantity(overshoot, "%"))
    });
    [settled, overshoot]
}
