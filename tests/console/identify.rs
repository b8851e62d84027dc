//! The screen "Identify", driven by its accessible names.

use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{SnapshotOptions, SnapshotResults};
use steadycut::app::command::{Command, FileCommand, SessionCommand};
use steadycut::app::panels::BroughtFile;
use steadycut::base::settings::Value;
use steadycut::models::genetic::Calibration;
use steadycut::run::job::{Budget, Job};
use steadycut::run::scenario::Scenario;
use steadycut::study::experiment::way::job::WayJob;
use steadycut::study::experiment::way::{CUTS_2007, WaySettings};
use steadycut::study::identify::gp::job::{GpJob, GpSettings};
use steadycut::study::identify::gp::problem::GpProblem;
use steadycut::study::identify::gp::report::GpReport;
use steadycut::study::published::PaperId;

use crate::drawn;
use crate::screen::{self, Screen, show, texts};

/// High enough to show all of it.
const SIZES: [Vec2; 2] = [vec2(1280.0, 1700.0), vec2(390.0, 4200.0)];
const BATCHES: u64 = 12;

fn open<'a>(size: Vec2) -> Screen<'a> {
    screen::open("first-cut", size, "Identify", &[])
}

fn click(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(3);
}

fn push(screen: &mut Screen<'_>, command: Command) {
    screen.state().as_ref().unwrap().push(command);
    screen.run_steps(3);
}

fn set(screen: &mut Screen<'_>, name: &str, value: f64) {
    screen.get_by_role_and_label(Role::SpinButton, name).set_value_accesskit(value);
    screen.run_steps(2);
}

fn scenario<'a>(screen: &'a Screen<'_>) -> &'a Scenario {
    screen.state().as_ref().unwrap().session().scenario()
}

fn enabled(screen: &Screen<'_>, name: &str) -> bool {
    !screen.get_by_role_and_label(Role::Button, name).accesskit_node().is_disabled()
}

fn problem(text: &str, target: &str, inputs: &[&str]) -> GpProblem {
    let inputs: Vec<String> = inputs.iter().map(|&input| input.to_owned()).collect();
    GpProblem::read(text, target, &inputs).unwrap()
}

/// What the screen asks for at first: the feed of a force in the table of 2007.
fn first() -> GpProblem {
    problem(PaperId::Sdnrp2007.text(), "feed_final_mm_min", &["force_final_n"])
}

fn job(problem: GpProblem, seed: u64, batches: u64) -> GpJob {
    GpJob::new(problem, &GpSettings { seed, batches, paper: None }).unwrap()
}

fn report(problem: GpProblem, seed: u64, batches: u64) -> GpReport {
    let mut job = job(problem, seed, batches);
    job.to_end();
    job.report()
}

fn brought(name: &str, text: &str) -> Command {
    let (name, text) = (name.to_owned(), text.to_owned());
    Command::File(FileCommand::Bring(BroughtFile::Table { name, text }))
}

/// Searches to the end.
fn searched<'a>(size: Vec2) -> Screen<'a> {
    let mut screen = open(size);
    set(&mut screen, "Most batches", BATCHES as f64);
    click(&mut screen, "Search");
    screen::rest(&mut screen);
    screen
}

