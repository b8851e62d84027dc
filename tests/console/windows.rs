//! The windows over the console, "Within a revolution" and "Workpiece", driven by their accessible
//! names, and their pictures.

use crate::drawn;
use crate::screen::{rest, texts};

use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::session::Session;
use steadycut::blocks::cutting::process::ForceModel;
use steadycut::run::edits::Edits;
use steadycut::run::revolution::revolution;
use steadycut::run::{Start, presets};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);

type Screen<'a> = Harness<'a, Option<Console>>;

/// The console on a preset, paused after some seconds of its cut.
fn at<'a>(preset: &str, size: Vec2, theme: Option<Theme>, time_s: usize) -> Screen<'a> {
    told(preset, (size, theme), time_s, None)
}

/// The same, with a message over it.
fn told<'a>(
    preset: &str,
    (size, theme): (Vec2, Option<Theme>),
    time_s: usize,
    notice: Option<String>,
) -> Screen<'a> {
    let mut scenario = presets::load(preset).unwrap();
    // Not much longer than is looked at: a frame simulates ahead.
    scenario.change(|s| s.run.duration_s = time_s as f64 + 1.0).unwrap();
    let builder = Harness::builder().with_size(size).with_step_dt(0.05);
    let builder = match theme {
        Some(theme) => builder.with_theme(theme).wgpu(),
        None => builder,
    };
    let frame = move |ui: &mut egui::Ui, console: &mut Option<Console>| {
        let (scenario, notice) = (scenario.clone(), notice.clone());
        let start = || Start { scenario, edits: Edits::none(), notice };
        console
            .get_or_insert_with(|| crate::screen::sliced(Console::new(ui.ctx(), start())))
            .ui(ui);
    };
    let mut screen = builder.build_ui_state(frame, None);
    screen.run_steps(2);
    press(&mut screen, Modifiers::NONE, Key::Space);
    while session(&screen).progress() < 1.0 {
        screen.run_steps(1);
    }
    press(&mut screen, Modifiers::NONE, Key::Home);
    for _ in 0..time_s {
        press(&mut screen, Modifiers::SHIFT, Key::ArrowRight);
    }
    screen
}

fn press(screen: &mut Screen, modifiers: Modifiers, key: Key) {
    screen.key_press_modifiers(modifiers, key);
    screen.run_steps(2);
}

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    screen.state().as_ref().unwrap().session()
}

fn click(screen: &mut Screen, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click();
    screen.run_steps(3);
}

/// A click by name alone: what is meant may be scrolled out of sight.
fn open(screen: &mut Screen, name: &str) {
    // A screen may have the name of a group.
    screen.get_all_by_label(name).last().expect("it is there").click_accesskit();
    screen.run_steps(10);
}

/// Opens the folds that hide a button on a phone, and the window of that button.
fn open_window(screen: &mut Screen, size: Vec2, folds: &[&str], name: &str) {
    if size == PHONE {
        open(screen, "Settings");
    }
    for fold in folds {
        open(screen, fold);
    }
    open(screen, name);
    if size == PHONE {
        open(screen, "Settings");
    }
}

const WORKPIECE: [&str; 2] = ["More settings", "Workpiece"];

#[test]
fn the_peak_of_the_control_period_is_found_within_the_revolution() {
    let mut screen = at("experiment-1", DESKTOP, None, 4);
    open_window(&mut screen, DESKTOP, &[], "Within a revolution\u{2026}");
    rest(&mut screen);
    let row = *session(&screen).row();
    let run = session(&screen).chosen().run();
    let found = revolution(run, session(&screen).playback().playhead_s, 1).unwrap();
    let peak_n = found.samples[found.peak.unwrap()].fxy_n();
    assert_eq!(peak_n, row.force_n);
    let shown = texts(&screen);
    assert!(shown.contains(&format!("{peak_n:.1} N at")), "{shown}");
    assert!(shown.contains("1086 samples"), "{shown}");
    click(&mut screen, "2 turns");
    rest(&mut screen);
    assert!(texts(&screen).contains("2171 samples"));
    // A step of the playhead goes on at once while the cut stands still.
    press(&mut screen, Modifiers::COMMAND, Key::ArrowRight);
    rest(&mut screen);
    let force_n = session(&screen).row().force_n;
    assert!(texts(&screen).contains(&format!("{force_n:.1} N at")));
    press(&mut screen, Modifiers::NONE, Key::Escape);
    assert!(!texts(&screen).contains("2171 samples"));
    assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
}

