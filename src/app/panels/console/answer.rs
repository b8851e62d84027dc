//! How the loop answers to the last change before the playhead: the error that remains, settling and
//! overshoot, or that it is unstable, or was before.

use crate::app::format;
use crate::app::panels::View;
use crate::app::widgets::standing::Standing;
use crate::base::language::{text, tr};
use crate::blocks::reference::Reference;
use crate::run::story::{EventKind, Figures, ResponseEnd, StepResponse, Story, StoryEvent};

/// What its card says.
pub struct LoopAnswer {
    /// The number.
    pub value: String,
    /// How it stands.
    pub standing: Standing,
    /// The lines below it.
    pub below: [String; 2],
    /// What the band of settling is now, and why; empty where there is none.
    pub band: String,
}

impl LoopAnswer {
    /// The answer at the playhead.
    pub fn of(view: &View<'_>) -> Self {
        let session = view.session;
        let now_s = session.row().time_s + 1e-9;
        let tolerance = session.current().target.tolerance_percent;
        let Some((event, response)) = session.story().response_at(now_s) else {
            let below = [String::new(), String::new()];
            return Self::new("-".to_owned(), Standing::Plain, below);
        };
        let held = session.current().target.reference;
        let found = Self::after(response, (held, tolerance), view.narrow);
        let coupled = session.current().machine.coupled;
        let off = shaken(event).filter(|_| coupled && held == Reference::Ra);
        let shakes = off.is_some();
        let found = match off {
            Some(off) => found.with_dynamics(off, tolerance, view.narrow),
            None => found,
        };
        let found = Self { band: band(response), ..found };
        let Some([word, stretch]) = was(session.story(), response, now_s) else { return found };
        // The last step alone is no verdict on a cut that swung or chattered.
        let standing = match found.standing {
            Standing::Good | Standing::Best | Standing::Plain => Standing::Watch,
            standing @ (Standing::Watch | Standing::Bad) => standing,
        };
        let [settled, with_dynamics] = found.below.clone();
        let told = if shakes { with_dynamics } else { settled };
        let below = match view.narrow {
            true => [word, stretch],
            false => [format!("{word} {stretch}"), told],
        };
        Self { standing, below, ..found }
    }

    fn new(value: String, standing: Standing, below: [String; 2]) -> Self {
        Self { value, standing, below, band: String::new() }
    }

    /// The same with what the machine's vibration makes of it, a deviation in percent: what rests within the tolerance
    /// may be outside it with that.
    fn with_dynamics(self, off: f64, tolerance: f64, narrow: bool) -> Self {
        let inside = off.abs() <= tolerance;
        let standing = match (self.standing, inside) {
            (standing, true) => standing,
            (_, false) if off > 0.0 => Standing::Bad,
            (Standing::Good | Standing::Best | Standing::Plain | Standing::Watch, false) => {
                Standing::Watch
            }
            (Standing::Bad, false) => Standing::Bad,
        };
        let [settled, _] = self.below;
        let error = format::deviation(off);
        let told = match (inside, narrow) {
            (true, false) => tr!("with dynamics {error} within", error = error),
            (false, false) => tr!("with dynamics {error} outside", error = error),
            (_, true) => tr!("with dynamics {error}", error = error),
        };
        Self::new(self.value, standing, [settled, told])
    }

    /// The answer to one change; what is held, and its tolerance in percent.
    fn after(response: &StepResponse, held: (Reference, f64), narrow: bool) -> Self {
        let words = |value: &str, below: [&str; 2]| {
            Self::new(value.to_owned(), Standing::Plain, below.map(str::to_owned))
        };
        match response.ends {
            ResponseEnd::TooShort if narrow => words("-", [tr("too short yet"), ""]),
            ResponseEnd::TooShort => words("-", [tr("too short to judge"), ""]),
            ResponseEnd::Moving => words(tr("not at rest"), [tr("still on its way"), ""]),
            ResponseEnd::Unstable => {
                let below = response.oscillation.map(|swing| {
                    let force = format::quantity(swing.force_percent, "%");
                    let period = format::quantity(swing.period_s, "s");
                    [
                        tr!("force ±{swing}", swing = force),
                        tr!("period {period}, no rest", period = period),
                    ]
                });
                Self::new(tr(UNSTABLE).to_owned(), Standing::Bad, below.unwrap_or_default())
            }
            ResponseEnd::AtRest => Self::at_rest(response, held, narrow),
        }
    }

