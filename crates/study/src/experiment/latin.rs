//! Latin hypercubes: of `count` points each factor has every of its `count` strata once (McKay, Beckman and
//! Conover 1979). The strata are paired so that points keep away from each other: of several random pairings the
//! best, then exchanges that lower the sum of d^-10 over all pairs at distance d (Morris and Mitchell 1995).

use crate::base::rng::Stream;

/// Random pairings that are tried.
const TRIES: u64 = 10;
/// Exchanges that are tried for each point and factor.
const EXCHANGES: u64 = 60;

/// The middle of a stratum, from -1 to 1.
fn level(stratum: u32, count: usize) -> f64 {
    (2.0 * f64::from(stratum) + 1.0) / count as f64 - 1.0
}

/// What one pair of points adds to the sum.
fn closeness(a: &[u32], b: &[u32]) -> f64 {
    let squares: f64 = a
        .iter()
        .zip(b)
        .map(|(a, b)| {
            let off = f64::from(*a) - f64::from(*b);
            off * off
        })
        .sum();
    let square = squares * squares;
    1.0 / (square * square * squares)
}

/// What the pairs of one point add, but for that with `but`.
fn around(points: &[Vec<u32>], point: usize, but: usize) -> f64 {
    let others = points.iter().enumerate().filter(|(other, _)| *other != point && *other != but);
    others.map(|(_, other)| closeness(&points[point], other)).sum()
}

fn whole(points: &[Vec<u32>]) -> f64 {
    let pairs = (0..points.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
    pairs.map(|(a, b)| closeness(&points[a], &points[b])).sum()
}

/// A permutation of 0 to `count` - 1.
fn permutation(stream: Stream, from: u64, count: usize) -> Vec<u32> {
    let mut all: Vec<u32> = (0..count as u32).collect();
    for last in (1..count).rev() {
        let other = stream.below(from + last as u64, last as u64 + 1) as usize;
        all.swap(last, other);
    }
    all
}

/// `count` points in `factors` dimensions, each level from -1 to 1 in the middle of its stratum.
#[must_use]
pub fn latin_hypercube(count: usize, factors: usize, seed: u64) -> Vec<Vec<f64>> {
    let stream = Stream::new(seed, "experiment.latin");
    let each = count.max(1) as u64;
    let pairing = |number: u64| -> Vec<Vec<u32>> {
        let columns: Vec<Vec<u32>> = (0..factors as u64)
            .map(|factor| permutation(stream, (number * factors as u64 + factor) * each, count))
            .collect();
        (0..count).map(|point| columns.iter().map(|column| column[point]).collect()).collect()
    };
    let mut best = pairing(0);
    let mut least = whole(&best);
    for number in 1..TRIES {
        let other = pairing(number);
        let sum = whole(&other);
        if sum < least {
            (best, least) = (other, sum);
        }
    }
    let exchanges = Stream::new(seed, "experiment.latin.exchange");
    let tries = if factors > 1 && count > 2 { EXCHANGES * each * factors as u64 } else { 0 };
    for number in 0..tries {
        let a = exchanges.below(3 * number, each) as usize;
        let b = exchanges.below(3 * number + 1, each) as usize;
        let factor = exchanges.below(3 * number + 2, factors as u64) as usize;
        if a == b {
            continue;
        }
        let before = around(&best, a, b) + around(&best, b, a);
        let swap = |points: &mut Vec<Vec<u32>>| {
            let of_a = points[a][factor];
            points[a][factor] = points[b][factor];
            points[b][factor] = of_a;
        };
        swap(&mut best);
        if around(&best, a, b) + around(&best, b, a) >= before {
            swap(&mut best);
        }
    }
    let coded = |point: &Vec<u32>| point.iter().map(|stratum| level(*stratum, count)).collect();
    best.iter().map(coded).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_factor_has_one_point_in_every_stratum() {
        for (count, factors, seed) in [(1, 3, 1), (2, 2, 1), (7, 1, 4), (24, 5, 2), (125, 2, 3)] {
            let points = latin_hypercube(count, factors, seed);
            assert_eq!(points.len(), count);
            for factor in 0..factors {
                let stratum = |point: &Vec<f64>| {
                    (0.5 * (point[factor] + 1.0) * count as f64).floor() as usize
                };
                let mut strata: Vec<usize> = points.iter().map(stratum).collect();
                strata.sort_unstable();
                assert!(strata.into_iter().eq(0..count), "{count} {factors}: factor {factor}");
            }
        }
    }

    fn nearest(points: &[Vec<f64>]) -> f64 {
        let mut least = f64::INFINITY;
        for (i, a) in points.iter().enumerate() {
            for b in &points[..i] {
                let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
                least = least.min(square);
            }
        }
        least.sqrt()
    }

    /// The exchanges at work: the nearest two of 30 points are further apart than in any of 200 random pairings.
    #[test]
    fn points_keep_away_from_each_other() {
        for seed in [1, 2, 3] {
            let improved = nearest(&latin_hypercube(30, 2, seed));
            let stream = Stream::new(99, "test");
            for number in 0..200 {
                let [x, y] = [0, 1].map(|i| permutation(stream, (2 * number + i) * 30, 30));
                let random: Vec<Vec<f64>> =
                    x.iter().zip(&y).map(|(x, y)| vec![level(*x, 30), level(*y, 30)]).collect();
                assert!(nearest(&random) <= improved, "{seed} {number}");
            }
        }
    }

    #[test]
    fn a_seed_gives_its_points_again_and_another_one_others() {
        assert_eq!(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 5));
        assert_ne!(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 6));
    }
}
