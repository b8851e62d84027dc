//! The one place for colours, sizes and line styles. The palette is that of Okabe
//! and Ito, which people with colour-blind eyes can distinguish; lines differ in style as well.

mod ease;
mod fit;

use egui::style::NumberFormatter;
use egui::{Color32, CornerRadius, Stroke, Theme};
use egui_plot::LineStyle;

use super::format;
use crate::base::language;

pub use ease::{is_large, is_still, set_large, set_still};
pub use fit::{FINGER, WindowFit, figure, fingers, large, note, value};

/// Below this width of the window, in points, everything stands in one column.
pub const NARROW: f32 = 900.0;
/// Below this height of a narrow screen, in points, less is pinned above its plots.
pub const LOW: f32 = 560.0;
/// Size of the first window, points.
pub const WINDOW: [f32; 2] = [1280.0, 800.0];
/// Smallest window, points.
pub const WINDOW_MIN: [f32; 2] = [320.0, 420.0];
/// Width of the controls beside the plots, points.
pub const CONTROLS_WIDTH: f32 = 276.0;
/// Least height of a plot with its axis, points; in one column, where plots are scrolled, more.
pub const PLOT_HEIGHT_MIN: f32 = 110.0;
/// See [`PLOT_HEIGHT_MIN`].
pub const PLOT_HEIGHT_SCROLLED: f32 = 170.0;
/// Least width of a card of the headline, points; where it is narrow, less.
pub const CARD_WIDTH: f32 = 172.0;
/// See [`CARD_WIDTH`].
pub const CARD_WIDTH_NARROW: f32 = 116.0;
/// Width of the content of a window over a screen at first, points; on a phone it takes the screen.
pub const OVERLAY_WIDTH: f32 = 640.0;
/// Largest height of such a window where the screen allows it, and that of a low one, points.
pub const OVERLAY_HEIGHTS: [f32; 2] = [620.0, 420.0];
/// Fraction of its reference within which a force counts as held.
pub const FORCE_BAND: f64 = 0.02;
/// Length of the window that follow mode shows, s.
pub const FOLLOW_S: f64 = 20.0;

/// The colours of one theme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// The value that is controlled or produced.
    pub produced: Color32,
    /// The same with dynamics.
    pub dynamics: Color32,
    /// What a controller commands.
    pub command: Color32,
    /// Target or reference.
    pub reference: Color32,
    /// The area of tolerance around it.
    pub band: Color32,
    /// Limits.
    pub limit: Color32,
    /// The constant-feed twin.
    pub twin: Color32,
    /// The run before the last change.
    pub ghost: Color32,
    /// The last cut driven by hand.
    pub hand: Color32,
    /// What was measured.
    pub measured: Color32,
    /// The playhead.
    pub playhead: Color32,
    /// As it should be.
    pub good: Color32,
    /// Not as it should be.
    pub bad: Color32,
    /// To be looked at.
    pub warn: Color32,
    /// Background of cards and strips.
    pub card: Color32,
    /// Lines around cards.
    pub line: Color32,
    /// Grid lines of plots.
    pub grid: Color32,
    /// Text of minor importance.
    pub weak: Color32,
    /// Text.
    pub text: Color32,
    /// Tabs and selections.
    pub accent: Color32,
    /// Boundaries of the plan's seven constraints, in their order.
    pub constraints: [Color32; 7],
    /// Small and large force on the map of the plan.
    pub force: [Color32; 2],
    /// The same where a constraint is violated.
    pub barred: [Color32; 2],
}

/// The part in space, light and dark alike since a lamp shines on it: bare metal; within the
/// tolerance, above it up to twice as far off, farther above, below it, each also darker or lighter than the
/// others; body and edges of the cutter, in none of their colours.
pub const METAL: Color32 = rgb(0xa8b0ba);
/// See [`METAL`].
pub const MACHINED: [Color32; 4] = [rgb(0x2aa584), rgb(0xe9c63a), rgb(0xcf4a1c), rgb(0x5b3f9e)];
/// See [`METAL`].
pub const CUTTER: [Color32; 2] = [rgb(0x6b7482), rgb(0x5f8fe0)];

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

