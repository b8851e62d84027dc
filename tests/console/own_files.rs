//! Files of one's own in the console: a folder that is listed, used, kept and begun in; what a browser keeps; and layouts of
//! measured data that are remembered.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use egui::accesskit::Role;
use egui::{Event, Key, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, LibraryCommand, SessionCommand};
use steadycut::app::library::{FolderShelf, PageShelf, Shelf, Slots};
use steadycut::app::remembered::{Keeper, Remembered};
use steadycut::run::edits::Edits;
use steadycut::run::{Start, presets, scenario_file};
use steadycut::study::library::LibraryKind;
use steadycut::study::opening::Opening;
use steadycut::study::own_file::OwnFileKind;
use steadycut::study::part::{EXAMPLE_CSV, EXAMPLE_GCODE};

use crate::drawn;
use crate::screen::{Screen, computed, in_time, rest, sliced, texts};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);
const BROKEN: &str = "broken mill.toml";
const LONG: &str = "a cutter whose file was given a name that is far longer than any window is wide, and then some more.toml";

/// Ra of a force, as K5.
const FORMULA: &str = "version = 1\nformula = \"0.2 + F/1000\"\nsource = \"a test\"\n[output]\nname = \"Ra\"\n\
    unit = \"um\"\n[[inputs]]\nname = \"F\"\nunit = \"N\"\nlow = 50.0\nhigh = 1000.0\n";

/// A fresh folder of a test's own.
fn fresh(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("own-files-{name}"));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// A console that keeps files on a shelf, paused.
fn console<'a>(size: Vec2, theme: Option<Theme>, shelf: Arc<dyn Shelf>) -> Screen<'a> {
    opened(size, theme, move |ctx| {
        let scenario = presets::load("first-cut").unwrap();
        let start = Start { scenario, edits: Edits::none(), notice: None };
        let mut console = Console::new(ctx, start);
        console.keep_files(shelf.clone());
        console
    })
}

fn opened<'a>(
    size: Vec2,
    theme: Option<Theme>,
    make: impl Fn(&egui::Context) -> Console + 'a,
) -> Screen<'a> {
    let builder = Harness::builder().with_size(size).with_step_dt(0.05);
    let builder = match theme {
        Some(theme) => builder.with_theme(theme).wgpu(),
        None => builder,
    };
    let mut screen: Screen<'a> = builder.build_ui_state(
        move |ui, console: &mut Option<Console>| {
            console.get_or_insert_with(|| sliced(make(ui.ctx()))).ui(ui);
        },
        None,
    );
    screen.run_steps(3);
    screen.key_press(Key::Space);
    screen.run_steps(2);
    screen
}

fn of<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn show(screen: &mut Screen<'_>, kind: Option<LibraryKind>) {
    of(screen).push(Command::Library(LibraryCommand::Show { open: true, kind }));
    screen.run_steps(3);
    rest(screen);
    screen.run_steps(3);
}

/// Frames until the screen says something: files are read and written on threads.
fn says(screen: &mut Screen<'_>, text: &str) {
    // Some 20 s at least: a test that fails shall not wait for minutes.
    let said = (0..4000).any(|_| {
        screen.run_steps(2);
        std::thread::sleep(std::time::Duration::from_millis(5));
        texts(screen).contains(text)
    });
    assert!(said, "{text}: {}", texts(screen));
    rest(screen);
    screen.run_steps(2);
}

fn click(screen: &mut Screen<'_>, name: &str) {
    let found = screen.get_all_by_role_and_label(Role::Button, name).last();
    found.unwrap_or_else(|| panic!("no {name}: {}", texts(screen))).click_accesskit();
    screen.run_steps(4);
}

/// Chooses from the list with this name.
fn choose(screen: &mut Screen<'_>, list: &str, option: &str) {
    screen.get_by_role_and_label(Role::ComboBox, list).click_accesskit();
    screen.run_steps(3);
    click(screen, option);
}

