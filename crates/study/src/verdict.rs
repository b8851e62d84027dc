//! What runs say of a band, a claim or a finding: an id for programs, beside the words for people.

steadycut_core::choice! {
    /// What runs say.
    pub enum Verdict {
        /// It holds.
        Holds = "holds", "holds";
        /// A part of it holds.
        InPart = "in_part", "holds in part";
        /// It does not hold.
        Not = "does_not_hold", "does not hold";
        /// No run has given a figure to judge it by.
        NoRun = "no_run", "no run yet";
    }
}

impl From<bool> for Verdict {
    fn from(holds: bool) -> Self {
        if holds { Self::Holds } else { Self::Not }
    }
}
