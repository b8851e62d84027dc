//! Long work of the screens: it goes on when its screen is left, is listed in the bar, and can be stopped
//! there.

use std::time::{Duration, Instant};

use egui::accesskit::Role;
use egui::{Key, Theme, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::jobs::Jobs;
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::job::{Budget, Job, Progress};
use steadycut::run::revolution::revolution;
use steadycut::run::scenario::Scenario;
use steadycut::run::{Start, presets};
use steadycut::study::plan::PlanJob;

use crate::drawn;
use crate::screen::{self, Screen, show, texts};

const SIZES: [Vec2; 2] = [vec2(1280.0, 800.0), vec2(390.0, 844.0)];

fn jobs<'a>(screen: &'a Screen<'_>) -> &'a Jobs {
    screen.state().as_ref().expect("made in the first frame").jobs()
}

fn click(screen: &mut Screen<'_>, name: &str) {
    // By its name alone: it may be scrolled out of sight.
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(2);
}

/// The screen with this title on a scenario; work on threads or in slices.
fn open<'a>(scenario: Scenario, size: Vec2, threads: bool, title: &str) -> Screen<'a> {
    let mut screen = Harness::builder().with_size(size).with_step_dt(0.05).build_ui_state(
        move |ui, console: &mut Option<Console>| {
            let console = console.get_or_insert_with(|| {
                let start =
                    Start { scenario: scenario.clone(), edits: Edits::none(), notice: None };
                let console = Console::new(ui.ctx(), start);
                if threads { console } else { screen::sliced(console) }
            });
            console.ui(ui);
        },
        None,
    );
    screen.run_steps(2);
    show(&mut screen, title);
    screen
}

/// The screen "Compare" on a scenario that its runs take some time for.
fn compare<'a>(size: Vec2, threads: bool) -> Screen<'a> {
    let mut scenario = presets::load("table3-5-noise").expect("shipped");
    scenario.set("run.duration_s", Value::Float(12.0)).expect("a valid setting");
    open(scenario, size, threads, "Compare")
}

/// Frames until `reached`, with time for threads between them.
fn until(screen: &mut Screen<'_>, reached: impl Fn(&Screen<'_>) -> bool) {
    let done = screen::in_time(|| {
        screen.run_steps(1);
        std::thread::sleep(Duration::from_millis(5));
        reached(screen)
    });
    assert!(done, "{}", texts(screen));
}

fn at_rest(screen: &Screen<'_>) -> bool {
    jobs(screen).is_at_rest()
}

#[test]
fn a_comparison_goes_on_while_another_screen_is_shown() {
    let mut tables = Vec::new();
    for size in SIZES {
        for threads in [true, false] {
            let mut screen = compare(size, threads);
            click(&mut screen, "Run the comparison");
            show(&mut screen, "Block diagram");
            assert!(!at_rest(&screen), "{}", texts(&screen));
            until(&mut screen, at_rest);
            show(&mut screen, "Compare");
            let shown = texts(&screen);
            assert!(shown.contains("\ndone") && shown.contains("240 of 240 runs"), "{shown}");
            if size == SIZES[0] {
                tables.push(shown.lines().filter(|line| line.contains('±')).collect::<String>());
            }
        }
    }
    assert_eq!(tables[0], tables[1], "threads and slices give the same table");
    assert!(tables[0].len() > 100);
}

