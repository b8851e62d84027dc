//! A recording laid over one turn of the spindle: the mean of the samples at every place.
//!
//! A spindle is never quite as fast as it was told, and in a long recording the turns would be smeared: beside the speed that
//! is given the one is searched for at which the samples of a place differ least (epoch folding; D. A. Leahy and others,
//! The Astrophysical Journal 266, 1983).

use super::{ForceAxis, ForceRecording, RecordedCut};
use crate::base::language::tr;
use crate::base::math;

/// Places of a turn, the most that samples fill are taken; made whole for the teeth.
const PLACES: [usize; 5] = [720, 360, 180, 90, 45];
/// How far from the speed that is given another one is searched for, as a share.
const REACH: f64 = 0.005;
/// Fewest turns that tell a speed.
const LEAST_TURNS: f64 = 5.0;
/// Share of what differs within the places that another speed must take away.
const LEAST_GAIN: f64 = 0.01;
/// Least ratio of the mean squares between and within places: below it nothing repeats.
const LEAST_RATIO: f64 = 2.0;

/// The recording over one turn.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Folded {
    /// What was recorded.
    pub axes: Vec<ForceAxis>,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Samples of each force.
    pub samples: usize,
    /// Turns of the recording.
    pub turns: f64,
    /// Angle of every place since the first sample, rad: the mean of its samples.
    pub angles_rad: Vec<f64>,
    /// Samples at every place.
    pub counts: Vec<f64>,
    /// Mean of every force at every place, N.
    pub means_n: Vec<Vec<f64>>,
    /// Sum of squares of the samples about the means of their places, N^2.
    pub within: f64,
    /// Sum of squares of the samples about their mean, N^2.
    pub total: f64,
}

/// Turns of the spindle at every sample, as places of a turn.
fn placed(turns_a_sample: f64, places: usize, i: usize) -> (usize, f64) {
    let turns = turns_a_sample * i as f64;
    let turn = turns - turns.floor();
    ((turn * places as f64) as usize % places, turn)
}

/// Sum of squares between the places, N^2, about nought.
fn between(recording: &ForceRecording, turns_a_sample: f64, places: usize) -> f64 {
    let mut sums = vec![[0.0; 4]; places];
    let mut counts = vec![0.0; places];
    for i in 0..recording.samples() {
        let (place, _) = placed(turns_a_sample, places, i);
        counts[place] += 1.0;
        for (sum, (_, samples)) in sums[place].iter_mut().zip(&recording.forces) {
            *sum += samples[i];
        }
    }
    let there = sums.iter().zip(counts).filter(|(_, count)| *count > 0.0);
    there.map(|(sums, count)| sums.iter().map(|sum| sum * sum).sum::<f64>() / count).sum()
}

/// Samples at each of the most places of a turn that are all filled.
fn filled(recording: &ForceRecording, turns_a_sample: f64, teeth: usize) -> Option<Vec<f64>> {
    let counted = |places: usize| {
        let mut counts = vec![0.0; places];
        (0..recording.samples()).for_each(|i| counts[placed(turns_a_sample, places, i).0] += 1.0);
        counts
    };
    let mut all = PLACES.iter().map(|most| counted(most / teeth * teeth));
    all.find(|counts| counts.iter().all(|count| *count > 0.0))
}

