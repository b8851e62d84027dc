//! Parts of one's own in the console: a table becomes the part, a program after it is cut from a blank.

use egui::accesskit::Role;
use egui::{Key, Theme, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{SnapshotOptions, SnapshotResults};
use steadycut::app::command::{Command, FileCommand, PlaybackCommand, SessionCommand};
use steadycut::app::panels::BroughtFile;
use steadycut::app::session::Session;
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::presets::load;
use steadycut::study::part::{EXAMPLE_CSV, EXAMPLE_GCODE, PartPath};

use crate::drawn;
use crate::screen::{self, Screen, texts};

/// A slot 2 mm deep over a way of 60 mm.
const PROGRAM: &str = "G0 X0 Y0\nG0 Z5\nG0 Z-2\nG1 X60 F300\nG0 Z5\n";

#[test]
fn a_table_becomes_the_part_in_one_step_of_undo() {
    let before = load("first-cut").unwrap();
    let mut session = Session::new(before.clone(), Edits::none());
    let path = Box::new(PartPath::read(EXAMPLE_CSV).unwrap());
    session.execute(SessionCommand::TakePart { name: "steps.csv".to_owned(), path });
    let workpiece = &session.scenario().workpiece;
    assert_eq!((workpiece.length_mm, workpiece.radial_steps[1]), (130.0, [30.0, 4.0]));
    let said = session.notices().last().map(|notice| notice.text.clone()).unwrap();
    assert!(said.contains("steps.csv") && said.contains("130.0 mm"), "{said}");
    session.execute(SessionCommand::Undo);
    assert_eq!(session.scenario(), &before);
}

#[test]
fn a_program_is_cut_from_a_blank_and_becomes_the_part() {
    let mut screen = screen::open("first-cut", egui::vec2(1280.0, 800.0), "Console", &[]);
    let (name, text) = ("slot.nc".to_owned(), PROGRAM.to_owned());
    let bring = Command::File(FileCommand::Bring(BroughtFile::Program { name, text }));
    screen.state().as_ref().expect("made in the first frame").push(bring);
    screen.run_steps(4);
    assert!(texts(&screen).contains("slot.nc: 3 moves"), "{}", texts(&screen));
    let press = |screen: &mut screen::Screen<'_>, name: &str| {
        screen.get_by_role_and_label(Role::Button, name).click_accesskit();
        screen.run_steps(3);
    };
    press(&mut screen, "Cut it from the blank");
    let make = "Make it the part";
    let done = screen::in_time(|| {
        screen.run_steps(1);
        screen.query_by_role_and_label(Role::Button, make).is_some()
    });
    assert!(done, "{}", texts(&screen));
    press(&mut screen, make);
    let session = screen.state().as_ref().expect("made in the first frame").session();
    let workpiece = &session.scenario().workpiece;
    assert_eq!((workpiece.length_mm, workpiece.axial_depth_mm), (60.0, 2.0));
    assert!(workpiece.cuts.is_empty() && !workpiece.radial_steps.is_empty());
}

fn push(screen: &mut Screen<'_>, command: Command) {
    screen.state().as_ref().expect("made in the first frame").push(command);
    screen.run_steps(3);
}

fn click(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_label(name).click_accesskit();
    screen.run_steps(3);
}

/// The bracket, cut from its blank, as the part of the preset that is made of it; at a share of its way.
fn bracket(screen: &mut Screen<'_>) {
    let (name, text) = ("bracket.nc".to_owned(), EXAMPLE_GCODE.to_owned());
    push(screen, Command::File(FileCommand::Bring(BroughtFile::Program { name, text })));
    screen.run_steps(3);
    for (i, axis) in ["X", "Y", "Z"].into_iter().enumerate() {
        let field = |name: &str| format!("{name} of the blank along {axis}");
        for (name, value) in
            [(field("Size"), [100.0, 60.0, 20.0][i]), (field("Least corner"), [0.0, 0.0, -20.0][i])]
        {
            screen.get_by_role_and_label(Role::SpinButton, &name).set_value_accesskit(value);
            screen.run_steps(2);
        }
    }
    click(screen, "Cut it from the blank");
    let made = screen::in_time(|| {
        screen.run_steps(1);
        screen.query_by_role_and_label(Role::Button, "Make it the part").is_some()
    });
    assert!(made, "{}", texts(screen));
    click(screen, "Make it the part");
    click(screen, "Close window");
    screen::computed(screen);
    screen.run_steps(3);
}

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    screen.state().as_ref().expect("made in the first frame").session()
}

