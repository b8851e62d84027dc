//! Design of experiments: which cuts to make, what they can tell before a chip is cut, the cuts themselves on the
//! simulator or on a sheet for a shop, and the way from cuts to models to a controller.
//!
//! | step | module |
//! | --- | --- |
//! | What is varied | [`factor`] |
//! | Which combinations: factorials and their fractions, composite designs, Latin hypercubes | [`design`], [`fraction`], [`latin`] |
//! | The plan: values, order, name | [`plan`] |
//! | What it can tell: terms, leverage, aliases, standard errors | [`terms`], [`assess`] |
//! | The cuts on the simulator | [`measure`] |
//! | The sheet for a shop, and what it has filled in | [`sheet`], [`filled`] |
//! | From cuts to models to a controller, and what it holds | [`way`] |

pub mod assess;
pub mod design;
pub mod factor;
pub mod filled;
pub mod fraction;
pub mod latin;
pub mod measure;
pub mod plan;
pub mod sheet;
pub mod terms;
pub mod way;
