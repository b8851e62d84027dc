//! The overload guard: too large a force stops the feed at once, past the dead time, for good, to save the
//! tool.

use serde::Serialize;

/// A force beyond what is allowed, which has stopped the feed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, thiserror::Error)]
#[error("stopped at {time_s:.2} s, {position_mm:.1} mm: {force_n:.0} N, allowed {limit_n:.0} N")]
pub struct Overload {
    /// The force, N.
    pub force_n: f64,
    /// The force that was allowed, N.
    pub limit_n: f64,
    /// Where along the way it happened, mm.
    pub position_mm: f64,
    /// When, s.
    pub time_s: f64,
}

/// The guard with what it has met.
#[derive(Clone, Copy, Debug)]
pub struct OverloadGuard {
    /// Force that stops the feed, N; infinite where that is switched off.
    limit_n: f64,
    met: Option<Overload>,
}

impl OverloadGuard {
    /// A guard that stops the feed beyond a force in N; `None` switches it off.
    #[must_use]
    pub fn new(limit_n: Option<f64>) -> Self {
        Self { limit_n: limit_n.unwrap_or(f64::INFINITY), met: None }
    }

    /// Takes over another limit in N; a feed that was stopped stays so.
    pub fn reconfigure(&mut self, limit_n: Option<f64>) {
        self.limit_n = limit_n.unwrap_or(f64::INFINITY);
    }

    /// Looks at a force in N at a position in mm and a time in s.
    #[inline]
    pub fn watch(&mut self, force_n: f64, position_mm: f64, time_s: f64) {
        if force_n > self.limit_n && self.met.is_none() {
            self.met = Some(Overload { force_n, limit_n: self.limit_n, position_mm, time_s });
        }
    }

    /// What has stopped the feed, if anything has.
    #[must_use]
    #[inline]
    pub fn met(&self) -> Option<Overload> {
        self.met
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_overload_stays_and_without_a_limit_there_is_none() {
        let mut guard = OverloadGuard::new(Some(2000.0));
        guard.watch(2000.0, 1.0, 0.1);
        assert_eq!(guard.met(), None, "what is allowed is allowed");
        guard.watch(2001.0, 2.0, 0.2);
        guard.watch(9000.0, 3.0, 0.3);
        guard.reconfigure(None);
        assert_eq!(guard.met().unwrap().force_n, 2001.0);
        let mut off = OverloadGuard::new(None);
        off.watch(1e9, 1.0, 0.1);
        assert_eq!(off.met(), None);
    }
}
