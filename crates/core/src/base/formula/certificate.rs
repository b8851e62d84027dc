//! What holds of a formula over the whole of a box of inputs, not only where it was tried: that it has a value
//! everywhere, and that it only rises or only falls with an input.
//!
//! The box is halved until interval arithmetic decides or the halves run out. What is certified is certain; what
//! is not may still hold, and the places are named.

use super::interval::{Interval, bounds};
use super::{Formula, Node, text};
use crate::base::language::{text, tr};

/// Most parts of the box that are looked at for one question.
const PARTS: usize = 4096;
/// Parts that are halved to make the bounds of the values narrow.
const NARROWED: usize = 400;
/// Most places that are named for one question.
const PLACES: usize = 8;

/// A part of a box where something is not certified.
#[derive(Clone, Debug, PartialEq)]
pub struct UncertifiedPlace {
    /// The ranges of the inputs there.
    pub at: Vec<Interval>,
    /// What may happen there, naming the part of the formula.
    pub why: String,
}

/// How a formula changes with an input.
#[derive(Clone, Debug, PartialEq)]
pub enum Trend {
    /// It does not read the input.
    Constant,
    /// It never falls.
    Rising,
    /// It never rises.
    Falling,
    /// It rises somewhere and falls elsewhere, surely.
    Turning,
    /// Neither is certified: the places.
    Uncertified(Vec<UncertifiedPlace>),
}

/// What holds of a formula over a box of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The ranges of the inputs.
    pub ranges: Vec<Interval>,
    /// Bounds of its values; none where it is not certified to be finite.
    pub values: Option<Interval>,
    /// Where it is not certified to be finite; empty where it is everywhere.
    pub not_finite: Vec<UncertifiedPlace>,
    /// How it changes with each input.
    pub trends: Vec<Trend>,
}

impl Certificate {
    /// Whether it has a finite value everywhere in the box, surely.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.not_finite.is_empty()
    }
}

/// A box of the same middle, wider by a part of its width on each side, as far as each input's own bounds.
///
/// ```
/// use steadycut_core::base::formula::{Interval, widened};
///
/// let wide = widened(&[Interval::new(150.0, 600.0)], &[Interval::new(69.7, f64::INFINITY)], 0.3);
/// assert_eq!(wide, [Interval::new(69.7, 735.0)]);
/// ```
#[must_use]
pub fn widened(ranges: &[Interval], physical: &[Interval], part: f64) -> Vec<Interval> {
    let wider = |(range, physical): (&Interval, &Interval)| {
        let more = part * range.width();
        Interval::new((range.low - more).max(physical.low), (range.high + more).min(physical.high))
    };
    ranges.iter().zip(physical).map(wider).collect()
}

/// The same, where an input that is nowhere negative in its range stays so: a length or a speed.
#[must_use]
pub fn widened_physically(ranges: &[Interval], part: f64) -> Vec<Interval> {
    let own = |range: &Interval| {
        let low = if range.low >= 0.0 { 0.0 } else { f64::NEG_INFINITY };
        Interval::new(low, f64::INFINITY)
    };
    widened(ranges, &ranges.iter().map(own).collect::<Vec<_>>(), part)
}

impl Formula {
    /// What is certain over ranges of the inputs, in the order of [`Formula::inputs`].
    ///
    /// # Errors
    /// Names a range that is none, or a wrong number of them.
    pub fn certify(&self, ranges: &[Interval]) -> Result<Certificate, String> {
        let (values, not_finite) = self.certify_values(ranges)?;
        let trends = (0..ranges.len()).map(|input| self.trend(input, ranges)).collect();
        Ok(Certificate { ranges: ranges.to_vec(), values, not_finite, trends })
    }

    /// Bounds of the values over ranges of the inputs, and where they are not certified to be finite: the first
    /// part of [`Self::certify`].
    ///
    /// # Errors
    /// As [`Self::certify`].
    pub fn certify_values(
        &self,
        ranges: &[Interval],
    ) -> Result<(Option<Interval>, Vec<UncertifiedPlace>), String> {
        let [given, needed] = [ranges.len(), self.inputs().len()];
        if given != needed {
            return Err(tr!(
                "{given} ranges were given for {needed} inputs",
                given = given,
                needed = needed
            ));
        }
        for (name, Interval { low, high }) in self.inputs().iter().zip(ranges) {
            if !(low.is_finite() && high.is_finite() && low <= high) {
                return Err(tr!(
                    "the range {low}..{high} of `{name}` is none: allowed is low <= high",
                    low = *low,
                    high = *high,
                    name = name
                ));
            }
        }
        let not_finite = search(self, ranges, |_| Verdict::Decided);
        let values = not_finite.is_empty().then(|| self.narrow_bounds(ranges)).flatten();
        Ok((values, not_finite))
    }

