//! What surrounds the screens: messages, keys, the sheet of keys, Escape and Tab, fingers, the address.

use std::time::{Duration, Instant};

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Pos2, Rect, Theme, TouchPhase, Vec2, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, HarnessBuilder, Node, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, SessionCommand, ShellCommand};
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::{Start, presets};

use crate::drawn;
use crate::screen::{self, Screen, finger, show, sliced, texts};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);
const SIZES: [Vec2; 2] = [DESKTOP, PHONE];

/// The console, with a message at its start, in a window or with the keys of a page.
fn open<'a>(size: Vec2, notice: Option<&str>, page: bool) -> Screen<'a> {
    built(Harness::builder().with_size(size).with_step_dt(0.05), notice, page)
}

fn built<'a>(
    builder: HarnessBuilder<Option<Console>>,
    notice: Option<&str>,
    page: bool,
) -> Screen<'a> {
    let notice = notice.map(str::to_owned);
    let mut screen = builder.build_ui_state(
        move |ui, console: &mut Option<Console>| {
            let console = console.get_or_insert_with(|| {
                let scenario = presets::load("first-cut").expect("shipped");
                let start = Start { scenario, edits: Edits::none(), notice: notice.clone() };
                let mut console = sliced(Console::new(ui.ctx(), start));
                if page {
                    console.act_as_page();
                }
                console
            });
            console.ui(ui);
        },
        None,
    );
    screen.run_steps(3);
    screen
}

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn press(screen: &mut Screen<'_>, modifiers: Modifiers, key: Key) {
    screen.key_press_modifiers(modifiers, key);
    screen.run_steps(3);
}

fn shown(screen: &Screen<'_>) -> String {
    let state: serde_json::Value = serde_json::from_str(&console(screen).state_json()).unwrap();
    state["screen"].as_str().unwrap().to_owned()
}

fn target_um(screen: &Screen<'_>) -> f64 {
    console(screen).session().current().target.ra_um
}

fn rect_of(screen: &Screen<'_>, role: Role, name: &str) -> Rect {
    screen.get_by_role_and_label(role, name).rect()
}

