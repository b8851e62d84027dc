//! What a chart shows, and the time axis that charts share.

use std::collections::BTreeSet;

use crate::app::overlay::trace::MeasuredTrace;
use crate::app::session::{Session, TwinStand};
use crate::app::theme::{self, Look};
use crate::base::language::{text, tr};
use crate::run::signals::SIGNALS;
use crate::study::over_run::OverRun;

/// One signal in a chart.
#[derive(Clone, Copy, Debug)]
pub struct ChartCurve {
    /// Its id in the table of signals.
    pub signal: &'static str,
    /// How it is drawn.
    pub look: Look,
    /// Whether the twin and the run before the last change are drawn with it.
    pub compared: bool,
}

/// A measured channel in a chart.
#[derive(Clone, Debug)]
pub struct ChartMeasured<'a> {
    /// Its number: larger than those of all before.
    pub id: u64,
    /// What it is called, in the chosen language.
    pub name: String,
    /// Its number among those over the plots.
    pub number: usize,
    /// Its samples.
    pub trace: &'a MeasuredTrace,
    /// How it lies over the signal.
    pub place: OverRun,
}

/// What a chart shows.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Its name for the program.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Its signals, the first ones at the back; all of one unit.
    pub curves: &'a [ChartCurve],
    /// A signal with the half-width of the band around it, as a fraction of it.
    pub band: Option<(&'static str, f64)>,
    /// Levels that are marked, with their names.
    pub levels: Vec<(&'static str, f64)>,
    /// Values that are always in the picture.
    pub include: &'static [f64],
    /// What was measured, at the back.
    pub measured: Vec<ChartMeasured<'a>>,
    /// How its values are written: the value and its unit as the tables have it.
    pub write: fn(f64, &str) -> String,
}

impl ChartCurve {
    /// Whether the run before the last change and what is to come are drawn with it: with vibration as well, where the
    /// machine vibrates in the cut.
    pub(super) fn has_ghost(&self, session: &Session) -> bool {
        self.compared || self.look == Look::Dynamics && session.current().machine.coupled
    }

    /// Whether the last cut that was driven by hand is drawn with it: what it turned is its override.
    pub(super) fn has_hand(&self) -> bool {
        self.compared || self.signal == "feed_override_percent"
    }
}

impl<'a> Chart<'a> {
    /// The unit of its values, as the tables have it.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        SIGNALS[index(self.curves[0].signal)].unit
    }

    /// The curves that it is about: those compared with the twin, or else all.
    pub(super) fn foremost(&self) -> impl Iterator<Item = &'a ChartCurve> {
        let any = self.curves.iter().any(|curve| curve.compared);
        self.curves.iter().filter(move |curve| curve.compared || !any)
    }
}

/// What charts with a common time axis share.
#[derive(Clone, Debug, Default)]
pub struct Axes {
    /// Range of time that was zoomed to, s.
    pub(super) zoomed: Option<[f64; 2]>,
    /// Where a drag over a range of time began, points.
    pub(super) drag: Option<f32>,
    /// Legend entries switched off: chart (or [`ALL`]) and name.
    pub(super) hidden: BTreeSet<(&'static str, &'static str)>,
    /// Measured channels switched off, by their numbers.
    pub(super) measured_off: BTreeSet<u64>,
}

/// Stands for the chart where an entry is one of all charts.
pub(super) const ALL: &str = "all";
/// The twin's name for the program: people read which one it is.
pub(super) const TWIN: &str = "constant feed";
/// How the twin's line is drawn, where it is hovered.
const TWIN_DRAWN: &str = text!(
    "It is drawn at the same place of the part: its steps and changes come where those of the cut do. It moves at \
     another feed, so it took another time to get there. Which constant feed it is stands in More settings, under \
     what to compare with."
);

