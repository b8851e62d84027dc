//! The clock of the console: how long work takes, so that a frame's share of it stays small.

/// Time since some moment in s.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::disallowed_methods, reason = "the front end has a clock")]
pub fn now_s() -> f64 {
    use std::sync::LazyLock;
    use std::time::Instant;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}

/// Time since some moment in s. Without the page's clock it is the time of day, which may be set.
#[cfg(target_arch = "wasm32")]
pub fn now_s() -> f64 {
    let performance = web_sys::window().and_then(|window| window.performance());
    1e-3 * performance.map_or_else(js_sys::Date::now, |performance| performance.now())
}