#[test]
fn a_message_moves_nothing_goes_by_itself_and_can_be_read_again() {
    const SAID: &str = "The link was not used, first-cut is open instead.";
    for size in SIZES {
        let before = rect_of(&open(size, None, false), Role::Button, "Pause");
        let mut screen = open(size, Some(SAID), false);
        assert_eq!(console(&screen).messages().collect::<Vec<&str>>(), [SAID]);
        assert_eq!(rect_of(&screen, Role::Button, "Pause"), before, "nothing has moved");
        let card = screen.get_by_label(SAID).rect();
        assert!(card.is_positive());
        // It lies on nothing that it speaks of, nor on what is pressed next.
        let free: &[(Role, &str)] = match size == PHONE {
            true => &[(Role::ComboBox, "Screen"), (Role::Button, "Menu"), (Role::Button, "Pause")],
            false => &[
                (Role::Button, "Pause"),
                (Role::Button, "Back to before it went wrong"),
                (Role::Label, "Disturbances: none"),
            ],
        };
        for (role, name) in free {
            let other = rect_of(&screen, *role, name);
            assert!(!card.intersects(other), "{name}: {card:?} and {other:?}");
        }
        // 5 s and 0.08 s a letter, in frames of 0.05 s.
        screen.run_steps(160);
        assert_eq!(console(&screen).messages().count(), 1);
        screen.run_steps(40);
        assert_eq!(console(&screen).messages().count(), 0);
        assert!(screen.query_by_label(SAID).is_none());
        screen.get_by_role_and_label(Role::Button, "Messages").click();
        screen.run_steps(3);
        assert!(screen.query_by_label(SAID).is_some(), "{}", texts(&screen));
        press(&mut screen, Modifiers::NONE, Key::Escape);
        assert!(screen.query_by_label(SAID).is_none());
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

#[test]
fn nothing_of_the_transport_moves_while_the_cut_is_computed() {
    // Far more steps than are simulated in the frames until it is looked at.
    let long = [("run.steps_per_control", Value::Int(500))];
    for size in [vec2(320.0, 640.0), PHONE, vec2(700.0, 800.0), vec2(899.0, 800.0)]
        .into_iter()
        .chain([900.0, 960.0, 1024.0, 1100.0, 1280.0].map(|width| vec2(width, 800.0)))
    {
        let mut screen = screen::open("first-cut", size, "Console", &long);
        press(&mut screen, Modifiers::NONE, Key::Space);
        let progress = |screen: &Screen<'_>| {
            let all = screen.query_all_by_role(Role::ProgressIndicator);
            let named = all.filter_map(|node| node.accesskit_node().label());
            named.filter(|name| name.starts_with("computing, ")).count()
        };
        let places = |screen: &Screen<'_>| {
            let button = |name: &str| rect_of(screen, Role::Button, name);
            let slider = rect_of(screen, Role::Slider, "Playhead").y_range();
            let follow = rect_of(screen, Role::CheckBox, "Follow").y_range();
            (["Restart", "Play", "Step", "End"].map(button), slider, follow)
        };
        assert!(console(&screen).session().simulated() < 0.9, "still being computed at {size}");
        assert_eq!(progress(&screen), 1, "{size}: {}", texts(&screen));
        let before = places(&screen);
        // The words have a place of their own, but on a phone.
        let words = screen.query_all_by_role(Role::Label);
        let words = words.filter_map(|node| node.accesskit_node().value());
        let words = words.filter(|text| text.starts_with("computing, ")).count();
        assert!(words == 0 || size.x >= 900.0, "{words} at {size}");
        screen::computed(&mut screen);
        assert_eq!(console(&screen).session().simulated(), 1.0);
        assert_eq!(progress(&screen), 0);
        assert_eq!(places(&screen), before, "{size}");
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

#[test]
fn escape_closes_what_lies_on_top_one_after_the_other() {
    let mut screen = open(DESKTOP, Some("a message"), false);
    press(&mut screen, Modifiers::NONE, Key::Questionmark);
    let sheet = |screen: &Screen<'_>| screen.query_by_label("This sheet").is_some();
    assert!(sheet(&screen) && console(&screen).messages().count() == 1);
    assert!(!console(&screen).tab_leaves());
    press(&mut screen, Modifiers::NONE, Key::Escape);
    assert!(!sheet(&screen) && console(&screen).messages().count() == 1);
    press(&mut screen, Modifiers::NONE, Key::Escape);
    assert_eq!(console(&screen).messages().count(), 0);
    assert!(!console(&screen).tab_leaves());
    // Nothing to close any more: the way out, until something is done in the console again.
    press(&mut screen, Modifiers::NONE, Key::Escape);
    assert!(console(&screen).tab_leaves());
    screen.get_by_label("Pause").click();
    screen.run_steps(2);
    assert!(!console(&screen).tab_leaves());
}

#[test]
fn the_sheet_of_keys_fits_and_lists_what_is_true_here() {
    for size in [DESKTOP, PHONE, vec2(320.0, 420.0)] {
        for page in [false, true] {
            let mut screen = open(size, None, page);
            press(&mut screen, Modifiers::NONE, Key::Questionmark);
            screen.run_steps(10);
            let shown = texts(&screen);
            let window = screen.get_by_role_and_label(Role::Window, "Keys and gestures").rect();
            let whole = Rect::from_min_size(Pos2::ZERO, size);
            assert!(whole.contains_rect(window), "{window:?} in {size:?}");
            for (text, in_page) in [
                ("Ctrl+1 … Ctrl+9", false),
                ("Ctrl+L", false),
                ("1 … 9", true),
                ("Esc, then Tab", true),
            ] {
                assert_eq!(shown.lines().any(|line| line == text), page == in_page, "{text}");
            }
            assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
            assert!(shown.contains("Double tap a plot"), "{shown}");
        }
    }
    // Whoever has fingers at hand reads first what they do.
    let mut screen = open(PHONE, None, true);
    finger(&mut screen, pos2(200.0, 500.0), TouchPhase::Start);
    finger(&mut screen, pos2(200.0, 500.0), TouchPhase::End);
    screen.run_steps(4);
    press(&mut screen, Modifiers::NONE, Key::Questionmark);
    let place = |text: &str| screen.get_by_label(text).rect().top();
    assert!(place("Pinch a plot") < place("Play or pause; after the end: again"));
}

#[test]
fn a_page_leaves_the_browser_its_keys() {
    let mut screen = open(DESKTOP, None, true);
    press(&mut screen, Modifiers::COMMAND, Key::Num4);
    assert_eq!(shown(&screen), "console", "Ctrl+4 is the browser's");
    press(&mut screen, Modifiers::NONE, Key::Num2);
    assert_eq!(shown(&screen), "block_diagram");
    press(&mut screen, Modifiers::NONE, Key::Space);
    press(&mut screen, Modifiers::SHIFT, Key::ArrowRight);
    let playhead_s = |screen: &Screen<'_>| console(screen).session().playback().playhead_s;
    let before_s = playhead_s(&screen);
    press(&mut screen, Modifiers::ALT, Key::ArrowLeft);
    assert_eq!(playhead_s(&screen), before_s, "Alt+Left is the browser's, in a window too");
    press(&mut screen, Modifiers::NONE, Key::ArrowLeft);
    assert!(playhead_s(&screen) < before_s);
    // In a window digits alone do nothing.
    let mut screen = open(DESKTOP, None, false);
    press(&mut screen, Modifiers::NONE, Key::Num2);
    assert_eq!(shown(&screen), "console");
    press(&mut screen, Modifiers::COMMAND, Key::Num2);
    assert_eq!(shown(&screen), "block_diagram");
}

#[test]
fn space_presses_what_can_be_pressed_and_plays_or_pauses_wherever_else_the_focus_is() {
    let mut screen = open(DESKTOP, None, false);
    let playing = |screen: &Screen<'_>| console(screen).session().playback().playing;
    let follows = |screen: &Screen<'_>| console(screen).session().playback().follow;
    let focus = |screen: &mut Screen<'_>, role: Role, name: &str| {
        screen.get_by_role_and_label(role, name).focus();
        screen.run_steps(2);
    };
    focus(&mut screen, Role::Slider, "Target Ra");
    assert!(playing(&screen));
    press(&mut screen, Modifiers::NONE, Key::Space);
    assert!(!playing(&screen));
    focus(&mut screen, Role::CheckBox, "Follow");
    let follow = follows(&screen);
    press(&mut screen, Modifiers::NONE, Key::Space);
    assert_eq!((follows(&screen), playing(&screen)), (!follow, false), "and nothing else");
    focus(&mut screen, Role::Button, "Play");
    press(&mut screen, Modifiers::NONE, Key::Space);
    assert!(playing(&screen), "once, not there and back");
    // What has no focus any more is not pressed.
    press(&mut screen, Modifiers::NONE, Key::Escape);
    press(&mut screen, Modifiers::NONE, Key::Space);
    assert!(!playing(&screen));
    // A field that is being written in keeps it.
    screen.get_by_role_and_label(Role::SpinButton, "Target Ra").focus();
    screen.run_steps(2);
    let before = playing(&screen);
    press(&mut screen, Modifiers::NONE, Key::Space);
    assert_eq!(playing(&screen), before);
}

#[test]
fn tab_goes_on_from_the_number_that_was_ended_with_enter() {
    let mut screen = open(DESKTOP, None, false);
    press(&mut screen, Modifiers::NONE, Key::Space);
    screen.get_by_role_and_label(Role::SpinButton, "Target Ra").focus();
    screen.run_steps(2);
    press(&mut screen, Modifiers::COMMAND, Key::A);
    screen.event(Event::Text("0.6".to_owned()));
    screen.run_steps(1);
    press(&mut screen, Modifiers::NONE, Key::Enter);
    assert_eq!(target_um(&screen), 0.6);
    // The keys are the playhead's again.
    press(&mut screen, Modifiers::NONE, Key::End);
    assert!(console(&screen).session().playback().at_end);
    press(&mut screen, Modifiers::NONE, Key::Tab);
    let slider = screen.get_by_role_and_label(Role::Slider, "Target Ra");
    assert!(slider.accesskit_node().is_focused(), "the slider below the number");
}

/// The names of what has the focus after each of so many keys.
fn stops(screen: &mut Screen<'_>, modifiers: Modifiers, count: usize) -> Vec<String> {
    let stop = |screen: &mut Screen<'_>| {
        press(screen, modifiers, Key::Tab);
        screen.run_steps(2);
        let focused =
            screen.root().children_recursive().find(|node| node.accesskit_node().is_focused());
        focused.map_or_else(String::new, |node| {
            let node = node.accesskit_node();
            node.label().or_else(|| node.value()).unwrap_or_default()
        })
    };
    (0..count).map(|_| stop(screen)).collect()
}