/// A folder with good and broken files, and the shelf on it.
fn shop(name: &str) -> (PathBuf, Arc<dyn Shelf>) {
    let home = fresh(name);
    let folder = home.join("files");
    std::fs::create_dir_all(folder.join("shop 2")).unwrap();
    let tool = OwnFileKind::Tool.template();
    let preset = presets::load("depth-step").unwrap();
    for (name, text) in [
        ("mill.toml", tool.to_owned()),
        ("broken mill.toml", tool.replacen("teeth = 3", "teeth = 30", 1)),
        (LONG, tool.replacen("teeth = 3", "teeth = 1", 1)),
        ("shop 2/c60.toml", OwnFileKind::Material.template().to_owned()),
        ("lathe.toml", OwnFileKind::Machine.template().to_owned()),
        ("slender.toml", OwnFileKind::Structure.template().to_owned()),
        ("steps.csv", EXAMPLE_CSV.to_owned()),
        ("bracket.nc", EXAMPLE_GCODE.to_owned()),
        ("step.toml", scenario_file::write(&preset, &Edits::none())),
        ("ra.toml", FORMULA.to_owned()),
        ("notes.pdf", "x".to_owned()),
    ] {
        std::fs::write(folder.join(name), text).unwrap();
    }
    std::fs::write(folder.join("latin.toml"), b"title = \"Fr\xe4ser\"").unwrap();
    (folder, Arc::new(FolderShelf::with_home(home)))
}

