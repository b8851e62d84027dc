//! The bands below the plots: over time, which controller was at work, where commands stood at
//! their limits, where models were used outside their range, and where the tool was in the air.

use egui::{Align2, Color32, Rect, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::app::panels::View;
use crate::app::theme::Palette;
use crate::app::trace::FLAG_ROWS;
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::run::signals::{FLAGS, Row, flag};

const HEIGHT: f32 = 13.0;
const SATURATED: u32 = flag::FEED_SATURATED | flag::SPEED_SATURATED;
const OUTSIDE: u32 = flag::K1_OUTSIDE
    | flag::K2_OUTSIDE
    | flag::K3_OUTSIDE
    | flag::K4_OUTSIDE
    | flag::K5_OUTSIDE
    | flag::K6_OUTSIDE;

/// Room that the bands need, points.
pub const TOTAL_HEIGHT: f32 = 4.0 * (HEIGHT + 3.0) + 4.0;

/// A stretch of time with its text.
struct Stretch {
    from_s: f64,
    to_s: f64,
    text: String,
}

/// The bands over a range of time.
pub fn show(ui: &mut Ui, view: &View<'_>, range: [f64; 2]) {
    let palette = Palette::at(ui);
    let row = view.session.row();
    let bands = [
        ("Controller", controllers(view), palette.accent, "its kind over time".to_owned()),
        ("At a limit", flagged(view, range, SATURATED), palette.warn, now(row, SATURATED)),
        ("Outside model", flagged(view, range, OUTSIDE), palette.bad, now(row, OUTSIDE)),
        ("In the air", flagged(view, range, flag::AIR), palette.twin, now(row, flag::AIR)),
    ];
    ui.spacing_mut().item_spacing.y = 3.0;
    for (title, stretches, color, text) in bands {
        band(ui, title, &stretches, color, range, view.session.playback().playhead_s, &text);
    }
}

/// The flags that are set at the playhead, in words.
fn now(row: &Row, bits: u32) -> String {
    let set = FLAGS.iter().filter(|info| info.bit & bits != 0 && row.has(info.bit));
    let names: Vec<&str> = set.map(|info| info.label).collect();
    if names.is_empty() { "not at the playhead".to_owned() } else { names.join(", ") }
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

/// Stretches of time in which any of the bits is set, as fine as the buckets of the pyramid.
fn flagged(view: &View<'_>, range: [f64; 2], bits: u32) -> Vec<Stretch> {
    let cut = view.session.chosen();
    let revealed = view.session.revealed();
    let row_s = cut.run().recording().row_s();
    let bucket_s = FLAG_ROWS as f64 * row_s;
    let full = (revealed.len() / FLAG_ROWS).min(cut.traces().flags().len());
    let buckets = cut.traces().flags()[..full].iter().map(|flags| (bucket_s, *flags));
    let rest = revealed[full * FLAG_ROWS..].iter().map(|row| (row_s, row.state_flags as u32));
    let mut stretches: Vec<Stretch> = Vec::new();
    let mut time_s = 0.0;
    for (length_s, flags) in buckets.chain(rest) {
        let end_s = time_s + length_s;
        if flags & bits != 0 && end_s >= range[0] && time_s <= range[1] {
            match stretches.last_mut() {
                Some(last) if last.to_s >= time_s - 0.5 * row_s => last.to_s = end_s,
                _ => stretches.push(Stretch { from_s: time_s, to_s: end_s, text: String::new() }),
            }
        }
        time_s = end_s;
    }
    stretches
}

fn band(
    ui: &mut Ui,
    title: &str,
    stretches: &[Stretch],
    color: Color32,
    [from_s, to_s]: [f64; 2],
    playhead_s: f64,
    text: &str,
) {
    let palette = Palette::at(ui);
    let font = egui::TextStyle::Small.resolve(ui.style());
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::hover());
    response
        .widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, format!("{title}: {text}")));
    let label_width = 86.0;
    let painter = ui.painter();
    let at = pos2(rect.left(), rect.center().y);
    painter.text(at, Align2::LEFT_CENTER, title, font.clone(), palette.weak);
    let rail = Rect::from_min_max(pos2(rect.left() + label_width, rect.top()), rect.max);
    painter.rect_filled(rail, 2.0, palette.card);
    let x = |time_s: f64| {
        let share = ((time_s - from_s) / (to_s - from_s)).clamp(0.0, 1.0);
        egui::lerp(rail.x_range(), share as f32)
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
    response.on_hover_text(format!("{title}: {text}"));
}