#[test]
fn tab_goes_in_the_order_of_use() {
    let mut screen = open(DESKTOP, None, false);
    press(&mut screen, Modifiers::NONE, Key::Space);
    let forward = stops(&mut screen, Modifiers::NONE, 7);
    let wanted =
        ["Scenario", "Target Ra", "Target Ra", "Material", "Hardness", "Hardness", "Noise"];
    assert_eq!(forward, wanted);
    // And back; before the first control comes the last one of the transport.
    let back = stops(&mut screen, Modifiers::SHIFT, 7);
    assert_eq!(
        back[..6],
        ["Hardness", "Hardness", "Material", "Target Ra", "Target Ra", "Scenario"]
    );
    assert_eq!(back[6], "Back to before it went wrong");
    // All that can be used is reached: once around, and no stop without a name.
    let mut around = stops(&mut screen, Modifiers::NONE, 90);
    assert!(around.iter().all(|name| !name.is_empty()), "{around:?}");
    let again = around.iter().skip(1).position(|name| *name == around[0]).expect("it goes around");
    around.truncate(again + 1);
    for wanted in ["Controller", "More settings", "Console", "Find", "Play", "Playhead"] {
        assert!(around.iter().any(|name| name == wanted), "{wanted} is not among {around:?}");
    }
}

