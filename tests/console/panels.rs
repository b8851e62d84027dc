//! The console, driven through its accessible names, and pictures of every screen.

use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::Queryable as _;
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::Command;
use steadycut::app::panels::{Panel, View, panels};
use steadycut::app::session::TwinStand;
use steadycut::app::shortcuts::{Host, screen_key};
use steadycut::run::edits::Edits;
use steadycut::run::one_run::Run;
use steadycut::run::{Start, presets};

use crate::drawn;
#[path = "panels/hands.rs"]
mod hands;

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);

type Window<'a> = Harness<'a, Option<Console>>;

fn frame(ui: &mut egui::Ui, console: &mut Option<Console>) {
    let start = || Start {
        scenario: presets::load("first-cut").unwrap(),
        edits: Edits::none(),
        notice: None,
    };
    console.get_or_insert_with(|| crate::screen::sliced(Console::new(ui.ctx(), start()))).ui(ui);
}

fn builder(size: Vec2) -> egui_kittest::HarnessBuilder<Option<Console>> {
    Harness::builder().with_size(size).with_step_dt(0.05)
}

/// A window with the console, some frames old.
fn window<'a>(size: Vec2) -> Window<'a> {
    let mut window = builder(size).build_ui_state(frame, None);
    window.run_steps(3);
    window
}

fn console<'a>(window: &'a Window<'_>) -> &'a Console {
    window.state().as_ref().unwrap()
}

fn playhead_s(window: &Window) -> f64 {
    console(window).session().playback().playhead_s
}

fn playing(window: &Window) -> bool {
    console(window).session().playback().playing
}

fn ra_um(window: &Window) -> f64 {
    console(window).session().row().ra_um
}

fn target_um(window: &Window) -> f64 {
    console(window).session().current().target.ra_um
}

fn press(window: &mut Window, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    window.run_steps(2);
}

fn shown(window: &Window) -> String {
    let state: serde_json::Value = serde_json::from_str(&console(window).state_json()).unwrap();
    state["screen"].as_str().unwrap().to_owned()
}

/// Shows the screen at a place in the order of the tabs, by its key, or by its tab where it has none.
fn show(window: &mut Window, place: usize, title: &str) {
    match screen_key(place, Host::Window) {
        Some(keys) => press(window, keys.modifiers, keys.logical_key),
        None => crate::screen::show(window, title),
    }
}

fn click(window: &mut Window, name: &str) {
    window.get_by_label(name).click();
    window.run_steps(2);
}

/// Drags the slider of the target roughness to a share of its length.
fn drag_target(window: &mut Window, fraction: f32) {
    let rect = window.get_by_role_and_label(Role::Slider, "Target Ra").rect();
    let at = |fraction: f32| egui::pos2(egui::lerp(rect.x_range(), fraction), rect.center().y);
    window.drag_at(at(0.5));
    window.run_steps(1);
    for step in 1..=4 {
        window.hover_at(at(0.5 + (fraction - 0.5) * step as f32 / 4.0));
        window.run_steps(1);
    }
    window.drop_at(at(fraction));
    window.run_steps(1);
}

#[test]
fn it_opens_cutting_and_the_produced_ra_follows_the_target() {
    let mut window = window(DESKTOP);
    assert!(playing(&window));
    window.run_steps(100);
    let (before_s, ra_before, target_before) =
        (playhead_s(&window), ra_um(&window), target_um(&window));
    assert!(before_s > 4.0, "{before_s}");
    assert!((ra_before - target_before).abs() < 0.1 * target_before, "{ra_before}");

    drag_target(&mut window, 0.66);
    let target = target_um(&window);
    assert!(target > 1.1 * target_before, "{target}");
    assert!(!console(&window).session().edits().list().is_empty());
    // Before the part gets deeper, after 46 mm.
    window.run_steps(50);
    assert!(console(&window).session().row().position_mm < 46.0);
    let ra = ra_um(&window);
    assert!((ra - target).abs() < 0.1 * target, "target {target}, produced {ra}");
    // What was done live replays to the same bits.
    let session = console(&window).session();
    let replayed = Run::complete(session.scenario(), session.edits());
    assert_eq!(session.chosen().run().recording().digest(), replayed.recording().digest());
    let state: serde_json::Value = serde_json::from_str(&console(&window).state_json()).unwrap();
    assert_eq!(state["ra_um"], ra);
    assert_eq!(state["screen"], "console");
    assert_eq!(state["error"], serde_json::Value::Null);
    assert_eq!(state["rects"]["target_ra_slider"].as_array().unwrap().len(), 4);
}

