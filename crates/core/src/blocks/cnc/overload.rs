//! The overload guard: too large a force stops the feed at once, past the dead time, for good, to save the
//! tool. A controller with a limit of its own can ask for the same.

use serde::Serialize;

use crate::base::language::tr;

/// A force beyond what is allowed, which has stopped the feed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, thiserror::Error)]
#[error("{}", self.sentence())]
pub struct Overload {
    /// The force, N.
    pub force_n: f64,
    /// The force that was allowed, N.
    pub limit_n: f64,
    /// Where along the way it happened, mm.
    pub position_mm: f64,
    /// When, s.
    pub time_s: f64,
    /// Whether the tool was lifted off the work; otherwise it stands in the cut.
    pub retracted: bool,
}

impl Overload {
    /// In words.
    fn sentence(&self) -> String {
        let Self { force_n, limit_n, position_mm, time_s, retracted } = *self;
        if retracted {
            tr!(
                "The machine stopped at {time:.2} s, {position:.1} mm: {force:.0} N, allowed {limit:.0} N; \
                 the tool is lifted off the work",
                time = time_s,
                position = position_mm,
                force = force_n,
                limit = limit_n
            )
        } else {
            tr!(
                "The machine stopped at {time:.2} s, {position:.1} mm: {force:.0} N, allowed {limit:.0} N",
                time = time_s,
                position = position_mm,
                force = force_n,
                limit = limit_n
            )
        }
    }
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
            let limit_n = self.limit_n;
            self.met = Some(Overload { force_n, limit_n, position_mm, time_s, retracted: false });
        }
    }

    /// Stops the feed for what a controller has met; what was met before stays.
    pub fn stop(&mut self, overload: Overload) {
        self.met.get_or_insert(overload);
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
