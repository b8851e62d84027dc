//! Formulas of one's own, typed and opened in the console: said what is wrong before they are used, used in the
//! running cut, shown on the card, taken back in one step.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, SessionCommand};
use steadycut::base::settings::Value;
use steadycut::models::genetic::Calibration;
use steadycut::models::tool::ShippedTool;
use steadycut::run::scenario::Scenario;

use crate::drawn;
use crate::screen::{Screen, open, rest, texts};

const SIZES: [Vec2; 2] = [vec2(1280.0, 1300.0), vec2(390.0, 844.0)];
const FORCE: &str = "Force of the cut";

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn current<'a>(screen: &'a Screen<'_>) -> &'a Scenario {
    console(screen).session().current()
}

fn press(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(3);
}

/// The card of the cut, with the playhead in the middle of it.
fn card<'a>(size: Vec2) -> Screen<'a> {
    let mut screen = open("table3-5", size, "Block diagram", &[]);
    screen.run_steps(40);
    screen.key_press(Key::Space);
    screen.run_steps(2);
    screen.get_by_role_and_label(Role::Button, "Cutting process K4").click_accesskit();
    screen.run_steps(3);
    assert!(console(&screen).session().row().time_s > 0.5, "the cut is under way");
    screen
}

/// Writes into a field in place of what stands there.
fn write(screen: &mut Screen<'_>, name: &str, text: &str) {
    screen.get_by_label(name).focus();
    screen.run_steps(2);
    screen.key_press_modifiers(Modifiers::COMMAND, Key::A);
    screen.event(Event::Text(text.to_owned()));
    screen.run_steps(3);
}

fn formula(screen: &mut Screen<'_>, text: &str) {
    write(screen, &format!("Formula: {FORCE}"), text);
}

fn can_be_used(screen: &Screen<'_>) -> bool {
    let name = format!("Use: {FORCE}");
    let button = screen.get_by_role_and_label(Role::Button, &name);
    !button.accesskit_node().is_disabled()
}

#[test]
fn a_formula_is_typed_told_what_is_wrong_used_in_the_cut_and_taken_back() {
    for size in SIZES {
        let mut screen = card(size);
        let before = current(&screen).clone();
        press(&mut screen, &format!("Type: {FORCE}"));
        assert!(texts(&screen).contains("N of the feed in mm/min and the speed in 1/min"));
        assert!(can_be_used(&screen), "it begins with one that does: {}", texts(&screen));
        for (text, said) in [
            ("390 - 182*(f/256)^-0.25 - 5*q", "column 29"),
            ("390 - 182*(f/256", "column"),
            ("300 + ln(f - 200)", "not certain"),
        ] {
            formula(&mut screen, text);
            assert!(texts(&screen).contains(said), "{text}: {said}: {}", texts(&screen));
            assert!(!can_be_used(&screen), "{text}");
        }
        formula(&mut screen, "380 - 180*(f/256)^-0.25 - 0.6*(n/1024)^3");
        write(&mut screen, &format!("f from: {FORCE}"), "700");
        assert!(texts(&screen).contains("700 is not below 600"), "{}", texts(&screen));
        assert!(!can_be_used(&screen));
        write(&mut screen, &format!("f from: {FORCE}"), "100");
        assert!(texts(&screen).contains("N there") && can_be_used(&screen), "{}", texts(&screen));
        assert_eq!(*current(&screen), before, "nothing acts before it is used");

        press(&mut screen, &format!("Use: {FORCE}"));
        let now = current(&screen).clone();
        assert_eq!(now.plant.calibration, Calibration::Formula);
        assert_eq!(now.belief.calibration, Calibration::Formula);
        let own = now.formula.force.get().expect("the formula");
        assert_eq!(own.inputs()[0].range.low, 100.0);
        assert_eq!(own.source(), "typed in the console");
        // In the running cut: the scenario itself is as it was.
        let session = console(&screen).session();
        assert_eq!(session.scenario().plant.calibration, Calibration::Identified);
        assert_eq!(session.edits().list().len(), 3);
        assert!(texts(&screen).contains("380 - 180 · (f / 256)^{-0.25}"), "{}", texts(&screen));

        // The field that was written in is gone, and has the keys no more.
        screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        screen.run_steps(3);
        assert_eq!(*current(&screen), before, "one step of undo");
        console(&screen).push(Command::Session(SessionCommand::Redo));
        screen.run_steps(3);
        assert_eq!(current(&screen).plant.calibration, Calibration::Formula);
        press(&mut screen, &format!("Remove: {FORCE}"));
        assert!(current(&screen).formula.force.get().is_none());
        assert_eq!(current(&screen).plant.calibration, Calibration::Identified);
        assert_eq!(current(&screen).belief.calibration, Calibration::Identified);
        assert!(console(&screen).messages().next().is_none(), "nothing was refused");
    }
}