#[test]
fn a_drag_is_one_step_of_undo_and_undo_never_moves_the_playhead() {
    let mut window = window(DESKTOP);
    window.run_steps(60);
    click(&mut window, "Pause");
    let (target, at_s) = (target_um(&window), playhead_s(&window));
    drag_target(&mut window, 0.66);
    let dragged = target_um(&window);
    assert_ne!(target, dragged);
    click(&mut window, "Undo");
    assert_eq!((target_um(&window), playhead_s(&window)), (target, at_s));
    assert!(console(&window).session().edits().list().is_empty());
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!((target_um(&window), playhead_s(&window)), (dragged, at_s));
    press(&mut window, Modifiers::COMMAND, Key::Z);
    press(&mut window, Modifiers::COMMAND, Key::Y);
    assert_eq!(target_um(&window), dragged);
}

/// A new future and the old one have names of their own in the legend, and a plot does not move when they come.
#[test]
fn what_is_to_come_and_what_would_have_come_are_in_the_legend() {
    let mut window = window(DESKTOP);
    window.run_steps(60);
    click(&mut window, "Pause");
    let shown = |window: &Window, name: &str| {
        window.query_all_by_role_and_label(Role::CheckBox, name).count()
    };
    let roughness = |window: &Window| {
        let charts = window.query_all_by(|node| {
            node.label().is_some_and(|label| label.starts_with("Roughness from"))
        });
        charts.map(|node| node.rect()).next().expect("the chart of Ra")
    };
    assert_eq!(["before", "from now on"].map(|name| shown(&window, name)), [0, 0]);
    let place = roughness(&window);
    drag_target(&mut window, 0.66);
    assert_eq!(["before", "from now on"].map(|name| shown(&window, name)), [1, 1]);
    assert_eq!(roughness(&window), place);
    click(&mut window, "Play");
    window.run_steps(5);
    assert_eq!(["before", "from now on"].map(|name| shown(&window, name)), [1, 0]);
}

#[test]
fn pause_scrub_and_keys_move_the_playhead() {
    let mut window = window(DESKTOP);
    press(&mut window, Modifiers::NONE, Key::Space);
    assert!(!playing(&window));
    let at_s = playhead_s(&window);
    window.run_steps(10);
    assert_eq!(playhead_s(&window), at_s);

    window.get_by_role_and_label(Role::Slider, "Playhead").set_value_accesskit(12.0);
    window.run_steps(2);
    assert!((playhead_s(&window) - 12.0).abs() < 0.05, "{}", playhead_s(&window));
    press(&mut window, Modifiers::SHIFT, Key::ArrowRight);
    assert!((playhead_s(&window) - 13.0).abs() < 0.05, "{}", playhead_s(&window));
    let before_s = playhead_s(&window);
    press(&mut window, Modifiers::COMMAND, Key::ArrowRight);
    let step_s = playhead_s(&window) - before_s;
    assert!(step_s > 0.0 && step_s <= 0.02 + 1e-9, "{step_s}");
    press(&mut window, Modifiers::NONE, Key::Home);
    assert_eq!(playhead_s(&window), 0.0);
    press(&mut window, Modifiers::NONE, Key::End);
    assert!(console(&window).session().finished().is_some());
    click(&mut window, "Play again");
    assert!(playing(&window) && playhead_s(&window) < 1.0);
}

#[test]
fn a_change_after_the_end_changes_the_whole_cut() {
    let mut window = window(DESKTOP);
    press(&mut window, Modifiers::NONE, Key::End);
    drag_target(&mut window, 0.66);
    let session = console(&window).session();
    assert!(session.edits().list().is_empty());
    assert_eq!(session.scenario().target.ra_um, target_um(&window));
    assert!(session.finished().is_some());
    let whole = Run::complete(session.scenario(), &Edits::none());
    assert_eq!(session.row(), whole.recording().rows().last().unwrap());
}

