//! Settings fitted to measured data: a file opened or dropped, roles and options, what was found, taken and taken back.

use std::path::Path;
use std::process::Command as Process;
use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, FileCommand, SessionCommand, ShellCommand};
use steadycut::app::overlay::file::MeasuredFile;
use steadycut::app::panels::BroughtFile;
use steadycut::base::settings::Value;
use steadycut::measured::layout::DataLayout;
use steadycut::run::edits::Edits;
use steadycut::run::scenario::Scenario;
use steadycut::run::{Start, presets};
use steadycut::study::identify::fits::MeasuredFitKind;

use crate::drawn;
use crate::screen::{self, Screen, in_time, rest, sliced, texts};

const SIZES: [Vec2; 2] = [vec2(1280.0, 1700.0), vec2(390.0, 3600.0)];
const PRESET: &str = "table3-5-noise";
const TEETH: &str = "square-12-4-42crmo4";
const SHOWN: &str = "No measured data yet";

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn scenario<'a>(screen: &'a Screen<'_>) -> &'a Scenario {
    console(screen).session().scenario()
}

fn push(screen: &mut Screen<'_>, command: Command) {
    console(screen).push(command);
    screen.run_steps(4);
}

fn open<'a>(preset: &str, size: Vec2) -> Screen<'a> {
    let mut screen = screen::open(preset, size, "Identify", &[]);
    click(&mut screen, "Fit settings");
    screen
}

fn click(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(4);
}

/// Chooses from the list with this name.
fn choose(screen: &mut Screen<'_>, list: &str, option: &str) {
    // A list that was chosen from may stand open still: then this closes it.
    for _ in 0..2 {
        screen.get_by_role_and_label(Role::ComboBox, list).click_accesskit();
        screen.run_steps(3);
        if screen.query_all_by_role_and_label(Role::Button, option).next().is_some() {
            break;
        }
    }
    let found = screen.get_all_by_role_and_label(Role::Button, option).last();
    found.unwrap_or_else(|| panic!("no {option}")).click_accesskit();
    screen.run_steps(4);
}

fn chosen(screen: &Screen<'_>, list: &str) -> String {
    let node = screen.get_by_role_and_label(Role::ComboBox, list);
    node.accesskit_node().value().unwrap_or_default()
}

fn enabled(screen: &Screen<'_>, name: &str) -> bool {
    !screen.get_by_role_and_label(Role::Button, name).accesskit_node().is_disabled()
}

fn brought(name: &str, text: &str) -> Command {
    let file = MeasuredFile::read(name.to_owned(), text.as_bytes().into(), DataLayout::default());
    Command::File(FileCommand::Bring(BroughtFile::ToFit(Box::new(file))))
}

fn title(kind: MeasuredFitKind) -> &'static str {
    kind.about().title
}

/// Chooses a fit and has it made of a file.
fn fitted(screen: &mut Screen<'_>, kind: MeasuredFitKind, name: &str, text: &str) {
    click(screen, &format!("Fitted: {}", title(kind)));
    push(screen, brought(name, text));
    click(screen, "Fit");
    rest(screen);
    screen.run_steps(3);
}

fn undo(screen: &mut Screen<'_>) {
    screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    screen.run_steps(4);
}

/// The arguments of the command that makes the same fit of a file, its columns by their names.
fn arguments(kind: MeasuredFitKind) -> &'static [&'static str] {
    match kind {
        MeasuredFitKind::DriveFromData => {
            &["--feed", "feed_mm_min", "--command", "feed_command_mm_min"]
        }
        MeasuredFitKind::ForceFromData => {
            &["--fx", "fx_n", "--fy", "fy_n", "--fz", "fz_n", "--scenario", TEETH]
        }
        MeasuredFitKind::StructureFromData => &[],
        MeasuredFitKind::NoiseFromData => &["--force", "force_measured_n", "--scenario", PRESET],
        MeasuredFitKind::WearFromData => &["--scenario", PRESET],
        MeasuredFitKind::MaterialFromData => &[
            "--force",
            "force_measured_n",
            "--feed",
            "feed_mm_min",
            "--speed",
            "spindle_rpm",
            "--position",
            "position_mm",
            "--scenario",
            PRESET,
        ],
    }
}

fn preset(kind: MeasuredFitKind) -> &'static str {
    if kind == MeasuredFitKind::ForceFromData { TEETH } else { PRESET }
}

