//! What follows from the list of controllers.

/// From the list of controllers `module::Type = "id", "Label";` their modules, [`ControllerKind`],
/// [`ControllerSettings`] and [`Controller`]. Nothing else in the program lists controllers.
///
/// [`ControllerKind`]: super::ControllerKind
/// [`ControllerSettings`]: super::ControllerSettings
/// [`Controller`]: super::Controller
macro_rules! controllers {
    ($( $module:ident :: $name:ident = $id:literal, $label:literal; )+) => {
        $( pub mod $module; )+

        /// A controller.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum ControllerKind {
            $( #[doc = concat!($label, ": [`", stringify!($module), "`].")] $name, )+
        }

        crate::choice!(@options ControllerKind {
            $( $name = $id, $label, <$module::$name as ControlLaw>::ABOUT; )+
        });

        impl ControllerKind {
            /// The group of its settings, `controller.<id>`.
            #[must_use]
            pub fn group(self) -> &'static str {
                match self { $( Self::$name => concat!("controller.", $id), )+ }
            }

            /// What it holds.
            #[must_use]
            pub fn held(self) -> Held {
                match self { $( Self::$name => <$module::$name as ControlLaw>::HELD, )+ }
            }

            /// Whether networks learn in it.
            #[must_use]
            pub fn learns(self) -> bool {
                match self { $( Self::$name => <$module::$name as ControlLaw>::LEARNS, )+ }
            }

            /// Whether a control period of it takes memory.
            #[must_use]
            pub fn allocates(self) -> bool {
                match self { $( Self::$name => <$module::$name as ControlLaw>::ALLOCATES, )+ }
            }

            /// The limits that it keeps, of those that the overrides set.
            #[must_use]
            pub fn limits(self, overrides: Limits) -> Limits {
                match self { $( Self::$name => <$module::$name as ControlLaw>::limits(overrides), )+ }
            }
        }

        /// Which controller closes the loop, and the settings of every controller.
        #[derive(Clone, Debug, PartialEq)]
        pub struct ControllerSettings {
            /// The controller that moves feed and spindle speed.
            pub kind: ControllerKind,
            $(
                #[doc = concat!("Settings under `controller.", $id, "`.")]
                pub $module: <$module::$name as ControlLaw>::Settings,
            )+
        }

        impl Default for ControllerSettings {
            fn default() -> Self {
                Self { kind: DEFAULT, $( $module: Default::default(), )+ }
            }
        }

        impl Group for ControllerSettings {
            fn specs() -> Vec<Spec> {
                vec![Spec {
                    key: "kind",
                    label: "Controller",
                    unit: "",
                    doc: "The controller that moves feed and spindle speed.",
                    allowed: ControllerKind::kind(0.0, 0.0),
                    default: DEFAULT.to_value(),
                    live: true,
                }]
            }
            fn get(&self, key: &str) -> Option<Value> {
                (key == "kind").then(|| self.kind.to_value())
            }
            fn set(&mut self, key: &str, value: &Value, kind: &Kind) -> Option<()> {
                if key != "kind" {
                    return None;
                }
                self.kind = ControllerKind::from_value(value, kind)?;
                Some(())
            }
            fn parts() -> Vec<(&'static str, Vec<Spec>)> {
                vec![ $( (
                    concat!("controller.", $id),
                    <<$module::$name as ControlLaw>::Settings as Group>::specs(),
                ), )+ ]
            }
            fn part(&self, path: &str) -> Option<&dyn Group> {
                match path { $( concat!("controller.", $id) => Some(&self.$module), )+ _ => None }
            }
            fn part_mut(&mut self, path: &str) -> Option<&mut dyn Group> {
                match path { $( concat!("controller.", $id) => Some(&mut self.$module), )+ _ => None }
            }
        }

        impl ControllerSettings {
            /// Where the chosen controller brings the force to rest in a cut that does not change.
            #[must_use]
            pub fn at_rest(&self) -> AtRest {
                match self.kind { $(
                    ControllerKind::$name => <$module::$name as ControlLaw>::at_rest(&self.$module),
                )+ }
            }

            /// Keys of the beliefs that the chosen controller asks for, as it is set.
            #[must_use]
            pub fn believes(&self) -> &'static [&'static str] {
                match self.kind { $(
                    ControllerKind::$name => <$module::$name as ControlLaw>::believes(&self.$module),
                )+ }
            }

            /// Keys of the chosen controller's settings that have no part in it as the others stand.
            #[must_use]
            pub fn left_out(&self) -> &'static [&'static str] {
                match self.kind { $(
                    ControllerKind::$name => <$module::$name as ControlLaw>::left_out(&self.$module),
                )+ }
            }

            /// The law of the chosen controller as its source prints it, where its models are those
            /// of `set`.
            #[must_use]
            pub fn printed(&self, set: ModelSet) -> Vec<Printed> {
                match self.kind { $(
                    ControllerKind::$name => {
                        <$module::$name as ControlLaw>::printed(&self.$module, set)
                    }
                )+ }
            }

            /// The law of the chosen controller with the values of a moment.
            #[must_use]
            pub fn explain(&self, moment: &ControlMoment) -> Explained {
                match self.kind { $(
                    ControllerKind::$name => {
                        <$module::$name as ControlLaw>::explain(&self.$module, moment)
                    }
                )+ }
            }
        }

        /// A controller with its state.
        #[derive(Clone, Debug)]
        pub enum Controller {
            $( #[doc = concat!("See [`", stringify!($module), "`].")] $name(Box<$module::$name>), )+
        }

        impl Controller {
            /// The chosen controller at the start of a run, the machine at rest at the programmed
            /// values.
            #[must_use]
            pub fn new(setup: &ControlSetup, programmed: FeedSpeed) -> Self {
                match setup.settings.kind { $( ControllerKind::$name => Self::$name(Box::new(
                    <$module::$name as ControlLaw>::new(&setup.settings.$module, setup, programmed),
                )), )+ }
            }

            /// Which it is.
            #[must_use]
            pub fn kind(&self) -> ControllerKind {
                match self { $( Self::$name(_) => ControllerKind::$name, )+ }
            }

            /// Takes over changed settings and keeps its state if it is still the chosen one;
            /// otherwise the chosen one takes over the running machine.
            pub fn reconfigure(&mut self, setup: &ControlSetup, running: &Running) {
                let settings = setup.settings;
                if self.kind() != settings.kind {
                    *self = match settings.kind { $( ControllerKind::$name => Self::$name(Box::new(
                        <$module::$name as ControlLaw>::take_over(&settings.$module, setup, running),
                    )), )+ };
                    return;
                }
                match self { $( Self::$name(law) => law.configure(&settings.$module, setup), )+ }
            }

            /// A new cut begins at the programmed values: what was learned stays, dynamic state goes.
            pub fn restart(&mut self, programmed: FeedSpeed) {
                match self { $( Self::$name(law) => law.restart(programmed), )+ }
            }

            /// One control period.
            pub fn update(&mut self, input: &ControlInput) -> ControlOutput {
                match self { $( Self::$name(law) => law.update(input), )+ }
            }

            /// What went wrong in it, if anything did.
            #[must_use]
            pub fn problem(&self) -> Option<&script::ScriptProblem> {
                match self { $( Self::$name(law) => law.problem(), )+ }
            }

            /// The networks that learn in the cut, for display; none where there are none.
            #[must_use]
            pub fn learning(&self) -> Option<unks::Learning<'_>> {
                match self { $( Self::$name(law) => law.learning(), )+ }
            }
        }
    };
}