#[test]
fn a_change_in_the_past_branches_and_leaves_the_old_future_as_a_ghost() {
    let mut window = window(DESKTOP);
    press(&mut window, Modifiers::NONE, Key::End);
    window.get_by_role_and_label(Role::Slider, "Playhead").set_value_accesskit(10.0);
    window.run_steps(2);
    click(&mut window, "N7: Ra 1.6 µm");
    let session = console(&window).session();
    let [edit] = session.edits().list() else { panic!("one edit") };
    assert!((edit.at_s - 10.0).abs() < 0.05, "{}", edit.at_s);
    assert_eq!(session.ghost().unwrap().from_s, edit.at_s);
    let rows = session.chosen().run().recording().rows();
    let at = |time_s: f64| rows[session.chosen().run().recording().index_at(time_s)];
    assert_eq!(at(9.0).ra_target_um, 0.81);
    assert_eq!(at(11.0).ra_target_um, 1.6);
    let found = crate::screen::in_time(|| {
        window.run_steps(1);
        console(&window).session().progress() >= 1.0
    });
    assert!(found);
    // The twin shares the target but never moves its feed.
    let session = console(&window).session();
    let TwinStand::Safe(safe) = session.twin_stand() else { panic!("{:?}", session.twin_stand()) };
    let twin = session.twin().run().recording();
    let at_s = session.twin().run().edits().list()[0].at_s;
    assert_eq!(twin.rows()[twin.index_at(at_s + 1.0)].ra_target_um, 1.6);
    assert_eq!(twin.rows()[twin.index_at(20.0)].feed_command_mm_min, safe.feed_mm_min);
}

#[test]
fn a_drag_on_a_plot_zooms_all_of_them_and_a_double_click_fits_again() {
    let mut window = window(DESKTOP);
    press(&mut window, Modifiers::NONE, Key::Space);
    let rect = window.get_by_label("Roughness from 0.00 s to 20.00 s").rect();
    let at = |x: f32, y: f32| rect.lerp_inside(vec2(x, y));
    window.hover_at(at(0.2, 0.2));
    window.run_steps(2);
    window.drag_at(at(0.25, 0.2));
    window.run_steps(1);
    for x in [0.4, 0.6, 0.75] {
        window.hover_at(at(x, 0.8));
        window.run_steps(1);
    }
    window.drop_at(at(0.75, 0.8));
    window.run_steps(2);
    assert!(window.query_by_label("Roughness from 0.00 s to 20.00 s").is_none());
    assert!(window.query_by_label("Force from 5.00 s to 15.00 s").is_some());
    // What was zoomed to does not follow, and the tick says so.
    assert!(!console(&window).session().playback().follow);
    for _ in 0..2 {
        window.drag_at(at(0.5, 0.5));
        window.drop_at(at(0.5, 0.5));
    }
    window.run_steps(3);
    assert!(window.query_by_label("Force from 0.00 s to 20.00 s").is_some());
    assert!(console(&window).session().playback().follow, "as before");
}

#[test]
fn every_screen_opens_by_its_tab_and_by_its_key() {
    let mut window = window(DESKTOP);
    let screens: Vec<(&str, &str)> = panels().iter().map(|p| (p.id(), p.title())).collect();
    for (id, title) in &screens {
        window.get_by_role_and_label(Role::Button, title).click();
        window.run_steps(2);
        assert_eq!(shown(&window), *id);
    }
    for (place, (id, title)) in screens.iter().enumerate() {
        show(&mut window, place, title);
        assert_eq!(shown(&window), *id);
    }
    let state: serde_json::Value = serde_json::from_str(&console(&window).state_json()).unwrap();
    let listed = state["screens"].as_array().unwrap();
    let ids: Vec<&str> = listed.iter().map(|screen| screen["id"].as_str().unwrap()).collect();
    assert_eq!(ids, screens.iter().map(|(id, _)| *id).collect::<Vec<&str>>());
    assert_eq!((&listed[0]["title"], &listed[0]["key"]), (&"Console".into(), &"1".into()));
}

/// A screen beside those of the program.
struct Dummy(&'static str);

impl Panel for Dummy {
    fn id(&self) -> &'static str {
        self.0
    }
    fn title(&self) -> &'static str {
        self.0
    }

    fn words(&self) -> &'static str {
        "dummy"
    }
    fn ui(&mut self, ui: &mut egui::Ui, _: &View<'_>, _: &mut Vec<Command>) {
        ui.label(format!("This is {}", self.0));
    }
}

