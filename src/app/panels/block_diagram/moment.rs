//! The state of the loop at the playhead, with the commands under way in the dead-time queue.

use crate::app::format;
use crate::app::panels::equation_cards::Moment;
use crate::app::session::Session;
use crate::run::diagram::Wire;
use crate::run::signals::Row;

/// Most dots in the queue: more would run into each other.
const MAX_DOTS: usize = 40;

/// A command in the queue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnderWay {
    /// How much of its way is done, from 0 to 1.
    pub done: f64,
    /// Feed command, mm/min.
    pub feed_mm_min: f64,
    /// Spindle command, 1/min.
    pub speed_rpm: f64,
}

/// The state of the loop at the playhead.
pub struct Now<'a> {
    /// Row, scenario and what leaves the queue.
    pub moment: Moment<'a>,
    /// The row that is leaving the queue.
    leaving: &'a Row,
    /// The commands of the control samples under way, oldest first.
    pub under_way: Vec<UnderWay>,
}

impl<'a> Now<'a> {
    /// The state at the session's playhead.
    #[must_use]
    pub fn of(session: &'a Session) -> Self {
        let recording = session.chosen().run().recording();
        let rows = recording.rows();
        let playhead_s = session.playback().playhead_s;
        let scenario = session.current();
        let dead_s = scenario.cnc.dead_time_s;
        let last = recording.index_at(playhead_s);
        let leaving = &rows[recording.index_at(playhead_s - dead_s)];
        let delayed = [leaving.feed_command_mm_min, leaving.spindle_command_rpm];
        Self {
            moment: Moment { row: &rows[last], scenario, delayed },
            leaving,
            under_way: under_way(
                rows,
                last,
                dead_s / recording.row_s(),
                recording.control_stride(),
            ),
        }
    }

    /// The value on a wire.
    #[must_use]
    pub fn value(&self, wire: Wire) -> f64 {
        let row = if wire.delayed { self.leaving } else { self.moment.row };
        (wire.info().get)(row)
    }

    /// The value with its unit.
    #[must_use]
    pub fn text(&self, wire: Wire) -> String {
        let row = if wire.delayed { self.leaving } else { self.moment.row };
        if (wire.info().value)(row).is_none() {
            return format::none(row).to_owned();
        }
        let unit = wire.info().unit;
        if unit == "%" {
            let quantised = self.moment.scenario.cnc.override_quantised;
            return format::override_percent(self.value(wire), quantised);
        }
        format::continued(format::quantity(self.value(wire), unit), row, wire.signal)
    }
}

/// The commands sent at control samples within the last `length` rows.
fn under_way(rows: &[Row], last: usize, length: f64, stride: usize) -> Vec<UnderWay> {
    if length < 1.0 {
        return Vec::new();
    }
    let first = (last as f64 - length).max(0.0).ceil() as usize;
    let samples = (length / stride as f64).ceil() as usize;
    let stride = stride * samples.div_ceil(MAX_DOTS).max(1);
    let sent = (first..=last).filter(|i| i % stride == 0);
    sent.map(|i| UnderWay {
        done: (last - i) as f64 / length,
        feed_mm_min: rows[i].feed_command_mm_min,
        speed_rpm: rows[i].spindle_command_rpm,
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_samples_of_20_ms_are_under_way_in_80_ms() {
        let rows: Vec<Row> =
            (0..500).map(|i| Row { feed_command_mm_min: f64::from(i), ..Row::default() }).collect();
        let dots = under_way(&rows, 410, 80.0, 20);
        let feeds: Vec<f64> = dots.iter().map(|dot| dot.feed_mm_min).collect();
        assert_eq!(feeds, [340.0, 360.0, 380.0, 400.0]);
        assert_eq!(dots[3].done, 10.0 / 80.0);
        assert!(under_way(&rows, 410, 0.0, 20).is_empty());
        assert!(under_way(&rows, 499, 500.0, 1).len() <= MAX_DOTS + 1);
        assert_eq!(under_way(&rows, 0, 80.0, 20).len(), 1);
    }
}
