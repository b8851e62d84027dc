//! Disturbances: what comes between a controller and a steady cut, each at a place along the way.
//!
//! ```text
//! part      hard spot     F times a factor                                           over a length
//!           gap           no material                                                over a length
//!           depth         A_D changed by so much, 0 at least                         over a length
//! tool      wear jump     VB grows by so much: w += VB/VB_T                          stays
//!           broken tooth  the next tooth cuts the feed of both                       stays
//! machine   chatter       F_dyn = F (1 + ... + a sin(2 pi f t)): imposed             over a length
//!           dead time     longer by so much                                          over a length
//!           operator      feed command times a factor, behind the dead time          over a length
//! sensor    dropout       reads 0, as a dynamometer does that is unplugged           over a length
//!           drift         offset that grows to so much over a length, then stays
//! ```
//!
//! All of them are decided by place, not by time: every controller, and the constant-feed twin, meets the same at
//! the same place of the part. The place is that of the tool's axis along the whole way; with several cuts it counts
//! the approaches too. Controllers know of none of them. Those of the same kind that overlap act together: factors
//! multiply, all else adds up; a gap is a gap. One of a kind can begin at a place.
//!
//! The sizes are chosen; nothing of the kind is published with the papers. An imposed chatter says nothing of
//! stability: whether a cut chatters by itself, `machine.coupled` and the stability chart say.

mod placed;

pub use placed::{MAX_PLACED, Placed, Placing, SHORTEST_MM, Zone};

use crate::base::language::text;
use crate::base::math::{self, TAU, limit};
use crate::base::settings::Value;
use crate::base::units::ratio_from_percent;

/// Deepest that a disturbed cut may be, mm: as deep as the axial depth may be set.
pub const DEEPEST_MM: f64 = 8.0;
/// Most of a chatter's period in a plant step: from three samples a period on, mean and deviation of a sine are
/// those of its samples.
pub const CHATTER_RESOLVED: f64 = 1.0 / 3.0;

/// How large a disturbance is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeOf {
    /// What it is called in texts.
    pub name: &'static str,
    /// What stands behind the number.
    pub suffix: &'static str,
    /// The size that is offered first.
    pub usual: f64,
}

macro_rules! kinds {
    ($(
        $(#[doc = $doc:literal])+
        $kind:ident: $marker:ident, $id:literal, $field:ident, $label:literal, $text:literal,
        lasts $length:expr, size $size:expr;
    )+) => {
        crate::choice! {
            /// A kind of disturbance.
            pub enum Disturbance {
                $( $(#[doc = $doc])+ $kind = $id, $label; )+
            }
        }

        $(
            #[doc = concat!("Marks the list of its kind: ", $text, ".")]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct $marker;

            impl Placing for $marker {
                const OF: Disturbance = Disturbance::$kind;
            }

            crate::structured!(Placed<$marker>);
        )+

        impl Disturbance {
            /// Its id as that of the shape of its list.
            const fn id_of_kind(self) -> &'static str {
                match self { $( Self::$kind => concat!("disturbance_", $id), )+ }
            }

            /// Path of its list among the settings.
            #[must_use]
            pub const fn path(self) -> &'static str {
                match self { $( Self::$kind => concat!("disturbances.", stringify!($field)), )+ }
            }

            /// Its name within a sentence.
            #[must_use]
            pub const fn in_text(self) -> &'static str {
                match self { $( Self::$kind => $text, )+ }
            }

            const fn length(self) -> Option<f64> {
                match self { $( Self::$kind => $length, )+ }
            }

            /// How large one is; none for those that either are or are not.
            #[must_use]
            pub const fn size(self) -> Option<SizeOf> {
                match self { $( Self::$kind => $size, )+ }
            }
        }

        impl Disturbances {
            /// All of a kind, by place.
            #[must_use]
            pub fn of(&self, kind: Disturbance) -> &[Zone] {
                match kind { $( Disturbance::$kind => self.$field.zones(), )+ }
            }

            /// Whether there are none at all.
            #[must_use]
            pub fn is_empty(&self) -> bool {
                true $( && self.$field.zones().is_empty() )+
            }
        }
    };
}

