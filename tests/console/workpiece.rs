//! The screen "Workpiece", driven by its accessible names and by drags over its picture.

use crate::drawn;
use crate::screen;

use crate::screen::{Screen, texts};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Theme, Vec2, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::base::settings::Value;
use steadycut::blocks::cutting::tool_path::ToolPath;
use steadycut::run::tooth_marks::MarkedPart;
use steadycut::study::profilometer::{ProfileLine, measure};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);

/// The screen at the end of a preset's cut.
fn open<'a>(preset: &str, size: Vec2, changes: &[(&str, Value)]) -> Screen<'a> {
    let mut screen = screen::open(preset, size, "Workpiece", changes);
    screen.key_press(Key::End);
    screen.run_steps(4);
    screen
}

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

/// By its name alone: it may be scrolled out of sight.
fn click(screen: &mut Screen, name: &str) {
    screen.get_by_label(name).click_accesskit();
    screen.run_steps(3);
}

/// The picture in space, and what it says.
fn picture(screen: &Screen) -> (Rect, String) {
    let node =
        screen.get_by(|node| node.label().is_some_and(|label| label.starts_with("Part in space")));
    (node.rect(), node.accesskit_node().label().unwrap_or_default())
}

/// A line drawn with the mouse, seen coming.
fn drag(screen: &mut Screen, from: Pos2, to: Pos2) {
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    screen.event(Event::PointerMoved(from));
    screen.run_steps(2);
    screen.event(button(from, true));
    screen.run_steps(1);
    for fraction in [0.3, 0.7, 1.0] {
        screen.event(Event::PointerMoved(from + fraction * (to - from)));
        screen.run_steps(1);
    }
    screen.event(button(to, false));
    screen.run_steps(2);
}

/// The number in a field.
fn field(screen: &Screen, name: &str) -> f64 {
    let node = screen.get_by_role_and_label(Role::SpinButton, name);
    node.accesskit_node().numeric_value().expect("a number")
}

fn set(screen: &mut Screen, name: &str, value: f64) {
    screen.get_by_role_and_label(Role::SpinButton, name).set_value_accesskit(value);
    screen.run_steps(2);
}

/// The screen shows what the core finds along the line in the fields.
fn agrees_with_core(screen: &Screen) {
    let session = console(screen).session();
    let mut marks = MarkedPart::new(session.scenario());
    marks.extend(session.revealed());
    let [x0, y0, x1, y1] = ["From x", "From y", "To x", "To y"].map(|name| field(screen, name));
    let line = ProfileLine { from_mm: [x0, y0], to_mm: [x1, y1] };
    let path = ToolPath::new(&session.current().workpiece, session.current().tool.outline());
    let cut = marks.cut();
    let surface = &marks.cuts()[cut].surface;
    let found = measure(surface, path.of(cut), &line, &session.current().profile).unwrap();
    let roughness = found.roughness;
    let shown = texts(screen);
    for (name, value) in [("Ra", roughness.ra_um), ("Rq", roughness.rq_um), ("Rz", roughness.rz_um)]
    {
        assert!(shown.contains(&format!("{name} {value:.3} µm")), "{name} {value} in {shown}");
    }
}

#[test]
fn the_profilometer_shows_what_the_core_computes_wherever_its_line_is() {
    for size in [vec2(1280.0, 1000.0), vec2(390.0, 1500.0)] {
        let mut screen = open("table3-5", size, &[]);
        assert!(screen.query_by_label("From x").is_none());
        click(&mut screen, "Profilometer");
        let shown = texts(&screen);
        agrees_with_core(&screen);
        assert!(shown.contains("Over 5 sampling lengths of 0.800 mm."), "{shown}");
        assert!(shown.contains("Profile from 0.80 mm to 4.80 mm along the line"), "{shown}");
        // By numbers.
        set(&mut screen, "From x", 30.0);
        set(&mut screen, "To x", 41.0);
        set(&mut screen, "From y", 2.9);
        assert_eq!((field(&screen, "To x"), field(&screen, "From y")), (41.0, 2.9));
        agrees_with_core(&screen);
        // With other cut-offs.
        set(&mut screen, "Long-wave cut-off", 0.25);
        assert_eq!(console(&screen).session().current().profile.long_mm, 0.25);
        agrees_with_core(&screen);
        set(&mut screen, "To x", 30.2);
        set(&mut screen, "To y", 2.9);
        assert!(texts(&screen).contains("long: with these cut-offs it takes at least 0.755 mm"));
        set(&mut screen, "To x", 131.0);
        assert!(texts(&screen).contains("The line leaves the machined surface at x = "));
        click(&mut screen, "Behind the tool");
        agrees_with_core(&screen);
    }
}

