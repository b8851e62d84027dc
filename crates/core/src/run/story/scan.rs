//! What happens along a recording, found in one pass: where each state flag is set, where the depth
//! of cut and the reference move. It grows with the recording and is cut back with it.

use super::super::signals::{Row, flag};
use super::chatter::Scatter;

/// Rows after one another, by their indices: the first and the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowSpan {
    /// The first row.
    pub first: usize,
    /// The last row.
    pub last: usize,
}

/// The flags that are told of.
pub(super) const WATCHED: [u32; 10] = [
    flag::FEED_SATURATED,
    flag::SPEED_SATURATED,
    flag::K1_OUTSIDE,
    flag::K2_OUTSIDE,
    flag::K3_OUTSIDE,
    flag::K4_OUTSIDE,
    flag::K5_OUTSIDE,
    flag::K6_OUTSIDE,
    flag::AIR,
    flag::LOST_CONTACT,
];

/// See the head of this file.
#[derive(Clone, Debug, Default)]
pub struct Scan {
    flagged: [Vec<RowSpan>; WATCHED.len()],
    depth: Vec<RowSpan>,
    reference: Vec<RowSpan>,
    scatter: Scatter,
    rows: usize,
}

fn note(spans: &mut Vec<RowSpan>, row: usize) {
    match spans.last_mut() {
        Some(span) if span.last + 1 == row => span.last = row,
        _ => spans.push(RowSpan { first: row, last: row }),
    }
}

fn cut_back(spans: &mut Vec<RowSpan>, rows: usize) {
    while spans.last().is_some_and(|span| span.first >= rows) {
        spans.pop();
    }
    if let Some(span) = spans.last_mut() {
        span.last = span.last.min(rows.saturating_sub(1));
    }
}

impl Scan {
    /// Takes in the rows that came since; `rows` are all rows of the recording.
    pub fn extend(&mut self, rows: &[Row]) {
        for (i, row) in rows.iter().enumerate().skip(self.rows) {
            let flags = row.state_flags as u32;
            if flags != 0 {
                for (bit, spans) in WATCHED.iter().zip(&mut self.flagged) {
                    if flags & bit != 0 {
                        note(spans, i);
                    }
                }
            }
            let Some(before) = i.checked_sub(1).map(|before| &rows[before]) else { continue };
            if row.axial_depth_mm != before.axial_depth_mm
                || row.radial_depth_mm != before.radial_depth_mm
            {
                note(&mut self.depth, i);
            }
            if row.force_ref_n != before.force_ref_n || row.ra_target_um != before.ra_target_um {
                note(&mut self.reference, i);
            }
        }
        self.scatter.extend(rows);
        self.rows = self.rows.max(rows.len());
    }

    /// Forgets what was found from row number `rows` on.
    pub fn truncate(&mut self, rows: usize) {
        if rows < self.rows {
            self.rows = rows;
            let all = self.flagged.iter_mut().chain([&mut self.depth, &mut self.reference]);
            all.for_each(|spans| cut_back(spans, rows));
            self.scatter.truncate(rows);
        }
    }

    /// Number of rows taken in.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Where the depth differs from that of the row before.
    #[must_use]
    pub fn depth(&self) -> &[RowSpan] {
        &self.depth
    }

    /// What the tooth's place scatters by.
    pub(super) fn scatter(&self) -> &Scatter {
        &self.scatter
    }

    /// Where the reference differs from that of the row before.
    pub(super) fn reference(&self) -> &[RowSpan] {
        &self.reference
    }

    /// Where a watched flag is set, with gaps of at most `gap` rows closed.
    pub(super) fn flagged(&self, bit: u32, gap: usize) -> Vec<RowSpan> {
        let place = WATCHED.iter().position(|watched| *watched == bit);
        place.map_or(Vec::new(), |place| joined(&self.flagged[place], gap))
    }
}

/// Spans with gaps of at most `gap` rows closed.
pub(super) fn joined(spans: &[RowSpan], gap: usize) -> Vec<RowSpan> {
    let mut found: Vec<RowSpan> = Vec::new();
    for span in spans {
        match found.last_mut() {
            Some(last) if span.first <= last.last + 1 + gap => last.last = last.last.max(span.last),
            _ => found.push(*span),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Vec<Row> {
        let row = |i: usize| Row {
            axial_depth_mm: if i < 40 { 2.0 } else { 2.2 },
            force_ref_n: if i < 70 { 170.0 } else { 160.0 },
            state_flags: f64::from(match i {
                10..20 | 22..30 => flag::FEED_SATURATED,
                90.. => flag::AIR | flag::FEED_SATURATED,
                _ => 0,
            }),
            ..Row::default()
        };
        (0..100).map(row).collect()
    }

    #[test]
    fn in_slices_cut_back_and_taken_in_again_it_finds_the_same() {
        let rows = rows();
        let mut scan = Scan::default();
        scan.extend(&rows[..15]);
        scan.extend(&rows[..95]);
        scan.truncate(25);
        assert_eq!(scan.flagged(flag::FEED_SATURATED, 0).last().unwrap().last, 24);
        assert_eq!((scan.depth().len(), scan.flagged(flag::AIR, 0).len()), (0, 0));
        scan.extend(&rows);
        let span = |first, last| RowSpan { first, last };
        assert_eq!(
            scan.flagged(flag::FEED_SATURATED, 0),
            [span(10, 19), span(22, 29), span(90, 99)]
        );
        assert_eq!(scan.flagged(flag::FEED_SATURATED, 2), [span(10, 29), span(90, 99)]);
        assert_eq!(scan.flagged(flag::AIR, 5), [span(90, 99)]);
        assert_eq!((scan.depth(), scan.reference()), (&[span(40, 40)][..], &[span(70, 70)][..]));
    }
}
