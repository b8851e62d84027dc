//! The fits of measured data as one front end or the other asks for them: channels in their roles and a few options go in,
//! values with intervals, what is left, settings and a file come out.
//!
//! A fit is one file here and one line in the list below. Its file says what it is called, which channels it reads in which
//! unit, which options it has, and how sample data are made for it ([`MeasuredFit`]); commands, screen and tests follow.

mod data;
mod job;
mod outcome;
mod request;

pub use data::{EvenChannel, force_n};
pub use job::MeasuredFitJob;
pub use outcome::{FitEstimate, FitOutcome, FitPlot, FitTable};
pub use request::{
    ChosenChannel, FitFault, FitOption, FitOptionKind, FitRequest, FitRole, FitValue, WITHIN,
    likely_channels,
};

use crate::run::scenario::Scenario;

/// What is known of a fit before it is made.
#[derive(Clone, Copy, Debug)]
pub struct FitAbout {
    /// Its name.
    pub title: &'static str,
    /// What it finds.
    pub finds: &'static str,
    /// What has to be recorded for it.
    pub needs: &'static str,
    /// A command that makes sample data, or what they look like.
    pub sample: &'static str,
    /// Whether it reads a recording in time; otherwise a table whose rows have no times.
    pub timed: bool,
    /// The channels that it reads.
    pub roles: &'static [FitRole],
    /// Its options.
    pub options: &'static [FitOption],
    /// Most steps that it takes.
    pub most_steps: usize,
}

/// A fit.
pub trait MeasuredFit {
    /// What is known of it.
    const ABOUT: FitAbout;
    /// The fit while it is worked at.
    type Work: FitAtWork;

    /// What is missing before it can begin, beside the roles that always have to be filled.
    fn lacks(_: &FitRequest) -> Option<FitFault> {
        None
    }

    /// Begins it.
    ///
    /// # Errors
    /// What of the request cannot be, by its option.
    fn begin(request: &FitRequest) -> Result<Self::Work, FitFault>;

    /// A recording as the cut of a scenario would give it, as CSV, with noise by a seed.
    ///
    /// # Errors
    /// The scenario has nothing of the kind.
    fn sample(scenario: &Scenario, seed: u32) -> Result<String, String>;
}

/// A fit while it is worked at.
pub trait FitAtWork: Clone + Send {
    /// Does the next step; `true` while there are more.
    fn step(&mut self) -> bool;

    /// What was found.
    ///
    /// # Errors
    /// Why nothing was.
    fn outcome(&self) -> Result<FitOutcome, FitFault>;
}

macro_rules! measured_fits {
    ($( $module:ident :: $fit:ident = $id:literal; )+) => {
        $( pub mod $module; )+

        /// What is fitted to measured data.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum MeasuredFitKind {
            $( #[doc = concat!("`steadycut identify ", $id, "`: [`", stringify!($module), "`].")] $fit, )+
        }

        impl MeasuredFitKind {
            /// All of them.
            pub const ALL: &'static [Self] = &[ $( Self::$fit, )+ ];

            /// Its name on the command line and in files.
            #[must_use]
            pub fn id(self) -> &'static str {
                match self { $( Self::$fit => $id, )+ }
            }

            /// What is known of it.
            #[must_use]
            pub fn about(self) -> FitAbout {
                match self { $( Self::$fit => <$module::$fit as MeasuredFit>::ABOUT, )+ }
            }

            /// What is missing before it can begin.
            #[must_use]
            pub fn lacks(self, request: &FitRequest) -> Option<FitFault> {
                request.lacks(self.about().roles).or_else(|| match self {
                    $( Self::$fit => <$module::$fit as MeasuredFit>::lacks(request), )+
                })
            }

            /// A recording as the cut of a scenario would give it, as CSV, with noise by a seed.
            ///
            /// # Errors
            /// The scenario has nothing of the kind.
            pub fn sample(self, scenario: &Scenario, seed: u32) -> Result<String, String> {
                match self { $( Self::$fit => <$module::$fit as MeasuredFit>::sample(scenario, seed), )+ }
            }
        }

        /// A fit of any kind while it is worked at.
        #[derive(Clone)]
        #[expect(clippy::enum_variant_names, reason = "named as the types of the list")]
        enum AnyWork {
            $( $fit(Box<<$module::$fit as MeasuredFit>::Work>), )+
        }

        impl AnyWork {
            fn begin(kind: MeasuredFitKind, request: &FitRequest) -> Result<Self, FitFault> {
                Ok(match kind {
                    $( MeasuredFitKind::$fit => {
                        Self::$fit(Box::new(<$module::$fit as MeasuredFit>::begin(request)?))
                    } )+
                })
            }

            fn step(&mut self) -> bool {
                match self { $( Self::$fit(work) => work.step(), )+ }
            }

            fn outcome(&self) -> Result<FitOutcome, FitFault> {
                match self { $( Self::$fit(work) => work.outcome(), )+ }
            }
        }
    };
}

// Module, type, id on the command line; in the order in which they are offered.
measured_fits! {
    drive::DriveFromData = "drive";
    force::ForceFromData = "force";
    structure::StructureFromData = "structure";
    noise::NoiseFromData = "noise";
    wear::WearFromData = "wear";
    material::MaterialFromData = "material";
}

#[cfg(test)]
mod tests;
