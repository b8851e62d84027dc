//! Marching squares: the line along which values on a grid reach a level.

/// A straight piece of a line, from one point to another.
pub type Segment = [[f64; 2]; 2];

/// Samples on a grid: `values[row * xs.len() + column]` belongs to (`xs[column]`, `ys[row]`).
#[derive(Clone, Copy, Debug)]
pub struct Samples<'a> {
    /// Ascending abscissae.
    pub xs: &'a [f64],
    /// Ascending ordinates.
    pub ys: &'a [f64],
    /// Finite values, row by row.
    pub values: &'a [f64],
}

/// The line where `samples` reach `level`, linear between grid points, as segments cell by cell.
/// Where a cell's corners alternate, the mean of the four decides which pairs join.
#[must_use]
pub fn contour(samples: &Samples, level: f64) -> Vec<Segment> {
    let mut segments = Vec::new();
    let columns = samples.xs.len();
    for row in 1..samples.ys.len() {
        for column in 1..columns {
            // Corners counter-clockwise from the lower left.
            let corner = |r: usize, c: usize| {
                let value = samples.values[r * columns + c] - level;
                ([samples.xs[c], samples.ys[r]], value)
            };
            let corners = [
                corner(row - 1, column - 1),
                corner(row - 1, column),
                corner(row, column),
                corner(row, column - 1),
            ];
            cell(&corners, &mut segments);
        }
    }
    segments
}

fn cell(corners: &[([f64; 2], f64); 4], segments: &mut Vec<Segment>) {
    // The points where the line crosses an edge, going round: 0, 2 or 4.
    let mut crossings = [[0.0; 2]; 4];
    let mut count = 0;
    for side in 0..4 {
        let ((from, a), (to, b)) = (corners[side], corners[(side + 1) % 4]);
        if (a > 0.0) != (b > 0.0) {
            let fraction = a / (a - b);
            crossings[count] = [0, 1].map(|d: usize| from[d] + fraction * (to[d] - from[d]));
            count += 1;
        }
    }
    match count {
        2 => segments.push([crossings[0], crossings[1]]),
        4 => {
            let mean = corners.iter().map(|(_, value)| value).sum::<f64>();
            // Sides 0 and 1 meet in corner 1: it is cut off if the middle is on the other side.
            let first = usize::from((mean > 0.0) == (corners[1].1 > 0.0));
            for pair in [first, first + 2] {
                segments.push([crossings[pair], crossings[(pair + 1) % 4]]);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(count: usize, f: impl Fn(f64, f64) -> f64) -> (Vec<f64>, Vec<f64>) {
        let axis: Vec<f64> =
            (0..count).map(|i| -2.0 + 4.0 * i as f64 / (count - 1) as f64).collect();
        let values = axis.iter().flat_map(|y| axis.iter().map(|x| f(*x, *y)).collect::<Vec<_>>());
        let values = values.collect();
        (axis, values)
    }

    fn length([[x0, y0], [x1, y1]]: &Segment) -> f64 {
        ((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0)).sqrt()
    }

    #[test]
    fn the_contour_of_a_circle_is_a_closed_circle() {
        let (axis, values) = sampled(81, |x, y| x * x + y * y);
        let samples = Samples { xs: &axis, ys: &axis, values: &values };
        let segments = contour(&samples, 2.2);
        let around: f64 = segments.iter().map(length).sum();
        let radius = 2.2_f64.sqrt();
        let circle = std::f64::consts::TAU * radius;
        assert!((around - circle).abs() < 1e-3 * circle, "{around} for {circle}");
        for [x, y] in segments.as_flattened() {
            assert!(((x * x + y * y).sqrt() - radius).abs() < 1e-3, "({x}, {y})");
        }
        // Closed: every end is the end of exactly one other segment.
        for [x, y] in segments.as_flattened() {
            let near = |[a, b]: &&[f64; 2]| (a - x).abs() < 1e-12 && (b - y).abs() < 1e-12;
            assert_eq!(segments.as_flattened().iter().filter(near).count(), 2);
        }
        assert!(contour(&samples, 9.0).is_empty(), "a level that is not reached");
    }

    #[test]
    fn a_saddle_splits_the_way_its_middle_says() {
        let corners = |bottom_left: f64, top_right: f64| {
            let mut segments = Vec::new();
            let at = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            let values = [bottom_left, -1.0, top_right, -1.0];
            cell(&[0, 1, 2, 3].map(|i: usize| (at[i], values[i])), &mut segments);
            segments
        };
        // The middle is high: the low corners (1, 0) and (0, 1) are cut off.
        let high = corners(3.0, 3.0);
        assert_eq!(high, [[[0.75, 0.0], [1.0, 0.25]], [[0.25, 1.0], [0.0, 0.75]]]);
        // The middle is low: the high corners (0, 0) and (1, 1) are cut off.
        let low = corners(0.5, 0.5);
        let near_high =
            |[a, b]: &Segment| (a[0] < 0.5) == (a[1] < 0.5) && (b[0] < 0.5) == (b[1] < 0.5);
        assert!(low.len() == 2 && low.iter().all(near_high), "{low:?}");
    }
}