#[test]
fn a_folder_is_listed_used_and_read_again() {
    let (folder, shelf) = shop("used");
    let mut screen = console(DESKTOP, None, shelf);
    show(&mut screen, None);
    let said = texts(&screen);
    for part in [
        folder.to_str().unwrap(),
        "Cutters (3)",
        "Square end mill 10 mm, 3 flutes; Square end, 3 teeth, 10 mm",
        "Square end, 1 tooth, 10 mm",
        "line 9: `teeth` cannot be 30",
        "shop 2/c60.toml",
        "Latin-1",
        "moves",
        "1 other file",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert!(screen.unnamed_widgets().is_empty(), "{:?}", screen.unnamed_widgets());
    let before = of(&screen).session().scenario().clone();
    click(&mut screen, "mill.toml");
    says(&mut screen, "is taken as the cutter of this cut");
    assert_eq!(of(&screen).session().scenario().tool.teeth, 3);
    assert!(texts(&screen).contains("mill.toml, in use"), "{}", texts(&screen));
    of(&screen).push(Command::Session(SessionCommand::Undo));
    screen.run_steps(3);
    assert_eq!(of(&screen).session().scenario(), &before);
    assert!(!texts(&screen).contains("in use"), "{}", texts(&screen));
    // A broken one cannot be pressed.
    let broken = screen.get_by_role_and_label(Role::Button, "broken mill.toml");
    assert!(broken.accesskit_node().is_disabled());
    click(&mut screen, "steps.csv");
    says(&mut screen, "steps.csv is the part now");
    click(&mut screen, "step.toml");
    says(&mut screen, "step.toml is open");
    assert!(texts(&screen).contains("step.toml, in use"), "{}", texts(&screen));

    // A formula is taken at a place of its units.
    click(&mut screen, "ra.toml");
    click(&mut screen, "Ra of a force");
    says(&mut screen, "ra.toml, in use");
    assert!(of(&screen).session().current().formula.ra.get().is_some());

    // It is mended, and another one comes.
    let text = OwnFileKind::Tool.template().replacen("teeth = 3", "teeth = 4 ", 1);
    std::fs::write(folder.join("broken mill.toml"), &text).unwrap();
    std::fs::write(folder.join("new.rhai"), "fn update(now) {\n  #{ feed: now.command }\n}\n")
        .unwrap();
    click(&mut screen, "Read again");
    rest(&mut screen);
    screen.run_steps(3);
    let said = texts(&screen);
    assert!(said.contains("Scripts (1)") && !said.contains("cannot be 30"), "{said}");
    click(&mut screen, "broken mill.toml");
    says(&mut screen, "is taken as the cutter of this cut");
    assert_eq!(of(&screen).session().scenario().tool.teeth, 4);
}

#[test]
fn files_are_begun_and_kept_and_none_is_overwritten() {
    let home = fresh("kept");
    let folder = home.join("files");
    let mut screen = console(DESKTOP, None, Arc::new(FolderShelf::with_home(home.clone())));
    show(&mut screen, None);
    assert!(texts(&screen).contains("No files here yet"), "{}", texts(&screen));
    choose(&mut screen, "Begin a new one", "material");
    says(&mut screen, "Materials (1)");
    std::fs::write(folder.join("my-material.toml"), "mine").unwrap();
    choose(&mut screen, "Begin a new one", "material");
    says(&mut screen, "my-material-2.toml");
    assert_eq!(std::fs::read(folder.join("my-material.toml")).unwrap(), b"mine");
    choose(&mut screen, "Keep of the present cut", "cutter");
    says(&mut screen, "Cutters (1)");
    choose(&mut screen, "Keep of the present cut", "scenario");
    says(&mut screen, "Scenarios (1)");
    // Both are in use, since they were made of what is.
    assert_eq!(texts(&screen).matches(", in use").count(), 2, "{}", texts(&screen));
    let text = std::fs::read_to_string(folder.join("drag-the-target-roughness.toml")).unwrap();
    assert_eq!(&scenario_file::parse(&text).unwrap().0, of(&screen).session().scenario());
    screen.get_by_role_and_label(Role::ComboBox, "Keep of the present cut").click_accesskit();
    screen.run_steps(3);
    let script = screen.get_all_by_role_and_label(Role::Button, "script").last().unwrap();
    assert!(script.accesskit_node().is_disabled(), "there is none");
    screen.key_press(Key::Escape);
    screen.run_steps(3);

    // What is dropped from elsewhere is used, and can be kept.
    show(&mut screen, None);
    let text = OwnFileKind::Machine.template().as_bytes().to_vec();
    screen
        .input_mut()
        .dropped_files
        .push(Arc::new(Dropped("/lab/heller.toml".into(), text.clone())));
    says(&mut screen, "is taken as the machine of this cut");
    click(&mut screen, "Keep it: heller.toml");
    says(&mut screen, "Machines (1)");
    assert_eq!(std::fs::read(folder.join("heller.toml")).unwrap(), text);
    assert!(!texts(&screen).contains("Opened from elsewhere"), "{}", texts(&screen));

    // Another folder by its path; a wrong one is refused.
    for (path, wanted) in [("nowhere", "from the root on"), ("/no such", "there is no such folder")]
    {
        of(&screen).push(Command::Library(LibraryCommand::Choose(path.to_owned())));
        says(&mut screen, wanted);
    }
    let other = fresh("kept-elsewhere");
    std::fs::write(other.join("only.toml"), OwnFileKind::Tool.template()).unwrap();
    screen.get_by_role(Role::TextInput).focus();
    screen.run_steps(2);
    screen.event(Event::Text(other.to_str().unwrap().to_owned()));
    screen.run_steps(2);
    screen.key_press(Key::Enter);
    says(&mut screen, "only.toml");
    assert!(!texts(&screen).contains("my-material"), "{}", texts(&screen));
    let again = FolderShelf::with_home(home);
    assert_eq!(again.place().as_deref(), other.to_str(), "the next start has it, too");
}

#[test]
fn what_is_locked_is_not_used_and_what_is_hidden_not_shown() {
    let (_, shelf) = shop("locked");
    let of_link = |link: &'static str| {
        let shelf = shelf.clone();
        opened(DESKTOP, None, move |ctx| {
            let mut console = Console::opened(ctx, Opening::of_link(link));
            console.keep_files(shelf.clone());
            console
        })
    };
    let mut screen = of_link("#embed=lock:tool.teeth");
    show(&mut screen, Some(LibraryKind::Tool));
    let mill = screen.get_by_role_and_label(Role::Button, "mill.toml");
    assert!(mill.accesskit_node().is_disabled(), "it would change a locked setting");
    assert!(texts(&screen).contains("Cannot be changed: it is locked"), "{}", texts(&screen));
    let before = of(&screen).session().scenario().clone();
    of(&screen).push(Command::Library(LibraryCommand::Use("mill.toml".to_owned())));
    says(&mut screen, "cannot be changed: it is locked");
    assert_eq!(of(&screen).session().scenario(), &before);
    let mut screen = of_link("#embed=hide:files");
    of(&screen).push(Command::Library(LibraryCommand::Show { open: true, kind: None }));
    screen.run_steps(3);
    assert!(!of(&screen).library().is_open());
    assert!(texts(&screen).contains("hide:files"), "{}", texts(&screen));
}