#[test]
fn a_search_comes_to_the_front_of_the_engine_whatever_the_window() {
    let report = report(first(), 1, BATCHES);
    for size in SIZES {
        let mut screen = open(size);
        assert!(texts(&screen).contains("No formula was searched for yet"), "{}", texts(&screen));
        set(&mut screen, "Most batches", BATCHES as f64);
        click(&mut screen, "Search");
        // It goes on beside another screen.
        show(&mut screen, "Console");
        assert!(screen.query_by_label("1 job at work").is_some(), "{}", texts(&screen));
        show(&mut screen, "Identify");
        screen::rest(&mut screen);
        let shown = texts(&screen);
        assert!(shown.contains(&format!("Digest {}", report.digest)), "{shown}");
        assert!(shown.contains(&format!("done after {} batches", report.batches)), "{shown}");
        for found in &report.front {
            let name = format!("Formula of size {}", found.size);
            assert!(screen.query_by_role_and_label(Role::Button, &name).is_some(), "{shown}");
        }
        let chosen = report.chosen().unwrap();
        let title = format!("Formula of size {}, the one chosen", chosen.size);
        assert!(shown.contains(&title), "{shown}");
        assert!(shown.contains("Outside Force, end 166.5..195.2 it says nothing"), "{shown}");
        assert!(shown.contains("There it is certain to be finite"), "{shown}");
        for outlier in &report.outliers {
            assert!(shown.contains(&format!("Row {} does not fit", outlier.row)), "{shown}");
        }
        let left_out = format!("left over over row: 10 rows, {} of them", report.outliers.len());
        assert!(shown.contains(&left_out), "{shown}");
        assert!(shown.contains(&format!("Tree of the formula, {} parts", chosen.size)), "{shown}");
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

#[test]
fn any_formula_of_the_front_is_picked_used_in_the_cut_and_taken_back() {
    let report = report(first(), 1, BATCHES);
    let other = report.front.iter().find(|found| found.size > 5 && found.certified).unwrap();
    assert!(!other.chosen);
    for size in SIZES {
        let mut screen = searched(size);
        // From the keyboard.
        let name = format!("Formula of size {}", other.size);
        screen.get_by_role_and_label(Role::Button, &name).focus();
        screen.run_steps(1);
        screen.key_press(Key::Enter);
        screen.run_steps(3);
        assert!(!texts(&screen).contains(", the one chosen"), "{}", texts(&screen));
        assert!(texts(&screen).contains(&format!("Tree of the formula, {} parts", other.size)));
        let before = scenario(&screen).clone();
        click(&mut screen, "Use in the cut: Feed for a force");
        let with = scenario(&screen);
        let model = with.formula.feed.get().expect("a formula");
        assert_eq!(model.formula().to_string(), other.formula);
        assert_eq!(model.output().unit.to_string(), "mm/min");
        // The plant has no model of the feed for a force: that is the controller's.
        let calibrations = [with.plant.calibration, with.belief.calibration];
        assert_eq!(calibrations, [before.plant.calibration, Calibration::Formula]);
        let shown = texts(&screen);
        assert!(shown.contains("In the running cut: Feed for a force"), "{shown}");
        screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        screen.run_steps(3);
        assert_eq!(*scenario(&screen), before, "one step takes all of it back");
        assert!(!texts(&screen).contains("In the running cut"), "{}", texts(&screen));
    }
}

#[test]
fn a_click_into_the_picture_picks_the_formula_that_is_nearest() {
    let mut screen = searched(SIZES[0]);
    let front = screen.get_by_label_contains("Front: error").rect();
    // The smallest formula has the largest error: at the upper left.
    let at = front.left_top() + vec2(26.0, 40.0);
    screen.hover_at(at);
    screen.run_steps(1);
    screen.drag_at(at);
    screen.run_steps(1);
    screen.drop_at(at);
    screen.run_steps(3);
    let smallest = report(first(), 1, BATCHES).front[0].size;
    let shown = texts(&screen);
    assert!(shown.contains(&format!("Tree of the formula, {smallest} parts")), "{shown}");
}

/// The batch that the search under way is at.
fn batch(screen: &Screen<'_>) -> u64 {
    let shown = texts(screen);
    let told = shown.split_once("batch ").and_then(|(_, rest)| rest.split(' ').next());
    told.and_then(|number| number.parse().ok()).unwrap_or(0)
}

/// Waits for a batch or a later one: one may come and go between two frames.
fn come_to(screen: &mut Screen<'_>, number: u64) {
    while batch(screen) < number {
        screen.run_steps(1);
    }
}

#[test]
fn a_search_is_paused_gone_on_with_and_ended_early_and_loses_nothing() {
    for size in SIZES {
        let mut screen = open(size);
        set(&mut screen, "Most batches", BATCHES as f64);
        click(&mut screen, "Search");
        come_to(&mut screen, 2);
        click(&mut screen, "Pause the search");
        screen.run_steps(3);
        let paused = texts(&screen);
        assert!(paused.contains("paused") && paused.contains(", so far"), "{paused}");
        screen.run_steps(10);
        assert_eq!(texts(&screen), paused, "it stands still");
        click(&mut screen, "Go on with the search");
        screen::rest(&mut screen);
        let whole = report(first(), 1, BATCHES);
        assert!(texts(&screen).contains(&whole.digest), "{}", texts(&screen));
        assert!(!enabled(&screen, "End here") && !enabled(&screen, "Go on with the search"));
    }
    let mut screen = open(SIZES[0]);
    click(&mut screen, "Search");
    come_to(&mut screen, 3);
    click(&mut screen, "Pause the search");
    let stood = batch(&screen);
    click(&mut screen, "End here");
    screen::rest(&mut screen);
    let short = report(first(), 1, stood);
    let shown = texts(&screen);
    assert!(shown.contains(&short.digest), "{stood}: {shown}");
}

#[test]
fn what_is_changed_meanwhile_is_said_and_begins_anew_only_when_asked() {
    let mut screen = searched(SIZES[0]);
    assert!(!enabled(&screen, "Begin anew"));
    set(&mut screen, "Seed", 5.0);
    let shown = texts(&screen);
    assert!(shown.contains("Changed since this search was begun: seed."), "{shown}");
    let [old, new] = [1, 5].map(|seed| report(first(), seed, BATCHES).digest);
    assert!(shown.contains(&old));
    click(&mut screen, "Set back");
    assert!(!texts(&screen).contains("Changed since"), "{}", texts(&screen));
    set(&mut screen, "Seed", 5.0);
    click(&mut screen, "Begin anew");
    screen::rest(&mut screen);
    assert!(texts(&screen).contains(&new), "{new} in {}", texts(&screen));
    // What cannot be searched is not begun.
    click(&mut screen, "Force, end: input");
    assert!(!enabled(&screen, "Begin anew"));
    assert!(texts(&screen).contains("choose at least one column"), "{}", texts(&screen));
}

#[test]
fn a_table_that_is_dropped_is_taken_or_refused_with_line_and_column() {
    let table = "x,y,word\n1,3.1,a\n2,4.9,b\n3,7.2,c\n4,8.8,d\n5,11.1,e\n6,12.9,f\n";
    for size in SIZES {
        let mut screen = open(size);
        show(&mut screen, "Console");
        push(&mut screen, brought("bad.csv", "x,y\n1,2\n2,three\n3,4\n"));
        let shown = texts(&screen);
        // All that is wrong with it at once.
        for said in [
            "not opened: bad.csv: 3 rows: at least 5 are needed; ",
            "a target and an input need two columns of numbers: line 3: `y` is `three`",
        ] {
            assert!(shown.contains(said), "{shown}");
        }
        assert!(shown.contains("SDNRP 2007, Table 3: 10 rows"), "the table before stays: {shown}");
        push(
            &mut screen,
            brought("a table with a name that is far too long for a button.csv", table),
        );
        let shown = texts(&screen);
        assert!(!shown.contains("bad.csv") && shown.contains("6 rows, 3 columns"), "{shown}");
        assert!(shown.contains("left out: line 2: `word` is `a`"), "{shown}");
        assert!(shown.contains("choose the column that the formula is to give"), "{shown}");
        assert!(!enabled(&screen, "Search"));
        click(&mut screen, "y: target");
        click(&mut screen, "x: input");
        set(&mut screen, "Most batches", 4.0);
        // Only with known units.
        screen.get_by_label("Only formulas that are right in their units").click_accesskit();
        screen.run_steps(3);
        assert!(texts(&screen).contains("the unit of `y` is not known"), "{}", texts(&screen));
        screen.get_by_label("Only formulas that are right in their units").click_accesskit();
        screen.run_steps(3);
        click(&mut screen, "Search");
        screen::rest(&mut screen);
        let digest = report(problem(table, "y", &["x"]), 1, 4).digest;
        let shown = texts(&screen);
        assert!(shown.contains(&digest), "{digest} in {shown}");
        // Without units no place of the cut is meant.
        assert!(shown.contains("The cut has no place for it by its units"), "{shown}");
    }
}

#[test]
fn a_saved_search_is_gone_on_with_where_it_is_the_same() {
    let mut begun = job(first(), 1, BATCHES);
    while begun.search().batches() < 4 {
        assert!(!begun.advance(&Budget::steps(100)));
    }
    let (name, text) = ("mine.json".to_owned(), begun.state_text());
    let file = Command::File(FileCommand::Bring(BroughtFile::Search { name, text }));
    let mut screen = open(SIZES[0]);
    set(&mut screen, "Most batches", BATCHES as f64);
    set(&mut screen, "Seed", 2.0);
    push(&mut screen, file.clone());
    let shown = texts(&screen);
    assert!(shown.contains("mine.json: the search was of another table"), "{shown}");
    set(&mut screen, "Seed", 1.0);
    push(&mut screen, file);
    screen::rest(&mut screen);
    let shown = texts(&screen);
    assert!(!shown.contains("mine.json"), "{shown}");
    assert!(shown.contains(&report(first(), 1, BATCHES).digest), "{shown}");
}

#[test]
fn a_formula_that_the_open_scenario_has_no_use_for_says_why() {
    let mut screen = searched(SIZES[0]);
    push(&mut screen, Command::Session(SessionCommand::LoadPreset("experiment-2".to_owned())));
    let shown = texts(&screen);
    assert!(shown.contains("Use in the cut: Feed for a force: a run has no use for it"), "{shown}");
    let path = "target.ra_um";
    push(&mut screen, Command::set(path, Value::Float(0.9)));
    push(&mut screen, Command::Session(SessionCommand::LoadPreset("first-cut".to_owned())));
    assert!(enabled(&screen, "Use in the cut: Feed for a force"));
}

#[test]
fn the_whole_way_goes_from_cuts_to_a_controller_that_cuts() {
    let settings = WaySettings { batches: BATCHES, ..WaySettings::default() };
    let mut job = WayJob::new(&settings).unwrap();
    job.to_end();
    let report = job.partial();
    for size in SIZES {
        let mut screen = open(size);
        set(&mut screen, "Most batches", BATCHES as f64);
        click(&mut screen, "Go the whole way");
        screen::rest(&mut screen);
        let shown = texts(&screen);
        assert!(shown.contains(&format!("Digest {}", report.digest)), "{shown}");
        assert!(shown.contains(&format!("{CUTS_2007} of {CUTS_2007} cuts measured")), "{shown}");
        for found in &report.models {
            assert!(shown.contains(&found.formula), "{}: {shown}", found.formula);
        }
        for one in &report.summary {
            let worst = one.worst_percent.expect("a Ra in every row");
            let text = format!(" on {}: off by {worst:.1} %", one.models.label());
            assert!(shown.contains(&text), "{text}: {shown}");
        }
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
        let picture = if size == SIZES[0] { "way-desktop-dark" } else { "way-phone-dark" };
        if drawn::in_software() {
            let options = SnapshotOptions::default();
            screen.try_snapshot_options(picture, &options).unwrap();
        }
        click(&mut screen, "Its cuts as the table");
        let shown = texts(&screen);
        assert!(shown.contains(&format!("cuts of the way: {CUTS_2007} rows")), "{shown}");
        click(&mut screen, "Cut with its models");
        let with = scenario(&screen);
        assert_eq!(with.belief.calibration, Calibration::Formula);
        assert!(with.formula.feed.get().is_some() && with.formula.ra.get().is_some());
    }
}

#[test]
fn it_looks_the_same_as_before() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    let sizes = [("desktop", vec2(1280.0, 1300.0)), ("phone", vec2(390.0, 2900.0))];
    for (name, size) in sizes {
        for (theme, of) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
            let mut screen = searched(size);
            screen.ctx.set_theme(theme);
            screen.run_steps(4);
            let shown = format!("identify-front-{name}-{of}");
            results.add(screen.try_snapshot_options(shown, &SnapshotOptions::default()));
        }
    }
}
