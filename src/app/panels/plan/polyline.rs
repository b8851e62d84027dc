//! Joins the segments of a contour to lines: dashes run on from segment to segment, and a plot
//! draws a line faster than its pieces.

use std::collections::VecDeque;

use crate::study::plan::contour::Segment;

/// Segments joined where their ends meet within `near` (a distance for either coordinate).
#[must_use]
pub fn joined(mut segments: Vec<Segment>, near: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let meet =
        |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < near[0] && (a[1] - b[1]).abs() < near[1];
    let mut lines = Vec::new();
    while let Some([a, b]) = segments.pop() {
        let mut line = VecDeque::from([a, b]);
        for at_end in [true, false] {
            loop {
                let tip = if at_end { line[line.len() - 1] } else { line[0] };
                // The neighbour was most likely found last.
                let next = segments.iter().rposition(|[a, b]| meet(*a, tip) || meet(*b, tip));
                let Some(next) = next else { break };
                let [a, b] = segments.swap_remove(next);
                let far = if meet(a, tip) { b } else { a };
                if at_end {
                    line.push_back(far);
                } else {
                    line.push_front(far);
                }
            }
        }
        lines.push(line.into());
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_in_any_order_and_direction_become_one_line() {
        let pieces = vec![
            [[2.0, 0.0], [1.0, 0.0]],
            [[3.0, 0.0], [4.0, 1.0]],
            [[0.0, 0.0], [1.0 + 1e-12, 0.0]],
            [[2.0, 0.0], [3.0, 0.0]],
            [[9.0, 9.0], [8.0, 9.0]],
        ];
        let mut lines = joined(pieces, [1e-9; 2]);
        lines.sort_by_key(Vec::len);
        assert_eq!(lines.len(), 2);
        let xs: Vec<f64> = lines[1].iter().map(|point| point[0].round()).collect();
        let up = vec![0.0, 1.0, 2.0, 3.0, 4.0];
        assert!(xs == up || xs == up.into_iter().rev().collect::<Vec<_>>(), "{xs:?}");
        assert!(joined(Vec::new(), [1.0; 2]).is_empty());
    }
}