#[test]
fn a_drag_zooms_into_the_revolution_and_a_double_click_fits_again() {
    let mut screen = at("experiment-1", DESKTOP, None, 4);
    open_window(&mut screen, DESKTOP, &[], "Within a revolution\u{2026}");
    rest(&mut screen);
    click(&mut screen, "Time");
    let whole = "Forces from 0.00 ms to 37.67 ms";
    let rect = screen.get_by_label(whole).rect();
    let at = |x: f32| rect.lerp_inside(vec2(x, 0.5));
    screen.hover_at(at(0.3));
    screen.run_steps(2);
    screen.drag_at(at(0.4));
    screen.run_steps(1);
    for x in [0.5, 0.6] {
        screen.hover_at(at(x));
        screen.run_steps(1);
    }
    screen.drop_at(at(0.6));
    screen.run_steps(2);
    assert!(screen.query_by_label(whole).is_none(), "{}", texts(&screen));
    for _ in 0..2 {
        screen.drag_at(at(0.5));
        screen.drop_at(at(0.5));
    }
    screen.run_steps(3);
    assert!(screen.query_by_label(whole).is_some(), "{}", texts(&screen));
}

#[test]
fn where_there_are_no_teeth_one_click_brings_them() {
    let mut screen = at("first-cut", DESKTOP, None, 1);
    open_window(&mut screen, DESKTOP, &[], "Within a revolution\u{2026}");
    click(&mut screen, "Simulate tooth by tooth");
    let scenario = session(&screen).scenario();
    assert_eq!(scenario.plant.force_model, ForceModel::Mechanistic);
    assert_eq!(scenario.info.name, "first-cut");
    rest(&mut screen);
    assert!(texts(&screen).contains("Peak of the last control period"));
    click(&mut screen, "Undo");
    assert_eq!(session(&screen).scenario().plant.force_model, ForceModel::Formula);
}