const LIGHT: Palette = Palette {
    produced: rgb(0x0072b2),
    dynamics: rgb(0x9ccbe8),
    command: rgb(0xb84e00),
    reference: rgb(0x00795a),
    band: Color32::from_rgba_premultiplied(0, 38, 28, 42),
    limit: rgb(0xa04a7a),
    twin: rgb(0x6b6b6b),
    ghost: rgb(0xb07a00),
    hand: rgb(0x6a3d9a),
    measured: rgb(0x2b2118),
    playhead: rgb(0x1f2933),
    good: rgb(0x006b4f),
    bad: rgb(0xb3431a),
    warn: rgb(0x8a6100),
    card: rgb(0xf3f6f9),
    line: rgb(0xd3dae2),
    grid: rgb(0xe4e9ee),
    weak: rgb(0x5a6672),
    text: rgb(0x18212b),
    accent: rgb(0x0072b2),
    constraints: [
        rgb(0x6b4a1f),
        rgb(0x6a3d9a),
        rgb(0xc24400),
        rgb(0x18212b),
        rgb(0xa8447f),
        rgb(0x00795a),
        rgb(0x946300),
    ],
    force: [rgb(0xb9e0f6), rgb(0x3f96cf)],
    barred: [rgb(0xe7e5e2), rgb(0xb1aeaa)],
};

const DARK: Palette = Palette {
    produced: rgb(0x56b4e9),
    dynamics: rgb(0x2b5f7f),
    command: rgb(0xf08a3c),
    reference: rgb(0x2fc79c),
    band: Color32::from_rgba_premultiplied(6, 44, 33, 52),
    limit: rgb(0xd98fb5),
    twin: rgb(0xa8a8a8),
    ghost: rgb(0xe6b94a),
    hand: rgb(0xb79af0),
    measured: rgb(0xf6efe2),
    playhead: rgb(0xe8edf2),
    good: rgb(0x3fd2a8),
    bad: rgb(0xff9166),
    warn: rgb(0xf0c24a),
    card: rgb(0x202830),
    line: rgb(0x39434e),
    grid: rgb(0x262e37),
    weak: rgb(0xa3afbb),
    text: rgb(0xe6ebf0),
    accent: rgb(0x56b4e9),
    constraints: [
        rgb(0xc9a46b),
        rgb(0xb79af0),
        rgb(0xff8a4a),
        rgb(0xf2f5f8),
        rgb(0xf09ac6),
        rgb(0x2fc79c),
        rgb(0xffd24a),
    ],
    force: [rgb(0x174560), rgb(0x2f8cc6)],
    barred: [rgb(0x1d1e20), rgb(0x4a4b4d)],
};

impl Palette {
    /// The palette of a theme.
    #[must_use]
    pub fn of(theme: Theme) -> &'static Self {
        match theme {
            Theme::Light => &LIGHT,
            Theme::Dark => &DARK,
        }
    }

    /// The palette in which `ui` is drawn.
    #[must_use]
    pub fn at(ui: &egui::Ui) -> &'static Self {
        if ui.visuals().dark_mode { &DARK } else { &LIGHT }
    }
}

/// How a line is drawn: its meaning in the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// The value that is controlled or produced.
    Produced,
    /// The same with dynamics.
    Dynamics,
    /// What a controller commands.
    Command,
    /// The force that the controller asks its models for.
    Setpoint,
    /// Target or reference.
    Reference,
    /// Limits.
    Limit,
    /// The constant-feed twin.
    Twin,
    /// The run before the last change.
    Ghost,
    /// The same with dynamics.
    GhostDynamics,
    /// The last cut driven by hand, beside that of a controller.
    Hand,
    /// The run after the last change, ahead of a playhead that stands.
    Future,
    /// The same with dynamics.
    FutureDynamics,
    /// The boundary of a constraint of the plan, by its number in the list of seven.
    Constraint(usize),
    /// The searched cutting speed where it is fixed.
    Searched,
    /// A measured channel, by its number among those over the plots.
    Measured(usize),
    /// A force component along the feed, across it, along the tool.
    Axis(usize),
}