#[test]
fn every_fit_gives_the_command_s_settings_and_is_taken_back_by_one_undo() {
    for kind in MeasuredFitKind::ALL.iter().copied() {
        let id = kind.id();
        let text = kind.sample(&presets::load(preset(kind)).unwrap(), 7).unwrap();
        let mut screen = open(preset(kind), SIZES[0]);
        let before = scenario(&screen).clone();
        let name = format!("fitted-{id}.csv");
        fitted(&mut screen, kind, &name, &text);
        let said = texts(&screen);
        assert!(said.contains("±") && said.contains("left over, rms") || id == "noise", "{said}");
        assert!(said.contains("measured against the model"), "{said}");
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
        click(&mut screen, "Use in this scenario");
        assert!(texts(&screen).contains("It stands in the scenario"), "{}", texts(&screen));
        let after = scenario(&screen).clone();
        assert_ne!(after, before, "{id}");

        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let out = format!("fitted-{id}.toml");
        std::fs::write(folder.join(&name), &text).unwrap();
        let data: &[&str] = match kind {
            MeasuredFitKind::StructureFromData => &["--x", &name],
            MeasuredFitKind::DriveFromData
            | MeasuredFitKind::ForceFromData
            | MeasuredFitKind::NoiseFromData
            | MeasuredFitKind::WearFromData
            | MeasuredFitKind::MaterialFromData => &["--data", &name],
        };
        let output = Process::new(env!("CARGO_BIN_EXE_steadycut"))
            .current_dir(folder)
            .args(["identify", id])
            .args(data)
            .args(arguments(kind))
            .args(["--out", &out, "--json"])
            .output()
            .unwrap();
        assert!(output.status.success(), "{id}: {}", String::from_utf8_lossy(&output.stderr));
        let written = std::fs::read_to_string(folder.join(&out)).unwrap();
        let mut by_command = before.clone();
        match kind {
            MeasuredFitKind::DriveFromData | MeasuredFitKind::StructureFromData => {
                let own = steadycut::study::own_file::OwnFile::read(&written).unwrap();
                by_command.set_all(&own.changes).unwrap();
            }
            MeasuredFitKind::ForceFromData
            | MeasuredFitKind::NoiseFromData
            | MeasuredFitKind::WearFromData
            | MeasuredFitKind::MaterialFromData => {
                by_command = steadycut::run::scenario_file::parse(&written).unwrap().0;
            }
        }
        for param in steadycut::run::scenario::table() {
            let [window, command] = [&after, &by_command].map(|s| s.get(&param.path));
            assert_eq!(window, command, "{id}: {}", param.path);
        }
        undo(&mut screen);
        assert_eq!(*scenario(&screen), before, "{id}: one step takes all of it back");
        assert!(!texts(&screen).contains("It stands in the scenario"), "{id}");
    }
}

#[test]
fn sample_data_are_made_of_the_scenario_and_fitted_at_every_size() {
    for size in SIZES {
        let mut screen = open(PRESET, size);
        let said = texts(&screen);
        assert!(said.contains(SHOWN), "{said}");
        for kind in MeasuredFitKind::ALL.iter().copied() {
            let command = format!("steadycut identify {}", kind.id());
            assert!(said.contains(&command), "{command}: {said}");
        }
        click(&mut screen, "Try with sample data");
        rest(&mut screen);
        screen.run_steps(3);
        assert!(chosen(&screen, "Feed, measured").starts_with("feed_mm_min"));
        assert!(chosen(&screen, "Feed, asked for").starts_with("feed_command_mm_min"));
        click(&mut screen, "Fit");
        rest(&mut screen);
        screen.run_steps(3);
        let said = texts(&screen);
        for part in
            ["dead time", "BIC", "AIC", "third order", "R²", "Left over: measured less model"]
        {
            assert!(said.contains(part), "{part}: {said}");
        }
        // Something else is asked: what stands there is of before.
        let later = vec![("cnc.dead_time_s".to_owned(), Value::Float(0.2))];
        push(&mut screen, Command::Session(SessionCommand::SetUp(later)));
        assert!(texts(&screen).contains("were changed since"), "{}", texts(&screen));
    }
    // Tooth by tooth forces have no sample of a map.
    let mut screen = open(PRESET, SIZES[0]);
    click(&mut screen, "Fitted: Forces");
    click(&mut screen, "Try with sample data");
    rest(&mut screen);
    screen.run_steps(3);
    let said = texts(&screen);
    assert!(said.contains("No sample data: ") && said.contains("tooth by tooth"), "{said}");
}

