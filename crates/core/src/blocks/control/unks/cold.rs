//! The scheme from a cold start: literal feedback-error learning (Miyamoto, Kawato, Setoyama,
//! Suzuki 1988), in which the feedback's command is the error that NM-2 learns from.
//!
//! ```text
//! z    = (f0 - ln a_0, f0 - f1, f0 - f2, ln F_ref)
//! u_fb = NM-R(F_ref, F_m) - 1                     the division controller's part, weight 1
//! u    = exp(NM-2(z)) + u_fb
//! NM-2 learns u_fb / u_ff, not at a limit
//! ```
//!
//! NM-2 gives 1 before it has learned, so the scheme begins as the division controller and hands
//! over, sample by sample, from the feedback to the inverse model. NM-1 has no part in it.

use super::{ForceSample, LEAST, UnksLaw, free};
use crate::base::math::{self, limit};
use crate::models::unks::REFERENCE_KN;

impl UnksLaw {
    pub(super) fn cold(&mut self, sample: &ForceSample, [now, old, older]: [f64; 3]) -> f64 {
        let most = sample.range[1];
        let features = [now - math::ln(sample.actual), now - old, now - older];
        let wanted = math::ln(REFERENCE_KN);
        let asked = math::exp(self.inverse.predict(features, wanted));
        let feed_forward = limit(asked, LEAST, most);
        let feedback = self.networks.ratio(REFERENCE_KN, sample.y * REFERENCE_KN) - 1.0;
        let u = limit(feed_forward + feedback, sample.range[0], most);
        let free = free(u, most);
        if free {
            let error = feedback / feed_forward;
            let rate = self.settings.cold_rate;
            self.inverse.learn((features, wanted), error, f64::INFINITY, rate);
        }
        self.trace.note(feed_forward, feedback, 0, free);
        u
    }
}