    fn at_rest(response: &StepResponse, (held, tolerance): (Reference, f64), narrow: bool) -> Self {
        let below = transient(response, narrow);
        let Some(error) = response.remaining_error_percent else {
            let value = if narrow { tr("no Ra") } else { tr("not judged") };
            let [settled, _] = below;
            let why = if narrow { tr("outside the model") } else { tr("Ra outside its model") };
            let below = [why.to_owned(), settled];
            return Self::new(value.to_owned(), Standing::Plain, below);
        };
        let swing = response.swing_percent.unwrap_or_default();
        let inside = error.abs() <= tolerance;
        let written = format::deviation(error);
        let value = match (inside, narrow) {
            (true, false) => tr!("{error} within", error = written),
            (false, false) if error.abs() < 100.0 => tr!("{error} outside", error = written),
            // The sign says it, and so much is outside anyway.
            (false, false) | (_, true) => written,
        };
        let standing = match (inside, error.abs() + swing <= tolerance) {
            (true, true) => Standing::Good,
            (true, false) => Standing::Watch,
            // Smoother than asked is no scrap.
            (false, _) if held == Reference::Ra && error < 0.0 => Standing::Watch,
            (false, _) => Standing::Bad,
        };
        let [settled, overshoot] = below;
        let told = if response.swings_on() { Some(swing) } else { response.told_swing_percent() };
        let second = told.map_or(overshoot, |swing| {
            let swing = format::quantity(swing, "%");
            match (held, narrow) {
                (Reference::Ra, true) => format!("Ra ±{swing}"),
                (Reference::Ra, false) => tr!("Ra swings by ±{swing}", swing = swing),
                (Reference::Force, true) => tr!("force ±{swing}", swing = swing),
                (Reference::Force, false) => tr!("force swings by ±{swing}", swing = swing),
            }
        });
        Self::new(value, standing, [settled, second])
    }
}

/// What an unstable loop is called.
const UNSTABLE: &str = text!("unstable");

/// How far Ra with dynamics lies from its target at the end of a change's stretch, percent.
fn shaken(event: &StoryEvent) -> Option<f64> {
    match &event.figures {
        Figures::Change(effect) => effect.after.and_then(|after| after.deviation_dyn_percent),
        Figures::Air(_)
        | Figures::Answer(_)
        | Figures::Limit(_)
        | Figures::Outside(_)
        | Figures::Chatter(_)
        | Figures::Wear(_)
        | Figures::LimitCycle(_)
        | Figures::End(_) => None,
    }
}

/// What the cut was before, from when to when, where that is not what it is now.
fn was(story: &Story, response: &StepResponse, now_s: f64) -> Option<[String; 2]> {
    if response.is_unstable() {
        return None;
    }
    let kinds = [(EventKind::LimitCycle, UNSTABLE), (EventKind::Chatter, text!("chattered"))];
    let each = kinds.map(|(kind, word)| (word, story.stretches_until(kind, now_s)));
    let (word, stretches) = each.into_iter().find(|(_, stretches)| !stretches.is_empty())?;
    let [from_s, to_s] = stretches.last()?;
    let when = match stretches.len() > 1 {
        true => tr!("{from:.1} to {to:.1} s, and before", from = *from_s, to = *to_s),
        false => tr!("{from:.1} to {to:.1} s", from = *from_s, to = *to_s),
    };
    Some([tr(word).to_owned(), when])
}

/// The band that settling is judged by, with where it comes from.
fn band(response: &StepResponse) -> String {
    let noise = response.settling_band_percent.zip(response.band_of_noise_percent());
    let Some((band, noise)) = noise else { return String::new() };
    let of = |share: f64| format::quantity(share, "%");
    let told = match of(noise) == of(0.0) {
        true => tr!(
            "The band is ±{band} here: the 2 % of the textbooks, since no noise moves the force at rest.",
            band = of(band)
        ),
        false => tr!(
            "The band is ±{band} here: the 2 % of the textbooks and {noise} for what noise still moves the force by \
             at rest.",
            band = of(band),
            noise = of(noise)
        ),
    };
    match response.swings_on() {
        true => {
            let on = tr("What is held swings by more than that: nothing settles here.");
            format!(" {told} {on}")
        }
        false => format!(" {told}"),
    }
}

/// How it came to rest: settling and overshoot, or that there was nothing of the kind.
fn transient(response: &StepResponse, narrow: bool) -> [String; 2] {
    let band = format::quantity(response.settling_band_percent.unwrap_or_default(), "%");
    if response.swings_on() {
        let swings = match narrow {
            true => tr!("no rest (±{band})", band = band),
            false => tr!("does not settle (±{band})", band = band),
        };
        return [swings, String::new()];
    }
    let settled = match response.settling_time_s {
        Some(settling_s) if !response.is_without_transient() => {
            let time = format::quantity(settling_s, "s");
            match narrow {
                true => tr!("force rests {time}", time = time),
                false => tr!("force settles in {time} (±{band})", time = time, band = band),
            }
        }
        Some(_) | None if narrow => tr("force steady").to_owned(),
        Some(_) | None => tr!("force settles at once (±{band})", band = band),
    };
    let overshoot = response.overshoot_percent.filter(|_| !response.is_without_transient());
    let overshoot = overshoot.map_or(tr("no transient").to_owned(), |overshoot| {
        let size = format::quantity(overshoot, "%");
        // Beside a peak in the plot "overshoot 0.0 %" reads as wrong: the peak is the change's own.
        let jump = response.jump_percent.filter(|_| size == format::quantity(0.0, "%"));
        match (jump.map(format::deviation), narrow) {
            (Some(jump), true) => tr!("jump {jump}", jump = jump),
            (Some(jump), false) => tr!("jump {jump}, no overshoot", jump = jump),
            (None, true) => tr!("overshoot {size}", size = size),
            (None, false) => tr!("its overshoot {size}", size = size),
        }
    });
    [settled, overshoot]
}