#[test]
fn find_menu_and_settings_lead_to_the_files() {
    let (_, shelf) = shop("found");
    let mut screen = console(DESKTOP, None, shelf.clone());
    screen.key_press(Key::Slash);
    screen.run_steps(3);
    screen.event(Event::Text("my files".to_owned()));
    screen.run_steps(3);
    screen.key_press(Key::Enter);
    says(&mut screen, "Cutters (3)");
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(!of(&screen).library().is_open());
    for name in ["More settings", "Cutter", "My files\u{2026}"] {
        screen.get_all_by_label(name).last().unwrap().click_accesskit();
        screen.run_steps(14);
    }
    says(&mut screen, "Cutters (3)");
    assert!(!texts(&screen).contains("steps.csv"), "parts are folded: {}", texts(&screen));
    let mut screen = console(PHONE, None, shelf);
    for name in ["Menu", "My files\u{2026}"] {
        screen.get_all_by_label(name).last().unwrap().click_accesskit();
        screen.run_steps(6);
    }
    says(&mut screen, "Cutters (3)");
}

/// A browser's storage.
#[derive(Default)]
struct Storage(Mutex<BTreeMap<String, String>>);

impl Slots for Storage {
    fn names(&self) -> Option<Vec<String>> {
        Some(self.0.lock().unwrap().keys().cloned().collect())
    }

    fn get(&self, name: &str) -> Option<String> {
        self.0.lock().unwrap().get(name).cloned()
    }

    fn put(&self, name: &str, text: &str) -> bool {
        self.0.lock().unwrap().insert(name.to_owned(), text.to_owned());
        true
    }

    fn remove(&self, name: &str) -> bool {
        self.0.lock().unwrap().remove(name);
        true
    }
}

/// What a browser keeps, under names in which nobody takes a word for one that was to be said in another language.
pub fn kept_by_a_browser() -> Arc<dyn Shelf> {
    kept(&[BROKEN, LONG].map(|name| name.replace(' ', "-")))
}

/// What a browser keeps: files of several kinds, one of them broken, one with a long name.
fn kept([broken, long]: &[String; 2]) -> Arc<dyn Shelf> {
    let shelf = PageShelf(Storage::default());
    let tool = OwnFileKind::Tool.template();
    for (name, text) in [
        ("mill.toml", tool),
        (broken.as_str(), &tool.replacen("teeth = 3", "teeth = 30", 1)),
        (long.as_str(), &tool.replacen("teeth = 3", "teeth = 1", 1)),
        ("c60.toml", OwnFileKind::Material.template()),
        ("steps.csv", EXAMPLE_CSV),
        ("bracket.nc", EXAMPLE_GCODE),
    ] {
        shelf.keep(name, text.as_bytes()).unwrap();
    }
    Arc::new(shelf)
}

#[test]
fn a_browser_keeps_files_until_they_are_deleted_twice_said() {
    let shelf = Arc::new(PageShelf(Storage::default()));
    let mut screen = console(PHONE, None, shelf.clone());
    show(&mut screen, None);
    choose(&mut screen, "Begin a new one", "cutter");
    says(&mut screen, "my-tool.toml");
    let said = texts(&screen);
    assert!(said.contains("clears the browser's data") && !said.contains("Its path"), "{said}");
    assert!(screen.unnamed_widgets().is_empty(), "{:?}", screen.unnamed_widgets());
    click(&mut screen, "my-tool.toml");
    says(&mut screen, "is taken as the cutter of this cut");
    click(&mut screen, "Delete\u{2026}: my-tool.toml");
    assert!(shelf.read("my-tool.toml").is_ok(), "it is asked first");
    click(&mut screen, "Keep it: my-tool.toml");
    click(&mut screen, "Delete\u{2026}: my-tool.toml");
    click(&mut screen, "Delete it: my-tool.toml");
    says(&mut screen, "No files here yet");
    assert!(shelf.read("my-tool.toml").is_err());
}

