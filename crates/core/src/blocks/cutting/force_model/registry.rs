//! What follows from the list of force models.

/// From the list of force models `module::Type = "id", "Label";` their modules, [`ForceModel`] and
/// [`Process`]. Nothing else in the program lists force models.
///
/// [`ForceModel`]: super::ForceModel
/// [`Process`]: super::Process
macro_rules! force_models {
    ($( $module:ident :: $name:ident = $id:literal, $label:literal; )+) => {
        $( pub mod $module; )+

        /// What gives the plant's cutting force.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum ForceModel {
            $( #[doc = concat!($label, ": [`", stringify!($module), "`].")] $name, )+
        }

        crate::choice!(@options ForceModel {
            $( $name = $id, $label, <$module::$name as ForceModelLaw>::ABOUT; )+
        });

        impl ForceModel {
            /// Whether the force is a function of feed, speed and engagement that gives the largest force
            /// of a revolution at once.
            #[must_use]
            pub fn is_map(self) -> bool {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::MAP, )+ }
            }

            /// Whether the force is the formula of a published model set, K4 or M4: what the tables of
            /// the papers were made with.
            #[must_use]
            pub fn is_formula(self) -> bool {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::FORMULA, )+ }
            }

            /// The network; `None` for the other force models.
            #[must_use]
            pub fn network(self) -> Option<NeuralKind> {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::NETWORK, )+ }
            }

            /// Longest plant step in s with which the force can be simulated; infinite for a map.
            #[must_use]
            pub fn longest_step_s(self) -> f64 {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::LONGEST_STEP_S, )+ }
            }

            /// The model set that was identified on this very force; `None` where the controller's
            /// models are those of the plant's own set.
            #[must_use]
            pub fn identified_set(self) -> Option<ModelSet> {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::IDENTIFIED_SET, )+ }
            }

            /// What it is called beside K1..K6 or M1..M6, where the formula is that of `set`.
            #[must_use]
            pub fn short_name(self, set: ModelSet) -> String {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::short_name(set), )+ }
            }

            /// Its equations as printed, where the formula is that of `set`.
            #[must_use]
            pub fn printed(self, set: ModelSet) -> &'static [Printed] {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::printed(set), )+ }
            }

            /// Its equations with the values of a moment.
            #[must_use]
            pub fn explain(self, moment: &ForceMoment) -> Vec<Live> {
                match self { $( Self::$name => <$module::$name as ForceModelLaw>::explain(moment), )+ }
            }

            /// Of a map, the force in N at feed in mm/min, speed in 1/min and an engagement; none of a
            /// force that is simulated tooth by tooth.
            #[must_use]
            pub fn at(
                self,
                setup: &ForceSetup,
                feed_mm_min: f64,
                speed_rpm: f64,
                place: &Engagement,
            ) -> Option<Valued> {
                match self { $(
                    Self::$name => {
                        <$module::$name as ForceModelLaw>::at(setup, feed_mm_min, speed_rpm, place)
                    }
                )+ }
            }
        }

        /// The force of a plant by its model, with its state.
        #[derive(Clone, Debug)]
        pub enum Process {
            $( #[doc = concat!("See [`", stringify!($module), "`].")] $name(Box<$module::$name>), )+
        }

        impl Process {
            /// The force of a plant at the start of a run.
            #[must_use]
            pub fn of(setup: &ForceSetup) -> Self {
                match setup.plant.force_model { $(
                    ForceModel::$name => {
                        Self::$name(Box::new(<$module::$name as ForceModelLaw>::new(setup)))
                    }
                )+ }
            }

            /// Takes over settings changed in the cut; the same model goes on where it stands.
            pub fn reconfigure(&mut self, mut now: Self) {
                $( if let (Self::$name(before), Self::$name(now)) = (&*self, &mut now) {
                    now.take_over(before);
                } )+
                *self = now;
            }

            /// Takes the compliance of the force tooth by tooth away: a machine that is coupled to the
            /// cut has its own, and counted twice the tool would be too soft.
            pub fn make_rigid(&mut self) {
                match self { $( Self::$name(law) => law.make_rigid(), )+ }
            }

            /// So many teeth are broken from now on; see [`ForceModelLaw::break_teeth`].
            pub fn break_teeth(&mut self, broken: usize) -> f64 {
                match self { $( Self::$name(law) => law.break_teeth(broken), )+ }
            }

            /// A new cut begins.
            pub fn restart(&mut self) {
                match self { $( Self::$name(law) => law.restart(), )+ }
            }

            /// What the teeth do at the last instant, where there are teeth.
            #[must_use]
            #[inline]
            pub fn teeth(&self) -> Option<&Cutting> {
                match self { $( Self::$name(law) => law.teeth(), )+ }
            }

            /// The same, for a machine that shakes them.
            #[inline]
            pub fn teeth_mut(&mut self) -> Option<&mut Cutting> {
                match self { $( Self::$name(law) => law.teeth_mut(), )+ }
            }

            /// The spindle's turn at the last instant, from 0 to below 1, where there are teeth.
            #[must_use]
            pub fn spindle_turn(&self) -> Option<f64> {
                match self { $( Self::$name(law) => law.spindle_turn(), )+ }
            }

            /// The force of a plant step, before any machine vibrates; see [`ForceModelLaw::cut`].
            #[inline]
            pub fn cut(&mut self, step: &CutStep, dynamic: impl FnOnce() -> f64) -> Force {
                match self { $( Self::$name(law) => law.cut(step, dynamic), )+ }
            }
        }
    };
}