/// Nine screens have a key. Those after them are shown by their tabs or from the list of narrow
/// windows, and the sheet of keys says so.
#[test]
fn a_tenth_and_an_eleventh_screen_are_shown_and_have_no_key() {
    for size in [DESKTOP, PHONE] {
        let with_more = |ui: &mut egui::Ui, console: &mut Option<Console>| {
            let start = || Start {
                scenario: presets::load("first-cut").unwrap(),
                edits: Edits::none(),
                notice: None,
            };
            let screens = || {
                let mut screens = panels();
                let names = ["tenth", "eleventh"];
                screens.extend(names.map(|name| Box::new(Dummy(name)) as Box<dyn Panel>));
                screens
            };
            let new = || Console::with_screens(ui.ctx(), start(), screens());
            console.get_or_insert_with(new).ui(ui);
        };
        let mut window = builder(size).build_ui_state(with_more, None);
        window.run_steps(3);
        let count = panels().len() + 2;
        assert_eq!(count, 11, "the dummies are named after the places that they have");
        press(&mut window, Modifiers::COMMAND, Key::Num9);
        assert_eq!(shown(&window), panels()[8].id());
        for name in ["tenth", "eleventh"] {
            crate::screen::show(&mut window, name);
            assert_eq!(shown(&window), name);
            assert!(window.query_by_label(&format!("This is {name}")).is_some());
        }
        let state: serde_json::Value =
            serde_json::from_str(&console(&window).state_json()).unwrap();
        let listed = state["screens"].as_array().unwrap();
        assert_eq!(listed.len(), count);
        let keys = listed.iter().filter(|screen| !screen["key"].is_null()).count();
        assert_eq!(keys, 9);
        press(&mut window, Modifiers::NONE, Key::Questionmark);
        window.run_steps(10);
        let text = "The first screens; the others by their tabs";
        assert!(window.query_by_label(text).is_some());
    }
}

#[test]
fn settings_presets_and_the_sheet_of_keys_are_at_hand() {
    let mut window = window(DESKTOP);
    window.get_by_role_and_label(Role::Slider, "Wear factor").set_value_accesskit(1.5);
    window.run_steps(2);
    assert_eq!(console(&window).session().current().plant.wear_factor, 1.5);
    click(&mut window, "More settings");
    window.run_steps(10);
    // The tab of a screen, and the group of settings.
    assert_eq!(window.query_all_by_label("Workpiece").count(), 2);
    press(&mut window, Modifiers::NONE, Key::Questionmark);
    assert!(window.query_by_label("Export all signals as CSV").is_some());
}

#[test]
fn a_text_that_is_being_written_keeps_its_keys() {
    let mut window = window(DESKTOP);
    for name in ["More settings", "Name"] {
        // By its name alone: it may be scrolled out of sight.
        window.get_by_label(name).click_accesskit();
        window.run_steps(10);
    }
    let field = |window: &Window, doing: &dyn Fn(&egui_kittest::Node<'_>)| {
        doing(&window.get_by_role_and_label(Role::TextInput, "Name"));
    };
    field(&window, &|field| field.scroll_to_me());
    window.run_steps(10);
    field(&window, &|field| field.click());
    window.run_steps(2);
    let before_s = playhead_s(&window);
    press(&mut window, Modifiers::NONE, Key::Home);
    field(&window, &|field| field.type_text("my "));
    press(&mut window, Modifiers::NONE, Key::Space);
    assert!(playing(&window) && playhead_s(&window) > before_s);
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(console(&window).session().scenario().info.name, "my first-cut");
    click(&mut window, "Undo");
    assert_eq!(console(&window).session().scenario().info.name, "first-cut");
}

#[test]
fn every_widget_has_a_name() {
    for size in [DESKTOP, PHONE] {
        let mut window = window(size);
        for (place, panel) in panels().iter().enumerate() {
            show(&mut window, place, panel.title());
            assert_eq!(window.unnamed_widgets(), Vec::<String>::new());
        }
    }
    // With every group of settings open, in a window that shows them all.
    let mut window = window(vec2(1280.0, 2400.0));
    click(&mut window, "More settings");
    window.run_steps(10);
    for group in [
        "Target",
        "Plant",
        "Feed drive",
        "CNC and dead time",
        "Workpiece",
        "Run",
        "Off-line plan",
        "Name",
    ] {
        // A screen may have the name of a group.
        window.get_all_by_label(group).last().expect("a group").click_accesskit();
        window.run_steps(10);
    }
    assert!(window.query_by_label("Depth of depth step 2").is_some());
    assert_eq!(window.unnamed_widgets(), Vec::<String>::new());
}

/// A file as a window system drops it.
#[derive(Debug)]
struct Dropped(&'static str, &'static [u8]);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        std::path::Path::new(self.0)
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.1.to_vec())
    }
}