    /// Bounds over a box where it is finite, made narrow by halving the parts that give the ends.
    fn narrow_bounds(&self, ranges: &[Interval]) -> Option<Interval> {
        let of = |part: &[Interval]| bounds(self.root(), part, &mut 0).ok();
        let mut parts = Vec::new();
        let mut open = vec![ranges.to_vec()];
        // As far as every part has bounds.
        while let Some(part) = open.pop() {
            match of(&part) {
                Some(found) => parts.push((part, found)),
                None if parts.len() + open.len() < PARTS => open.extend(halves(&part, ranges)?),
                None => return None,
            }
        }
        for round in 0..NARROWED {
            let order = |a: &Interval, b: &Interval| match round % 2 {
                0 => a.low.total_cmp(&b.low),
                _ => b.high.total_cmp(&a.high),
            };
            let place = (0..parts.len()).min_by(|a, b| order(&parts[*a].1, &parts[*b].1))?;
            let Some(both) = halves(&parts[place].0, ranges) else { continue };
            let [one, other] = both.map(|half| of(&half).map(|found| (half, found)));
            if let (Some(one), Some(other)) = (one, other) {
                parts[place] = one;
                parts.push(other);
            }
        }
        let low = parts.iter().map(|(_, found)| found.low).fold(f64::INFINITY, f64::min);
        let high = parts.iter().map(|(_, found)| found.high).fold(f64::NEG_INFINITY, f64::max);
        Some(Interval::new(low, high))
    }

    fn trend(&self, input: usize, ranges: &[Interval]) -> Trend {
        let place =
            |why: String| Trend::Uncertified(vec![UncertifiedPlace { at: ranges.to_vec(), why }]);
        let slope = match self.derivative(input) {
            Ok(slope) => slope,
            Err(problem) => return place(problem),
        };
        if *slope.root() == Node::Number(0.0) {
            return Trend::Constant;
        }
        let (mut rises, mut falls) = (false, false);
        let unsure = search(&slope, ranges, |found| {
            rises |= found.low > 0.0;
            falls |= found.high < 0.0;
            match () {
                () if rises && falls => Verdict::Enough,
                () if found.low >= 0.0 || found.high <= 0.0 => Verdict::Decided,
                () => Verdict::Halve(text!("its slope may be of either sign")),
            }
        });
        match (rises, falls, unsure.is_empty()) {
            (true, true, _) => Trend::Turning,
            (false, true, true) => Trend::Falling,
            (_, false, true) => Trend::Rising,
            (_, _, false) => Trend::Uncertified(unsure),
        }
    }
}

enum Verdict {
    /// Nothing more to find out here.
    Decided,
    /// Perhaps in its halves; otherwise it is a place with this fault.
    Halve(&'static str),
    /// Nothing more to find out anywhere.
    Enough,
}

/// Halves the box where bounds or `judge` ask for it; returns the places that stayed open.
fn search(
    formula: &Formula,
    ranges: &[Interval],
    mut judge: impl FnMut(Interval) -> Verdict,
) -> Vec<UncertifiedPlace> {
    let (printed, spans) = text::print(formula);
    let mut open = std::collections::VecDeque::from([ranges.to_vec()]);
    let mut looked_at = 0;
    let mut places = Vec::new();
    while let Some(part) = open.pop_front() {
        looked_at += 1;
        let why = match bounds(formula.root(), &part, &mut 0) {
            Ok(found) => match judge(found) {
                Verdict::Decided => continue,
                Verdict::Enough => return Vec::new(),
                Verdict::Halve(why) => tr(why).to_owned(),
            },
            Err(hole) => {
                let at = spans.get(hole.index).cloned().unwrap_or(0..printed.len());
                format!("`{}`: {}", &printed[at], tr(hole.why))
            }
        };
        match halves(&part, ranges).filter(|_| looked_at + open.len() < PARTS) {
            Some(both) => open.extend(both),
            None => places.push(UncertifiedPlace { at: part, why }),
        }
    }
    joined(places)
}

/// Both halves of a part by the input whose range is widest beside its whole; none of a point.
fn halves(part: &[Interval], ranges: &[Interval]) -> Option<[Vec<Interval>; 2]> {
    let share = |i: usize| part[i].width() / ranges[i].width().max(f64::MIN_POSITIVE);
    let widest = (0..part.len()).max_by(|a, b| share(*a).total_cmp(&share(*b)).then(b.cmp(a)))?;
    let Interval { low, high } = part[widest];
    let middle = 0.5 * (low + high);
    let half = |range: Interval| {
        let mut half = part.to_vec();
        half[widest] = range;
        half
    };
    (low < middle && middle < high)
        .then(|| [half(Interval::new(low, middle)), half(Interval::new(middle, high))])
}

/// Places with the same fault joined to one while there are too many: what holds all of them.
fn joined(mut places: Vec<UncertifiedPlace>) -> Vec<UncertifiedPlace> {
    if places.len() <= PLACES {
        return places;
    }
    let mut all: Vec<UncertifiedPlace> = Vec::new();
    for place in places.drain(..) {
        match all.iter_mut().find(|known| known.why == place.why) {
            Some(known) => {
                for (known, new) in known.at.iter_mut().zip(place.at) {
                    *known = Interval::new(known.low.min(new.low), known.high.max(new.high));
                }
            }
            None => all.push(place),
        }
    }
    all
}
