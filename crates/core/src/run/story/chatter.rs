//! Chatter as it is seen in the rows of a coupled machine: a tooth that jumps out of the cut, or, where the teeth keep
//! contact, vibration that differs from tooth to tooth and does not die down.
//!
//! In a quiet cut every tooth is struck alike, so that each leaves its mark at the same place of its vibration: what
//! the tooth's place scatters by from one to the next is what the noise of the force strikes. Chatter has a frequency
//! of its own, which the passes of the teeth meet at another phase each: the scatter is then its amplitude, and grows
//! until the teeth lose contact or the depth changes. It is looked at in blocks, about its trend in each of them.

use super::super::signals::{Row, flag};
use super::figures::{Chatter, ChatterEnd};
use super::means::{produced_ra_um, shaken_ra_um};
use super::scan::{RowSpan, Scan, joined};
use crate::base::stats;

/// Gaps up to this are closed, s (chosen).
const GAP_S: f64 = 0.5;
/// A tooth that jumps out for less than this meets a step and no chatter, s (chosen).
const LEAST_LOST_S: f64 = 0.3;
/// Length of a block, s (chosen): a dozen teeth of the papers' cutter.
const BLOCK_S: f64 = 0.25;
/// Fewest blocks after one another that chatter lasts for where teeth keep contact (chosen).
const LEAST_BLOCKS: usize = 2;
/// Scatter of the tooth's place from which on it is told of, um (chosen): some 0.4 um of Ra. Noise at its usual level
/// makes a tenth of it on the papers' machine, and up to 1.7 um on one that borders on chatter.
const LEAST_UM: f64 = 2.0;
/// Fraction of the largest scatter that still counts as the largest: from the last such block on it dies down (chosen).
const NEARLY: f64 = 0.8;
/// Mean scatter of the second half of what lasts over that of the first from which on it does not die down (chosen).
const NOT_DYING: f64 = 0.97;

/// The scatter of the tooth's place in each whole block of a recording.
#[derive(Clone, Debug, Default)]
pub(super) struct Scatter {
    blocks_um: Vec<f64>,
    /// Rows in a block; 0 as long as that is not known.
    rows: usize,
}

impl Scatter {
    /// Takes in the rows that came since; `rows` are all rows of the recording.
    pub fn extend(&mut self, rows: &[Row]) {
        if let ([first, second, ..], 0) = (rows, self.rows) {
            let row_s = (second.time_s - first.time_s).max(1e-9);
            self.rows = ((BLOCK_S / row_s).round() as usize).max(1);
        }
        if self.rows == 0 {
            return;
        }
        for block in self.blocks_um.len()..rows.len() / self.rows {
            let rows = &rows[block * self.rows..(block + 1) * self.rows];
            self.blocks_um.push(of_block(rows));
        }
    }

    /// Forgets what was found from row number `rows` on.
    pub fn truncate(&mut self, rows: usize) {
        if let Some(blocks) = rows.checked_div(self.rows) {
            self.blocks_um.truncate(blocks);
        }
    }

    /// Where it is large and does not die down for long enough.
    fn large(&self) -> Vec<RowSpan> {
        let is_large = |um: &f64| *um >= LEAST_UM;
        let runs = self.blocks_um.chunk_by(|a, b| is_large(a) == is_large(b));
        let (mut found, mut begin) = (Vec::new(), 0);
        for run in runs {
            if let Some(blocks) = run.first().filter(|um| is_large(um)).and_then(|_| lasting(run)) {
                let (first, last) = (begin * self.rows, (begin + blocks) * self.rows - 1);
                found.push(RowSpan { first, last });
            }
            begin += run.len();
        }
        found
    }

    /// The largest scatter in rows, as an amplitude, um.
    fn amplitude_um(&self, span: RowSpan) -> f64 {
        let Some(first) = span.first.checked_div(self.rows) else { return 0.0 };
        let blocks = self.blocks_um.iter().skip(first).take(span.last / self.rows + 1 - first);
        2.0_f64.sqrt() * blocks.fold(0.0, |most: f64, um| most.max(*um))
    }
}

/// How many of a run of large scatters, from its begin on, do not die down; none where all do, or too few.
fn lasting(run: &[f64]) -> Option<usize> {
    let most = run.iter().copied().fold(0.0, f64::max);
    let blocks = 1 + run.iter().rposition(|um| *um >= NEARLY * most)?;
    let mean = |of: &[f64]| stats::mean(of.iter().copied()).unwrap_or(0.0);
    let halves = run[..blocks].split_at(blocks / 2);
    let stays = mean(halves.1) >= NOT_DYING * mean(halves.0);
    (blocks >= LEAST_BLOCKS && stays).then_some(blocks)
}

/// Root mean square of the tooth's place about the straight line that fits it best, um; none where the tool is in the
/// air, and where the depth changes, which strikes the machine once.
fn of_block(rows: &[Row]) -> f64 {
    let alike = |row: &Row| {
        !row.has(flag::AIR)
            && row.axial_depth_mm == rows[0].axial_depth_mm
            && row.radial_depth_mm == rows[0].radial_depth_mm
    };
    if rows.iter().all(|row| row.vibration_um == 0.0) || !rows.iter().all(alike) {
        return 0.0;
    }
    let middle = 0.5 * (rows.len() - 1) as f64;
    let mean = stats::mean(rows.iter().map(|row| row.vibration_um)).unwrap_or(0.0);
    let (mut product, mut square) = (0.0, 0.0);
    for (i, row) in rows.iter().enumerate() {
        let x = i as f64 - middle;
        product += x * (row.vibration_um - mean);
        square += x * x;
    }
    let slope = if square > 0.0 { product / square } else { 0.0 };
    let off = rows
        .iter()
        .enumerate()
        .map(|(i, row)| row.vibration_um - mean - slope * (i as f64 - middle));
    stats::rms(off).unwrap_or(0.0)
}