#[test]
fn a_formula_typed_for_another_cutter_holds_for_that_one() {
    let square = Value::Text("square-12-4".to_owned());
    let mut screen = open("table3-5", SIZES[0], "Block diagram", &[("tool.name", square)]);
    screen.get_by_role_and_label(Role::Button, "Cutting process K4").click_accesskit();
    screen.run_steps(3);
    assert!(texts(&screen).contains("of the papers' cutter alone"), "{}", texts(&screen));
    press(&mut screen, &format!("Type: {FORCE}"));
    press(&mut screen, &format!("Use: {FORCE}"));
    let own = current(&screen).formula.force.get().expect("the formula").clone();
    assert_eq!(own.tool(), Some(ShippedTool::Square12));
    assert!(!texts(&screen).contains("cutter alone"), "{}", texts(&screen));
    let ball = Value::Text("ball-10-2".to_owned());
    console(&screen).push(Command::set("tool.name", ball));
    screen.run_steps(3);
    assert!(texts(&screen).contains("of the cutter square-12-4 alone"), "{}", texts(&screen));
}

#[test]
fn what_is_begun_can_be_cancelled() {
    let mut screen = card(SIZES[0]);
    let before = current(&screen).clone();
    press(&mut screen, &format!("Type: {FORCE}"));
    formula(&mut screen, "200 + 0*f + 0*n");
    press(&mut screen, &format!("Cancel: {FORCE}"));
    assert!(screen.query_by_role_and_label(Role::Button, &format!("Use: {FORCE}")).is_none());
    assert_eq!(*current(&screen), before);
}

#[test]
fn choosing_own_formulas_without_one_says_what_to_do() {
    let mut screen = card(SIZES[0]);
    screen.get_by_role_and_label(Role::ComboBox, "Calibration").click();
    screen.run_steps(3);
    screen.get_by_role_and_label(Role::Button, "own formulas").click();
    screen.run_steps(3);
    let said: Vec<&str> = console(&screen).messages().collect();
    assert!(said.iter().any(|said| said.contains("`formula.force`")), "{said:?}");
    assert_eq!(current(&screen).plant.calibration, Calibration::Identified);
}

#[test]
fn a_file_of_a_formula_is_taken_or_refused_by_name() {
    let file = |text: &str| {
        Command::Session(SessionCommand::LoadFormula {
            path: "formula.force".to_owned(),
            name: "mine.toml".to_owned(),
            text: text.to_owned(),
        })
    };
    let good = "version = 1\nformula = \"300 - 9000/f - n/50\"\n[output]\nname = \"F\"\nunit = \"N\"\n\
                [[inputs]]\nname = \"f\"\nunit = \"mm/min\"\nlow = 100\nhigh = 600\n\
                [[inputs]]\nname = \"n\"\nunit = \"1/min\"\nlow = 800\nhigh = 2500\n";
    let mut screen = card(SIZES[0]);
    console(&screen).push(file(&good.replace("n/50", "m/50")));
    screen.run_steps(3);
    let said: Vec<&str> = console(&screen).messages().collect();
    assert!(
        said.iter().any(|said| said.contains("mine.toml") && said.contains("column")),
        "{said:?}"
    );
    console(&screen).push(file(&good.replace("\"N\"", "\"um\"")));
    screen.run_steps(3);
    let said: Vec<&str> = console(&screen).messages().collect();
    assert!(said.iter().any(|said| said.contains("allowed is N of the feed")), "{said:?}");
    console(&screen).push(file(good));
    screen.run_steps(3);
    assert_eq!(current(&screen).plant.calibration, Calibration::Formula);
}

/// Desktop and phone, as a formula with a fault is written. `UPDATE_SNAPSHOTS=1` renews the pictures.
#[test]
fn the_editor_looks_as_its_pictures() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, name) in SIZES.into_iter().zip(["desktop", "phone"]) {
        for theme in [Theme::Light, Theme::Dark] {
            let mut screen = card(size);
            screen.ctx.set_theme(theme);
            press(&mut screen, &format!("Type: {FORCE}"));
            formula(&mut screen, "390 - 182*(f/256)^-0.25 - 5*q");
            let field = format!("Use: {FORCE}");
            screen.get_by_role_and_label(Role::Button, &field).scroll_to_me();
            screen.run_steps(20);
            rest(&mut screen);
            let look = if theme == Theme::Light { "light" } else { "dark" };
            let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
            let picture = format!("formula-{name}-{look}");
            results.add(screen.try_snapshot_options(picture, &options));
        }
    }
}
