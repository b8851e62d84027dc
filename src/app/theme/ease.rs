//! What makes the console easier to look at: large type for a projector or tired eyes, and less motion.

use egui::style::ScrollAnimation;
use egui::{Context, Id, Theme};

/// How much larger everything is for a projector (chosen): a laptop's 1280 points are as wide as a desktop's
/// console needs even so.
const PROJECTOR_ZOOM: f32 = 1.4;

fn large_id() -> Id {
    Id::unique("large type")
}

fn still_id() -> Id {
    Id::unique("less motion")
}

/// Whether type and everything else is large, for a projector.
#[must_use]
pub fn is_large(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(large_id())).unwrap_or(false)
}

/// Makes everything large, or as it was.
pub fn set_large(ctx: &Context, large: bool) {
    ctx.data_mut(|data| data.insert_temp(large_id(), large));
    ctx.set_zoom_factor(if large { PROJECTOR_ZOOM } else { 1.0 });
}

/// Whether nothing is to move but what shows the cut.
#[must_use]
pub fn is_still(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(still_id())).unwrap_or(false)
}

/// Has windows and lists come without gliding, and pictures stand until they are set in motion, or no more.
pub fn set_still(ctx: &Context, still: bool) {
    ctx.data_mut(|data| data.insert_temp(still_id(), still));
    let usual = egui::Style::default();
    for theme in [Theme::Light, Theme::Dark] {
        ctx.style_mut_of(theme, |style| {
            style.animation_time = if still { 0.0 } else { usual.animation_time };
            style.scroll_animation =
                if still { ScrollAnimation::none() } else { usual.scroll_animation };
        });
    }
}
