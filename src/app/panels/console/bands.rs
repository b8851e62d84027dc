//! The bands below the plots: over time, which controller was at work, where commands stood at
//! their limits, where models were used outside their range, where the tool was in the air, and
//! where overrides moved at their rate.

use egui::{Align2, Color32, Rangef, Rect, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::app::panels::View;
use crate::app::session::disturb::told;
use crate::app::theme::Palette;
use crate::app::trace::FLAG_ROWS;
use crate::base::language::{in_english, text, tr};
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::run::diagram::Names;
use crate::run::met_disturbances;
use crate::run::signals::{FLAGS, FlagInfo, flag};

const HEIGHT: f32 = 15.0;

/// Height of the bands' text line, points.
const TEXT: f32 = 16.0;
const GAP: f32 = 3.0;
/// Room at the sides of a text in a band, points.
const PAD: f32 = 5.0;
/// Length of the mark of a disturbance that stays, as a share of the run.
const MARK: f64 = 0.02;

/// The bands about states.
const STATES: [(&str, u32); 3] = [
    (text!("At a limit"), flag::SATURATED),
    (text!("Outside model"), flag::OUTSIDE),
    (text!("In the air"), flag::AIR),
];
/// The band where overrides are rate-limited, and the one where a controller has a limit of its own.
const RATE: (&str, u32) = (text!("Override on its way"), flag::RATE_LIMITED);
const OVER: (&str, u32) = (text!("Over the AFC limit"), flag::OVER_LIMIT);

/// The states that there are bands for.
fn states(view: &View<'_>) -> Vec<(&'static str, u32)> {
    let (scenario, edits) = (view.session.scenario(), view.session.edits().list());
    let changed = |path: &str| edits.iter().any(|edit| edit.path == path);
    let mut states = STATES.to_vec();
    if scenario.cnc.override_rate_limited || changed("cnc.override_rate_limited") {
        states.push(RATE);
    }
    let afc = Value::Text(ControllerKind::Afc.id().to_owned());
    let chosen = edits.iter().any(|edit| edit.path == "controller.kind" && edit.value == afc);
    if scenario.controller.kind == ControllerKind::Afc || chosen {
        states.push(OVER);
    }
    states
}

/// Room that the bands need, points.
#[must_use]
pub fn total_height(view: &View<'_>, beside: bool) -> f32 {
    let text = if beside { 0.0 } else { TEXT };
    (2 + states(view).len()) as f32 * (HEIGHT + text + GAP) + 4.0
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
    let kind = tr(view.session.current().controller.kind.label()).to_owned();
    let title = tr("Controller");
    let mut bands = vec![(title, controllers(view), palette.accent, kind, String::new())];
    // There from the start, so that nothing moves when one is dropped.
    let (stretches, text, more) = disturbances(view);
    bands.push((tr("Disturbances"), stretches, palette.warn, text, more));
    for (title, bits) in states(view) {
        let color = match bits {
            flag::OUTSIDE | flag::OVER_LIMIT => palette.bad,
            flag::AIR => palette.twin,
            flag::RATE_LIMITED => palette.command,
            _ => palette.warn,
        };
        let (stretches, seen) = flagged(view, place.range, bits);
        bands.push((tr(title), stretches, color, state(view, bits, seen), symbols(view, seen)));
    }
    ui.spacing_mut().item_spacing.y = GAP;
    for (title, stretches, color, text, more) in bands {
        let playhead_s = view.session.playback().playhead_s;
        band(ui, (title, &text, &more), &stretches, color, playhead_s, place);
    }
}

/// The disturbances, those ahead of the playhead too where the run is worked out so far; what acts now in words, and
/// all of them with their sizes.
fn disturbances(view: &View<'_>) -> (Vec<Stretch>, String, String) {
    let session = view.session;
    let run = session.chosen().run();
    let rows = run.recording().rows();
    let now = session.revealed().len() - 1;
    let time_s = |row: usize| rows.get(row).or(rows.last()).map_or(0.0, |row| row.time_s);
    let (mut stretches, mut acting, mut all) = (Vec::new(), Vec::new(), Vec::new());
    for met in met_disturbances::met(run, rows) {
        let to_s = match met.kind.lasts() {
            true => met.to.map_or(f64::INFINITY, time_s),
            // A mark: what it does stays.
            false => time_s(met.from) + MARK * session.length_s(),
        };
        let to_s = to_s.min(session.length_s());
        let text = tr(met.kind.label()).to_owned();
        stretches.push(Stretch { from_s: time_s(met.from), to_s, text });
        if met.from <= now && (met.kind.stays() || met.to.is_none_or(|to| now < to)) {
            acting.push(tr(met.kind.in_text()));
        }
        all.push(told(met.kind, &met.zone));
    }
    let text = match (acting.is_empty(), all.len()) {
        (true, 0) => tr("none").to_owned(),
        (true, _) => tr("none now").to_owned(),
        (false, _) => {
            acting.dedup();
            tr!("{names} now", names = acting.join(", "))
        }
    };
    (stretches, text, all.join("\n"))
}

/// What is so at the playhead, or else in the picture, in words.
fn state(view: &View<'_>, bits: u32, seen: u32) -> String {
    let names = |set: u32| {
        let set = FLAGS.iter().filter(|info| info.bit & bits & set != 0);
        // The model in plain words, with its symbol; the feed of a feed at a limit.
        let of = Names::of(view.session.current());
        let names = set.map(|info| match model(info.bit) {
            Some(number) => format!("{} ({})", tr(Names::gives(number)), symbol(of, info)),
            None => subject(info.bit).to_owned(),
        });
        names.collect::<Vec<String>>().join(", ")
    };
    let now = view.session.row().state_flags as u32 & bits;
    match (bits, now, seen) {
        (_, 0, 0) => tr("no").to_owned(),
        (flag::AIR | flag::OVER_LIMIT, 0, _) => tr("not now").to_owned(),
        (flag::AIR | flag::OVER_LIMIT, ..) => tr("now").to_owned(),
        (_, 0, seen) => tr!("{names}, not now", names = names(seen)),
        (_, now, _) => tr!("{names} now", names = names(now)),
    }
}

/// What stands at its limit or moves at its rate, by a flag that is about no model.
fn subject(bit: u32) -> &'static str {
    match bit {
        flag::FEED_SATURATED | flag::FEED_RATE_LIMITED => tr("feed"),
        flag::SPEED_SATURATED => tr("speed"),
        flag::SPEED_RATE_LIMITED => tr("spindle"),
        _ => "",
    }
}