#[test]
fn screens_without_the_run_have_no_transport_of_it_and_it_rests() {
    for size in SIZES {
        let mut screen = open(size, None, false);
        for (title, timeline) in [
            ("Block diagram", true),
            ("Workpiece", true),
            ("Plan", false),
            ("Machine", true),
            ("Compare", false),
            ("Papers", false),
            ("Identify", false),
        ] {
            show(&mut screen, title);
            let has = screen.query_by_role_and_label(Role::Slider, "Playhead").is_some();
            assert_eq!(has, timeline, "{title}");
            let before_s = console(&screen).session().playback().playhead_s;
            screen.run_steps(5);
            let moved = console(&screen).session().playback().playhead_s > before_s;
            assert_eq!(moved, timeline, "{title}");
            // Keys for what is not there do nothing.
            press(&mut screen, Modifiers::NONE, Key::Space);
            let playing = console(&screen).session().playback().playing;
            assert_eq!(playing, !timeline, "{title}");
            if timeline {
                press(&mut screen, Modifiers::NONE, Key::Space);
            }
        }
    }
}

#[test]
fn no_plot_moves_when_the_run_before_a_change_comes_into_the_legend() {
    for size in SIZES {
        let mut screen = open(size, None, false);
        screen.run_steps(20);
        press(&mut screen, Modifiers::NONE, Key::Space);
        let plot =
            |screen: &Screen<'_>| screen.get_by_label("Roughness from 0.00 s to 20.00 s").rect();
        let before = plot(&screen);
        let entries = |screen: &Screen<'_>| screen.query_all_by_label("before").count();
        assert_eq!(entries(&screen), 0);
        let slider = rect_of(&screen, Role::Slider, "Target Ra");
        screen.hover_at(slider.center());
        screen.run_steps(1);
        screen.drag_at(slider.center());
        screen.run_steps(2);
        screen.hover_at(slider.center() + vec2(30.0, 0.0));
        screen.run_steps(2);
        assert!(console(&screen).session().ghost().is_some() && entries(&screen) == 1);
        assert_eq!(plot(&screen), before);
        screen.drop_at(slider.center() + vec2(30.0, 0.0));
        screen.run_steps(2);
    }
}

/// What stands at a limit now? It is in sight without scrolling in the window that the console opens with.
#[test]
fn the_states_of_the_loop_are_in_sight_in_the_first_window() {
    let mut screen = open(DESKTOP, None, false);
    screen.run_steps(4);
    let playhead = rect_of(&screen, Role::Slider, "Playhead");
    for state in ["Controller", "Disturbances", "At a limit", "Outside model", "In the air"] {
        let begins = format!("{state}: ");
        let found = screen.root().children_recursive().find(|node| said(node).starts_with(&begins));
        let rect = found.unwrap_or_else(|| panic!("{state} in {}", texts(&screen))).rect();
        assert!(rect.bottom() < playhead.top(), "{state} at {rect:?}, {playhead:?}");
    }
}

/// What a node says.
fn said(node: &Node<'_>) -> String {
    let node = node.accesskit_node();
    let [label, value] = [node.label(), node.value()].map(Option::unwrap_or_default);
    if label.is_empty() { value } else { label }
}

