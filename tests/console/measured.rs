//! Measured data over the plots of the console: dropped, aligned as the command does it, moved by hand, removed.

use std::fmt::Write as _;
use std::process::Command as Process;
use std::sync::Arc;

use egui::accesskit::Role;
use egui::epaint::ColorMode;
use egui::{Event, Key, Shape, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, PlaybackCommand};
use steadycut::app::theme::Palette;
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::signals::signal;
use steadycut::run::{Start, presets};

use crate::drawn;
use crate::screen::{self, Screen, computed, in_time, rest, sliced, texts};

const SIZES: [Vec2; 2] = [vec2(1280.0, 800.0), vec2(390.0, 844.0)];
const PRESET: &str = "depth-step";

/// A file as a window system drops it.
#[derive(Debug)]
struct Dropped(&'static str, Vec<u8>);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        std::path::Path::new(self.0)
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.1.clone())
    }
}

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

/// Drops a file and waits until the screen says something.
fn drop_file(screen: &mut Screen<'_>, file: Dropped, says: &str) {
    screen.input_mut().dropped_files.push(Arc::new(file));
    let said = in_time(|| {
        screen.run_steps(2);
        std::thread::sleep(std::time::Duration::from_millis(2));
        texts(screen).contains(says)
    });
    assert!(said, "{says}: {}", texts(screen));
    rest(screen);
}

/// The force of the run as a German logger has it: later, larger, at 100 Hz, with a second channel in kN.
fn logged(screen: &Screen<'_>) -> String {
    let recording = console(screen).session().chosen().run().recording();
    let force = signal("force_n").unwrap();
    let values: Vec<f64> =
        recording.rows().iter().map(|row| (force.value)(row).unwrap_or(0.0)).collect();
    let step = (0.01 / recording.row_s()).round() as usize;
    let mut text = "Zeit;Fx;Fz\n[s];[N];[kN]\n".to_owned();
    for (i, known) in values.iter().step_by(step).enumerate() {
        let (fx, fz) = (12.0 + 1.3 * known, 1e-3 * known);
        let line = format!("{:.4};{fx:.4};{fz:.6}", 3.25 + 0.01 * i as f64);
        writeln!(text, "{}", line.replace('.', ",")).unwrap();
    }
    text
}

fn click(screen: &mut Screen<'_>, name: &str) {
    let found = screen.get_all_by_label(name).last();
    found.unwrap_or_else(|| panic!("no {name}")).click_accesskit();
    screen.run_steps(4);
}

fn number(screen: &Screen<'_>, name: &str) -> f64 {
    let node = screen.get_by_role_and_label(Role::SpinButton, name);
    node.accesskit_node().numeric_value().unwrap_or_else(|| panic!("no number in {name}"))
}

fn set(screen: &mut Screen<'_>, name: &str, value: f64) {
    screen.get_by_role_and_label(Role::SpinButton, name).set_value_accesskit(value);
    screen.run_steps(3);
}

/// Chooses from the list with this name.
fn choose(screen: &mut Screen<'_>, list: &str, option: &str) {
    screen.get_by_role_and_label(Role::ComboBox, list).click_accesskit();
    screen.run_steps(3);
    let found = screen.get_all_by_role_and_label(Role::Button, option).last();
    found.unwrap_or_else(|| panic!("no {option}")).click_accesskit();
    screen.run_steps(3);
    rest(screen);
}

/// Shapes that are drawn in the colour of what was measured.
fn drawn_lines(screen: &Screen<'_>) -> usize {
    fn of(shape: &Shape) -> usize {
        let color = Palette::of(Theme::Dark).measured;
        let light = Palette::of(Theme::Light).measured;
        let is = |stroke: egui::Color32| usize::from(stroke == color || stroke == light);
        match shape {
            Shape::Vec(shapes) => shapes.iter().map(of).sum(),
            Shape::Path(path) => match path.stroke.color {
                ColorMode::Solid(color) => is(color),
                ColorMode::UV(_) => 0,
            },
            Shape::Band(band) => is(band.fill),
            Shape::LineSegment { stroke, .. } => is(stroke.color),
            _ => 0,
        }
    }
    screen.output().shapes.iter().map(|clipped| of(&clipped.shape)).sum()
}

/// A console with the file over its plots, paused at its start.
fn overlaid<'a>(size: Vec2) -> (Screen<'a>, String) {
    let mut screen = screen::open(PRESET, size, "Console", &[]);
    screen.key_press(Key::Space);
    screen.run_steps(2);
    computed(&mut screen);
    let text = logged(&screen);
    let file = Dropped("/lab/cut.csv", text.clone().into_bytes());
    drop_file(&mut screen, file, "what is left, rms");
    (screen, text)
}

