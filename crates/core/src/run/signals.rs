//! The signals of a run: one table gives rows, CSV headers, axis titles and the digest.

use crate::base::language::text;

macro_rules! signals {
    ($(
        $(#[doc = $doc:literal])+ $name:ident, $unit:literal, $label:literal
        $(, none where $none:expr)?;
    )+) => {
        /// One recorded row: all signals at one tick.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct Row {
            $( $(#[doc = $doc])+ pub $name: f64, )+
        }

        /// The table of signals, in the order of [`Row::values`].
        pub const SIGNALS: &[SignalInfo] = &[
            $( SignalInfo {
                id: stringify!($name),
                unit: $unit,
                label: $label,
                doc: concat!($($doc),+),
                get: |row| row.$name,
                value: |row| {
                    $( let none: fn(&Row) -> bool = $none; if none(row) { return None; } )?
                    Some(row.$name)
                },
            }, )+
        ];

        impl Row {
            /// Number of signals.
            pub const LEN: usize = SIGNALS.len();

            /// All values in the order of [`SIGNALS`].
            #[must_use]
            #[inline]
            pub fn values(&self) -> [f64; Self::LEN] {
                [ $( self.$name, )+ ]
            }
        }
    };
}

/// The description of one signal.
#[derive(Clone, Copy, Debug)]
pub struct SignalInfo {
    /// Its name in CSV, JSON and code; ends with the unit.
    pub id: &'static str,
    /// Unit, `-` for none.
    pub unit: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// What it is.
    pub doc: &'static str,
    /// Reads it from a row; 0 where there is none.
    pub get: fn(&Row) -> f64,
    /// Its value in a row, if there is one: without a chip there is no roughness, and none where its model has
    /// ended at zero.
    pub value: fn(&Row) -> Option<f64>,
}

signals! {
    /// Time since the start of the run.
    time_s, "s", "Time";
    /// Position of the tool along the path.
    position_mm, "mm", "Position";
    /// Axial depth of cut A_D at the tool.
    axial_depth_mm, "mm", "Axial depth";
    /// Radial depth of cut R_D at the tool.
    radial_depth_mm, "mm", "Radial depth";
    /// Target roughness.
    ra_target_um, "um", "Target Ra";
    /// Produced roughness, Ra = K5(F) or M5(F).
    ra_um, "um", "Ra", none where |row| row.has(flag::AIR) || row.ra_has_ended();
    /// Produced roughness with machine dynamics, Ra = K6(F_dyn) or M6(F_dyn).
    ra_dyn_um, "um", "Ra with dynamics",
        none where |row| {
            // Where model 5 has ended, what vibration adds would stand alone.
            row.has(flag::AIR)
                || row.ra_has_ended()
                || row.has(flag::K6_OUTSIDE) && row.ra_dyn_um == 0.0
        };
    /// Desired force F_d = K1(target Ra) or M1(target Ra).
    force_ref_n, "N", "Desired force";
    /// The force that the controller asks its models for.
    force_setpoint_n, "N", "Force setpoint";
    /// Maximum cutting force of the control window by the plant's model, without vibration: a map gives
    /// it at once and without the dynamic component; tooth by tooth it is the largest of the last whole
    /// control period, in the material as it is there.
    force_n, "N", "Maximum force";
    /// The same maximum with all that shakes it, dynamic component and vibration: what is sensed.
    force_dyn_n, "N", "Force with dynamics";
    /// Force as measured at the last control sample.
    force_measured_n, "N", "Measured force";
    /// Feed command as sent by the controller.
    feed_command_mm_min, "mm/min", "Feed command";
    /// Actual feed.
    feed_mm_min, "mm/min", "Feed";
    /// Feed override DNCFRO, of the programmed feed.
    feed_override_percent, "%", "Feed override";
    /// Spindle speed command as sent by the controller.
    spindle_command_rpm, "1/min", "Spindle command";
    /// Actual spindle speed.
    spindle_rpm, "1/min", "Spindle speed";
    /// Spindle override DNCSPO, of the programmed speed.
    spindle_override_percent, "%", "Spindle override";
    /// The controller's estimate of true over modelled force.
    gain_estimate, "-", "Gain estimate";
    /// Fraction of the tool's life that is used.
    used_life, "-", "Tool life used";
    /// Displacement of the tooth off the work as the last tooth made the surface; coupled machine only.
    vibration_um, "um", "Vibration";
    /// Trend of the cutting sound E_S: root mean square of the velocity between tooth and work over
    /// the last second; coupled machine only.
    sound_mm_s, "mm/s", "Sound";
    /// Saturation, models outside their range, air: a sum of the bits in the table of flags.
    state_flags, "-", "State flags";
}

impl SignalInfo {
    /// Column title: the name with its unit.
    #[must_use]
    pub fn header(&self) -> String {
        format!("{} [{}]", self.id, self.unit)
    }
}

/// The signal with this id.
#[must_use]
pub fn signal(id: &str) -> Option<&'static SignalInfo> {
    SIGNALS.iter().find(|signal| signal.id == id)
}

/// One bit of [`Row::state_flags`].
#[derive(Clone, Copy, Debug)]
pub struct FlagInfo {
    /// The bit's value.
    pub bit: u32,
    /// Its name in JSON.
    pub id: &'static str,
    /// Its name for people.
    pub label: &'static str,
}

/// Bits of [`Row::state_flags`].
pub mod flag {
    /// The feed command stands at a limit.
    pub const FEED_SATURATED: u32 = 1;
    /// The speed command stands at a limit.
    pub const SPEED_SATURATED: u32 = 2;
    /// Model 1 (K1, M1) is used outside its range.
    pub const K1_OUTSIDE: u32 = 4;
    /// Model 2 (or the inverse of model 4 in its place) is used outside its range.
    pub const K2_OUTSIDE: u32 = 8;
    /// Model 3 is used outside its range.
    pub const K3_OUTSIDE: u32 = 16;
    /// Model 4, or the neural force model, is used outside its range.
    pub const K4_OUTSIDE: u32 = 32;
    /// Model 5 is used outside its range.
    pub const K5_OUTSIDE: u32 = 64;
    /// Model 6 is used outside its range.
    pub const K6_OUTSIDE: u32 = 128;
    /// No chip is cut, since the tool is in the air or stands: no force, no roughness.
    pub const AIR: u32 = 256;
    /// The feed override moves no faster than its rate allows.
    pub const FEED_RATE_LIMITED: u32 = 512;
    /// The spindle override moves no faster than its rate allows.
    pub const SPEED_RATE_LIMITED: u32 = 1024;
    /// A tooth that should cut has jumped out of the cut: chatter.
    pub const LOST_CONTACT: u32 = 2048;
    /// The measured force has been over the controller's own limit for too long.
    pub const OVER_LIMIT: u32 = 4096;
    /// The controller has switched itself off, and the feed is as programmed.
    pub const CONTROL_OFF: u32 = 8192;
    /// A tooth of the cutter is broken, by its load or by a disturbance.
    pub const TOOTH_BROKEN: u32 = 16_384;
    /// An override moves no faster than its rate allows.
    pub const RATE_LIMITED: u32 = FEED_RATE_LIMITED | SPEED_RATE_LIMITED;
    /// A command stands at a limit.
    pub const SATURATED: u32 = FEED_SATURATED | SPEED_SATURATED;
    /// Some model is used outside its range.
    pub const OUTSIDE: u32 =
        K1_OUTSIDE | K2_OUTSIDE | K3_OUTSIDE | K4_OUTSIDE | K5_OUTSIDE | K6_OUTSIDE;
}

/// All flags.
pub const FLAGS: &[FlagInfo] = &[
    FlagInfo { bit: flag::FEED_SATURATED, id: "feed_saturated", label: text!("feed at a limit") },
    FlagInfo {
        bit: flag::SPEED_SATURATED,
        id: "speed_saturated",
        label: text!("speed at a limit"),
    },
    FlagInfo { bit: flag::K1_OUTSIDE, id: "k1_outside", label: "K1 outside its range" },
    FlagInfo { bit: flag::K2_OUTSIDE, id: "k2_outside", label: "K2 outside its range" },
    FlagInfo { bit: flag::K3_OUTSIDE, id: "k3_outside", label: "K3 outside its range" },
    FlagInfo { bit: flag::K4_OUTSIDE, id: "k4_outside", label: "K4 outside its range" },
    FlagInfo { bit: flag::K5_OUTSIDE, id: "k5_outside", label: "K5 outside its range" },
    FlagInfo { bit: flag::K6_OUTSIDE, id: "k6_outside", label: "K6 outside its range" },
    FlagInfo { bit: flag::AIR, id: "air", label: text!("in the air") },
    FlagInfo {
        bit: flag::FEED_RATE_LIMITED,
        id: "feed_rate_limited",
        label: text!("feed override at its rate"),
    },
    FlagInfo {
        bit: flag::SPEED_RATE_LIMITED,
        id: "speed_rate_limited",
        label: text!("spindle override at its rate"),
    },
    FlagInfo { bit: flag::LOST_CONTACT, id: "lost_contact", label: text!("tooth out of contact") },
    FlagInfo {
        bit: flag::OVER_LIMIT,
        id: "over_limit",
        label: text!("force over the controller's limit"),
    },
    FlagInfo { bit: flag::CONTROL_OFF, id: "control_off", label: text!("control switched off") },
    FlagInfo { bit: flag::TOOTH_BROKEN, id: "tooth_broken", label: text!("tooth broken") },
];

impl Row {
    /// Whether any of the flag's bits is set.
    #[must_use]
    pub fn has(&self, bits: u32) -> bool {
        self.state_flags as u32 & bits != 0
    }

    /// Whether model 5 has ended at zero for the force: a roughness outside the model, not of 0.
    #[must_use]
    pub fn ra_has_ended(&self) -> bool {
        self.has(flag::K5_OUTSIDE) && self.ra_um == 0.0
    }
}
