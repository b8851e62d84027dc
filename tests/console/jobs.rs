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
use steadycut::run::{Start, presets};

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

/// The screen "Compare" on a scenario that its runs take some time for; on threads or in slices.
fn compare<'a>(size: Vec2, threads: bool) -> Screen<'a> {
    let mut scenario = presets::load("table3-5-noise").expect("shipped");
    scenario.set("run.duration_s", Value::Float(12.0)).expect("a valid setting");
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
    show(&mut screen, "Compare");
    screen
}

/// Frames until `reached`, with time for threads between them.
fn until(screen: &mut Screen<'_>, reached: impl Fn(&Screen<'_>) -> bool) {
    for _ in 0..2000 {
        screen.run_steps(1);
        if reached(screen) {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("{}", texts(screen));
}

fn at_rest(screen: &Screen<'_>) -> bool {
    screen.query_by_label("1 job at work").is_none()
}

#[test]
fn a_comparison_goes_on_while_another_screen_is_shown() {
    let mut tables = Vec::new();
    for size in SIZES {
        for threads in [true, false] {
            let mut screen = compare(size, threads);
            click(&mut screen, "Part: Open scenario");
            click(&mut screen, "Run the comparison");
            show(&mut screen, "Block diagram");
            assert!(!at_rest(&screen), "{}", texts(&screen));
            until(&mut screen, at_rest);
            show(&mut screen, "Compare");
            let shown = texts(&screen);
            assert!(shown.contains("\ndone") && shown.contains("180 of 180 runs"), "{shown}");
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
        click(&mut screen, "Run the comparison");
        // From the keyboard.
        screen.get_by_role_and_label(Role::Button, "1 job at work").focus();
        screen.run_steps(1);
        screen.key_press(Key::Enter);
        screen.run_steps(2);
        let shown = texts(&screen);
        assert!(shown.contains("Compare: Experiment 2"), "{shown}");
        assert!(shown.contains(" of 189 runs"), "load steps and runs: {shown}");
        until(&mut screen, |screen| texts(screen).contains(" left"));
        // The load steps come first: one of them is to be there.
        until(&mut screen, |screen| !texts(screen).contains("Not run yet"));
        click(&mut screen, "Stop Compare: Experiment 2");
        assert!(at_rest(&screen));
        screen.run_steps(3);
        let shown = texts(&screen);
        assert!(shown.contains("Overshoot") && shown.contains("of 180 runs done"), "{shown}");
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