#[test]
fn a_dropped_file_lies_where_the_command_puts_it() {
    for size in SIZES {
        let (screen, text) = overlaid(size);
        let said = texts(&screen);
        for part in [
            "Text, semicolons between the values, decimal comma, names in line 1, units in line 2",
            "times in the column Zeit",
            "Fz [kN]",
            "measured: Fx",
            "neither a file nor a link holds it",
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
        assert!(screen.unnamed_widgets().is_empty(), "{:?}", screen.unnamed_widgets());
        if size == SIZES[1] {
            continue;
        }
        let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("overlaid-cut.csv");
        std::fs::write(&file, text).unwrap();
        let output = Process::new(env!("CARGO_BIN_EXE_steadycut"))
            .args(["measured", file.to_str().unwrap(), "--align", PRESET])
            .args(["--pair", "Fx=force_n", "--json"])
            .output()
            .unwrap();
        let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let told = |key: &str| told["aligned"][key].as_f64().unwrap();
        assert!((told("shift_s") - 3.25).abs() < 0.02, "{}", told("shift_s"));
        for (name, key) in [("Shift", "shift_s"), ("Scale", "scale"), ("Offset", "offset")] {
            let shown = number(&screen, name);
            assert!((shown - told(key)).abs() < 1e-6, "{name}: {shown} {}", told(key));
        }
        let left = format!("rms {:.4} N over {} samples", told("rest"), told("samples"));
        assert!(said.contains(&left), "{left}: {said}");
    }
}

#[test]
fn it_is_switched_moved_by_hand_kept_through_edits_and_removed() {
    let (mut screen, _) = overlaid(SIZES[0]);
    assert!(drawn_lines(&screen) > 0);
    screen.get_by_role_and_label(Role::CheckBox, "measured: Fx").click();
    screen.run_steps(3);
    // The sample in the legend is struck out then.
    assert_eq!(drawn_lines(&screen), 0);
    click(&mut screen, "Show it");
    assert!(drawn_lines(&screen) > 0);

    let aligned = number(&screen, "Shift");
    set(&mut screen, "Shift", aligned + 1.5);
    assert!((number(&screen, "Shift") - aligned - 1.5).abs() < 1e-6);
    let said = texts(&screen);
    assert!(said.contains("by hand: what is left, rms"), "{said}");
    set(&mut screen, "Scale", 0.0);
    let said = texts(&screen);
    assert!(said.contains("Scale: 0 cannot be") && number(&screen, "Scale") > 1.0, "{said}");

    // A change in the running cut leaves it where it is, and what is left is that of the new run.
    let left = |screen: &Screen<'_>| {
        let said = texts(screen);
        said.split_once("left, rms ").unwrap().1.split(' ').next().unwrap().to_owned()
    };
    let before = left(&screen);
    console(&screen).push(Command::Playback(PlaybackCommand::SeekTo(5.0)));
    console(&screen).push(Command::set("target.ra_um", Value::Float(0.7)));
    screen.run_steps(3);
    computed(&mut screen);
    assert_eq!(console(&screen).session().edits().list().len(), 1);
    assert!((number(&screen, "Shift") - aligned - 1.5).abs() < 1e-6);
    assert_ne!(left(&screen), before);
    assert!(drawn_lines(&screen) > 0);
    click(&mut screen, "Align");
    rest(&mut screen);
    screen.run_steps(3);
    assert!((number(&screen, "Shift") - aligned).abs() < 0.3, "{}", number(&screen, "Shift"));

    // Another channel, in its own unit over the force, and over another plot.
    choose(&mut screen, "Channel", "Fz [kN]");
    screen.run_steps(3);
    // As a force of the cut before the change, not as a thousandth of it.
    assert!((0.2..2.0).contains(&number(&screen, "Scale")), "{}", number(&screen, "Scale"));
    choose(&mut screen, "Its unit", "as it is, not converted");
    screen.run_steps(3);
    assert!(number(&screen, "Scale") < 0.01, "{}", number(&screen, "Scale"));
    choose(&mut screen, "Laid over", "Feed");
    screen.run_steps(3);
    let unit = screen.get_by_role_and_label(Role::ComboBox, "Its unit");
    assert_eq!(unit.accesskit_node().value().as_deref(), Some("as it is, not converted"));
    click(&mut screen, "Remove");
    let said = texts(&screen);
    assert!(!said.contains("measured: F") && drawn_lines(&screen) == 0, "{said}");
}

