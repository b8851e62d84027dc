//! The comparison at the head of the console: the chosen controller against constant feed.

use egui::{RichText, Role, TextWrapMode, Ui, WidgetInfo};

use super::answer::LoopAnswer;
use crate::app::format;
use crate::app::panels::View;
use crate::app::theme::{self, Palette};
use crate::app::twin::Comparison;
use crate::app::widgets::standing::Standing;
use crate::base::units::ratio_from_percent;
use crate::blocks::reference::Reference;
use crate::run::metrics::Metrics;
use crate::run::signals::{Row, flag};
use crate::run::story::{EventKind, produced_ra_um};

/// One number of the comparison.
struct Item {
    title: &'static str,
    help: String,
    value: String,
    standing: Standing,
    /// The lines below the value.
    below: [String; 2],
}

/// Deviations of the force up to the first count as good, beyond the second as bad, %.
const FORCE_LEVELS: [f64; 2] = [5.0, 15.0];
/// Fractions of the length in tolerance from the first on count as good, below the second as bad, %.
const TOLERANCE_LEVELS: [f64; 2] = [90.0, 50.0];

fn items(view: &View<'_>) -> [Item; 5] {
    let twin_has = |value: String| {
        let twin = if view.narrow { "const." } else { "constant feed" };
        format!("{twin} {value}")
    };
    let Comparison { chosen, twin, .. } = view.session.comparison();
    let reference = view.session.current().target.reference;
    // Where Ra is held, the force is the means: how far it strays says nothing about the surface.
    let last = match reference {
        Reference::Ra => Item {
            title: "Metal removed",
            help: "Axial depth times radial depth, summed over the path.".to_owned(),
            value: format::quantity(chosen.metal_removed_cm3, "cm^3"),
            standing: Standing::Plain,
            below: [
                format!("on {} of path", format::quantity(chosen.path_mm, "mm")),
                twin_has(format::quantity(twin.metal_removed_cm3, "cm^3")),
            ],
        },
        Reference::Force => worst_force(chosen, twin_has(signed(twin.force_worst_percent))),
    };
    [
        match reference {
            Reference::Ra => ra_now(view, &twin_has),
            Reference::Force => force_now(view, &twin_has),
        },
        in_tolerance(chosen, reference, view.narrow, twin_has(judged(twin))),
        answer(view),
        time_of_cut(view),
        last,
    ]
}

fn ra_now(view: &View<'_>, twin_has: &dyn Fn(String) -> String) -> Item {
    let (now, twin) = (view.session.row(), &view.session.comparison().twin_now);
    let target = &view.session.current().target;
    // The target as it is set now: that of the row is one control period or an undo behind.
    let (target_um, tolerance) = (target.ra_um, ratio_from_percent(target.tolerance_percent));
    let text = |row: &Row| match produced_ra_um(row) {
        Some(ra_um) => format::quantity(ra_um, "um"),
        None => format::none(row).to_owned(),
    };
    let ra = produced_ra_um(now);
    let side = ra.map(|ra_um| side(ra_um, target_um, tolerance));
    let swings = swings(view);
    let target_text = format::quantity(target_um, "um");
    Item {
        title: "Ra now",
        help: format!(
            "Roughness produced at the playhead: as it should be within {} % of its target.",
            target.tolerance_percent
        ),
        value: text(now),
        standing: Standing::judged(
            side == Some(WITHIN) && !swings,
            side.is_some_and(|side| side != WITHIN),
        ),
        below: [
            match side {
                Some(_) if swings && !view.narrow => format!("swings, target {target_text}"),
                Some(side) if !view.narrow => format!("{side} target {target_text}"),
                Some(_) | None => format!("target {target_text}"),
            },
            twin_has(text(twin)),
        ],
    }
}

/// Whether an instability or chatter lasts at the playhead: what swings through its target is not held there.
fn swings(view: &View<'_>) -> bool {
    let lasting = view.session.story().lasting_at(view.session.row().time_s + 1e-9);
    lasting.is_some_and(|event| matches!(event.id, EventKind::LimitCycle | EventKind::Chatter))
}

/// The word for a value within the tolerance of its target.
const WITHIN: &str = "within";