/// The speed at which the turns lie best on each other by so many places, 1/min. Few of them would take the slope of the
/// force within a place for a difference between turns.
fn repeated(recording: &ForceRecording, cut: &RecordedCut, places: usize) -> f64 {
    let a_sample = recording.period_s * cut.speed_rpm / 60.0;
    let turns = a_sample * recording.samples() as f64;
    if turns < LEAST_TURNS || recording.samples() < 4 * places {
        return cut.speed_rpm;
    }
    let score = |share: f64| between(recording, a_sample * (1.0 + share), places);
    // A quarter of a tooth's pitch over the whole recording at a step, at most a hundred to either side.
    let step = (0.25 / (f64::from(cut.tool.teeth) * turns)).max(REACH / 100.0);
    let steps = (REACH / step) as i32;
    let given = score(0.0);
    let best = (-steps..=steps)
        .map(|k| (f64::from(k) * step, score(f64::from(k) * step)))
        .fold((0.0, given), |best, next| if next.1 > best.1 { next } else { best });
    // Golden section about the best.
    let (mut low, mut high) = (best.0 - step, best.0 + step);
    for _ in 0..24 {
        let share = 0.381_966 * (high - low);
        let (a, b) = (low + share, high - share);
        if score(a) > score(b) {
            high = b;
        } else {
            low = a;
        }
    }
    let found = 0.5 * (low + high);
    let squares: f64 = recording.forces.iter().flat_map(|(_, x)| x).map(|x| x * x).sum();
    let within = squares - given;
    // What reshuffling noise between the places gains, six standard deviations of it.
    let (axes, places) = (recording.forces.len() as f64, places as f64);
    let chance = 6.0 * (2.0 * places * axes).sqrt() / (recording.samples() as f64 * axes);
    let gained = score(found) - given > LEAST_GAIN.max(chance) * within;
    if gained { cut.speed_rpm * (1.0 + found) } else { cut.speed_rpm }
}

/// Lays a recording over one turn.
///
/// # Errors
/// Its samples fill too few places; its forces do not change, or not with the turn.
pub(super) fn folded(recording: &ForceRecording, cut: &RecordedCut) -> Result<Folded, String> {
    let axes: Vec<ForceAxis> = recording.forces.iter().map(|(axis, _)| *axis).collect();
    for (axis, samples) in &recording.forces {
        let [low, high] = math::extent(samples.iter().copied());
        if low == high {
            return Err(tr!(
                "{axis} is {value} N throughout: no cut was recorded; expected is a force that changes as the teeth pass",
                axis = axis.id(),
                value = low
            ));
        }
    }
    let samples = recording.samples();
    let teeth = cut.tool.teeth as usize;
    let given = recording.period_s * cut.speed_rpm / 60.0;
    let speed_rpm = match filled(recording, given, teeth) {
        Some(counts) => repeated(recording, cut, counts.len()),
        None => cut.speed_rpm,
    };
    let a_sample = recording.period_s * speed_rpm / 60.0;
    let Some(counts) = filled(recording, a_sample, teeth) else {
        return Err(tr!(
            "the samples do not fill {places} places of a turn: expected is a longer recording, or more samples a turn than {count:.1}",
            places = PLACES[PLACES.len() - 1] / teeth * teeth,
            count = 1.0 / a_sample
        ));
    };
    let places = counts.len();
    let mut turned = vec![0.0; places];
    let mut sums = vec![vec![0.0; places]; axes.len()];
    for i in 0..samples {
        let (place, turn) = placed(a_sample, places, i);
        turned[place] += turn;
        for (sums, (_, samples)) in sums.iter_mut().zip(&recording.forces) {
            sums[place] += samples[i];
        }
    }
    let mean = |sums: &[f64]| sums.iter().zip(&counts).map(|(sum, count)| sum / count).collect();
    let means_n: Vec<Vec<f64>> = sums.iter().map(|sums| mean(sums)).collect();
    let turned: Vec<f64> = mean(&turned);
    let (mut within, mut total) = (0.0, 0.0);
    for ((_, samples), means) in recording.forces.iter().zip(&means_n) {
        let middle = samples.iter().sum::<f64>() / samples.len() as f64;
        for (i, x) in samples.iter().enumerate() {
            let off = x - means[placed(a_sample, places, i).0];
            within += off * off;
            total += (x - middle) * (x - middle);
        }
    }
    let count = (samples * axes.len()) as f64;
    let all = (places * axes.len()) as f64;
    // Only where places have several samples each is there something to compare.
    if count > 2.0 * all {
        let ratio = (total - within) / all / (within / (count - all)).max(f64::MIN_POSITIVE);
        if ratio < LEAST_RATIO {
            return Err(tr!(
                "the forces do not repeat with the turns of the spindle at {speed:.1} 1/min: expected is a steady cut at this speed",
                speed = speed_rpm
            ));
        }
    }
    Ok(Folded {
        axes,
        speed_rpm,
        samples,
        turns: a_sample * samples as f64,
        angles_rad: turned.iter().map(|turn| math::TAU * turn).collect(),
        counts,
        means_n,
        within,
        total,
    })
}
