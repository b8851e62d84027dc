//! The arguments of `steadycut measured`.

use clap::Args;

use crate::cli::files::{InPath, OutPath, ScenarioPath};
use crate::measured::layout::DataLayout;
use crate::measured::signal::Preparation;

/// Arguments of `measured`.
#[derive(Debug, Args)]
pub struct MeasuredArgs {
    /// Text of any separator, decimal sign and encoding, MATLAB v5 or v7.3, HDF5, TDMS or Parquet.
    #[arg(value_name = "FILE")]
    pub file: InPath,
    /// Overrule a guess about the file's layout, for example `--layout decimal=comma`: encoding, separator, decimal,
    /// thousands, names_line, units_line, first_line, names, units, time, rate_hz. What FILE.layout.toml beside the
    /// file says counts before what is guessed, this before both.
    #[arg(long, value_name = "KEY=VALUE", value_parser = layout_entry)]
    pub layout: Vec<(String, String)>,
    /// What of a file with several things is read, for example `mill[3]`, `mill[3].smcAC` or `cut1/force`; without it, all channels or
    /// the first record. The report lists what there is.
    #[arg(long, value_name = "NAME")]
    pub variable: Option<String>,
    /// Keep what was overruled in FILE.layout.toml beside the file, which is read from then on.
    #[arg(long)]
    pub remember: bool,
    /// What is done with the channels before they are told and written.
    #[command(flatten)]
    pub prepare: PrepareArgs,
    /// Write the channels as CSV, with decimal points, names, units and times in s.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// An entry of a layout as an argument.
pub fn layout_entry(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("allowed is KEY=VALUE")?;
    let entry = (key.trim().to_owned(), value.trim().to_owned());
    // Tried by itself: whether it goes with the file is seen when it is read.
    DataLayout::default().set(&entry.0, &entry.1)?;
    Ok(entry)
}

/// What is done with the channels, in this order: missing samples filled in, zero and drift, axes, filter, peaks, periods.
#[derive(Debug, Args)]
pub struct PrepareArgs {
    /// Make all channels zero on average between two times in s, before the cut.
    #[arg(long, value_name = "FROM..TO", value_parser = span, help_heading = "Preparation")]
    pub zero: Option<[f64; 2]>,
    /// A second such time, behind the cut: the line through both is taken off, which is the drift.
    #[arg(long, value_name = "FROM..TO", value_parser = span, requires = "zero", help_heading = "Preparation")]
    pub drift: Option<[f64; 2]>,
    /// Turn two forces across the spindle's axis into the machine's axes; DEG is the angle from the machine's X to the
    /// dynamometer's x, towards Y.
    #[arg(long, value_name = "X,Y,DEG", value_parser = rotation, help_heading = "Preparation")]
    pub rotate: Option<(String, String, f64)>,
    /// Low-pass filter all channels, without a shift in time.
    #[arg(long, value_name = "HZ", help_heading = "Preparation")]
    pub low_pass: Option<f64>,
    /// The largest force across the tool of two forces in every period, as controllers see it.
    #[arg(long, value_name = "X,Y", value_parser = two_names, requires = "period", help_heading = "Preparation")]
    pub peak: Option<(String, String)>,
    /// One value in so many s, such as the control period.
    #[arg(long, value_name = "S", help_heading = "Preparation")]
    pub period: Option<f64>,
    /// Align a channel in time and size with a signal of a run (`steadycut list` names them), whose sampling in time it
    /// takes, and tell shift and scale; written CSV has the signal beside it, in the run's time.
    #[arg(long, value_name = "PRESET|FILE|LINK", requires = "pair", help_heading = "Preparation")]
    pub align: Option<ScenarioPath>,
    /// The channel that is aligned, and the run's signal, for example `--pair Fx=force_n`.
    #[arg(long, value_name = "CHANNEL=SIGNAL", value_parser = pair, requires = "align", help_heading = "Preparation")]
    pub pair: Option<(String, String)>,
}

impl PrepareArgs {
    /// The steps.
    #[must_use]
    pub fn preparation(&self) -> Preparation {
        Preparation {
            idle_s: self.zero,
            idle_later_s: self.drift,
            rotation: self.rotate.clone(),
            low_pass_hz: self.low_pass,
            peaks: self.peak.clone(),
            period_s: self.period,
        }
    }
}

/// Two times as an argument.
pub fn span(text: &str) -> Result<[f64; 2], String> {
    let ends = text.split_once("..").and_then(|(from, to)| {
        Some([from.trim().parse::<f64>().ok()?, to.trim().parse::<f64>().ok()?])
    });
    ends.filter(|[from, to]| from <= to)
        .ok_or_else(|| "allowed is FROM..TO with two times in s".to_owned())
}

fn two_names(text: &str) -> Result<(String, String), String> {
    match text.split_once(',') {
        Some((x, y)) if !x.trim().is_empty() && !y.trim().is_empty() => {
            Ok((x.trim().to_owned(), y.trim().to_owned()))
        }
        Some(_) | None => Err("allowed are the names of two channels: X,Y".to_owned()),
    }
}

fn rotation(text: &str) -> Result<(String, String, f64), String> {
    let wrong =
        || "allowed are the names of two channels and an angle in degrees: X,Y,DEG".to_owned();
    let (names, angle) = text.rsplit_once(',').ok_or_else(wrong)?;
    let (x, y) = two_names(names).map_err(|_| wrong())?;
    let angle_deg = angle.trim().parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(wrong)?;
    Ok((x, y, angle_deg))
}

fn pair(text: &str) -> Result<(String, String), String> {
    match text.rsplit_once('=') {
        Some((channel, signal)) if !channel.is_empty() && !signal.is_empty() => {
            Ok((channel.to_owned(), signal.to_owned()))
        }
        Some(_) | None => Err("allowed is CHANNEL=SIGNAL".to_owned()),
    }
}
