//! What a chart shows, and the time axis that charts share.

use std::collections::BTreeSet;

use crate::app::session::Session;
use crate::app::theme::{self, Look};
use crate::run::signals::SIGNALS;

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
    /// How its values are written: the value and its unit as the tables have it.
    pub write: fn(f64, &str) -> String,
}

impl<'a> Chart<'a> {
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
}

/// Stands for the chart where an entry is one of all charts.
pub(super) const ALL: &str = "all";
/// The legend's name of the twin.
pub(super) const TWIN: &str = "constant feed";
/// What the twin's line is, where it is hovered.
pub(super) const TWIN_HELP: &str = "The same part cut at the programmed feed, without a controller, drawn at \
    the same place of the part: its steps and changes come where those of the cut do. It moves at another \
    feed, so it took another time to get there.";
/// The legend's name of the run before the last change.
pub(super) const GHOST: &str = "before";
/// What that line is, where it is hovered.
pub(super) const GHOST_HELP: &str = "The run as it went on before the last change.";
/// The legend's name of the run after the last change.
pub(super) const FUTURE: &str = "from now on";
/// What that line is, where it is hovered.
pub(super) const FUTURE_HELP: &str =
    "What the run does after the last change, ahead of the playhead.";

impl Axes {
    /// The range of time in the picture.
    #[must_use]
    pub fn range(&self, session: &Session) -> [f64; 2] {
        if let Some(range) = self.zoomed {
            return range;
        }
        let playback = session.playback();
        let length_s = session.length_s();
        if !playback.follow || length_s <= theme::FOLLOW_S {
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

    /// Back to the automatic range.
    pub fn fit(&mut self) {
        self.zoomed = None;
    }
}

/// Index of a signal in the table.
pub(super) fn index(id: &str) -> usize {
    SIGNALS.iter().position(|signal| signal.id == id).expect("charts name signals of the table")
}
