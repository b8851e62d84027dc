//! What a cut is compared with: nothing of it moves the cut.

crate::choice! {
    /// Which constant feed stands beside a cut.
    pub enum TwinKind {
        /// The largest constant feed that is nowhere rougher than allowed (where a force is held: nowhere above its
        /// tolerance). Whoever must keep the tolerance everywhere programs it: by the deepest, hardest place.
        Safe = "safe", "safe: as fast as the tolerance allows everywhere";
        /// Feed and speed of the program, whatever they do to the surface.
        Programmed = "programmed", "as programmed";
    }
}

crate::settings! {
    /// What a cut is compared with.
    pub struct TwinSettings {
        /// The constant feed that is drawn and told beside the cut.
        kind: TwinKind = TwinKind::Safe, [], "", setup, "Constant feed";
        /// Whether the safe feed may have another spindle speed than the programmed one, within the limits of the
        /// machine and of the force model: of all pairs the one with the least time of cut.
        free_speed: bool = false, [], "", setup, "At any speed";
    }
}