/// A finger that goes from a place by a way, in ten frames, rests and is lifted.
pub fn swipe(screen: &mut Screen<'_>, from: Pos2, way: Vec2) {
    finger(screen, from, TouchPhase::Start);
    for step in 1..=10 {
        finger(screen, from + way * (0.1 * step as f32), TouchPhase::Move);
    }
    for _ in 0..6 {
        finger(screen, from + way, TouchPhase::Move);
    }
    finger(screen, from + way, TouchPhase::End);
    screen.run_steps(20);
}

#[test]
fn a_finger_that_begins_on_a_slider_or_field_scrolls_unless_it_goes_across() {
    for role in [Role::Slider, Role::SpinButton] {
        for way in [vec2(0.0, -180.0), vec2(15.0, -300.0), vec2(-10.0, -120.0)] {
            let mut screen = open(PHONE, None, false);
            press(&mut screen, Modifiers::NONE, Key::Space);
            let before = rect_of(&screen, role, "Target Ra");
            let target = target_um(&screen);
            let plot = |screen: &Screen<'_>| {
                screen.get_by_label("Roughness from 0.00 s to 20.00 s").rect().top()
            };
            let top = plot(&screen);
            swipe(&mut screen, before.center(), way);
            assert_eq!(target_um(&screen), target, "{role:?} {way:?}");
            assert!(!console(&screen).session().can_undo());
            // It stands above the plots, which are scrolled.
            assert_eq!(rect_of(&screen, role, "Target Ra"), before);
            assert!(plot(&screen) < top - 60.0, "scrolled: {top} to {}", plot(&screen));
            // The next finger at the very same place is one of its own.
            swipe(&mut screen, before.center(), vec2(60.0, 0.0));
            assert_ne!(target_um(&screen), target, "{role:?} {way:?}, then across");
        }
        // Among the settings it goes with them.
        let mut screen = open(PHONE, None, false);
        press(&mut screen, Modifiers::NONE, Key::Space);
        for name in ["Settings", "More settings"] {
            screen.get_by_label(name).click_accesskit();
            screen.run_steps(12);
        }
        let before = rect_of(&screen, role, "Hardness");
        swipe(&mut screen, before.center(), vec2(4.0, -150.0));
        let after = rect_of(&screen, role, "Hardness");
        assert!(after.top() < before.top() - 60.0, "{role:?} scrolled: {before:?} to {after:?}");
        assert!(!console(&screen).session().can_undo());
        let mut screen = open(PHONE, None, false);
        press(&mut screen, Modifiers::NONE, Key::Space);
        let rect = rect_of(&screen, role, "Target Ra");
        let target = target_um(&screen);
        // A tap is no drag.
        swipe(&mut screen, rect.center() + vec2(30.0, 0.0), Vec2::ZERO);
        assert_eq!(target_um(&screen), target, "{role:?}");
        press(&mut screen, Modifiers::NONE, Key::Escape);
        swipe(&mut screen, rect.center(), vec2(80.0, 10.0));
        assert!(target_um(&screen) > target, "{role:?}");
        assert_eq!(rect_of(&screen, role, "Target Ra").top(), rect.top());
    }
}

#[test]
#[expect(clippy::disallowed_methods, reason = "a test of times")]
fn the_address_has_the_last_change_within_a_second_also_after_a_burst() {
    let mut screen = open(DESKTOP, None, false);
    press(&mut screen, Modifiers::NONE, Key::Space);
    screen.get_by_role_and_label(Role::Slider, "Target Ra").set_value_accesskit(1.5);
    screen.run_steps(2);
    for key in [Key::Z, Key::Y, Key::Z, Key::Y, Key::Z] {
        screen.key_press_modifiers(Modifiers::COMMAND, key);
        screen.run_steps(1);
    }
    let state = |screen: &Screen<'_>| -> serde_json::Value {
        serde_json::from_str(&console(screen).state_json()).unwrap()
    };
    let (start, mut frames) = (Instant::now(), 0);
    while state(&screen)["address_is_current"] != true {
        assert!(start.elapsed() < Duration::from_secs(1), "{frames} frames");
        std::thread::sleep(Duration::from_millis(100));
        screen.run_steps(1);
        frames += 1;
    }
}