/// What the twin's line is, where it is hovered.
pub(super) fn twin_help(session: &Session) -> String {
    let without = if session.current().machine.coupled { TWIN_WITHOUT } else { "" };
    let what = match session.twin_stand() {
        TwinStand::Programmed => {
            tr("The same part cut at the programmed feed, without a controller: what the papers call conventional, and what \
                the controller Conventional (constant feed) cuts at 100 %.").to_owned()
        }
        TwinStand::Safe(_) => tr("The same part cut without a controller, at the largest constant feed that is nowhere \
            above the tolerance: who must keep it everywhere chooses the feed by the deepest, hardest place. Found by \
            cutting the part at many feeds. The controller Conventional (constant feed) cuts at the programmed feed \
            instead, as the papers' conventional milling does.")
            .to_owned(),
        TwinStand::Finding(_) => tr("The largest constant feed that is nowhere above the tolerance is being found: the \
            part is cut at many feeds.")
            .to_owned(),
        TwinStand::NoneSafe(why) => {
            tr!("The same part cut at the programmed feed, without a controller: {why}.", why = why)
        }
    };
    format!("{what} {}{}{}", tr(TWIN_DRAWN), if without.is_empty() { "" } else { " " }, tr(without))
}
/// What is said of its line where the machine vibrates in the cut.
const TWIN_WITHOUT: &str = text!("Ra and force are drawn without dynamics.");
/// The legend's name of the run before the last change.
pub(super) const GHOST: &str = text!("before");
/// What that line is, where it is hovered.
pub(super) fn ghost_help(session: &Session) -> String {
    let what = tr("The run as it went on before the last change.");
    match session.current().machine.coupled {
        true => format!("{what} {}", tr(GHOST_WITH)),
        false => what.to_owned(),
    }
}
/// What is said of its lines where the machine vibrates in the cut.
const GHOST_WITH: &str = text!("Its thin line is that with dynamics, of Ra and of the force.");
/// The legend's name of the last cut that was driven by hand.
pub(super) const BY_HAND: &str = text!("your hand");
/// What that line is, where it is hovered.
pub(super) const BY_HAND_HELP: &str =
    text!("The same part as you cut it last by hand, drawn at the same places of the part.");
/// The legend's name of the run after the last change.
pub(super) const FUTURE: &str = text!("from now on");
/// What that line is, where it is hovered.
pub(super) const FUTURE_HELP: &str =
    text!("What the run does after the last change, ahead of the playhead.");

impl Axes {
    /// The range of time in the picture.
    #[must_use]
    pub fn range(&self, session: &Session) -> [f64; 2] {
        if let Some(range) = self.zoomed {
            return range;
        }
        let playback = session.playback();
        let length_s = session.length_s();
        // A cut that is over is looked at as a whole.
        if !playback.follow || length_s <= theme::FOLLOW_S || session.finished().is_some() {
            return [0.0, length_s];
        }
        // The playhead stands near the right edge, with some room for what is to come.
        let right = (playback.playhead_s + 0.1 * theme::FOLLOW_S).clamp(theme::FOLLOW_S, length_s);
        [right - theme::FOLLOW_S, right]
    }

    /// Whether a range was zoomed to.
    #[must_use]
    pub fn is_zoomed(&self) -> bool {
        self.zoomed.is_some()
    }

    /// Whether a measured channel is drawn.
    #[must_use]
    pub fn shows_measured(&self, id: u64) -> bool {
        !self.measured_off.contains(&id)
    }

    /// Draws a measured channel, or does not.
    pub fn show_measured(&mut self, id: u64, shown: bool) {
        if shown {
            self.measured_off.remove(&id);
        } else {
            self.measured_off.insert(id);
        }
    }

    /// Back to the automatic range.
    pub fn fit(&mut self) {
        self.zoomed = None;
    }
}

/// Index of a signal in the table.
pub(super) fn index(id: &str) -> usize {
    SIGNALS.iter().position(|signal| signal.id == id).expect("charts name signals of the table")
}