/// The symbol of the model that a flag is about: it is cut out of its English sentence, which begins with it.
fn symbol(names: Names, info: &FlagInfo) -> String {
    let sentence = in_english(|| names.flag(info));
    sentence.split(' ').next().unwrap_or_default().to_owned()
}

/// The number of the model that a flag is about.
fn model(bit: u32) -> Option<u32> {
    const OUTSIDE: [u32; 6] = [
        flag::K1_OUTSIDE,
        flag::K2_OUTSIDE,
        flag::K3_OUTSIDE,
        flag::K4_OUTSIDE,
        flag::K5_OUTSIDE,
        flag::K6_OUTSIDE,
    ];
    (1..).zip(OUTSIDE).find(|(_, known)| *known == bit).map(|(number, _)| number)
}

/// Which models are outside their range, by their symbols: what the band's text says in plain words.
fn symbols(view: &View<'_>, seen: u32) -> String {
    let names = Names::of(view.session.current());
    let models = FLAGS.iter().filter(|info| info.bit & seen != 0);
    let models = models.filter_map(|info| {
        let gives = tr(Names::gives(model(info.bit)?));
        Some(format!("{}: {gives}", symbol(names, info)))
    });
    models.collect::<Vec<String>>().join("\n")
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
            let text = tr(kind.label()).to_owned();
            stretches.push(Stretch { from_s, to_s: edit.at_s, text });
            from_s = edit.at_s;
            kind = ControllerKind::from_id(id).unwrap_or(kind);
        }
    }
    stretches.push(Stretch { from_s, to_s: end_s, text: tr(kind.label()).to_owned() });
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
    (title, text, more): (&str, &str, &str),
    stretches: &[Stretch],
    color: Color32,
    playhead_s: f64,
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
    let seen: Vec<&Stretch> =
        stretches.iter().filter(|s| s.to_s >= from_s && s.from_s <= to_s).collect();
    for (n, stretch) in seen.iter().enumerate() {
        // At least a point wide: short ones must be seen as well.
        let (left, right) = (x(stretch.from_s), x(stretch.to_s));
        let block =
            Rect::from_min_max(pos2(left, rail.top()), pos2(right.max(left + 1.0), rail.bottom()));
        let worded = !stretch.text.is_empty();
        let fill = if worded { color.gamma_multiply(0.3) } else { color };
        painter.rect_filled(block, 2.0, fill);
        if !worded {
            continue;
        }
        // Whole, in the block or behind it where there is room up to the next one; a part of a word is none. What has no
        // room is read by hovering.
        let text = painter.layout_no_wrap(stretch.text.clone(), font.clone(), palette.text);
        let end = seen.get(n + 1).map_or(rail.right(), |next| x(next.from_s));
        let left = match 2.0 * PAD + text.size().x {
            width if width <= block.width() => block.left() + PAD,
            width if width <= end - block.right() => block.right() + PAD,
            _ => continue,
        };
        painter.galley(pos2(left, block.center().y - 0.5 * text.size().y), text, palette.text);
    }
    if (from_s..=to_s).contains(&playhead_s) {
        painter.vline(x(playhead_s), rail.y_range(), egui::Stroke::new(1.0, palette.playhead));
    }
    response.on_hover_text(format!("{said}\n{more}").trim_end());
}