#[test]
fn what_is_wrong_is_told_at_the_field_and_nothing_is_taken() {
    let kind = MeasuredFitKind::DriveFromData;
    let mut screen = open(PRESET, SIZES[0]);
    let sound = kind.sample(&presets::load(PRESET).unwrap(), 1).unwrap();
    let before = scenario(&screen).clone();
    // Nothing to fit yet.
    push(&mut screen, brought("step.csv", &sound));
    choose(&mut screen, "Feed, measured", "choose");
    assert!(!enabled(&screen, "Fit"));
    let said = texts(&screen);
    assert!(said.contains("choose a channel: expected is a feed"), "{said}");
    choose(&mut screen, "Feed, measured", "feed_mm_min [mm/min]");
    assert!(enabled(&screen, "Fit"));
    let steady: String = "t [s],set [mm/min],act [mm/min]\n".to_owned()
        + (0..200)
            .map(|i| format!("{},300,300\n", 0.01 * f64::from(i)))
            .collect::<String>()
            .as_str();
    let without = |line: &str| match line.starts_with("0.100,") {
        true => format!("0.100,,{}\n", line.rsplit(',').next().unwrap_or_default()),
        false => format!("{line}\n"),
    };
    let holed: String = sound.lines().map(without).collect();
    let short: String = sound.lines().take(9).map(|line| format!("{line}\n")).collect();
    for (name, text, part) in [
        ("steady.csv", &steady, "the command never changes: record a step"),
        ("holed.csv", &holed, "are missing or no numbers"),
        ("short.csv", &short, "samples: allowed are 20 to"),
    ] {
        fitted(&mut screen, kind, name, text);
        let said = texts(&screen);
        assert!(said.contains(part), "{name}, {part}: {said}");
        assert!(screen.query_by_label("Use in this scenario").is_none(), "{said}");
    }
    // A unit that is none of a force, said otherwise.
    click(&mut screen, "Fitted: Noise");
    let volts: String = "t [s],Fx [V]\n".to_owned()
        + (0..2000)
            .map(|i| format!("{},{}\n", 0.001 * f64::from(i), 100 + (i * 7919) % 13))
            .collect::<String>()
            .as_str();
    push(&mut screen, brought("volts.csv", &volts));
    choose(&mut screen, "Force", "Fx [V]");
    click(&mut screen, "Fit");
    rest(&mut screen);
    screen.run_steps(3);
    let said = texts(&screen);
    assert!(said.contains("is in V; expected is a force in N or kN"), "{said}");
    choose(&mut screen, "Unit: Force", "N");
    click(&mut screen, "Fit");
    rest(&mut screen);
    screen.run_steps(3);
    assert!(texts(&screen).contains("white noise"), "{}", texts(&screen));
    // What cannot be read says where.
    push(&mut screen, brought("bad.csv", "t [s],Fx [N]\n0,1\n0.1,x\n"));
    let said = texts(&screen);
    assert!(said.contains("bad.csv: ") && !enabled(&screen, "Fit"), "{said}");
    assert_eq!(*scenario(&screen), before);
}

/// A file as a window system drops it.
#[derive(Debug)]
struct Dropped(&'static str, String);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        Path::new(self.0)
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.1.clone().into_bytes())
    }
}

#[test]
fn a_dropped_recording_is_fitted_where_fits_are_shown_and_found_from_anywhere() {
    let mut screen = screen::open(PRESET, SIZES[0], "Plan", &[]);
    push(&mut screen, Command::Shell(ShellCommand::ShowPart("identify", "Fit settings")));
    assert!(texts(&screen).contains(SHOWN), "{}", texts(&screen));
    click(&mut screen, "Fitted: Wear");
    let wear = MeasuredFitKind::WearFromData;
    let text = wear.sample(&presets::load(PRESET).unwrap(), 1).unwrap();
    screen.input_mut().dropped_files.push(Arc::new(Dropped("/lab/readings.csv", text)));
    let came = in_time(|| {
        screen.run_steps(2);
        std::thread::sleep(std::time::Duration::from_millis(2));
        texts(&screen).contains("readings.csv")
    });
    assert!(came);
    screen.run_steps(3);
    // The times of readings are a column like others.
    assert!(chosen(&screen, "Time in the cut").starts_with("time"), "{}", texts(&screen));
    assert!(enabled(&screen, "Fit"));
    screen.key_press(Key::Slash);
    screen.run_steps(3);
    screen.event(egui::Event::Text("kienzle".to_owned()));
    screen.run_steps(3);
    assert!(texts(&screen).contains("Fit settings to measured data"), "{}", texts(&screen));
}

#[test]
fn the_fits_look_as_they_should() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, theme, kind, name) in [
        (vec2(1280.0, 800.0), Theme::Light, None, "fits-empty-desktop"),
        (vec2(1280.0, 1300.0), Theme::Light, Some("Drive"), "fits-drive-desktop"),
        (vec2(1280.0, 1300.0), Theme::Dark, Some("Noise"), "fits-noise-desktop-dark"),
        (vec2(390.0, 2600.0), Theme::Light, Some("Drive"), "fits-drive-phone"),
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
        push(&mut screen, Command::Shell(ShellCommand::ShowPart("identify", "Fit settings")));
        if let Some(kind) = kind {
            click(&mut screen, &format!("Fitted: {kind}"));
            click(&mut screen, "Try with sample data");
            rest(&mut screen);
            screen.run_steps(3);
            click(&mut screen, "Fit");
            rest(&mut screen);
        }
        screen.run_steps(20);
        results.add(screen.try_snapshot_options(name, &SnapshotOptions::default()));
    }
}