const fn sized(name: &'static str, suffix: &'static str, usual: f64) -> Option<SizeOf> {
    Some(SizeOf { name, suffix, usual })
}

// Kind, marker, id, field, label, within a sentence; the length offered first, none of one that stays; the size.
kinds! {
    /// A hard spot of the part: the force is multiplied by a factor over a length.
    HardSpot: OfHardSpots, "hard_spot", hard_spots, "Hard spot", "hard spot",
        lasts Some(5.0), size sized(text!("factor"), text!(" times the force"), 1.5);
    /// A gap in the part: no material over a length, the tool goes through the air.
    Gap: OfGaps, "gap", gaps, "Gap", "gap", lasts Some(5.0), size None;
    /// The part is deeper or shallower over a length than it is programmed; controllers do not know of it.
    DepthStep: OfDepths, "depth_step", depth_steps, "Depth step", "depth step",
        lasts Some(10.0), size sized(text!("change"), text!(" mm deeper"), 0.5);
    /// The wear land of the tool grows at once, and stays.
    WearJump: OfWearJumps, "wear_jump", wear_jumps, "Wear jump", "wear jump",
        lasts None, size sized(text!("wear land"), text!(" mm more VB"), 0.1);
    /// A tooth breaks, and stays broken: the next one cuts the feed of both.
    BrokenTooth: OfBrokenTeeth, "broken_tooth", broken_teeth, "Broken tooth", "broken tooth",
        lasts None, size None;
    /// The force oscillates over a length: imposed, not from the stability of the cut.
    ChatterBurst: OfChatter, "chatter_burst", chatter_bursts, "Chatter burst", "chatter burst",
        lasts Some(5.0), size sized(text!("amplitude"), text!(" % of the force"), 20.0);
    /// The sensor reads 0 over a length, as a dynamometer does that is unplugged.
    SensorDropout: OfDropouts, "sensor_dropout", sensor_dropouts, "Sensor dropout", "sensor dropout",
        lasts Some(1.0), size None;
    /// The sensor's reading drifts off by a growing offset over a length, and stays off.
    SensorDrift: OfDrifts, "sensor_drift", sensor_drifts, "Sensor drift", "sensor drift",
        lasts Some(20.0), size sized(text!("offset"), text!(" N in the end"), 50.0);
    /// Commands take longer to the drives over a length.
    DeadTime: OfDeadTimes, "dead_time", dead_times, "Longer dead time", "longer dead time",
        lasts Some(10.0), size sized(text!("addition"), text!(" s longer"), 0.2);
    /// The operator turns the feed override by hand over a length, on top of the controller's.
    Operator: OfOperator, "operator", operator_overrides, "Operator's override", "operator's override",
        lasts Some(5.0), size sized(text!("override"), text!(" % of the feed"), 60.0);
}

