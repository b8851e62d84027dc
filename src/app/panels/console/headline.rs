//! The comparison at the head of the console: the chosen controller against constant feed, the safe one or as it is
//! programmed.

use egui::Ui;

use super::answer::LoopAnswer;
use super::cards::{self, Item};
use crate::app::format;
use crate::app::panels::View;
use crate::app::session::TwinStand;
use crate::app::widgets::standing::Standing;
use crate::base::language::{in_english, text, tr};
use crate::base::units::ratio_from_percent;
use crate::blocks::reference::Reference;
use crate::run::against_twin::{Comparison, TimeJudged};
use crate::run::diagram::Names;
use crate::run::metrics::{HELD_PERCENT, Metrics};
use crate::run::signals::{FLAGS, Row, flag, signal};
use crate::run::story::{EventKind, produced_ra_um};

/// What stands in the place of the safe feed's figures until it is found.
const FINDING: &str = text!("finding \u{2026}");

/// Deviations of the force up to the first count as good, beyond the second as bad, %.
const FORCE_LEVELS: [f64; 2] = [5.0, 15.0];
/// Fractions of the length in tolerance from the first on count as good, below the second as bad, %.
const TOLERANCE_LEVELS: [f64; 2] = [HELD_PERCENT, 50.0];

/// The strip.
pub fn show(ui: &mut Ui, view: &View<'_>) {
    cards::show(ui, view, &items(view));
}

fn items(view: &View<'_>) -> [Item; 5] {
    let stand = view.session.twin_stand();
    let twin_has = |value: String| {
        let twin = if view.narrow { stand.short() } else { stand.name() };
        match twin_is_known(view) {
            true => format!("{twin} {value}"),
            false => format!("{twin}: {}", tr(FINDING)),
        }
    };
    let Comparison { chosen, twin, .. } = view.session.comparison();
    let reference = view.session.current().target.reference;
    // Where Ra is held, the force is the means: how far it strays says nothing about the surface.
    let last = match reference {
        Reference::Ra => Item {
            title: tr("Metal removed"),
            help: tr("Axial depth times radial depth, summed over the path.").to_owned(),
            value: format::quantity(chosen.metal_removed_cm3, "cm^3"),
            standing: Standing::Plain,
            below: [
                tr!("on {path} of path", path = format::quantity(chosen.path_mm, "mm")),
                twin_has(format::quantity(twin.metal_removed_cm3, "cm^3")),
            ],
        },
        Reference::Force => worst_force(
            chosen,
            match shakes(view) {
                true => tr(JUDGED).to_owned(),
                false => twin_has(signed(twin.force_worst_percent)),
            },
        ),
    };
    [
        match reference {
            Reference::Ra => ra_now(view, &twin_has),
            Reference::Force => force_now(view, &twin_has),
        },
        in_tolerance(
            view,
            chosen,
            match (shakes(view), reference) {
                (true, Reference::Force) => tr(JUDGED).to_owned(),
                (true, Reference::Ra) | (false, _) => twin_has(share_with_scrap(twin, reference)),
            },
        ),
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
        Some(ra_um) => format::continued(format::quantity(ra_um, "um"), row, "ra_um"),
        None => format::none(row).to_owned(),
    };
    let ra = produced_ra_um(now);
    let side = ra.map(|ra_um| side(ra_um, target_um, tolerance));
    let swings = swings(view);
    let target_text = format::quantity(target_um, "um");
    let continued = format!(" {}", format::continued_help([now, twin]));
    let continued = continued.trim_end();
    if shakes(view) {
        // What is left on the part is with dynamics, and that is judged.
        let with = value_of(now, "ra_dyn_um");
        let without = match ra {
            None if view.narrow => tr("without: none").to_owned(),
            None => tr("without: outside its model").to_owned(),
            Some(_) => tr!("without {ra}", ra = text(now)),
        };
        let beside = match view.session.twin_stand().is_settled() {
            true => tr!(
                "In {twin}: {ra}.",
                twin = view.session.twin_title(),
                ra = signal_text(twin, "ra_dyn_um", "um")
            ),
            false => format!("{}.", view.session.twin_title()),
        };
        return Item {
            title: tr(WITH[0]),
            help: tr!(
                "Roughness produced at the playhead, with the marks of the machine's vibration: as it should be within \
                 {percent} % of the target. Without is Ra by the model of the cut alone, which a controller holds. \
                 {beside}",
                percent = target.tolerance_percent,
                beside = beside
            ) + continued,
            value: signal_text(now, "ra_dyn_um", "um"),
            standing: match with.map(|ra_um| self::side(ra_um, target_um, tolerance)) {
                Some(ToleranceSide::Within) if !swings => Standing::Good,
                Some(ToleranceSide::Above) => Standing::Bad,
                Some(ToleranceSide::Within | ToleranceSide::Below) => Standing::Watch,
                None => Standing::Plain,
            },
            below: [without, tr!("target {target}", target = target_text)],
        };
    }
    Item {
        title: tr("Ra now"),
        help: tr!(
            "Roughness produced at the playhead: as it should be within {percent} % of its target.",
            percent = target.tolerance_percent
        ) + continued,
        value: text(now),
        // Smoother than asked is no scrap: time was given away.
        standing: match side {
            // Beyond what was measured nothing is known to be good.
            Some(ToleranceSide::Within) if now.has(flag::K5_OUTSIDE) => Standing::Watch,
            Some(ToleranceSide::Within) if !swings => Standing::Good,
            Some(ToleranceSide::Above) => Standing::Bad,
            Some(ToleranceSide::Below) => Standing::Watch,
            Some(ToleranceSide::Within) | None => Standing::Plain,
        },
        below: [
            match side {
                Some(_) if swings && !view.narrow => {
                    tr!("swings, target {target}", target = target_text)
                }
                Some(ToleranceSide::Above) if !view.narrow => {
                    tr!("above target {target}", target = target_text)
                }
                Some(ToleranceSide::Within) if !view.narrow => {
                    tr!("within target {target}", target = target_text)
                }
                Some(ToleranceSide::Below) if !view.narrow => {
                    tr!("below target {target}", target = target_text)
                }
                Some(_) | None => tr!("target {target}", target = target_text),
            },
            twin_has(text(twin)),
        ],
    }
}