/// On which side of its target's tolerance a value lies: a word, since colours alone tell not everybody.
fn side(value: f64, target: f64, tolerance: f64) -> &'static str {
    match (value - target) / target {
        off if off > tolerance => "above",
        off if off < -tolerance => "below",
        _ => WITHIN,
    }
}

fn answer(view: &View<'_>) -> Item {
    let LoopAnswer { value, standing, below } = LoopAnswer::of(view);
    Item {
        title: "Remaining error",
        help: "The steady-state error: how far Ra, or the force where a force is held, comes to rest \
               from its target after the last step, whether that, with what it still swings by, is \
               within the tolerance; the settling time of the force (within 2 % of where it rests for \
               good, and what noise moves it by) and its overshoot over where it rests. Unstable: feed \
               and force swing without dying down; a cut that did so is not called good later on."
            .to_owned(),
        value,
        standing,
        below,
    }
}

/// In the place of the roughness where a force is to be held.
fn force_now(view: &View<'_>, twin_has: &dyn Fn(String) -> String) -> Item {
    let (now, twin) = (view.session.row(), &view.session.comparison().twin_now);
    let percent = view.session.current().target.tolerance_percent;
    let tolerance_n = ratio_from_percent(percent) * now.force_ref_n;
    let inside = (now.force_n - now.force_ref_n).abs() <= tolerance_n;
    let side = side(now.force_n, now.force_ref_n, ratio_from_percent(percent));
    let side = if now.has(flag::AIR) { "in the air," } else { side };
    let force = |row: &Row| format::quantity(row.force_n, "N");
    Item {
        title: "Force now",
        help: format!(
            "Maximum force at the playhead: as it should be within {percent} % of its reference."
        ),
        value: force(now),
        standing: Standing::judged(inside && !swings(view), !inside && !now.has(flag::AIR)),
        below: [
            format!("{side} reference {}", format::quantity(now.force_ref_n, "N")),
            twin_has(force(twin)),
        ],
    }
}

fn in_tolerance(chosen: &Metrics, reference: Reference, narrow: bool, twin: String) -> Item {
    let share = chosen.in_tolerance_percent;
    let unknown = chosen.not_judged_percent.unwrap_or(0.0);
    let below = match format::number(unknown, "%").as_str() {
        "0.0" => "of the length cut".to_owned(),
        _ if is_all(unknown) => "outside the model".to_owned(),
        some if narrow => format!("{some} % not judged"),
        some => format!("{some} % outside the model"),
    };
    let [good, bad] = TOLERANCE_LEVELS;
    Item {
        title: match reference {
            Reference::Ra => "Ra in tolerance",
            Reference::Force => "Force in tolerance",
        },
        help: match reference {
            Reference::Ra => {
                "Share of the cut length on which the produced Ra lies within the tolerance \
                 around its target. Where it lies outside the model it is not judged: it is neither \
                 within nor outside."
            }
            Reference::Force => {
                "Share of the cut length on which the maximum force lies within the tolerance \
                 around its reference."
            }
        }
        .to_owned(),
        value: judged(chosen),
        standing: Standing::judged(
            share.is_some_and(|x| x >= good),
            share.is_some_and(|x| x + unknown < bad),
        ),
        below: [below, twin],
    }
}

fn worst_force(chosen: &Metrics, twin: String) -> Item {
    let size = chosen.force_worst_percent.map(f64::abs);
    let [good, bad] = FORCE_LEVELS;
    let standing = Standing::judged(size.is_some_and(|x| x <= good), size.is_some_and(|x| x > bad));
    Item {
        title: "Worst force deviation",
        help: "Largest deviation of the force from the desired force after the first second."
            .to_owned(),
        value: signed(chosen.force_worst_percent),
        standing,
        below: ["from desired force".to_owned(), twin],
    }
}