/// Drops a file and waits until it is read.
fn drop_file(window: &mut Window, file: Dropped, done: impl Fn(&Window) -> bool) {
    window.input_mut().dropped_files.push(std::sync::Arc::new(file));
    let read = crate::screen::in_time(|| {
        window.run_steps(1);
        std::thread::sleep(std::time::Duration::from_millis(5));
        done(window)
    });
    assert!(read, "the dropped file was not read");
}

#[test]
fn a_bad_file_becomes_a_notice_and_loses_nothing_a_good_one_loads() {
    let mut window = window(DESKTOP);
    window.run_steps(20);
    let rows = console(&window).session().chosen().run().recording().rows().len();
    let has_notice = |window: &Window| console(window).messages().next().is_some();
    drop_file(&mut window, Dropped("/x/bad.toml", b"version = 1\ntarget.ra_um = 99"), has_notice);
    let text = console(&window).session().notices()[0].text.clone();
    for part in ["bad.toml", "target.ra_um", "99", "from 0.05 to 4"] {
        assert!(text.contains(part), "{text}");
    }
    window.run_steps(1);
    assert_eq!(console(&window).session().chosen().run().recording().rows().len(), rows);
    click(&mut window, "Dismiss");
    assert!(!has_notice(&window));

    let good = Dropped("/x/good.toml", b"version = 1\nname = \"dropped\"\n");
    drop_file(&mut window, good, |w| console(w).session().scenario().info.name == "dropped");
}

#[test]
fn a_binary_file_is_refused_in_words() {
    let mut window = window(PHONE);
    let file = Dropped("/x/picture.png", &[0x89, b'P', b'N', b'G', 0xff]);
    drop_file(&mut window, file, |w| !console(w).session().notices().is_empty());
    assert!(console(&window).session().notices()[0].text.contains("picture.png"));
}

/// Odd sizes and a scenario whose name and description are as long as they may be.
#[test]
fn no_size_and_no_name_breaks_the_layout() {
    let sizes = [
        [320.0, 420.0],
        [390.0, 844.0],
        [640.0, 480.0],
        [700.0, 500.0],
        [760.0, 460.0],
        [844.0, 390.0],
        [899.0, 600.0],
        [900.0, 600.0],
        [1000.0, 700.0],
        [3840.0, 2160.0],
    ];
    for size in sizes.map(Vec2::from) {
        let mut window = window(size);
        let name = "W".repeat(80);
        let text =
            format!("version = 1\nname = \"{name}\"\ndescription = \"{}\"", "long ".repeat(119));
        let file = Dropped("/x/long.toml", text.leak().as_bytes());
        drop_file(&mut window, file, |w| console(w).session().scenario().info.name == name);
        window.run_steps(3);
        let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, size).expand(1.0);
        for name in ["Target Ra", "Playhead"] {
            let rect = window.get_by_role_and_label(Role::Slider, name).rect();
            assert!(screen.contains_rect(rect), "{name} at {rect} in {size}");
        }
        // The bar: no tab lies below the buttons.
        let list = window.query_by_role_and_label(Role::ComboBox, "Screen");
        let last = list.unwrap_or_else(|| window.get_by_label("Identify")).rect();
        for name in ["Menu", "Undo"] {
            if let Some(button) = window.query_by_label(name) {
                assert!(last.right() < button.rect().left(), "{name} in {size}");
            }
        }
    }
}

/// Pictures of every registered screen. `UPDATE_SNAPSHOTS=1` renews them.
#[test]
fn every_screen_looks_as_its_picture() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size_name, size) in [("desktop", DESKTOP), ("phone", PHONE)] {
        for (theme_name, theme) in [("light", Theme::Light), ("dark", Theme::Dark)] {
            let mut window = builder(size).with_theme(theme).wgpu().build_ui_state(frame, None);
            window.run_steps(3);
            press(&mut window, Modifiers::NONE, Key::Space);
            press(&mut window, Modifiers::NONE, Key::Home);
            for _ in 0..26 {
                press(&mut window, Modifiers::SHIFT, Key::ArrowRight);
            }
            for (place, panel) in panels().iter().enumerate() {
                show(&mut window, place, panel.title());
                // Until what fades in has come.
                window.run_steps(20);
                while !console(&window).jobs().is_at_rest() {
                    window.run_steps(1);
                }
                let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
                let name = format!("{}-{size_name}-{theme_name}", panel.id());
                results.add(window.try_snapshot_options(name, &options));
            }
        }
    }
}