impl Look {
    /// Stroke and style of such a line.
    #[must_use]
    pub fn line(self, palette: &Palette) -> (Stroke, LineStyle) {
        let (width, color, style) = match self {
            Self::Produced => (2.0, palette.produced, LineStyle::Solid),
            Self::Dynamics => (1.0, palette.dynamics, LineStyle::Solid),
            Self::Command => (1.4, palette.command, LineStyle::Solid),
            Self::Setpoint => (1.4, palette.command, LineStyle::Dashed { length: 4.0 }),
            Self::Reference => (1.6, palette.reference, LineStyle::Dashed { length: 12.0 }),
            Self::Limit => (1.2, palette.limit, LineStyle::Dashed { length: 6.0 }),
            Self::Twin => (1.2, palette.twin, LineStyle::Dashed { length: 6.0 }),
            Self::Ghost => (1.3, palette.ghost, LineStyle::Dotted { spacing: 5.0 }),
            Self::GhostDynamics => (0.8, palette.ghost, LineStyle::Solid),
            Self::Hand => (1.8, palette.hand, LineStyle::Dashed { length: 10.0 }),
            Self::Future => (1.5, palette.produced, LineStyle::Dashed { length: 3.0 }),
            Self::FutureDynamics => (1.0, palette.dynamics, LineStyle::Dashed { length: 3.0 }),
            Self::Measured(number) => {
                let style = match number % 3 {
                    0 => LineStyle::Solid,
                    1 => LineStyle::Dashed { length: 9.0 },
                    _ => LineStyle::Dotted { spacing: 6.0 },
                };
                (1.2, palette.measured, style)
            }
            Self::Searched => (1.2, palette.weak, LineStyle::Dashed { length: 6.0 }),
            Self::Axis(0) => (1.4, palette.command, LineStyle::Solid),
            Self::Axis(1) => (1.4, palette.limit, LineStyle::Dashed { length: 8.0 }),
            Self::Axis(_) => (1.4, palette.ghost, LineStyle::Dotted { spacing: 5.0 }),
            Self::Constraint(number) => {
                let (width, style) = match number {
                    0 => (2.0, LineStyle::Dashed { length: 16.0 }),
                    1 => (1.6, LineStyle::Dashed { length: 8.0 }),
                    2 => (2.6, LineStyle::Solid),
                    3 => (2.2, LineStyle::Dotted { spacing: 5.0 }),
                    4 => (2.2, LineStyle::Dashed { length: 4.0 }),
                    5 => (2.2, LineStyle::Dotted { spacing: 9.0 }),
                    _ => (1.6, LineStyle::Solid),
                };
                (width, palette.constraints[number], style)
            }
        };
        (Stroke::new(width, color), style)
    }
}

/// Sets spacing and colours of both themes, and sizes as for a desktop.
pub fn install(ctx: &egui::Context) {
    fit::sizes(ctx, WindowFit::default());
    for theme in [Theme::Light, Theme::Dark] {
        let palette = Palette::of(theme);
        ctx.style_mut_of(theme, |style| {
            style.number_formatter = NumberFormatter::new(|number, decimals| {
                format::signed(language::decimal(egui::emath::format_with_decimals_in_range(
                    number, decimals,
                )))
            });
            style.spacing.item_spacing = egui::vec2(8.0, 5.0);
            style.spacing.slider_rail_height = 6.0;
            style.spacing.scroll = egui::style::ScrollStyle::thin();
            // What fades towards the edge is hard to read there.
            style.spacing.scroll.fade.strength = 0.0;
            let visuals = &mut style.visuals;
            visuals.selection.bg_fill = palette.accent.gamma_multiply(0.35);
            visuals.selection.stroke = Stroke::new(1.0, palette.text);
            visuals.hyperlink_color = palette.accent;
            visuals.slider_trailing_fill = true;
            visuals.widgets.noninteractive.fg_stroke.color = palette.text;
            visuals.widgets.inactive.fg_stroke.color = palette.text;
            visuals.weak_text_color = Some(palette.weak);
            visuals.disabled_alpha = 0.7;
            let fill = if theme == Theme::Light { rgb(0xffffff) } else { rgb(0x161b21) };
            visuals.panel_fill = fill;
            visuals.window_fill = fill;
            // Text in the shadow of a window stays legible.
            visuals.window_shadow.color = Color32::from_black_alpha(25);
            visuals.extreme_bg_color =
                if theme == Theme::Light { rgb(0xfcfdfe) } else { rgb(0x11161b) };
            visuals.widgets.noninteractive.bg_stroke = Stroke::new(1.0, palette.line);
            let radius = CornerRadius::same(5);
            for widget in [
                &mut visuals.widgets.inactive,
                &mut visuals.widgets.hovered,
                &mut visuals.widgets.active,
                &mut visuals.widgets.open,
            ] {
                widget.corner_radius = radius;
            }
        });
    }
}

/// Fits the sizes to the window in which `ui` is the whole, and says to what.
pub fn fit(ui: &mut egui::Ui) -> WindowFit {
    let fit = WindowFit::of(ui);
    fit::sizes(ui.ctx(), fit);
    // It was made with the style of the frame's start.
    ui.reset_style();
    fit
}

/// Bars that are always seen, for what would not be thought to scroll; nothing fades at its edge either.
#[must_use]
pub fn solid_bars() -> egui::style::ScrollStyle {
    let mut style = egui::style::ScrollStyle::solid();
    style.fade.strength = 0.0;
    style
}

/// A frame for a card or strip.
pub fn card(palette: &Palette) -> egui::Frame {
    egui::Frame::new()
        .fill(palette.card)
        .stroke(Stroke::new(1.0, palette.line))
        .corner_radius(CornerRadius::same(6))
        .inner_margin(egui::Margin::symmetric(10, 6))
}