fn time_of_cut(view: &View<'_>) -> Item {
    let Comparison { chosen, twin, time_saved_s, .. } = view.session.comparison();
    let saved = if *time_saved_s < 0.0 { "lost" } else { "saved" };
    let size_s = format::quantity(time_saved_s.abs(), "s");
    let percent =
        if twin.time_of_cut_s > 0.0 { 100.0 * time_saved_s / twin.time_of_cut_s } else { 0.0 };
    let holds = |of: &Metrics| of.in_tolerance_percent.unwrap_or(0.0) >= TOLERANCE_LEVELS[0];
    let below = if holds(chosen) && holds(twin) {
        let compared = match percent {
            even if even.abs() < 0.5 => "as long as constant feed".to_owned(),
            saved if saved > 0.0 => format!("{saved:.0} % shorter than constant feed"),
            lost => format!("{:.0} % longer than constant feed", -lost),
        };
        match compared.split_once(" than ") {
            // Where it is narrow, the sentence takes both lines.
            Some((start, rest)) if view.narrow => [format!("{start} than"), rest.to_owned()],
            _ => [compared, format!("{size_s} {saved} on the same path")],
        }
    } else {
        // A time is no victory where the tolerance is broken, by either.
        let held = match holds(chosen) {
            true => format!("it held {}", judged(twin)),
            false => format!("{} held", judged(chosen)),
        };
        [
            format!("constant feed {}", format::time(twin.time_of_cut_s)),
            format!("not compared: {held}"),
        ]
    };
    Item {
        title: "Time of cut",
        help: format!(
            "Time since the start of the cut. Constant feed takes {} for the same length of \
             path: {size_s} {saved}. Times are compared only where both hold the tolerance on at least \
             {} % of the length: a faster cut outside it is no gain.",
            format::time(twin.time_of_cut_s),
            TOLERANCE_LEVELS[0]
        ),
        value: format::time(chosen.time_of_cut_s),
        standing: Standing::Plain,
        below,
    }
}

/// Whether a share in percent is all there is, as it is written.
fn is_all(share: f64) -> bool {
    format::number(share, "%") == "100.0"
}

/// The share in tolerance, or that none is judged.
fn judged(of: &Metrics) -> String {
    match of.not_judged_percent {
        Some(unknown) if is_all(unknown) => "not judged".to_owned(),
        Some(_) | None => share_of(of.in_tolerance_percent),
    }
}

/// Before the first contact, and in the air alone, there is no share.
fn share_of(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |x| format::quantity(x, "%"))
}

fn signed(value: Option<f64>) -> String {
    let Some(value) = value else { return "-".to_owned() };
    let text = format::quantity(value, "%");
    if value > 0.0 && !text.starts_with("0.0 ") { format!("+{text}") } else { text }
}

/// The strip: cards beside each other, as long as their numbers have room.
pub fn show(ui: &mut Ui, view: &View<'_>) {
    let items = items(view);
    let (gap, least) =
        if view.narrow { (4.0, theme::CARD_WIDTH_NARROW) } else { (8.0, theme::CARD_WIDTH) };
    let most = ((ui.available_width() + gap) / (least + gap)).floor().max(1.0) as usize;
    // Rows of about the same length.
    let columns = items.len().div_ceil(items.len().div_ceil(most));
    let width = (ui.available_width() - gap * (columns - 1) as f32) / columns as f32;
    for row in items.chunks(columns) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            for item in row {
                // A short last row is stretched over the whole width.
                let width = width * columns as f32 / row.len() as f32
                    + gap * (columns as f32 / row.len() as f32 - 1.0);
                card(ui, item, width, view.narrow);
            }
        });
    }
}

fn card(ui: &mut Ui, item: &Item, width: f32, narrow: bool) {
    let margin =
        if narrow { egui::Margin::symmetric(6, 3) } else { egui::Margin::symmetric(10, 5) };
    let palette = Palette::at(ui);
    let frame = theme::card(palette).inner_margin(margin);
    let inside = width - frame.total_margin().sum().x;
    let response = frame
        .show(ui, |ui| {
            ui.set_width(inside);
            ui.vertical(|ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                let title = RichText::new(item.title).small().color(palette.weak);
                ui.add(egui::Label::new(title).truncate());
                let value = RichText::new(&item.value).text_style(theme::figure()).strong();
                let label = item.standing.line(ui, value, TextWrapMode::Truncate);
                let words = item.standing.words();
                let said = format!("{} {words}", item.value);
                label.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.trim_end()));
                for line in &item.below {
                    let below = RichText::new(line).small().color(palette.weak);
                    ui.add(egui::Label::new(below).truncate());
                }
            });
        })
        .response;
    response.on_hover_text(&item.help);
}