#[test]
fn a_link_that_cannot_be_copied_is_put_up_and_closed_by_escape() {
    // What the browser answers where there is no clipboard.
    for size in SIZES {
        let mut screen = open(size, None, true);
        let link = "https://example.org/#first-cut".to_owned();
        let console = screen.state_mut().as_mut().unwrap();
        console.push(Command::Shell(ShellCommand::ShowLink { link: link.clone(), copied: false }));
        screen.run_steps(4);
        assert!(texts(&screen).contains(&link), "{}", texts(&screen));
        let repeats = "steadycut run 'https://example.org/#fir…'";
        assert!(texts(&screen).contains(repeats), "{}", texts(&screen));
        assert!(!texts(&screen).contains('`'), "{}", texts(&screen));
        let window = screen.get_by_role_and_label(Role::Window, "Link to this state").rect();
        assert!(Rect::from_min_size(pos2(0.0, 0.0), size).contains_rect(window));
        press(&mut screen, Modifiers::NONE, Key::Escape);
        press(&mut screen, Modifiers::NONE, Key::Escape);
        assert!(!texts(&screen).contains(&link));
    }
}

/// Pictures of what lies over the screens. `UPDATE_SNAPSHOTS=1` renews them.
#[test]
fn what_lies_over_the_screens_looks_as_its_pictures() {
    if !drawn::in_software() {
        return;
    }
    const SAID: &str = "The link was not used, first-cut is open instead. `target.ra_um` cannot be \
                        99: allowed is a number from 0.05 to 4 um";
    let mut results = SnapshotResults::new();
    for (size, theme, look) in
        [(DESKTOP, Theme::Light, "desktop-light"), (PHONE, Theme::Dark, "phone-dark")]
    {
        let builder = Harness::builder().with_size(size).with_step_dt(0.05);
        let builder = builder.with_theme(theme).wgpu();
        let mut screen = built(builder, Some(SAID), size == PHONE);
        press(&mut screen, Modifiers::NONE, Key::Space);
        let mut picture = |screen: &mut Screen<'_>, name: &str| {
            screen.run_steps(20);
            screen::computed(screen);
            let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
            results.add(screen.try_snapshot_options(format!("{name}-{look}"), &options));
        };
        picture(&mut screen, "message");
        press(&mut screen, Modifiers::NONE, Key::Escape);
        screen.get_by_role_and_label(Role::Button, "Messages").click();
        picture(&mut screen, "messages");
        press(&mut screen, Modifiers::NONE, Key::Escape);
        press(&mut screen, Modifiers::NONE, Key::Questionmark);
        picture(&mut screen, "keys");
        press(&mut screen, Modifiers::NONE, Key::Escape);
        let link = format!("https://example.org/steadycut/#z={}", "Qx7".repeat(60));
        console(&screen).push(Command::Shell(ShellCommand::ShowLink { link, copied: false }));
        picture(&mut screen, "link");
    }
}

#[test]
fn keys_of_one_frame_act_in_the_order_in_which_they_were_pressed() {
    let mut screen = open(DESKTOP, None, false);
    let at_first_um = target_um(&screen);
    let value = Value::Float(0.5);
    let path = "target.ra_um".to_owned();
    console(&screen).push(Command::Session(SessionCommand::Set { path, value }));
    screen.run_steps(2);
    assert_eq!(target_um(&screen), 0.5);
    for key in [Key::Z, Key::Y, Key::Z] {
        let modifiers = Modifiers::COMMAND;
        let pressed = true;
        screen.input_mut().events.push(Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers,
        });
    }
    screen.run_steps(1);
    assert_eq!(target_um(&screen), at_first_um, "back, on, back");
}

/// As by a key or a screen reader: no pointer is pressed anywhere, which would close any list.
#[test]
fn what_is_chosen_without_a_pointer_closes_its_list() {
    let is_open = |screen: &Screen<'_>| egui::Popup::is_any_open(&screen.ctx);
    for (size, list, entry) in [
        (DESKTOP, "Controller", "Tracking"),
        (DESKTOP, "Scenario", "A deeper stretch: what control buys"),
        (DESKTOP, "Speed", "as fast as possible"),
        (PHONE, "Screen", "Identify"),
    ] {
        let mut screen = open(size, None, false);
        screen.run_steps(2);
        screen.get_by_role_and_label(Role::ComboBox, list).click_accesskit();
        screen.run_steps(2);
        assert!(is_open(&screen), "{list}");
        screen.get_by_role_and_label(Role::Button, entry).click_accesskit();
        screen.run_steps(2);
        assert!(!is_open(&screen), "{list}");
    }
    let mut screen = open(PHONE, None, false);
    screen.run_steps(2);
    screen.get_by_label("Menu").click_accesskit();
    screen.run_steps(2);
    assert!(is_open(&screen));
    screen.get_by_label("Find").click_accesskit();
    screen.run_steps(2);
    assert!(!is_open(&screen));
}