crate::settings! {
    /// Disturbances along the way; see [`crate::models::disturbances`].
    pub struct Disturbances {
        /// Hard spots of the part, lists [position, length, factor on the force].
        hard_spots: Placed<OfHardSpots> = Placed::default(), [0.2, 5.0], "", live, "Hard spots";
        /// Gaps of the part, lists [position, length]: air in between.
        gaps: Placed<OfGaps> = Placed::default(), [], "", live, "Gaps";
        /// Changes of the axial depth that no controller knows of, lists [position, length, change of A_D]; what
        /// would be less than no depth is a gap, and the cut is nowhere deeper than 8 mm.
        depth_steps: Placed<OfDepths> = Placed::default(), [-8.0, 8.0], "mm", live, "Surprising depth";
        /// Jumps of the tool's wear, lists [position, growth of the wear land VB]; they stay. The force follows by
        /// the curves of `wear`, whether or not the tool wears by itself; the life used does not change.
        wear_jumps: Placed<OfWearJumps> = Placed::default(), [0.01, 1.0], "mm", live, "Wear jumps";
        /// Places, each in a list of its own, at each of which one more tooth breaks, the first one first, fewer
        /// than there are. Tooth by tooth that tooth is gone; a force that is a map grows by Kienzle's power of the
        /// feed of the teeth that are missing before the next one, (1 + b)^(1 - m_c).
        broken_teeth: Placed<OfBrokenTeeth> = Placed::default(), [], "", live, "Broken teeth";
        /// Bursts of chatter, lists [position, length, amplitude in percent of the force]: imposed on the dynamic
        /// component, not from the stability of the cut.
        chatter_bursts: Placed<OfChatter> = Placed::default(), [1.0, 100.0], "%", live, "Imposed bursts";
        /// Frequency of the bursts (chosen: no multiple of the sampling); a plant step holds a third of a period at most.
        chatter_hz: f64 = 230.0, [1.0, 5000.0], "Hz", live, "Burst frequency";
        /// Where the sensor reads 0, lists [position, length]: what an unplugged dynamometer does.
        sensor_dropouts: Placed<OfDropouts> = Placed::default(), [], "", live, "Sensor dropouts";
        /// Drifts of the sensor, lists [position, length, offset]: the offset grows evenly over the length and
        /// stays. A reading is never negative.
        sensor_drifts: Placed<OfDrifts> = Placed::default(), [-1000.0, 1000.0], "N", live, "Sensor drifts";
        /// Where the dead time is longer, lists [position, length, addition].
        dead_times: Placed<OfDeadTimes> = Placed::default(), [0.01, 2.0], "s", live, "Longer dead times";
        /// Where the operator turns the feed override by hand, lists [position, length, override]: behind the dead
        /// time, on top of what the controller commands and beyond its limits.
        operator_overrides: Placed<OfOperator> = Placed::default(), [10.0, 200.0], "%", live, "Operator's overrides";
    }
}

impl Disturbance {
    /// Whether it is over after a length; otherwise it stays.
    #[must_use]
    pub const fn lasts(self) -> bool {
        self.length().is_some()
    }

    /// The length that is offered first, mm; 0 of one that stays.
    #[must_use]
    pub fn usual_length_mm(self) -> f64 {
        self.length().unwrap_or(0.0)
    }

    /// Whether what it does stays behind its length: a drift goes on being off.
    #[must_use]
    pub fn stays(self) -> bool {
        !self.lasts() || self == Self::SensorDrift
    }

    /// Whether it belongs to the part; otherwise to tool, machine or sensor.
    #[must_use]
    pub fn of_part(self) -> bool {
        match self {
            Self::HardSpot | Self::Gap | Self::DepthStep => true,
            Self::WearJump
            | Self::BrokenTooth
            | Self::ChatterBurst
            | Self::SensorDropout
            | Self::SensorDrift
            | Self::DeadTime
            | Self::Operator => false,
        }
    }
}

/// Places that are told apart, mm: nearer than that, a disturbance takes the place of another of its kind.
const APART_MM: f64 = 0.01;

impl Disturbances {
    /// The value of the list of a kind with one more; one of the kind that begins at the same place gives way.
    #[must_use]
    pub fn with(&self, kind: Disturbance, zone: Zone) -> Value {
        let mut zones = self.of(kind).to_vec();
        zones.retain(|other| (other.at_mm - zone.at_mm).abs() >= APART_MM);
        let before = zones.partition_point(|other| other.at_mm < zone.at_mm);
        zones.insert(before, zone);
        placed::written(kind, &zones)
    }

