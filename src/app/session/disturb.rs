//! Disturbances dropped into the cut: at a place of the part, or a little ahead of the tool.

use super::Session;
use crate::app::command::DisturbCommand;
use crate::app::format;
use crate::base::equation::number;
use crate::base::language::{decimal, tr};
use crate::blocks::cutting::tool_path::ToolPath;
use crate::models::disturbances::{Disturbance, Zone};

/// How far ahead of the tool one begins that is dropped without a place, mm: so near that it is met at once, and not
/// yet met in the step that is being cut.
const AHEAD_MM: f64 = 0.5;
/// Places are such parts of a millimetre, so that people can read them.
const PARTS_OF_MM: f64 = 10.0;

/// The sizes and lengths that are offered at first, kind by kind.
pub(super) fn usual() -> Vec<Zone> {
    let usual = |kind: &Disturbance| Zone {
        at_mm: 0.0,
        length_mm: if kind.lasts() { kind.usual_length_mm() } else { f64::INFINITY },
        size: kind.size().map_or(1.0, |size| size.usual),
    };
    Disturbance::ALL.iter().map(usual).collect()
}

fn index(kind: Disturbance) -> usize {
    Disturbance::ALL.iter().position(|other| *other == kind).unwrap_or_default()
}

impl Session {
    /// Length and size with which a kind is dropped next: those used last, or the usual ones.
    #[must_use]
    pub fn offered(&self, kind: Disturbance) -> Zone {
        self.offered[index(kind)]
    }

    /// Drops a disturbance, or keeps what the next one is to be like.
    pub(super) fn disturb(&mut self, command: DisturbCommand) {
        match command {
            DisturbCommand::Offer { kind, zone } => self.offered[index(kind)] = zone,
            DisturbCommand::Drop { kind, at_mm } => {
                if let Err(refused) = self.drop_in(kind, at_mm) {
                    self.notify(refused);
                }
            }
        }
    }

    /// An edit at the playhead where the place is still ahead of the tool; what lies behind it is a part of the
    /// scenario itself, and the cut is done again under the playhead.
    fn drop_in(&mut self, kind: Disturbance, at_mm: Option<f64>) -> Result<(), String> {
        let tool_mm = self.row().position_mm;
        let ahead_mm = || ((tool_mm + AHEAD_MM) * PARTS_OF_MM).ceil() / PARTS_OF_MM;
        let at_mm =
            at_mm.map_or_else(ahead_mm, |at_mm| (at_mm * PARTS_OF_MM).round() / PARTS_OF_MM);
        let end_mm = ToolPath::length_of(&self.current.workpiece);
        if at_mm >= end_mm || at_mm < 0.0 {
            return Err(tr!(
                "No {kind} at {place}: the cut goes from 0 to {end}. Go back in time first, or place it on the part.",
                kind = tr(kind.in_text()),
                place = format::quantity(at_mm, "mm"),
                end = format::quantity(end_mm, "mm")
            ));
        }
        let zone = Zone { at_mm, ..self.offered(kind) };
        let value = self.current.disturbances.with(kind, zone);
        // Each is a step of undo of its own.
        self.gesture = None;
        let ahead = at_mm > tool_mm;
        let done = match ahead {
            true => self.set(kind.path(), value),
            false => self.set_up(&[(kind.path().to_owned(), value)]),
        };
        self.gesture = None;
        done.map_err(|error| error.to_string())?;
        let what = told(kind, &zone);
        self.notify(match ahead {
            true => tr!("{what}. Undo takes it back.", what = what),
            false => tr!(
                "{what}, behind the tool: the cut is done again. Undo takes it back.",
                what = what
            ),
        });
        Ok(())
    }
}

/// A disturbance in words, with its place.
#[must_use]
pub fn told(kind: Disturbance, zone: &Zone) -> String {
    let size = kind.size().map(|size| format!("{}{}", decimal(number(zone.size)), tr(size.suffix)));
    let length = kind.lasts().then(|| format::quantity(zone.length_mm, "mm"));
    let (kind, place) = (tr(kind.label()), format::quantity(zone.at_mm, "mm"));
    match (size, length) {
        (None, None) => tr!("{kind} at {place}", kind = kind, place = place),
        (Some(size), None) => {
            tr!("{kind} at {place}: {size}", kind = kind, place = place, size = size)
        }
        (None, Some(length)) => {
            tr!("{kind} at {place}: over {length}", kind = kind, place = place, length = length)
        }
        (Some(size), Some(length)) => tr!(
            "{kind} at {place}: {size} over {length}",
            kind = kind,
            place = place,
            size = size,
            length = length
        ),
    }
}