/// A file as a window system drops it.
#[derive(Debug)]
struct Dropped(PathBuf, Vec<u8>);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.1.clone())
    }
}

/// What outlives a console.
#[derive(Clone, Default)]
struct Kept(Arc<Mutex<Option<String>>>);

impl Keeper for Kept {
    fn kept(&self) -> Option<String> {
        self.0.lock().unwrap().clone()
    }

    fn keep(&self, text: &str) -> bool {
        *self.0.lock().unwrap() = Some(text.to_owned());
        true
    }
}

/// A recording whose column n has the times, as nobody guesses.
fn recording(begin: i32) -> Vec<u8> {
    let rows = (0..60).map(|i| format!("{};{},5;{}\n", begin + i, 3 * i % 7, 2 * i));
    format!("Zeit;Fx;n\n[s];[N];[1/min]\n{}", rows.collect::<String>()).into_bytes()
}

#[test]
fn what_was_said_of_a_layout_holds_for_the_next_recording_and_can_be_forgotten() {
    let lab = fresh("lab");
    let kept = Kept::default();
    let start = || {
        let kept = kept.clone();
        opened(DESKTOP, None, move |ctx| {
            let scenario = presets::load("first-cut").unwrap();
            let start = Start { scenario, edits: Edits::none(), notice: None };
            let mut console = Console::new(ctx, start);
            console.remember(Remembered::of(Box::new(kept.clone())));
            console
        })
    };
    let drop_it = |screen: &mut Screen<'_>, path: &Path, bytes: Vec<u8>, wanted: &str| {
        screen.input_mut().dropped_files.push(Arc::new(Dropped(path.to_owned(), bytes)));
        says(screen, wanted);
    };
    let mut screen = start();
    computed(&mut screen);
    let first = lab.join("cut-1.csv");
    drop_it(&mut screen, &first, recording(0), "times in the column Zeit");
    choose(&mut screen, "Time column", "n");
    says(&mut screen, "Remembered in cut-1.csv.layout.toml");
    assert!(texts(&screen).contains("times in the column n"), "{}", texts(&screen));
    let beside = lab.join("cut-1.csv.layout.toml");
    let written =
        in_time(|| std::fs::read_to_string(&beside).is_ok_and(|x| x.contains("time = \"n\"")));
    assert!(written);

    // The next start, another recording, which may have no place at all.
    let mut screen = start();
    computed(&mut screen);
    drop_it(&mut screen, Path::new("cut-2.csv"), recording(500), "times in the column n");
    let said = texts(&screen);
    assert!(said.contains("As you said for a file with the same columns: time"), "{said}");
    drop_it(&mut screen, &first, recording(0), "As the file cut-1.csv.layout.toml beside it says");
    click(&mut screen, "Guess again");
    says(&mut screen, "times in the column Zeit");
    assert!(in_time(|| !beside.exists()), "nothing is remembered beside it");
    let mut screen = start();
    computed(&mut screen);
    drop_it(&mut screen, &first, recording(0), "times in the column Zeit");
    assert!(!texts(&screen).contains("Guess again"), "{}", texts(&screen));
    std::fs::write(&beside, "version = 1\ndecimal = \"dot\"\n").unwrap();
    drop_it(&mut screen, &first, recording(0), "cut-1.csv.layout.toml: `decimal` cannot be dot");
}

#[test]
fn the_files_look_as_they_should() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, theme, name) in [
        (DESKTOP, Theme::Dark, "own-files-desktop-dark"),
        (DESKTOP, Theme::Light, "own-files-desktop-light"),
        (PHONE, Theme::Dark, "own-files-phone-dark"),
        (PHONE, Theme::Light, "own-files-phone-light"),
    ] {
        // The path of a folder is another one on every machine.
        let mut screen = console(size, Some(theme), kept(&[BROKEN, LONG].map(str::to_owned)));
        show(&mut screen, None);
        computed(&mut screen);
        click(&mut screen, "mill.toml");
        says(&mut screen, "mill.toml, in use");
        computed(&mut screen);
        screen.run_steps(200);
        results.add(screen.try_snapshot_options(name, &SnapshotOptions::default()));
    }
}