/// Where it chatters, in order.
pub(super) fn spans(scan: &Scan, rows: &[Row], row_s: f64) -> Vec<RowSpan> {
    let lost = lost(scan, row_s).into_iter();
    let scatter = scan.scatter();
    let large = scatter.large().into_iter().map(|span| begun(span, scatter.rows, rows));
    let mut all: Vec<RowSpan> = lost.chain(large).collect();
    all.sort_by_key(|span| span.first);
    joined(&all, (GAP_S / row_s) as usize)
}

/// A span of whole blocks from where in its first one the tooth's place leaves what it was in the block before: what
/// strikes the machine there must not seem to come after what it does.
fn begun(span: RowSpan, block: usize, rows: &[Row]) -> RowSpan {
    let before =
        &rows[span.first.saturating_sub(block).min(rows.len())..span.first.min(rows.len())];
    let Some(mean) = stats::mean(before.iter().map(|row| row.vibration_um)) else { return span };
    let first = rows.iter().skip(span.first).take(block);
    let quiet = first.take_while(|row| (row.vibration_um - mean).abs() < LEAST_UM).count();
    // Where it leaves that nowhere in the first block it crept there.
    let quiet = if quiet < block { quiet } else { 0 };
    RowSpan { first: (span.first + quiet).min(span.last), last: span.last }
}

/// Where teeth jump out of the cut for longer than a step makes them.
fn lost(scan: &Scan, row_s: f64) -> Vec<RowSpan> {
    let mut lost = scan.flagged(flag::LOST_CONTACT, (GAP_S / row_s) as usize);
    lost.retain(|span| (span.last - span.first) as f64 * row_s >= LEAST_LOST_S - 0.5 * row_s);
    lost
}

/// The figures of such a stretch; `so_far`: the cut goes on after the rows that are known.
pub(super) fn chatter(
    span: RowSpan,
    scan: &Scan,
    rows: &[Row],
    row_s: f64,
    so_far: bool,
) -> Chatter {
    let RowSpan { first, last } = span;
    let spanned = &rows[first..=last];
    let most = |of: fn(&Row) -> f64| spanned.iter().map(of).fold(0.0, f64::max);
    // What changes around the last row has ended it.
    let gap = (GAP_S / row_s) as usize;
    let near = &rows[last.saturating_sub(gap)..(last + gap).min(rows.len())];
    let ends = if last + gap >= rows.len() {
        if so_far { ChatterEnd::SoFar } else { ChatterEnd::GoesOn }
    } else if near.iter().any(|row| row.has(flag::AIR)) {
        ChatterEnd::Air
    } else if near.iter().any(|row| row.axial_depth_mm != rows[last].axial_depth_mm) {
        ChatterEnd::Depth
    } else {
        ChatterEnd::Itself
    };
    let mean_ra = |of: fn(&Row) -> Option<f64>| {
        let known: Vec<f64> = spanned.iter().filter_map(of).collect();
        if 2 * known.len() > spanned.len() { stats::mean(known) } else { None }
    };
    let ra = mean_ra(shaken_ra_um).zip(mean_ra(produced_ra_um));
    Chatter {
        axial_depth_mm: spanned[0].axial_depth_mm,
        deepest_mm: most(|row| row.axial_depth_mm),
        spindle_rpm: spanned[0].spindle_rpm,
        largest_force_n: most(|row| row.force_dyn_n),
        mean_force_n: stats::mean(spanned.iter().map(|row| row.force_n)).unwrap_or(0.0),
        loses_contact: lost(scan, row_s)
            .iter()
            .any(|lost| lost.first <= last && first <= lost.last),
        from_tooth_to_tooth_um: scan.scatter().amplitude_um(span),
        ra_um: ra.map(|(with, without)| [with, without]),
        ends,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_begins_where_the_tooth_is_struck_and_not_with_the_block_that_this_is_in() {
        let row = |i: usize| Row {
            time_s: 0.01 * i as f64,
            axial_depth_mm: 2.0,
            vibration_um: match i {
                ..60 => 7.0,
                _ if i.is_multiple_of(2) => 1.0,
                _ => 13.0,
            },
            ..Row::default()
        };
        let rows: Vec<Row> = (0..200).map(row).collect();
        let mut scan = Scan::default();
        scan.extend(&rows);
        let found = spans(&scan, &rows, 0.01);
        assert_eq!(found, [RowSpan { first: 60, last: 199 }]);
    }

    #[test]
    fn what_dies_down_is_none_and_what_grows_or_stays_is() {
        // A slow end of what a step struck: 5 % less in each block.
        let dying: Vec<f64> = (0..12).map(|i| 10.0 - 0.5 * f64::from(i)).collect();
        assert_eq!(lasting(&dying), None);
        assert_eq!(lasting(&[5.0]), None);
        assert_eq!(lasting(&[3.0, 3.2, 3.4]), Some(3));
        assert_eq!(lasting(&[3.0, 2.9, 3.1, 3.0, 2.9]), Some(5));
        // It grows, and dies down when the speed is another.
        assert_eq!(lasting(&[3.0, 5.0, 8.0, 9.0, 4.0, 2.5]), Some(4));
    }
}
