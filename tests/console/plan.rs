//! The screen "Plan", driven by its accessible names.

use crate::{drawn, screen};

use crate::screen::{Screen, texts};
use egui::accesskit::{Role, Toggled};
use egui::{Key, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::base::settings::Value;
use steadycut::blocks::control::ControllerKind;
use steadycut::models::tool::Tool;
use steadycut::run::edits::Edits;
use steadycut::run::scenario::Scenario;
use steadycut::run::{Start, presets};
use steadycut::study::plan::PlanJob;
use steadycut::study::plan::constraints::CONSTRAINTS;
use steadycut::study::plan::machine::MachineLimits;
use steadycut::study::plan::over_depths::OverDepths;
use steadycut::study::recommend::table::Table;
use steadycut::study::recommend::{Advisor, EngagementCode};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
/// As wide as a phone, and as high as all that stands below each other.
const LONG: Vec2 = vec2(390.0, 3000.0);

/// The screen after a few frames, on a scenario with these changes.
fn open<'a>(size: Vec2, changes: &[(&str, Value)]) -> Screen<'a> {
    let mut screen = screen::open("first-cut", size, "Plan", changes);
    screen.run_steps(1);
    screen
}

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn scenario<'a>(screen: &'a Screen<'_>) -> &'a Scenario {
    console(screen).session().scenario()
}

fn click(screen: &mut Screen, name: &str) {
    screen.get_by_label(name).click();
    screen.run_steps(3);
}

/// To the end of the search.
fn finish(screen: &mut Screen) {
    click(screen, "To the end");
    screen::rest(screen);
}

/// How long will the cut take? The plan's time is that of its own feed, which the controller changes.
#[test]
fn the_time_is_told_as_that_of_constant_feed_and_weights_say_which_way_they_go() {
    for size in [DESKTOP, LONG] {
        for (kind, said) in [("sdnrp", true), ("constant_feed", false)] {
            let kind = ("controller.kind", Value::Text(kind.to_owned()));
            let mut screen = open(size, &[kind]);
            if size == LONG {
                click(&mut screen, "Settings of the plan");
            }
            let shown = texts(&screen);
            assert!(
                shown.contains("Time at this feed") && !shown.contains("Time of cut"),
                "{shown}"
            );
            let text = "kept through the whole cut: SDNRP changes the feed in the cut";
            assert_eq!(shown.contains(text), said, "{shown}");
            assert!(shown.contains("Weight of a large force"), "{shown}");
            assert!(shown.contains("a large force is one near its limit"), "{shown}");
        }
    }
}

/// What will it come to? At every depth of the part, by the plan's network and in the run; the console's force is
/// compared only where it is the planned cut.
#[test]
fn the_plan_is_judged_at_every_depth_by_the_network_and_by_the_run() {
    for size in [DESKTOP, LONG] {
        let mut screen = open(size, &[]);
        finish(&mut screen);
        let optimum = PlanJob::complete(scenario(&screen)).unwrap().optimum();
        let machine = MachineLimits::heller_bea_01();
        let over = OverDepths::of(scenario(&screen), &machine, &optimum);
        assert_eq!(over.depths.len(), 3, "2.2, 2 and 1.9 mm");
        assert!(!over.is_good(), "the run has another force: {:?}", over.lines());
        let shown = texts(&screen);
        for line in over.lines() {
            assert!(shown.contains(&line), "{line} in {shown}");
        }
        let verdict = over.verdict_text(&optimum).replacen("feasible", "Feasible", 1);
        assert!(shown.contains(&format!("{verdict}.")), "{verdict} in {shown}");
        // SDNRP cuts at another feed.
        assert!(!shown.contains("The console's force at the playhead"), "{shown}");
        click(&mut screen, "Cut it at constant feed");
        screen.run_steps(4);
        screen.key_press_modifiers(egui::Modifiers::COMMAND, Key::Num4);
        screen.run_steps(2);
        finish(&mut screen);
        let row = console(&screen).session().row();
        let plan_n = over.force_at_n(row.axial_depth_mm).unwrap();
        let now = format!(
            "The console's force at the playhead is {:.1} N, {:+.1} % against the plan's at its depth, {:.2} mm.",
            row.force_n,
            100.0 * (row.force_n / plan_n - 1.0),
            row.axial_depth_mm,
        );
        let shown = texts(&screen);
        assert!(shown.contains(&now), "{now} in {shown}");
    }
}

/// Is it feasible? For the lightest stretch, and not where the part is deeper: depth and constraint are named.
#[test]
fn the_depth_that_breaks_the_plan_is_named_in_its_verdict() {
    let mut screen = open(DESKTOP, &[("plan.section", Value::Text("lightest".to_owned()))]);
    finish(&mut screen);
    let shown = texts(&screen);
    assert!(shown.contains("Feasible at 1.9 mm depth by the plan's network"), "{shown}");
    assert!(shown.contains("; not at 2.20 mm: Cutting force "), "{shown}");
    assert!(shown.contains("; violated: Cutting force"), "{shown}");
}

fn iteration(screen: &Screen) -> u32 {
    let shown = texts(screen);
    let after = shown.split(": iteration ").nth(1).unwrap_or_else(|| panic!("{shown}"));
    after.split(' ').next().unwrap().parse().unwrap()
}

fn fixed_limit(force_n: f64) -> [(&'static str, Value); 2] {
    let fixed = Value::Text("fixed".to_owned());
    [("plan.force_limit", fixed), ("plan.force_max_n", Value::Float(force_n))]
}

#[test]
fn the_swarm_moves_an_iteration_at_a_time_and_finds_the_optimum() {
    let mut screen = open(DESKTOP, &[]);
    let early = iteration(&screen);
    // 0.06 s an iteration, 0.05 s a frame.
    screen.run_steps(12);
    assert_eq!(iteration(&screen), early + 10);
    assert!(texts(&screen).contains("Best so far"));
    click(&mut screen, "Pause the swarm");
    let paused = iteration(&screen);
    screen.run_steps(12);
    assert_eq!(iteration(&screen), paused);
    click(&mut screen, "One iteration");
    assert_eq!(iteration(&screen), paused + 1);
    finish(&mut screen);
    let job = PlanJob::complete(scenario(&screen)).unwrap();
    assert_eq!(iteration(&screen), job.counts().iteration);
    let shown = texts(&screen);
    let optimum = job.optimum();
    for said in [
        "Optimum".to_owned(),
        optimum.verdict_text().replacen("feasible", "Feasible", 1),
        format!("{:.0} mm/min", optimum.feed_mm_min),
        format!("{:.0} 1/min", optimum.speed_rpm),
        format!("{:.1} N", optimum.force_n),
    ] {
        assert!(shown.contains(&said), "{said} in {shown}");
    }
    click(&mut screen, "Search again");
    assert!(iteration(&screen) < 4);
}

#[test]
fn a_change_of_a_setting_restarts_the_plan_at_once_and_can_be_undone() {
    let mut screen = open(DESKTOP, &[]);
    finish(&mut screen);
    let before = scenario(&screen).clone();
    let playhead_s = console(&screen).session().playback().playhead_s;
    assert!(playhead_s > 0.0, "the cut is running");
    screen.get_by_role_and_label(Role::Slider, "Target Ra").set_value_accesskit(1.5);
    screen.run_steps(2);
    assert!(iteration(&screen) < 4);
    assert_eq!(scenario(&screen).target.ra_um, 1.5, "from the start of the cut on");
    assert!(console(&screen).session().edits().list().is_empty());
    finish(&mut screen);
    let optimum = PlanJob::complete(scenario(&screen)).unwrap().optimum();
    assert!(texts(&screen).contains(&format!("{:.1} N", optimum.force_n)));

    click(&mut screen, "Undo");
    assert_eq!(scenario(&screen), &before);
    assert!(iteration(&screen) < 5);
    click(&mut screen, "Other seed");
    assert_eq!(scenario(&screen).plan.seed, before.plan.seed + 1);
    assert!(iteration(&screen) < 5);
    screen.get_by_role_and_label(Role::Slider, "Weight of a short time").set_value_accesskit(0.5);
    screen.run_steps(2);
    assert_eq!(scenario(&screen).plan.weight_time, 0.5);
    // What the plan does not depend on leaves it alone.
    screen.run_steps(12);
    assert!(iteration(&screen) > 8);
}

#[test]
fn the_optimum_becomes_the_programmed_values_in_one_undoable_change() {
    for size in [DESKTOP, LONG] {
        let mut screen = open(size, &[]);
        let before = scenario(&screen).clone();
        let name = "Use as programmed values";
        assert!(screen.get_by_label(name).accesskit_node().is_disabled(), "still searching");
        finish(&mut screen);
        assert!(texts(&screen).contains("430 mm/min, 1571 1/min, not the optimum"));
        screen.get_by_label(name).click();
        screen.run_steps(3);
        let session = console(&screen).session();
        let optimum = PlanJob::complete(&before).unwrap().optimum();
        assert_eq!(session.scenario(), &optimum.apply(&before).unwrap());
        assert!(session.playback().playing && session.playback().playhead_s < 0.3);
        let row = session.chosen().run().recording().rows()[0];
        assert_eq!([row.feed_mm_min, row.spindle_rpm], [optimum.feed_mm_min, optimum.speed_rpm]);
        assert!(console(&screen).state_json().contains("\"screen\":\"console\""));

        screen.key_press_modifiers(egui::Modifiers::COMMAND, Key::Num4);
        screen.run_steps(2);
        let [feed, speed] = [optimum.feed_mm_min, optimum.speed_rpm];
        let said = format!("{feed:.0} mm/min, {speed:.0} 1/min, the optimum");
        let shown = texts(&screen);
        assert!(shown.contains(&said), "{said} in {shown}");
        screen.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
        screen.run_steps(2);
        assert_eq!(scenario(&screen), &before);
        assert!(!console(&screen).session().can_undo());
    }
}

#[test]
fn recommended_conditions_follow_the_hardness_and_can_be_programmed() {
    let ask = |hardness_hb| {
        let advisor = Advisor::new(&Table::shipped());
        advisor.recommend(hardness_hb, &Tool::default(), EngagementCode::Light).unwrap()
    };
    for (hardness_hb, said) in [(300.0, "inside the table"), (480.0, "its edge answers")] {
        let mut screen = open(DESKTOP, &[("plant.hardness_hb", Value::Float(hardness_hb))]);
        let before = scenario(&screen).clone();
        screen.get_by_label("Recommended conditions").click_accesskit();
        screen.run_steps(6);
        let shown = texts(&screen);
        let found = ask(hardness_hb);
        let speed = format!("{:.1} m/min", found.cutting_speed_m_min.value);
        for said in [said, "light side cut:", "synthetic", &speed] {
            assert!(shown.contains(said), "{said} in {shown}");
        }
        screen.get_by_label("Start from it").click_accesskit();
        screen.run_steps(3);
        let program = &scenario(&screen).program;
        assert_eq!(
            [program.feed_mm_min, program.spindle_rpm],
            [found.feed_mm_min, found.speed_rpm]
        );
        click(&mut screen, "Undo");
        assert_eq!(scenario(&screen), &before);
    }
}

/// What is planned is a cut at one feed: one button cuts just that, the other says who moves the feed on.
#[test]
fn the_planned_cut_can_be_cut_as_it_is_planned() {
    for size in [DESKTOP, LONG] {
        let mut screen = open(size, &[]);
        let before = scenario(&screen).clone();
        finish(&mut screen);
        assert!(texts(&screen).contains("SDNRP moves the feed on from the programmed one at once"));
        click(&mut screen, "Cut it at constant feed");
        let optimum = PlanJob::complete(&before).unwrap().optimum();
        let now = scenario(&screen).clone();
        assert_eq!(now.controller.kind, ControllerKind::ConstantFeed);
        assert_eq!(now.program.feed_mm_min, optimum.feed_mm_min);
        let rows = console(&screen).session().chosen().run().recording().rows();
        assert!(rows.iter().all(|row| row.feed_command_mm_min == optimum.feed_mm_min));
        assert!(texts(&screen).contains("the part is cut from its start, at constant feed"));
        screen.key_press_modifiers(egui::Modifiers::COMMAND, Key::Num4);
        screen.run_steps(2);
        finish(&mut screen);
        assert!(screen.query_by_label("Cut it at constant feed").is_none(), "it is");
        screen.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
        screen.run_steps(2);
        assert_eq!(scenario(&screen), &before, "one step of undo");
    }
}

#[test]
fn where_nothing_is_allowed_nothing_can_be_programmed_and_the_reason_is_told() {
    let mut screen = open(DESKTOP, &fixed_limit(20.0));
    finish(&mut screen);
    let before = scenario(&screen).clone();
    let shown = texts(&screen);
    assert!(shown.contains("Nothing is feasible in the range searched"), "{shown}");
    assert!(shown.contains("Not programmed: nothing is feasible"), "{shown}");
    assert!(shown.contains("Cutting force (violated)"), "{shown}");
    let button = screen.get_by_label("Use as programmed values");
    assert!(button.accesskit_node().is_disabled());
    button.click();
    screen.run_steps(3);
    assert_eq!(scenario(&screen), &before);
    assert!(screen.get_by_label("Zoom to allowed").accesskit_node().is_disabled());
}

#[test]
fn an_error_names_its_setting_and_goes_away_with_it() {
    let zero = |path| (path, Value::Float(0.0));
    for size in [DESKTOP, LONG] {
        let none = (("workpiece.depth_steps"), Value::List(Vec::new()));
        let mut screen = open(size, &[none, zero("workpiece.axial_depth_mm")]);
        let shown = texts(&screen);
        assert!(shown.contains("`workpiece.axial_depth_mm` cannot be 0 mm"), "{shown}");
        assert!(screen.query_by_label("Use as programmed values").is_none());
        assert!(shown.contains("The strategy in eight steps") && shown.contains("no plan"));

        screen = open(size, &[zero("plan.weight_force")]);
        let shown = texts(&screen);
        assert!(shown.contains("`plan.weight_force` cannot be 0"), "{shown}");
        if size == LONG {
            click(&mut screen, "Settings of the plan");
        }
        screen
            .get_by_role_and_label(Role::Slider, "Weight of a large force")
            .set_value_accesskit(1.0);
        screen.run_steps(2);
        assert!(screen.query_by_label("Use as programmed values").is_some());
    }
}

#[test]
fn every_constraint_has_an_entry_and_its_explanation() {
    let mut screen = open(LONG, &fixed_limit(665.0));
    // Fingers get the switches in a list.
    click(&mut screen, "Lines of the map");
    let toggled = |screen: &Screen, name: &str| {
        screen.get_by_role_and_label(Role::CheckBox, name).accesskit_node().toggled()
    };
    assert_eq!(toggled(&screen, "Tool life"), Some(Toggled::True));
    screen.get_by_role_and_label(Role::CheckBox, "Tool life").click();
    screen.run_steps(2);
    assert_eq!(toggled(&screen, "Tool life"), Some(Toggled::False));
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    // Those that do not cross the map are named as such.
    assert!(texts(&screen).contains("Outside the map:"));
    screen.get_by_role_and_label(Role::Label, "Spindle power");
    for constraint in &CONSTRAINTS {
        click(&mut screen, &format!("Explain {}", constraint.label));
        let shown = texts(&screen);
        assert!(shown.contains(constraint.formula), "{} in {shown}", constraint.formula);
        assert!(shown.contains("chosen: the papers cite their list"), "{shown}");
    }
    assert!(texts(&screen).contains("* 3 limits of the machine are placeholders"));
}

#[test]
fn a_click_on_the_map_keeps_the_values_of_that_place() {
    let mut screen = open(LONG, &fixed_limit(100.0));
    let map = screen
        .query_all_by_role(Role::Figure)
        .find(|node| node.accesskit_node().label().is_some_and(|name| name.starts_with("Force")));
    let rect = map.expect("the map").rect();
    let at = rect.lerp_inside(vec2(0.5, 0.2));
    screen.hover_at(at);
    screen.run_steps(2);
    screen.drag_at(at);
    screen.run_steps(1);
    screen.drop_at(at);
    screen.run_steps(3);
    let shown = texts(&screen);
    assert!(shown.contains("violated: Cutting force"), "{shown}");
    assert!(shown.contains("Ra of feed marks"), "{shown}");
    click(&mut screen, "Let go of this place");
    screen.hover_at(egui::pos2(5.0, 5.0));
    screen.run_steps(5);
    assert!(!texts(&screen).contains("Ra of feed marks"));
}

#[test]
fn the_keyboard_moves_the_swarm() {
    let mut screen = open(DESKTOP, &[]);
    let playing = console(&screen).session().playback().playing;
    screen.get_by_label("Pause the swarm").focus();
    screen.run_steps(2);
    screen.key_press(Key::Enter);
    screen.run_steps(2);
    let paused = iteration(&screen);
    screen.run_steps(5);
    assert_eq!(iteration(&screen), paused);
    assert_eq!(console(&screen).session().playback().playing, playing, "the cut is left alone");
}

#[test]
fn a_fixed_speed_is_searched_along_a_line_and_kept() {
    let mut screen = open(DESKTOP, &fixed_limit(665.0));
    assert!(!texts(&screen).contains("the speed searched"));
    click(&mut screen, "Search the speed too");
    assert!(texts(&screen).contains("the speed searched"));
    assert!(!scenario(&screen).plan.free_speed);
    finish(&mut screen);
    let optimum = PlanJob::complete(scenario(&screen)).unwrap().optimum();
    assert_eq!(optimum.cutting_speed_m_min, 80.0);
    screen.get_by_role_and_label(Role::Slider, "Cutting speed");
    assert!(texts(&screen).contains(&format!("{:.0} mm/min", optimum.feed_mm_min)));
}

#[test]
fn the_surface_can_be_seen_and_turned_in_space() {
    for size in [DESKTOP, LONG] {
        let mut screen = open(size, &fixed_limit(665.0));
        let figure = |screen: &Screen, name: &str| {
            let mut nodes = screen.query_all_by_role(Role::Figure);
            nodes.any(|node| node.accesskit_node().label().is_some_and(|x| x.starts_with(name)))
        };
        assert!(figure(&screen, "Force over cutting speed") && !figure(&screen, "Force surface"));
        click(&mut screen, "3-D");
        assert!(figure(&screen, "Force surface in space, turned by 32°"));
        click(&mut screen, "Turn right");
        assert!(figure(&screen, "Force surface in space, turned by 17°"));
        let name = "Force surface in space, turned by 17°, seen 32° from above";
        let rect = screen.get_by_label(name).rect();
        screen.hover_at(rect.center());
        screen.run_steps(2);
        screen.drag_at(rect.center());
        screen.run_steps(1);
        screen.hover_at(rect.center() + vec2(-50.0, 40.0));
        screen.run_steps(1);
        screen.drop_at(rect.center() + vec2(-50.0, 40.0));
        screen.run_steps(1);
        assert!(figure(&screen, "Force surface in space, turned by -6°, seen 50° from above"));
        click(&mut screen, "3-D");
        assert!(figure(&screen, "Force over cutting speed"));
    }
}

/// Pictures of the surface in space. `UPDATE_SNAPSHOTS=1` renews them.
#[test]
fn the_surface_in_space_looks_as_its_picture() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    let builder = Harness::builder().with_size(DESKTOP).with_step_dt(0.05);
    let mut screen: Screen<'_> = builder.wgpu().build_ui_state(
        |ui, console: &mut Option<Console>| {
            let start = || {
                let mut scenario = presets::load("first-cut").expect("shipped");
                scenario
                    .set_all(&fixed_limit(665.0).map(|(path, x)| (path.to_owned(), x)))
                    .unwrap();
                Start { scenario, edits: Edits::none(), notice: None }
            };
            console.get_or_insert_with(|| Console::new(ui.ctx(), start())).ui(ui);
        },
        None,
    );
    screen.run_steps(40);
    screen.key_press(Key::Space);
    screen.run_steps(2);
    screen::show(&mut screen, "Plan");
    finish(&mut screen);
    click(&mut screen, "3-D");
    for (size_name, size) in [("desktop", DESKTOP), ("phone", vec2(390.0, 844.0))] {
        screen.set_size(size);
        for (theme_name, theme) in [("light", Theme::Light), ("dark", Theme::Dark)] {
            screen.ctx.set_theme(theme);
            screen.run_steps(20);
            let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
            let name = format!("plan-space-{size_name}-{theme_name}");
            results.add(screen.try_snapshot_options(name, &options));
        }
    }
}

#[test]
fn what_was_changed_during_the_cut_is_planned_for_on_request() {
    let mut screen = open(DESKTOP, &[]);
    click(&mut screen, "Console");
    screen.get_by_role_and_label(Role::Slider, "Target Ra").set_value_accesskit(1.5);
    screen.run_steps(2);
    assert_eq!(console(&screen).session().edits().list().len(), 1);
    click(&mut screen, "Plan");
    assert!(texts(&screen).contains("Changed during the cut, after its start: Target Ra."));
    click(&mut screen, "Plan for the values now");
    assert_eq!(scenario(&screen).target.ra_um, 1.5);
    assert!(console(&screen).session().edits().list().is_empty());
    assert!(iteration(&screen) < 5);
    assert!(!texts(&screen).contains("Changed during the cut"));
    click(&mut screen, "Undo");
    assert_eq!(console(&screen).session().edits().list().len(), 1);
}

#[test]
fn a_cut_that_the_network_does_not_know_is_told() {
    let warning = "The network does not know this cut";
    assert!(!texts(&open(DESKTOP, &[])).contains(warning));
    let screen = open(DESKTOP, &[("plant.hardness_hb", Value::Float(450.0))]);
    assert!(texts(&screen).contains(warning));
}