#[test]
fn cuts_are_edited_in_tables_and_every_change_can_be_undone() {
    for size in [DESKTOP, PHONE] {
        let mut screen = at("experiment-1", size, None, 0);
        open_window(&mut screen, size, &WORKPIECE, "Edit depths\u{2026}");
        let cuts = |screen: &Screen| session(screen).scenario().workpiece.cuts.clone();
        let before = cuts(&screen);
        assert_eq!(before[0].len(), 3);
        // 2.4 mm deep at a wall of 1.2915 mm: R_D = sqrt(2.4 x 13.6) - 1.2915.
        assert!(texts(&screen).contains("4.42"), "{}", texts(&screen));
        open(&mut screen, "Duplicate section 2");
        assert_eq!(cuts(&screen)[0][2], before[0][1]);
        open(&mut screen, "Remove section 1");
        assert_eq!(cuts(&screen)[0].len(), 3);
        open(&mut screen, "Add a section");
        open(&mut screen, "Add a cut");
        open(&mut screen, "Duplicate cut 2");
        assert_eq!(cuts(&screen).len(), 3);
        open(&mut screen, "Remove cut 3");
        open(&mut screen, "Cut 1, tool");
        for (name, value) in [("Length", 55.5), ("Axial depth", 1.5), ("Wall", -1.0)] {
            let name = format!("{name} of section 1");
            screen.get_by_label(&name).set_value_accesskit(value);
            screen.run_steps(3);
        }
        assert_eq!(cuts(&screen)[0][0], [55.5, 1.5, -1.0]);
        open(&mut screen, "Experiment 2");
        assert_eq!(cuts(&screen), presets::load("experiment-2").unwrap().workpiece.cuts);
        assert_eq!(session(&screen).scenario().info.name, "experiment-1");
        for _ in 0..20 {
            press(&mut screen, Modifiers::COMMAND, Key::Z);
        }
        assert_eq!(cuts(&screen), before);
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

/// A place in the picture from the side: along the cut and below the surface, mm. `open` as the picture's.
fn in_side_view(screen: &Screen, open: bool, x_mm: f64, depth_mm: f64) -> egui::Pos2 {
    let figures = screen.query_all_by(|node| {
        node.label().is_some_and(|label| label.starts_with("Cut from the side"))
    });
    let rect = figures.map(|node| node.rect()).next().expect("the picture");
    let workpiece = &session(screen).current().workpiece;
    let length_mm = match workpiece.cuts.first() {
        Some(sections) => sections.iter().map(|section| section[0]).sum(),
        None => workpiece.length_mm,
    };
    let begin_mm = if open { 9.0 } else { 16.5 };
    let scale = f64::from(rect.width()) / (begin_mm + length_mm + 9.0);
    let across = (begin_mm + x_mm) * scale;
    egui::pos2(rect.left() + across as f32, rect.top() + ((6.5 + depth_mm) * scale.max(4.0)) as f32)
}

/// With the mouse, which shows itself by moving before it presses.
fn drag(screen: &mut Screen, from: egui::Pos2, to: egui::Pos2) {
    screen.hover_at(from);
    screen.run_steps(2);
    screen.drag_at(from);
    screen.run_steps(2);
    for share in [0.25, 0.5, 1.0] {
        screen.hover_at(from + share * (to - from));
        screen.run_steps(2);
    }
    screen.drop_at(to);
    screen.run_steps(3);
}

#[test]
fn depths_and_ends_are_dragged_in_the_picture() {
    let mut screen = at("first-cut", DESKTOP, None, 0);
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    let workpiece = |screen: &Screen| session(screen).current().workpiece.clone();
    let before = workpiece(&screen);
    let [first_mm, depth_mm] = before.depth_steps[0];
    // The floor of the first stretch, deeper.
    let at = |screen: &Screen, x_mm, depth_mm| in_side_view(screen, true, x_mm, depth_mm);
    let (from, to) =
        (at(&screen, 0.5 * first_mm, before.axial_depth_mm), at(&screen, 0.5 * first_mm, 6.0));
    drag(&mut screen, from, to);
    // A picture as small as this one takes 20 points to a millimetre, so that each step can be met.
    let expected = before.axial_depth_mm + f64::from(to.y - from.y) / 20.0;
    let dragged = workpiece(&screen);
    assert!((dragged.axial_depth_mm - expected).abs() < 0.051, "{expected}: {dragged:?}");
    assert_eq!(workpiece(&screen).depth_steps, before.depth_steps);
    // The step between the first two, 10 mm on.
    let (from, to) = (at(&screen, first_mm, 1.0), at(&screen, first_mm + 10.0, 1.0));
    drag(&mut screen, from, to);
    let [now_mm, still_mm] = workpiece(&screen).depth_steps[0];
    assert!(
        (now_mm - first_mm - 10.0).abs() < 0.51 && still_mm == depth_mm,
        "{now_mm}, {still_mm}"
    );
    // Each drag is one step of undo; a drag over nothing changes nothing.
    let (from, to) = (at(&screen, 10.0, -5.0), at(&screen, 60.0, -2.0));
    drag(&mut screen, from, to);
    press(&mut screen, Modifiers::COMMAND, Key::Z);
    press(&mut screen, Modifiers::COMMAND, Key::Z);
    assert_eq!(workpiece(&screen), before);
}

#[test]
fn a_cut_is_dragged_within_what_its_table_allows() {
    let mut screen = at("experiment-1", DESKTOP, None, 0);
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    let cut = |screen: &Screen| session(screen).current().workpiece.cuts[0].clone();
    let before = cut(&screen);
    let [length_mm, depth_mm, wall_mm] = before[0];
    let from = in_side_view(&screen, false, 0.5 * length_mm, depth_mm);
    let far = from - vec2(0.0, 300.0);
    drag(&mut screen, from, far);
    assert_eq!(cut(&screen)[0], [length_mm, 0.0, wall_mm], "no depth above the surface");
    let from = in_side_view(&screen, false, length_mm, 0.5);
    drag(&mut screen, from, from + vec2(25.0, 0.0));
    assert!(cut(&screen)[0][0] > length_mm && cut(&screen)[1..] == before[1..]);
}

#[test]
fn feeds_per_cut_are_numbers_each_with_its_cut() {
    let mut screen = at("experiment-2-per-cut", DESKTOP, None, 0);
    for fold in ["More settings", "NC program"] {
        open(&mut screen, fold);
    }
    let feeds = |screen: &Screen| session(screen).scenario().program.cut_feeds_mm_min.clone();
    let before = feeds(&screen);
    assert_eq!(before.len(), 5);
    let brackets = format!("[{}", before[0]);
    assert!(!texts(&screen).contains(&brackets), "{}", texts(&screen));
    screen.get_by_label("cut 2: Feeds per cut").set_value_accesskit(512.5);
    screen.run_steps(3);
    assert_eq!(feeds(&screen)[1], 512.5);
    open(&mut screen, "Remove Feeds per cut of cut 1");
    open(&mut screen, "Add one for cut 5");
    assert_eq!(feeds(&screen), [512.5, before[2], before[3], before[4], before[4]]);
}

#[test]
fn a_number_that_cannot_be_is_answered_in_the_window() {
    let mut screen = at("experiment-1", DESKTOP, None, 1);
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    screen.get_by_label("Axial depth of section 1").click();
    screen.run_steps(3);
    press(&mut screen, Modifiers::COMMAND, Key::A);
    screen.get_by_label("Axial depth of section 1").type_text("99");
    screen.run_steps(2);
    press(&mut screen, Modifiers::NONE, Key::Enter);
    let shown = texts(&screen);
    assert!(shown.contains("Axial depth of section 1: “99” was limited to 8 mm"), "{shown}");
    assert_eq!(session(&screen).scenario().workpiece.cuts[0][0][1], 8.0);
    assert!(session(&screen).notices().is_empty(), "it is said in place");
}

#[test]
fn the_one_path_has_its_profile_as_a_table_and_becomes_cuts() {
    let mut screen = at("depth-step", DESKTOP, None, 0);
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    let workpiece = |screen: &Screen| session(screen).current().workpiece.clone();
    let before = workpiece(&screen);
    assert!(!before.depth_steps.is_empty() && before.cuts.is_empty());
    open(&mut screen, "Add a stretch");
    assert_eq!(workpiece(&screen).depth_steps.len(), before.depth_steps.len() + 1);
    screen.get_by_label("Axial depth of stretch 1").set_value_accesskit(1.25);
    screen.run_steps(3);
    assert_eq!(workpiece(&screen).axial_depth_mm, 1.25);
    open(&mut screen, "Remove stretch 2");
    open(&mut screen, "Make cuts of the path");
    let cuts = workpiece(&screen).cuts;
    let length_mm: f64 = cuts[0].iter().map(|section| section[0]).sum();
    assert!((length_mm - before.length_mm).abs() < 1e-9, "{length_mm} mm");
    open(&mut screen, "One path");
    assert!(workpiece(&screen).cuts.is_empty());
}

/// The numbers of a column have as many digits behind the point, with three where one of them needs it.
#[test]
fn numbers_of_a_column_have_the_same_digits() {
    let mut screen = at("depth-step", DESKTOP, None, 0);
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    let shown = |screen: &Screen, name: &str| {
        let node = screen.get_by_label(name);
        node.accesskit_node().value().unwrap_or_default()
    };
    let digits = |text: &str| text.split_once('.').map_or(0, |(_, behind)| behind.len());
    let columns = ["Axial depth of stretch 1", "Axial depth of stretch 2", "Start of stretch 2"];
    for name in columns {
        assert_eq!(digits(&shown(&screen, name)), 2, "{name}: {}", shown(&screen, name));
    }
    screen.get_by_label(columns[0]).set_value_accesskit(1.125);
    screen.run_steps(3);
    for (name, expected) in columns.into_iter().zip([3, 3, 2]) {
        assert_eq!(digits(&shown(&screen, name)), expected, "{name}: {}", shown(&screen, name));
    }
    assert!(!texts(&screen).contains('`'), "{}", texts(&screen));
}

/// Escape closes the window that is worked in; a message beside it stays until the next one.
#[test]
fn escape_closes_the_window_before_a_message() {
    // Long enough to be read for the whole test.
    let notice = "A message. ".repeat(200);
    let mut screen = told("depth-step", (DESKTOP, None), 0, Some(notice));
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    let message = |screen: &Screen| screen.query_by_label("Dismiss").is_some();
    assert!(message(&screen), "{}", texts(&screen));
    press(&mut screen, Modifiers::NONE, Key::Escape);
    assert!(screen.query_by_label("Add a stretch").is_none(), "the window is closed");
    assert!(message(&screen), "{}", texts(&screen));
    press(&mut screen, Modifiers::NONE, Key::Escape);
    assert!(!message(&screen), "{}", texts(&screen));
}

#[test]
fn the_windows_fit_odd_screens() {
    for size in [[320.0, 420.0], [844.0, 390.0], [900.0, 600.0], [3840.0, 2160.0]] {
        let mut screen = at("depth-step", DESKTOP, None, 0);
        open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
        open(&mut screen, "Within a revolution\u{2026}");
        screen.set_size(size.into());
        screen.run_steps(5);
        for name in ["Add a stretch", "Simulate tooth by tooth"] {
            assert!(screen.query_by_label(name).is_some(), "{name} in {size:?}");
        }
    }
}

/// Pictures of both windows. `UPDATE_SNAPSHOTS=1` renews them.
#[test]
fn the_windows_look_as_their_pictures() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    let mut picture = |screen: &mut Screen, name: String| {
        screen.run_steps(20);
        rest(screen);
        let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
        results.add(screen.try_snapshot_options(name, &options));
    };
    for (size_name, size) in [("desktop", DESKTOP), ("phone", PHONE)] {
        for (theme_name, theme) in [("light", Theme::Light), ("dark", Theme::Dark)] {
            let look = format!("{size_name}-{theme_name}");
            let mut screen = at("experiment-2", size, Some(theme), 6);
            open_window(&mut screen, size, &[], "Within a revolution\u{2026}");
            picture(&mut screen, format!("revolution-{look}"));
            let mut screen = at("experiment-2", size, Some(theme), 6);
            open_window(&mut screen, size, &WORKPIECE, "Edit depths\u{2026}");
            picture(&mut screen, format!("cuts-{look}"));
        }
    }
    let mut screen = at("depth-step", DESKTOP, Some(Theme::Light), 6);
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    picture(&mut screen, "cuts-path-desktop-light".to_owned());
    let mut screen = at("first-cut", PHONE, Some(Theme::Light), 2);
    open_window(&mut screen, PHONE, &[], "Within a revolution\u{2026}");
    picture(&mut screen, "revolution-none-phone-light".to_owned());
}

/// When does the step that I enter act? It says so where it is entered.
#[test]
fn depths_entered_behind_the_tool_say_from_where_they_act() {
    for size in [DESKTOP, PHONE] {
        let mut screen = at("first-cut", size, None, 4);
        open_window(&mut screen, size, &WORKPIECE, "Edit depths\u{2026}");
        let at_mm = session(&screen).row().position_mm;
        let shown = texts(&screen);
        assert!(at_mm > 1.0 && shown.contains(&format!("The tool is at {at_mm:.2} mm")), "{shown}");
        assert!(shown.contains("act from there and from now on"), "{shown}");
    }
}

/// What if I change the depth of what is cut already? It cannot be: the change would act where the tool is now.
#[test]
fn the_depth_of_what_is_cut_stays() {
    let mut screen = at("first-cut", DESKTOP, None, 12);
    open_window(&mut screen, DESKTOP, &WORKPIECE, "Edit depths\u{2026}");
    let workpiece = |screen: &Screen| session(screen).current().workpiece.clone();
    let before = workpiece(&screen);
    let [first_mm, _] = before.depth_steps[0];
    assert!(session(&screen).row().position_mm > first_mm, "the tool is in the second stretch");
    let is_disabled =
        |screen: &Screen, name: &str| screen.get_by_label(name).accesskit_node().is_disabled();
    assert!(is_disabled(&screen, "Axial depth of stretch 1"));
    assert!(!is_disabled(&screen, "Axial depth of stretch 2"));
    let from = in_side_view(&screen, true, 0.5 * first_mm, before.axial_depth_mm);
    drag(&mut screen, from, from + vec2(0.0, 30.0));
    assert_eq!(workpiece(&screen), before);
    let said = session(&screen).notices().last().expect("a message").text.clone();
    assert!(said.contains("Stretch 1: it is cut"), "{said}");
    screen.get_by_label("Axial depth of stretch 2").set_value_accesskit(2.5);
    screen.run_steps(3);
    assert_eq!(workpiece(&screen).depth_steps[0], [first_mm, 2.5]);
}