    /// All of them, kind by kind.
    pub fn all(&self) -> impl Iterator<Item = (Disturbance, Zone)> {
        let each = |kind: Disturbance| self.of(kind).iter().map(move |zone| (kind, *zone));
        Disturbance::ALL.iter().copied().flat_map(each)
    }

    /// Factor of the hard spots on the force at a place in mm.
    #[must_use]
    pub fn hardness_factor(&self, position_mm: f64) -> f64 {
        self.hard_spots.at(position_mm).map(|zone| zone.size).product()
    }

    /// Whether the part differs anywhere from how it is programmed in depth.
    #[must_use]
    pub fn changes_depth(&self) -> bool {
        !(self.gaps.zones().is_empty() && self.depth_steps.zones().is_empty())
    }

    /// Axial depth in mm at a place in mm where so much is programmed.
    #[must_use]
    pub fn depth_mm(&self, position_mm: f64, programmed_mm: f64) -> f64 {
        if self.gaps.at(position_mm).next().is_some() {
            return 0.0;
        }
        let changes: f64 = self.depth_steps.at(position_mm).map(|zone| zone.size).sum();
        math::positive(programmed_mm + changes)
    }

    /// Where the depth changes along the way, mm, ascending.
    #[must_use]
    pub fn depth_borders_mm(&self) -> Vec<f64> {
        let zones = self.gaps.zones().iter().chain(self.depth_steps.zones());
        let mut borders: Vec<f64> = zones.flat_map(|zone| [zone.at_mm, zone.end_mm()]).collect();
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        borders
    }

    /// Growth of the wear land in mm by all jumps up to a place in mm.
    #[must_use]
    pub fn wear_land_mm(&self, position_mm: f64) -> f64 {
        self.wear_jumps.at(position_mm).map(|zone| zone.size).sum()
    }

    /// Teeth that are broken at a place in mm.
    #[must_use]
    pub fn broken_teeth(&self, position_mm: f64) -> usize {
        self.broken_teeth.at(position_mm).count()
    }

    /// Amplitude of the chatter at a place in mm as a share of the force.
    #[must_use]
    pub fn chatter_share(&self, position_mm: f64) -> f64 {
        ratio_from_percent(self.chatter_bursts.at(position_mm).map(|zone| zone.size).sum())
    }

    /// Course of the chatter at a time in s, from -1 to 1.
    #[must_use]
    pub fn chatter_course(&self, time_s: f64) -> f64 {
        let turns = self.chatter_hz * time_s;
        math::sin(TAU * (turns - turns.floor()))
    }

    /// What the sensor tells of a force in N that it would read at a place in mm.
    #[must_use]
    pub fn sensed_n(&self, position_mm: f64, read_n: f64) -> f64 {
        if self.sensor_dropouts.at(position_mm).next().is_some() {
            return 0.0;
        }
        let drifted =
            |zone: &Zone| zone.size * limit((position_mm - zone.at_mm) / zone.length_mm, 0.0, 1.0);
        let offset_n: f64 = self.sensor_drifts.zones().iter().map(drifted).sum();
        math::positive(read_n + offset_n)
    }

    /// By how much the dead time is longer at a place in mm, s.
    #[must_use]
    pub fn added_dead_time_s(&self, position_mm: f64) -> f64 {
        self.dead_times.at(position_mm).map(|zone| zone.size).sum()
    }

    /// Factor of the operator's hand on the feed at a place in mm.
    #[must_use]
    pub fn operator_factor(&self, position_mm: f64) -> f64 {
        let factors = self.operator_overrides.at(position_mm);
        factors.map(|zone| ratio_from_percent(zone.size)).product()
    }

    /// The next place behind one in mm at which any of them begins or ends, mm; infinite where there is none.
    #[must_use]
    pub fn next_border_mm(&self, position_mm: f64) -> f64 {
        let borders = self.all().flat_map(|(_, zone)| [zone.at_mm, zone.end_mm()]);
        borders.filter(|border| *border > position_mm).fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests;