/// Titles of Ra and of the force where the machine vibrates in the cut: each has two curves then. Of Ra what is left on
/// the part is judged, of the force what is held.
pub(super) const WITH: [&str; 2] = [text!("Ra with dynamics"), text!("Force without dynamics")];

/// What is said of a force that is judged so.
const JUDGED: &str = text!("judged without dynamics");

/// Whether the twin is the one that belongs to the cut, and has come as far as it is compared.
fn twin_is_known(view: &View<'_>) -> bool {
    let Comparison { chosen, twin, .. } = view.session.comparison();
    let far = twin.path_mm >= chosen.path_mm - 1.0;
    view.session.twin_stand().is_settled() && (far || view.session.twin_is_done())
}

/// Whether the machine vibrates in the cut.
pub(super) fn shakes(view: &View<'_>) -> bool {
    view.session.current().machine.coupled
}

fn value_of(row: &Row, id: &str) -> Option<f64> {
    signal(id).and_then(|signal| (signal.value)(row))
}

fn signal_text(row: &Row, id: &str, unit: &str) -> String {
    value_of(row, id).map_or(format::none(row).to_owned(), |value| {
        format::continued(format::quantity(value, unit), row, id)
    })
}

/// Whether an instability or chatter lasts at the playhead: what swings through its target is not held there.
fn swings(view: &View<'_>) -> bool {
    let lasting = view.session.story().lasting_at(view.session.row().time_s + 1e-9);
    lasting.is_some_and(|event| matches!(event.id, EventKind::LimitCycle | EventKind::Chatter))
}

