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
    let seconds = |time_s: Option<f64>| time_s.map_or("never".to_owned(), |s| format!("{s:.3} s"));
    let ends = match of.ends {
        ResponseEnd::AtRest => "comes to rest",
        ResponseEnd::Moving => "still moves at the end",
        ResponseEnd::Unstable => "unstable",
        ResponseEnd::TooShort => "too short to judge",
    };
    let error = of.remaining_error_percent;
    let error = error.map_or("none to tell".to_owned(), |error| format!("{error:+.2} %"));
    format!(
        "{ends}; settled {}, at rest {}, overshoot {:.2} %, remaining error {error}",
        seconds(of.settling_time_s),
        seconds(of.at_rest_after_s),
        of.overshoot_percent
    )
}