/// Goes to a place of the way, mm.
fn go_to(screen: &mut Screen<'_>, place_mm: f64) {
    let rows = session(screen).chosen().run().recording().rows();
    let row = rows.partition_point(|row| row.position_mm < place_mm);
    let at_s = rows[row.min(rows.len() - 1)].time_s;
    push(screen, Command::Playback(PlaybackCommand::SeekTo(at_s)));
    screen.run_steps(6);
}

/// What the picture in space says.
fn said(screen: &Screen<'_>) -> String {
    let node =
        screen.get_by(|node| node.label().is_some_and(|label| label.contains(" in space, ")));
    node.accesskit_node().label().unwrap_or_default()
}

#[test]
fn the_blank_is_shown_as_it_is_cut_while_the_part_is_that_of_the_program() {
    for size in [vec2(1280.0, 800.0), vec2(390.0, 844.0)] {
        let mut screen = screen::open("own-part", size, "Workpiece", &[]);
        screen.key_press(Key::Space);
        screen.run_steps(2);
        // A table has no shape in space.
        assert!(said(&screen).starts_with("Part in space"), "{}", said(&screen));
        assert!(texts(&screen).contains("has no shape in space"), "{}", texts(&screen));
        bracket(&mut screen);
        go_to(&mut screen, 60.0);
        let blank = said(&screen);
        assert!(blank.starts_with("Blank in space, tool at 60."), "{blank}");
        assert!(blank.contains("of 305.97 mm") && blank.contains("3.00 mm deep"), "{blank}");
        assert!(blank.contains("4.00 mm wide, line 12"), "{blank}");
        go_to(&mut screen, 175.0);
        assert!(said(&screen).contains("in the air, line 14"), "{}", said(&screen));
        for name in ["Whole part", "At the tool", "Turn left", "Nearer", "Cutter"] {
            click(&mut screen, name);
        }
        assert!(screen.query_by_label("Close up").is_none());
        assert!(screen.unnamed_widgets().is_empty(), "{:?}", screen.unnamed_widgets());
        // The strip is there, too; its profilometer asks for it.
        click(&mut screen, "Strip along the way");
        assert!(said(&screen).starts_with("Part in space"), "{}", said(&screen));
        click(&mut screen, "Blank");
        assert!(said(&screen).starts_with("Blank in space"), "{}", said(&screen));
        click(&mut screen, "Profilometer");
        assert!(said(&screen).starts_with("Part in space"), "{}", said(&screen));
        click(&mut screen, "Blank");
        assert!(said(&screen).starts_with("Blank in space"), "{}", said(&screen));
        // Another part, and another cutter, are told; back again it is there.
        push(&mut screen, Command::Playback(PlaybackCommand::SeekTo(0.0)));
        screen.run_steps(3);
        for (path, value, why) in [
            ("workpiece.length_mm", Value::Float(300.0), "another one than that of bracket.nc"),
            ("tool.diameter_mm", Value::Float(16.0), "was cut with another cutter"),
        ] {
            push(&mut screen, Command::set(path, value));
            assert!(said(&screen).starts_with("Part in space"), "{path}: {}", said(&screen));
            assert!(texts(&screen).contains(why), "{path}: {}", texts(&screen));
            push(&mut screen, Command::Session(SessionCommand::Undo));
            screen.run_steps(3);
            assert!(said(&screen).starts_with("Blank in space"), "{path}: {}", said(&screen));
        }
    }
}

/// Pictures of the blank. `UPDATE_SNAPSHOTS=1` renews them.
#[test]
fn the_blank_looks_as_its_pictures() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (name, size, theme, place_mm) in [
        ("blank-desktop-light", vec2(1280.0, 800.0), Theme::Light, 225.0),
        ("blank-desktop-dark", vec2(1280.0, 800.0), Theme::Dark, 400.0),
        ("blank-phone-light", vec2(390.0, 844.0), Theme::Light, 225.0),
    ] {
        let mut screen = screen::open("own-part", size, "Workpiece", &[]);
        screen.ctx.set_theme(theme);
        screen.key_press(Key::Space);
        screen.run_steps(2);
        bracket(&mut screen);
        go_to(&mut screen, place_mm);
        // What is told of the part lies over it.
        while screen.query_by_label("Dismiss").is_some() {
            click(&mut screen, "Dismiss");
        }
        screen.run_steps(20);
        screen::computed(&mut screen);
        screen::rest(&mut screen);
        let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
        results.add(screen.try_snapshot_options(name, &options));
    }
}
