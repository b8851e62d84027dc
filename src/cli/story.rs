//! The story of a run, printed.

use std::io::Write;

use crate::run::story::{ResponseEnd, StepResponse, Story};

/// Prints what happens, a line for the moment and the sentence, and below each step how the loop answers.
pub fn print(out: &mut impl Write, story: &Story) -> std::io::Result<()> {
    writeln!(out, "  what happens")?;
    for event in &story.events {
        writeln!(out, "  {:>9.3} s  {}", event.from_s, event.sentence)?;
        if let Some(response) = event.response() {
            writeln!(out, "{:14}{}", "", figures(response))?;
        }
    }
    Ok(())
}

fn figures(of: &StepResponse) -> String {
    let ends = match of.ends {
        ResponseEnd::AtRest => "comes to rest",
        ResponseEnd::Moving => "still moves at the end",
        ResponseEnd::Unstable => "unstable",
        ResponseEnd::TooShort => "too short to judge",
    };
    let error = of.remaining_error_percent;
    let error = error.map_or("none to tell".to_owned(), |error| format!("{error:+.2} %"));
    let swing = of.swing_percent.map_or(String::new(), |swing| format!(" +-{swing:.2} %"));
    let band = of.settling_band_percent.unwrap_or_default();
    let settling = match of.settling_time_s {
        Some(_) if of.is_without_transient() => format!("no transient beyond {band:.2} %"),
        Some(time_s) => format!("settled within {band:.2} % after {time_s:.3} s"),
        None if of.swings_on() => format!("swings by more than {band:.2} %, never settled"),
        None => "never settled".to_owned(),
    };
    let overshoot = of.overshoot_percent.filter(|_| !of.is_without_transient());
    let overshoot = overshoot.map_or(String::new(), |most| format!(", overshoot {most:.2} %"));
    let jump = of.jump_percent.filter(|_| !of.is_without_transient());
    let jump = jump.map_or(String::new(), |most| format!(", jump {most:+.2} %"));
    format!("{ends}; {settling}{jump}{overshoot}, remaining error {error}{swing}")
}