#[test]
fn a_drag_draws_the_line_or_turns_the_part() {
    let mut screen = open("table3-5", DESKTOP, &[]);
    click(&mut screen, "Close up");
    click(&mut screen, "Profilometer");
    let (rect, _) = picture(&screen);
    let before = field(&screen, "To x");
    let places = [0.25, 0.6].map(|fraction| {
        pos2(
            rect.left() + fraction * rect.width(),
            rect.top() + (0.7 - 0.35 * fraction) * rect.height(),
        )
    });
    drag(&mut screen, places[0], places[1]);
    let ends = ["From x", "To x"].map(|name| field(&screen, name));
    assert!(ends[1] > ends[0] + 1.0 && ends[1] != before, "{ends:?}");
    for name in ["From y", "To y"] {
        let y = field(&screen, name);
        assert!((2.29..5.3).contains(&y), "{name} {y} is within the strip");
    }
    assert!(!texts(&screen).contains("leaves the machined surface"), "{}", texts(&screen));
    // Turning leaves the line where it is.
    click(&mut screen, "turns the part");
    drag(&mut screen, places[0], places[1]);
    assert_eq!(["From x", "To x"].map(|name| field(&screen, name)), ends);
}

#[test]
fn the_picture_says_where_the_tool_is_and_what_was_cut() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("table3-5", size, &[]);
        let (_, said) = picture(&screen);
        assert!(said.contains("tool at 80.23 of 200.00 mm"), "{said}");
        let shown = texts(&screen);
        assert!(shown.contains("Colour: Ra against its tolerance"), "{shown}");
        assert!(shown.contains("within, 79.0 mm"), "{shown}");
        assert!(!shown.contains("scrap, "), "{shown}");
        for name in
            ["Whole part", "Close up", "At the tool", "Turn left", "Higher", "Nearer", "Farther"]
        {
            click(&mut screen, name);
        }
        let times = |screen: &Screen| {
            let (_, said) = picture(screen);
            let words: Vec<&str> = said.split(' ').collect();
            words[words.len() - 3].parse::<f64>().expect("a factor")
        };
        click(&mut screen, "Close up");
        let near = times(&screen);
        click(&mut screen, "Whole part");
        assert!(times(&screen) > near, "{} {near}", times(&screen));
        click(&mut screen, "Own factor");
        let slider = screen.get_by_role_and_label(Role::Slider, "Own factor");
        slider.set_value_accesskit(7.0);
        screen.run_steps(2);
        assert_eq!(times(&screen), 7.0);
    }
}

#[test]
fn before_the_first_tooth_and_tooth_by_tooth_it_says_what_is_missing() {
    let mut screen = screen::open("experiment-2", DESKTOP, "Workpiece", &[]);
    screen.key_press(Key::Space);
    screen.key_press(Key::Home);
    screen.run_steps(3);
    let (_, said) = picture(&screen);
    assert!(said.contains("cut 1 of 5, tool 7.60 mm before the part"), "{said}");
    click(&mut screen, "Profilometer");
    let shown = texts(&screen);
    assert!(shown.contains("No tooth has been in this cut yet"), "{shown}");
    assert!(shown.contains("K5's Ra does not hold"), "{shown}");
    assert!(shown.contains("Colour: force against its tolerance"), "{shown}");
}