#[test]
fn a_faulty_file_is_told_with_line_and_column_and_other_layouts_are_said() {
    let mut screen = screen::open(PRESET, SIZES[0], "Console", &[]);
    let line = |i: i32| format!("0,{i:02};{},5\n", i % 7);
    let mut lines: Vec<String> = (0..40).map(line).collect();
    lines[20] = "0,20;2,x\n".to_owned();
    let text = format!("Zeit [s];Fx [N]\n{}", lines.concat());
    drop_file(&mut screen, Dropped("/lab/bad.csv", text.into_bytes()), "bad.csv: line");
    let said = texts(&screen);
    assert!(said.contains("line 22, column 2 (Fx)") && said.contains("2,x"), "{said}");
    // The next one takes its place.
    lines[20] = line(20);
    let text = format!("Zeit [s];Fx [N]\n{}", lines.concat());
    drop_file(&mut screen, Dropped("/lab/good.csv", text.into_bytes()), "good.csv");
    assert!(!texts(&screen).contains("bad.csv"), "{}", texts(&screen));
    choose(&mut screen, "Time column", "none: a sample rate");
    assert!(texts(&screen).contains("Zeit [s]"), "the times are a channel now");
    set(&mut screen, "Sample rate", 200.0);
    let said = texts(&screen);
    assert!(said.contains("200 samples in a second"), "{said}");
}

#[test]
fn find_lists_it() {
    let mut screen = screen::open(PRESET, SIZES[0], "Plan", &[]);
    screen.key_press(Key::Slash);
    screen.run_steps(3);
    screen.event(Event::Text("labview".to_owned()));
    screen.run_steps(3);
    assert!(texts(&screen).contains("Lay measured data over the plots"), "{}", texts(&screen));
}

/// On a phone it folds to a line, which says what lies over the plots, and is found again.
#[test]
fn on_a_phone_it_folds_to_a_line_and_leaves_the_plots_free() {
    let (mut screen, _) = overlaid(SIZES[1]);
    let lowest = |screen: &Screen<'_>, name: &str| screen.get_by_label(name).rect().top();
    assert!(lowest(&screen, "Fold to a line") < 0.75 * SIZES[1].y);
    click(&mut screen, "Fold to a line");
    assert!(screen.query_by_label("Open a file\u{2026}").is_none(), "{}", texts(&screen));
    let line = screen.get_by_label_contains("Fx over").rect();
    assert!(line.top() > 0.78 * SIZES[1].y && line.bottom() <= SIZES[1].y, "{line:?}");
    for name in ["Unfold", "Close window"] {
        let rect = screen.get_by_label(name).rect();
        assert!(rect.size().min_elem() > 43.9 && rect.right() <= SIZES[1].x, "{name}: {rect:?}");
    }
    assert!(screen.unnamed_widgets().is_empty(), "{:?}", screen.unnamed_widgets());
    assert!(drawn_lines(&screen) > 0, "it stays over the plots");
    click(&mut screen, "Unfold");
    assert!(texts(&screen).contains("what is left, rms"), "{}", texts(&screen));
    click(&mut screen, "Fold to a line");
    click(&mut screen, "Close window");
    assert!(screen.query_by_label("Unfold").is_none() && drawn_lines(&screen) > 0);
    // A desktop has room for it.
    let (screen, _) = overlaid(SIZES[0]);
    assert!(screen.query_by_label("Fold to a line").is_none());
}

#[test]
fn the_plots_with_measured_data_look_as_they_should() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, theme, name) in [
        (SIZES[0], Theme::Dark, "measured-desktop-dark"),
        (SIZES[0], Theme::Light, "measured-desktop-light"),
        (SIZES[1], Theme::Dark, "measured-phone-dark"),
        (SIZES[1], Theme::Light, "measured-phone-light"),
    ] {
        let builder = Harness::builder().with_size(size).with_step_dt(0.05).with_theme(theme);
        let mut screen: Screen<'_> = builder.wgpu().build_ui_state(
            |ui, console: &mut Option<Console>| {
                let console = console.get_or_insert_with(|| {
                    let scenario = presets::load(PRESET).unwrap();
                    let start = Start { scenario, edits: Edits::none(), notice: None };
                    sliced(Console::new(ui.ctx(), start))
                });
                console.ui(ui);
            },
            None,
        );
        screen.run_steps(3);
        screen.key_press(Key::Space);
        computed(&mut screen);
        console(&screen).push(Command::Playback(PlaybackCommand::SeekTo(8.0)));
        let file = Dropped("/lab/cut.csv", logged(&screen).into_bytes());
        drop_file(&mut screen, file, "what is left, rms");
        screen.run_steps(20);
        results.add(screen.try_snapshot_options(name, &SnapshotOptions::default()));
        if name == "measured-phone-dark" {
            click(&mut screen, "Fold to a line");
            screen.run_steps(20);
            let folded = "measured-phone-folded";
            results.add(screen.try_snapshot_options(folded, &SnapshotOptions::default()));
        }
    }
}