#[test]
fn the_list_names_the_work_and_its_button_stops_it_and_keeps_what_was_found() {
    for size in SIZES {
        let mut screen = compare(size, true);
        click(&mut screen, "Part: Experiment 2");
        click(&mut screen, "Run the comparison");
        // From the keyboard.
        screen.get_by_role_and_label(Role::Button, "1 job at work").focus();
        screen.run_steps(1);
        screen.key_press(Key::Enter);
        screen.run_steps(2);
        let shown = texts(&screen);
        assert!(shown.contains("Compare: Experiment 2"), "{shown}");
        // One count here and there, of the runs over the seeds.
        assert!(shown.contains("0 of 180 runs") && !shown.contains("189"), "{shown}");
        // The load steps come first: one of them is to be there.
        assert!(shown.contains("of 9, then 180 runs"), "{shown}");
        until(&mut screen, |screen| !texts(screen).contains("Not run yet"));
        click(&mut screen, "Stop Compare: Experiment 2");
        assert!(at_rest(&screen));
        screen.run_steps(3);
        let shown = texts(&screen);
        assert!(shown.contains("Overshoot") && shown.contains("of 180 runs done"), "{shown}");
        // It can be taken back where it was done.
        assert!(
            shown.contains("what is found stays") && shown.contains("1 job stopped"),
            "{shown}"
        );
        click(&mut screen, "Go on with Compare: Experiment 2");
        assert!(!at_rest(&screen));
        click(&mut screen, "Stop Compare: Experiment 2");
        assert!(screen.query_by_label("Run the comparison").is_some());
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

#[test]
#[expect(clippy::disallowed_methods, reason = "a test of times")]
fn no_frame_waits_for_the_work() {
    let mut screen = compare(SIZES[0], true);
    // The median, and what nine of ten frames keep to.
    let times = |screen: &mut Screen<'_>| {
        let frame = |_| {
            let start = Instant::now();
            screen.run_steps(1);
            start.elapsed().as_secs_f64()
        };
        let mut all: Vec<f64> = (0..60).map(frame).collect();
        all.sort_by(f64::total_cmp);
        [all[30], all[54]]
    };
    let idle_s = times(&mut screen);
    click(&mut screen, "Run the comparison");
    let working_s = times(&mut screen);
    assert!(!at_rest(&screen));
    eprintln!("a frame: idle {idle_s:.4?} s, while Compare runs {working_s:.4?} s");
    // Threads share the cores with the frames; before there were threads a frame had 40 ms of work in it.
    assert!(working_s[1] < 3.0 * idle_s[1] + 0.02, "{idle_s:?} s idle, {working_s:?} s at work");
}

/// A plan with a swarm that takes its time.
fn large_swarm() -> Scenario {
    let mut scenario = presets::load("first-cut").expect("shipped");
    let changes = [("plan.particles", 500), ("plan.iterations", 1000), ("plan.stop_after", 1000)];
    let changes = changes.map(|(path, value)| (path.to_owned(), Value::Int(value)));
    scenario.set_all(&changes).expect("valid settings");
    scenario
}

#[test]
fn the_search_of_a_plan_goes_on_beside_other_screens_and_is_stopped_in_the_list() {
    let scenario = large_swarm();
    let plan = PlanJob::complete(&scenario).unwrap();
    let found = format!("{:.1} N", plan.optimum().force_n);
    for size in SIZES {
        for threads in [true, false] {
            let mut screen = open(scenario.clone(), size, threads, "Plan");
            show(&mut screen, "Block diagram");
            if !threads {
                // A frame does a part of it that is known: there is time to stop it.
                click(&mut screen, "1 job at work");
                let shown = texts(&screen);
                assert!(shown.contains(" of 1000 iterations, "), "with the time left: {shown}");
                click(&mut screen, "Stop Plan: search of the swarm");
                assert!(at_rest(&screen));
                show(&mut screen, "Plan");
                let shown = texts(&screen);
                assert!(shown.contains("stopped: iteration"), "{shown}");
                assert!(!shown.contains("stopped: iteration 0 "), "nothing is lost: {shown}");
                click(&mut screen, "Move the swarm");
                show(&mut screen, "Block diagram");
            }
            until(&mut screen, at_rest);
            // What was found meanwhile is shown at once.
            show(&mut screen, "Plan");
            let shown = texts(&screen);
            assert!(shown.contains("done: iteration 1000"), "{shown}");
            assert!(shown.contains(&found), "{found} in {shown}");
        }
    }
}

#[test]
fn a_changed_setting_gives_the_search_up_and_begins_that_of_the_new_plan() {
    let mut screen = open(large_swarm(), SIZES[0], false, "Plan");
    assert!(!at_rest(&screen));
    screen.get_by_role_and_label(Role::Slider, "Target Ra").set_value_accesskit(1.5);
    screen.run_steps(2);
    assert!(screen.query_by_label("2 jobs at work").is_none(), "{}", texts(&screen));
    let mut scenario = large_swarm();
    scenario.set("target.ra_um", Value::Float(1.5)).unwrap();
    click(&mut screen, "To the end");
    until(&mut screen, at_rest);
    screen.run_steps(2);
    let found = format!("{:.1} N", PlanJob::complete(&scenario).unwrap().optimum().force_n);
    assert!(texts(&screen).contains(&found), "{found} in {}", texts(&screen));
}

#[test]
fn the_picture_of_a_revolution_is_made_beside_another_screen() {
    for threads in [true, false] {
        let mut scenario = presets::load("experiment-1").expect("shipped");
        scenario.change(|settings| settings.run.duration_s = 3.0).expect("a valid setting");
        let mut screen = open(scenario, SIZES[0], threads, "Console");
        let session = |screen: &Screen<'_>| screen.state().as_ref().unwrap().session().progress();
        screen.key_press(Key::Space);
        until(&mut screen, |screen| session(screen) >= 1.0);
        screen.key_press(Key::End);
        screen.run_steps(2);
        // Begun in one frame, and left in the next.
        screen.get_by_label("Within a revolution\u{2026}").click_accesskit();
        screen.run_steps(2);
        let shown = texts(&screen);
        assert!(!shown.contains("was not simulated tooth by tooth"), "{shown}");
        show(&mut screen, "Papers");
        screen::rest(&mut screen);
        show(&mut screen, "Console");
        let console = screen.state().as_ref().unwrap();
        let run = console.session().chosen().run();
        let found = revolution(run, console.session().playback().playhead_s, 1).unwrap();
        let peak_n = found.samples[found.peak.unwrap()].fxy_n();
        let shown = texts(&screen);
        assert!(shown.contains(&format!("{peak_n:.1} N at")), "{peak_n} N in {shown}");
        assert!(jobs(&screen).is_at_rest(), "nothing was begun again");
    }
}

/// Work that stands where it is.
struct Still(Progress);

impl Job for Still {
    type Partial = ();

    fn advance(&mut self, _: &Budget<'_>) -> bool {
        false
    }

    fn progress(&self) -> Progress {
        self.0
    }

    fn partial(&self) {}
}

#[test]
fn the_list_looks_the_same_as_before() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, name) in SIZES.into_iter().zip(["desktop", "phone"]) {
        for theme in [Theme::Light, Theme::Dark] {
            let mut screen = compare(size, false);
            screen.ctx.set_theme(theme);
            let progress = |done, total, unit| Progress { done, total, unit };
            let runs = Still(progress(37.4, 189.0, "runs"));
            let points = Still(progress(9_200.0, 14_383.0, "points of time"));
            let _work = (
                jobs(&screen).begin("Compare: Experiment 2", runs, 1),
                jobs(&screen).begin("Trends over the tool life", points, 1),
            );
            screen.run_steps(2);
            click(&mut screen, "2 jobs at work");
            screen.run_steps(4);
            let shown =
                format!("jobs-{name}-{}", if theme == Theme::Dark { "dark" } else { "light" });
            results.add(screen.try_snapshot_options(shown, &SnapshotOptions::default()));
        }
    }
}
