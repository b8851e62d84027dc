//! The one place for sizes of text, and for what a window is made: desktop or phone, mouse or fingers.

use egui::{Context, Event, FontFamily, FontId, Id, TextStyle, Theme, Ui, Vec2, vec2};

use super::NARROW;

/// What the console fits itself to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WindowFit {
    /// Whether the window is as narrow as a phone's.
    pub phone: bool,
    /// Whether fingers press: a touch was seen, or it is a phone.
    pub fingers: bool,
}

impl WindowFit {
    /// What the window in which `ui` is the whole is to be fitted to.
    pub(super) fn of(ui: &Ui) -> Self {
        let id = Id::unique("touched");
        let before = ui.data(|data| data.get_temp(id)).unwrap_or(false);
        let touched = before || ui.input(|input| input.events.iter().any(is_touch));
        if touched != before {
            ui.data_mut(|data| data.insert_temp(id, touched));
        }
        let phone = ui.available_width() < NARROW;
        Self { phone, fingers: phone || touched }
    }
}

fn is_touch(event: &Event) -> bool {
    matches!(event, Event::Touch { .. })
}

/// Least width and height of what a finger presses, points (WCAG 2.2, 2.5.5).
pub const FINGER: f32 = 44.0;

/// Whether fingers press here.
#[must_use]
pub fn fingers(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp::<WindowFit>(fitted())).is_some_and(|fit| fit.fingers)
}

fn fitted() -> Id {
    Id::unique("fit")
}

/// Sizes of text in logical pixels.
struct Sizes {
    /// The smallest that there is: notes, legends, names in pictures.
    note: f32,
    /// Text, buttons, numbers.
    plain: f32,
    /// Readings beside the plots.
    value: f32,
    /// Numbers of the headline.
    figure: f32,
    heading: f32,
    /// Figures of an operator's panel, to be read from afar.
    large: f32,
}

const DESKTOP: Sizes =
    Sizes { note: 12.0, plain: 13.0, value: 15.0, figure: 20.0, heading: 18.0, large: 34.0 };
const PHONE: Sizes =
    Sizes { note: 13.0, plain: 14.0, value: 16.0, figure: 16.0, heading: 18.0, large: 24.0 };

/// The style of readings beside the plots.
#[must_use]
pub fn value() -> TextStyle {
    TextStyle::Name("value".into())
}

/// The style of the headline's numbers.
#[must_use]
pub fn figure() -> TextStyle {
    TextStyle::Name("figure".into())
}

/// The style of the figures of an operator's panel.
#[must_use]
pub fn large() -> TextStyle {
    TextStyle::Name("large".into())
}

/// The font of the smallest text, for what is painted without a style.
#[must_use]
pub fn note(ctx: &Context) -> FontId {
    TextStyle::Small.resolve(&ctx.global_style())
}

/// Gives both themes the sizes of text and targets for `fit`.
pub(super) fn sizes(ctx: &Context, fit: WindowFit) {
    if ctx.data(|data| data.get_temp(fitted())) == Some(fit) {
        return;
    }
    ctx.data_mut(|data| data.insert_temp(fitted(), fit));
    let sizes = if fit.phone { PHONE } else { DESKTOP };
    let font = FontId::proportional;
    let styles = [
        (TextStyle::Small, font(sizes.note)),
        (TextStyle::Body, font(sizes.plain)),
        (TextStyle::Button, font(sizes.plain)),
        (TextStyle::Monospace, FontId::new(sizes.plain, FontFamily::Monospace)),
        (TextStyle::Heading, font(sizes.heading)),
        (value(), font(sizes.value)),
        (figure(), font(sizes.figure)),
        (large(), font(sizes.large)),
    ];
    for theme in [Theme::Light, Theme::Dark] {
        ctx.style_mut_of(theme, |style| {
            style.text_styles.extend(styles.clone());
            // A finger that begins on a sentence scrolls: it would mark the words.
            style.interaction.selectable_labels = !fit.fingers;
            let spacing = &mut style.spacing;
            if fit.fingers {
                spacing.interact_size = Vec2::splat(FINGER);
                spacing.button_padding = vec2(10.0, 6.0);
                spacing.icon_width = 20.0;
                spacing.icon_width_inner = 12.0;
                // Lists are longer.
                spacing.default_area_size = vec2(600.0, 660.0);
            } else {
                spacing.interact_size = vec2(40.0, 24.0);
                spacing.button_padding = vec2(8.0, 4.0);
                spacing.icon_width = 14.0;
                spacing.icon_width_inner = 8.0;
                spacing.default_area_size = vec2(600.0, 400.0);
            }
        });
    }
}
