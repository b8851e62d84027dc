//! Parts of one's own in the console: a table becomes the part, a program after it is cut from a blank.

use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use steadycut::app::command::{Command, FileCommand, SessionCommand};
use steadycut::app::panels::BroughtFile;
use steadycut::app::session::Session;
use steadycut::run::edits::Edits;
use steadycut::run::presets::load;
use steadycut::study::part::{EXAMPLE_CSV, PartPath};

use crate::screen::{self, texts};

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
