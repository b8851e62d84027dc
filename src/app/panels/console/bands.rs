//! The bands below the plots: over time, which controller was at work, where commands stood at
//! their limits, where models were used outside their range, where the tool was in the air, and
//! where overrides moved at their rate.

use egui::{Align2, Color32, Rangef, Rect, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::app::panels::View;
use crate::app::theme::Palette;
use crate::app::trace::FLAG_ROWS;
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::run::diagram::Names;
use crate::run::signals::{FLAGS, flag};

const HEIGHT: f32 = 15.0;

/// Height of the bands' text line, points.
const TEXT: f32 = 16.0;
const GAP: f32 = 3.0;

/// The bands about states, the last one only where overrides are rate-limited.
const STATES: [(&str, u32); 4] = [
    ("At a limit", flag::SATURATED),
    ("Outside model", flag::OUTSIDE),
    ("In the air", flag::AIR),
    ("Override on its way", flag::RATE_LIMITED),
];

/// The states that there are bands for.
fn states(view: &View<'_>) -> &'static [(&'static str, u32)] {
    const SWITCH: &str = "cnc.override_rate_limited";
    let session = view.session;
    let limited = session.scenario().cnc.override_rate_limited
        || session.edits().list().iter().any(|edit| edit.path == SWITCH);
    if limited { &STATES } else { &STATES[..3] }
}

/// Room that the bands need, points.
#[must_use]
pub fn total_height(view: &View<'_>, beside: bool) -> f32 {
    let text = if beside { 0.0 } else { TEXT };
    (1 + states(view).len()) as f32 * (HEIGHT + text + GAP) + 4.0
}

/// Where the bands stand.
#[derive(Clone, Copy, Debug)]
pub struct BandPlace {
    /// The time axis of the charts above: the bands share it.
    pub axis: Rangef,
    /// The range of time on it, s.
    pub range: [f64; 2],
    /// Whether the texts stand at the right of the bands rather than above them.
    pub beside: bool,
}

/// An interval of time with its text.
struct Stretch {
    from_s: f64,
    to_s: f64,
    text: String,
}

/// The bands below the charts.
pub fn show(ui: &mut Ui, view: &View<'_>, place: BandPlace) {
    let palette = Palette::at(ui);
    let kind = view.session.current().controller.kind.label();
    let mut bands = vec![("Controller", controllers(view), palette.accent, kind.to_owned())];
    for (title, bits) in states(view) {
        let color = match *bits {
            flag::OUTSIDE => palette.bad,
            flag::AIR => palette.twin,
            flag::RATE_LIMITED => palette.command,
            _ => palette.warn,
        };
        let (stretches, seen) = flagged(view, place.range, *bits);
        bands.push((title, stretches, color, state(view, *bits, seen)));
    }
    ui.spacing_mut().item_spacing.y = GAP;
    for (title, stretches, color, text) in bands {
        band(ui, title, &stretches, color, view.session.playback().playhead_s, &text, place);
    }
}

/// What is so at the playhead, or else in the picture, in words.
fn state(view: &View<'_>, bits: u32, seen: u32) -> String {
    let names = |set: u32| {
        let set = FLAGS.iter().filter(|info| info.bit & bits & set != 0);
        let names = set.map(|info| {
            // "K2" of "K2 outside its range", "feed" of "feed at a limit".
            let name = Names::of(view.session.current()).flag(info);
            name.split(' ').next().unwrap_or_default().to_owned()
        });
        names.collect::<Vec<String>>().join(", ")
    };
    let now = view.session.row().state_flags as u32 & bits;
    match (bits, now, seen) {
        (_, 0, 0) => "no".to_owned(),
        (flag::AIR, 0, _) => "not now".to_owned(),
        (flag::AIR, ..) => "now".to_owned(),
        (_, 0, seen) => format!("{}, not now", names(seen)),
        (_, now, _) => format!("{} now", names(now)),
    }
}

fn controllers(view: &View<'_>) -> Vec<Stretch> {
    let session = view.session;
    let mut kind = session.scenario().controller.kind;
    let mut from_s = 0.0;
    let mut stretches = Vec::new();
    let end_s = session.playback().playhead_s;
    for edit in session.edits().list().iter().filter(|edit| edit.at_s < end_s) {
        let Value::Text(id) = &edit.value else { continue };
        if edit.path == "controller.kind" {
            stretches.push(Stretch { from_s, to_s: edit.at_s, text: kind.label().to_owned() });
            from_s = edit.at_s;
            kind = ControllerKind::from_id(id).unwrap_or(kind);
        }
    }
    stretches.push(Stretch { from_s, to_s: end_s, text: kind.label().to_owned() });
    stretches
}

/// Stretches of time in which any of the bits is set, as fine as the buckets of the pyramid; and
/// those of the bits that are set anywhere in the range.
fn flagged(view: &View<'_>, range: [f64; 2], bits: u32) -> (Vec<Stretch>, u32) {
    let cut = view.session.chosen();
    let revealed = view.session.revealed();
    let row_s = cut.run().recording().row_s();
    let bucket_s = FLAG_ROWS as f64 * row_s;
    let full = (revealed.len() / FLAG_ROWS).min(cut.traces().flags().len());
    let buckets = cut.traces().flags()[..full].iter().map(|flags| (bucket_s, *flags));
    let rest = revealed[full * FLAG_ROWS..].iter().map(|row| (row_s, row.state_flags as u32));
    let mut stretches: Vec<Stretch> = Vec::new();
    let (mut time_s, mut seen) = (0.0, 0);
    for (length_s, flags) in buckets.chain(rest) {
        let end_s = time_s + length_s;
        if flags & bits != 0 && end_s >= range[0] && time_s <= range[1] {
            seen |= flags & bits;
            match stretches.last_mut() {
                Some(last) if last.to_s >= time_s - 0.5 * row_s => last.to_s = end_s,
                _ => stretches.push(Stretch { from_s: time_s, to_s: end_s, text: String::new() }),
            }
        }
        time_s = end_s;
    }
    (stretches, seen)
}

fn band(
    ui: &mut Ui,
    title: &str,
    stretches: &[Stretch],
    color: Color32,
    playhead_s: f64,
    text: &str,
    place: BandPlace,
) {
    let palette = Palette::at(ui);
    let font = egui::TextStyle::Small.resolve(ui.style());
    let [from_s, to_s] = place.range;
    let height = if place.beside { HEIGHT } else { HEIGHT + TEXT };
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let said = format!("{title}: {text}");
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, said.clone()));
    let painter = ui.painter();
    let rail_y = Rangef::new(rect.bottom() - HEIGHT, rect.bottom());
    let rail = Rect::from_x_y_ranges(place.axis, rail_y);
    let at = if place.beside {
        pos2(rail.right() + 12.0, rail.center().y)
    } else {
        pos2(rail.left(), rect.top() + 0.5 * TEXT)
    };
    painter.text(at, Align2::LEFT_CENTER, &said, font.clone(), palette.weak);
    painter.rect_filled(rail, 2.0, palette.card);
    let x = |time_s: f64| {
        let fraction = ((time_s - from_s) / (to_s - from_s)).clamp(0.0, 1.0);
        egui::lerp(rail.x_range(), fraction as f32)
    };
    for stretch in stretches.iter().filter(|s| s.to_s >= from_s && s.from_s <= to_s) {
        // At least a point wide: short ones must be seen as well.
        let (left, right) = (x(stretch.from_s), x(stretch.to_s));
        let block =
            Rect::from_min_max(pos2(left, rail.top()), pos2(right.max(left + 1.0), rail.bottom()));
        let worded = !stretch.text.is_empty();
        let fill = if worded { color.gamma_multiply(0.3) } else { color };
        painter.rect_filled(block, 2.0, fill);
        if worded {
            let clip = painter.with_clip_rect(block);
            let at = pos2(block.left() + 5.0, block.center().y);
            clip.text(at, Align2::LEFT_CENTER, &stretch.text, font.clone(), palette.text);
        }
    }
    if (from_s..=to_s).contains(&playhead_s) {
        painter.vline(x(playhead_s), rail.y_range(), egui::Stroke::new(1.0, palette.playhead));
    }
    response.on_hover_text(said);
}