#[test]
fn the_wheel_over_the_picture_zooms_and_does_not_scroll_the_page() {
    let mut screen = open("table3-5", PHONE, &[]);
    let (rect, said) = picture(&screen);
    screen.event(Event::PointerMoved(rect.center()));
    screen.event(Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 900.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Unknown,
        modifiers: Modifiers::NONE,
    });
    screen.run_steps(12);
    let (moved, zoomed) = picture(&screen);
    assert_eq!(moved, rect);
    assert_ne!(zoomed, said, "heights follow the distance");
}

#[test]
fn it_fits_odd_parts_and_windows() {
    let long = ("workpiece.length_mm", Value::Float(5000.0));
    let slot = ("workpiece.radial_depth_mm", Value::Float(10.0));
    let shallow = ("workpiece.axial_depth_mm", Value::Float(0.1));
    for changes in [vec![long], vec![slot], vec![shallow]] {
        for size in [vec2(320.0, 420.0), vec2(1900.0, 500.0)] {
            let mut screen = open("depth-step", size, &changes);
            click(&mut screen, "Whole part");
            let (rect, _) = picture(&screen);
            assert!(rect.is_finite() && rect.area() > 1000.0, "{rect:?}");
        }
    }
}

/// Pictures of the profilometer. `UPDATE_SNAPSHOTS=1` renews them.
#[test]
fn the_profilometer_looks_as_its_pictures() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (name, preset, size, theme) in [
        ("profilometer-desktop-light", "table3-5", DESKTOP, Theme::Light),
        ("profilometer-desktop-dark", "table3-5", DESKTOP, Theme::Dark),
        ("profilometer-phone-light", "table3-5", vec2(390.0, 1400.0), Theme::Light),
    ] {
        let mut screen = open(preset, size, &[]);
        screen.ctx.set_theme(theme);
        click(&mut screen, "Close up");
        click(&mut screen, "Profilometer");
        screen.run_steps(20);
        screen::rest(&mut screen);
        let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
        results.add(screen.try_snapshot_options(name, &options));
    }
}

/// A drag of a finger.
fn swipe(screen: &mut Screen, from: Pos2, to: Pos2) {
    let mut send = |phase, pos: Pos2, also: Event| {
        screen.event(Event::Touch {
            device_id: egui::TouchDeviceId(0),
            id: egui::TouchId::from(0),
            phase,
            pos,
            force: None,
        });
        screen.event(also);
        screen.run_steps(1);
    };
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    use egui::TouchPhase as Phase;
    // The first touch only shows that there is a finger.
    send(Phase::Start, from, Event::PointerGone);
    send(Phase::End, from, Event::PointerGone);
    send(Phase::Start, from, button(from, true));
    for fraction in [0.3, 0.7, 1.0] {
        let at = from + fraction * (to - from);
        send(Phase::Move, at, Event::PointerMoved(at));
    }
    send(Phase::End, to, button(to, false));
    screen.event(Event::PointerGone);
    screen.run_steps(30);
}

#[test]
fn a_finger_scrolls_the_page_or_turns_the_part_or_draws_the_line() {
    let mut screen = open("table3-5", PHONE, &[]);
    click(&mut screen, "Close up");
    click(&mut screen, "Profilometer");
    let (rect, _) = picture(&screen);
    let [low, high] =
        [0.8, 0.3].map(|fraction| pos2(rect.center().x, rect.top() + fraction * rect.height()));
    swipe(&mut screen, low, high);
    assert_eq!(picture(&screen).0, rect, "the page stays");
    let ends = |screen: &Screen| ["From x", "To x"].map(|name| field(screen, name));
    let drawn = ends(&screen);
    assert_ne!(drawn, [73.0, 79.0], "a line was drawn");
    click(&mut screen, "turns the part");
    click(&mut screen, "Turn by touch");
    swipe(&mut screen, low, high);
    assert_eq!((picture(&screen).0, ends(&screen)), (rect, drawn), "the part was turned");
    click(&mut screen, "Turn by touch");
    swipe(&mut screen, low, high);
    let scrolled = picture(&screen).0;
    assert!(scrolled.top() < rect.top() - 20.0, "{scrolled:?} {rect:?}");
    assert_eq!(ends(&screen), drawn);
}