/// On which side of its target's tolerance a value lies; it is told in a word, since colours alone tell not everybody.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ToleranceSide {
    Above,
    Within,
    Below,
}

fn side(value: f64, target: f64, tolerance: f64) -> ToleranceSide {
    match (value - target) / target {
        off if off > tolerance => ToleranceSide::Above,
        off if off < -tolerance => ToleranceSide::Below,
        _ => ToleranceSide::Within,
    }
}

fn answer(view: &View<'_>) -> Item {
    let LoopAnswer { value, standing, below, band } = LoopAnswer::of(view);
    Item {
        title: match shakes(view) {
            true => tr("Error without dynamics"),
            false => tr("Remaining error"),
        },
        help: tr!(
            "The steady-state error: how far Ra, or the force where a force is held, comes to rest \
             from its target after the last step, whether that, with what it still swings by, is \
             within the tolerance; the settling time of the force, until it stays within a band around where it \
             rests for good, and its overshoot beyond where it rests: the jump that the change itself makes is none. Unstable: feed \
             and force swing without dying down; a cut that did so is not called good later on.{band}",
            band = band
        ),
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
    let force = |row: &Row| format::quantity(row.force_n, "N");
    let wanted = format::quantity(now.force_ref_n, "N");
    let reference = match (now.has(flag::AIR), side) {
        (true, _) => tr!("in the air, reference {force}", force = wanted),
        (false, ToleranceSide::Above) => tr!("above reference {force}", force = wanted),
        (false, ToleranceSide::Within) => tr!("within reference {force}", force = wanted),
        (false, ToleranceSide::Below) => tr!("below reference {force}", force = wanted),
    };
    let (title, below) = match shakes(view) {
        true => {
            let shaken = signal_text(now, "force_dyn_n", "N");
            (tr(WITH[1]), [tr!("with dynamics {force}", force = shaken), reference])
        }
        false => (tr("Force now"), [reference, twin_has(force(twin))]),
    };
    Item {
        title,
        help: tr!(
            "Maximum force at the playhead, without dynamics: as it should be within {percent} % of its \
             reference.",
            percent = percent
        ),
        value: force(now),
        standing: Standing::judged(inside && !swings(view), !inside && !now.has(flag::AIR)),
        below,
    }
}

fn in_tolerance(view: &View<'_>, chosen: &Metrics, twin: String) -> Item {
    let reference = view.session.current().target.reference;
    let with_dynamics = chosen.in_tolerance_dyn_percent.is_some();
    let share = chosen.judged_in_tolerance_percent();
    let unknown = chosen.not_judged_percent.unwrap_or(0.0);
    let twin_sides = sides(&view.session.comparison().twin, reference);
    let sides = sides(chosen, reference);
    let model = ra_model(view);
    // One line: what stands below must not move when another word comes.
    let part = format::number(unknown, "%");
    let mut below = match () {
        () if is_none(unknown) && (sides.is_empty() || view.narrow) => {
            tr("of the length cut").to_owned()
        }
        () if is_none(unknown) => side_foremost(chosen, reference),
        () if is_all(unknown) => tr!("outside the Ra model ({model})", model = model),
        () if view.narrow => tr!("{share} % no Ra ({model})", share = part, model = model),
        () => tr!("{share} % outside the Ra model ({model})", share = part, model = model),
    };
    // What is not judged says more than what was without dynamics.
    if with_dynamics && is_none(unknown) {
        let share = share_of(chosen.in_tolerance_percent);
        below = tr!("without dynamics {share}", share = share);
    }
    let [good, bad] = TOLERANCE_LEVELS;
    // Nothing but smoother than asked is no scrap.
    let scrap = chosen.judged_above_tolerance_percent().unwrap_or(0.0);
    let low = share.is_some_and(|x| x + unknown < bad);
    Item {
        title: match (reference, with_dynamics) {
            (Reference::Ra, false) => tr("Ra in tolerance"),
            (Reference::Ra, true) => tr("With dynamics in tolerance"),
            (Reference::Force, _) => tr("Force in tolerance"),
        },
        help: match (reference, with_dynamics) {
            (Reference::Ra, false) => tr(
                "Share of the cut length on which the produced Ra lies within the tolerance \
                 around its target. Outside it is too rough, which is scrap, or smoother than asked, which is none. \
                 Where Ra lies outside its model it is not judged: it is neither within nor outside.",
            ),
            (Reference::Ra, true) => tr(
                "Share of the cut length on which Ra with dynamics, which is what is left on the part, lies within the \
                 tolerance around the target. Outside it is too rough, which is scrap, or smoother than asked, which \
                 is none. Where Ra lies outside its model it is not judged.",
            ),
            (Reference::Force, _) => tr(
                "Share of the cut length on which the maximum force lies within the tolerance \
                 around its reference.",
            ),
        }
        .to_owned()
            + match sides.is_empty() {
                true => String::new(),
                false => format!(" {}", tr!("So far: {sides}.", sides = sides)),
            }
            .as_str()
            + match (view.session.twin_stand().is_settled(), twin_sides.is_empty()) {
                (true, false) => {
                    let twin = view.session.twin_title();
                    format!(" {}", tr!("In {twin}: {sides}.", twin = twin, sides = twin_sides))
                }
                (true, true) | (false, _) => String::new(),
            }
            .as_str(),
        value: judged(chosen),
        standing: match (share.is_some_and(|x| x >= good), low, reference) {
            (true, _, _) => Standing::Good,
            (false, true, Reference::Ra) if scrap <= 100.0 - good => Standing::Watch,
            (false, true, _) => Standing::Bad,
            (false, false, _) => Standing::Plain,
        },
        below: [below, twin],
    }
}

/// On which side of its tolerance a cut lies, as shares of its length; empty where it is nowhere outside.
fn sides(of: &Metrics, reference: Reference) -> String {
    let Some(inside) = of.judged_in_tolerance_percent() else { return String::new() };
    let over = of.judged_above_tolerance_percent().unwrap_or(0.0);
    let under = (100.0 - inside - over - of.not_judged_percent.unwrap_or(0.0)).max(0.0);
    if is_none(over) && is_none(under) {
        return String::new();
    }
    let [over, under] = [over, under].map(|share| format::number(share, "%"));
    match reference {
        Reference::Ra => {
            tr!("{over} % too rough, {under} % smoother", over = over, under = under)
        }
        Reference::Force => tr!("{over} % above, {under} % below", over = over, under = under),
    }
}

/// What is said of a cut outside its tolerance in one line: how much of it is too rough, and how much is smoother.
fn side_foremost(of: &Metrics, reference: Reference) -> String {
    let over = of.judged_above_tolerance_percent().unwrap_or(0.0);
    let outside = 100.0 - of.judged_in_tolerance_percent().unwrap_or(100.0);
    let under = (outside - over).max(0.0);
    if !is_none(over) && !is_none(under) {
        let [over, under] = [over, under].map(|share| format::number(share, "%"));
        return match reference {
            Reference::Ra => {
                tr!("{over} % rough, {under} % smoother", over = over, under = under)
            }
            Reference::Force => tr!("{over} % above, {under} % below", over = over, under = under),
        };
    }
    let share = format::number(if is_none(over) { under } else { over }, "%");
    match (reference, is_none(over)) {
        (Reference::Ra, true) => tr!("{share} % smoother, no scrap", share = share),
        (Reference::Force, true) => tr!("{share} % below, no scrap", share = share),
        (Reference::Ra, false) => tr!("{share} % too rough", share = share),
        (Reference::Force, false) => tr!("{share} % above", share = share),
    }
}

/// The share in tolerance of the twin, and what the rest of it is: scrap, or smoother than asked, which is none.
fn share_with_scrap(of: &Metrics, reference: Reference) -> String {
    let over = of.judged_above_tolerance_percent().unwrap_or(0.0);
    let unknown = of.not_judged_percent.unwrap_or(0.0);
    let share = judged(of);
    match (of.judged_in_tolerance_percent(), is_none(over), reference) {
        (None, _, _) => share,
        (Some(inside), true, _) if is_all(inside) || !is_none(unknown) => share,
        (Some(_), true, Reference::Ra) => tr!("{share}, rest smoother", share = share),
        (Some(_), true, Reference::Force) => tr!("{share}, rest below", share = share),
        (Some(_), false, _) => {
            let over = format::number(over, "%");
            tr!("{share}, {over} % scrap", share = share, over = over)
        }
    }
}

/// The name of the model of Ra, as the band of models outside their range has it.
fn ra_model(view: &View<'_>) -> String {
    let names = Names::of(view.session.current());
    let info = FLAGS.iter().find(|info| info.bit == flag::K5_OUTSIDE);
    // Cut out of its English sentence, which begins with it.
    let name = info.map_or(String::new(), |info| in_english(|| names.flag(info)));
    name.split(' ').next().unwrap_or_default().to_owned()
}

fn worst_force(chosen: &Metrics, twin: String) -> Item {
    let size = chosen.force_worst_percent.map(f64::abs);
    let [good, bad] = FORCE_LEVELS;
    let standing = Standing::judged(size.is_some_and(|x| x <= good), size.is_some_and(|x| x > bad));
    Item {
        title: tr("Worst force deviation"),
        help: tr("Largest deviation of the force from the desired force after the first second.")
            .to_owned(),
        value: signed(chosen.force_worst_percent),
        standing,
        below: [tr("from desired force").to_owned(), twin],
    }
}

fn time_of_cut(view: &View<'_>) -> Item {
    let compared = view.session.comparison();
    let Comparison { chosen, twin, time_saved_s, .. } = compared;
    let (stand, name) = (view.session.twin_stand(), view.session.twin_stand().name());
    let title = view.session.twin_title();
    let size_s = format::quantity(time_saved_s.abs(), "s");
    let took = format::time(twin.time_of_cut_s);
    let (below, told) = match (twin_is_known(view), compared.time_judged()) {
        (false, _) => ([format!("{name}: {}", tr(FINDING)), String::new()], format!("{title}.")),
        (true, TimeJudged::AtEqualQuality(percent)) => {
            let bought = match percent {
                even if even.abs() < 0.5 => tr("as long").to_owned(),
                saved if saved > 0.0 => tr!("saves {percent:.0} %", percent = saved),
                lost => tr!("{percent:.0} % longer", percent = -lost),
            };
            let bought = format!("{bought}, {}", equal(chosen, twin));
            let told = match *time_saved_s < 0.0 {
                true => tr!(
                    "{twin}: {took} for the same length of path, {time} lost.",
                    twin = title,
                    took = took,
                    time = size_s
                ),
                false => tr!(
                    "{twin}: {took} for the same length of path, {time} saved.",
                    twin = title,
                    took = took,
                    time = size_s
                ),
            };
            ([bought, format!("{name} {took}")], told)
        }
        (true, TimeJudged::NotCompared(hold)) => {
            // A time is no victory where the surface is scrap.
            let reference = view.session.current().target.reference;
            let why = not_compared(hold, [chosen, twin], reference, name);
            let told =
                tr!("{twin}: {took}, not compared: {why}.", twin = title, took = took, why = why);
            ([why, format!("{name} {took}")], told)
        }
    };
    let none_safe = match stand {
        TwinStand::NoneSafe(why) => {
            format!(" {}", tr!("It is compared with the programmed feed, since {why}.", why = why))
        }
        TwinStand::Programmed | TwinStand::Safe(_) | TwinStand::Finding(_) => String::new(),
    };
    Item {
        title: tr("Time of cut"),
        help: tr!(
            "Time since the start of the cut. {told} Times are compared only where both hold the target: above the \
             tolerance on at most {percent:.0} % of the length. A faster cut that is scrap is no gain; a surface that is \
             smoother than asked is no scrap.{none_safe}",
            told = told,
            percent = 100.0 - HELD_PERCENT,
            none_safe = none_safe
        ),
        value: format::time(chosen.time_of_cut_s),
        standing: Standing::Plain,
        below,
    }
}

/// Why the times of a cut and its twin are not compared: how much of which of them is scrap, or cannot be judged. In
/// the shares that the card of the tolerance has, so that the two never say different things.
fn not_compared(
    hold: [Option<bool>; 2],
    [chosen, twin]: [&Metrics; 2],
    reference: Reference,
    name: &str,
) -> String {
    let over =
        |of: &Metrics| format::number(of.judged_above_tolerance_percent().unwrap_or(0.0), "%");
    let unknown = |of: &Metrics| format::number(of.not_judged_percent.unwrap_or(0.0), "%");
    match (hold, reference) {
        ([Some(true), Some(false)], Reference::Ra) => {
            tr!("{twin}: {over} % scrap", twin = name, over = over(twin))
        }
        ([Some(true), Some(false)], Reference::Force) => {
            tr!("{twin}: {over} % above", twin = name, over = over(twin))
        }
        ([Some(false), Some(true)], Reference::Ra) => {
            tr!("this cut: {over} % scrap", over = over(chosen))
        }
        ([Some(false), Some(true)], Reference::Force) => {
            tr!("this cut: {over} % above", over = over(chosen))
        }
        ([Some(false), Some(false)], Reference::Ra) => {
            tr!("both scrap: {own} and {over} %", own = over(chosen), over = over(twin))
        }
        ([Some(false), Some(false)], Reference::Force) => {
            tr!("both above: {own} and {over} %", own = over(chosen), over = over(twin))
        }
        ([None, _], _) if chosen.not_judged_percent.is_some() => {
            tr!("this cut: {share} % not judged", share = unknown(chosen))
        }
        ([_, None], _) if twin.not_judged_percent.is_some() => {
            tr!("{twin}: {share} % not judged", twin = name, share = unknown(twin))
        }
        ([None, _] | [_, None] | [Some(true), Some(true)], _) => {
            tr("nothing is cut yet").to_owned()
        }
    }
}

/// In what two cuts are equal whose times are compared.
fn equal(chosen: &Metrics, twin: &Metrics) -> String {
    let above = [chosen, twin].map(|of| of.judged_above_tolerance_percent().unwrap_or(0.0));
    let most = above[0].max(above[1]);
    match is_none(most) {
        true => tr("neither is scrap").to_owned(),
        false => tr!("\u{2264} {most} % is scrap", most = format::number(most, "%")),
    }
}

/// Whether a share in percent is all there is, as it is written.
fn is_all(share: f64) -> bool {
    format::number(share, "%") == format::number(100.0, "%")
}

/// Whether it is nothing, as it is written.
fn is_none(share: f64) -> bool {
    format::number(share, "%") == format::number(0.0, "%")
}

/// What stands in the place of a share where nothing could be judged.
const NOT_JUDGED: &str = text!("not judged");

/// The share in tolerance, or that none is judged.
fn judged(of: &Metrics) -> String {
    match of.not_judged_percent {
        Some(unknown) if is_all(unknown) => tr(NOT_JUDGED).to_owned(),
        Some(_) | None => share_of(of.judged_in_tolerance_percent()),
    }
}

/// Before the first contact, and in the air alone, there is no share.
fn share_of(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |x| format::quantity(x, "%"))
}

fn signed(value: Option<f64>) -> String {
    let Some(value) = value else { return "-".to_owned() };
    let text = format::quantity(value, "%");
    if value > 0.0 && !is_none(value) { format!("+{text}") } else { text }
}
