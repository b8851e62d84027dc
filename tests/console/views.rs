//! All that the console can show, one view after the other, for tests that judge every one of them.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Rect, Shape, Theme, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use steadycut::app::Console;
use steadycut::app::command::{Command, FileCommand, LibraryCommand, ShellCommand};
use steadycut::app::overlay::file::MeasuredFile;
use steadycut::app::panels::{BroughtFile, panels};
use steadycut::measured::layout::DataLayout;
use steadycut::run::edits::Edits;
use steadycut::run::{Start, presets};

use crate::own_files::kept_by_a_browser;
use crate::screen::{self, Screen, sliced};

/// A window of the desktop and the screen of a phone.
pub const DESKTOP: Vec2 = vec2(1280.0, 800.0);
/// See [`DESKTOP`].
pub const PHONE: Vec2 = vec2(390.0, 844.0);
/// Heights of windows in which whole pages are seen, points: on the desktop and on a phone. The last shows all of
/// every page; a picture costs by its height, so one is drawn at the first height that shows as much.
const TALL: [[f32; 4]; 2] = [[800.0, 1100.0, 1500.0, 2000.0], [844.0, 1500.0, 2200.0, 3000.0]];

/// What looks at a view; it gets its name.
pub type Look<'l> = &'l mut dyn FnMut(&mut Screen<'_>, &str);

/// The console in a window: drawn if `pixels`, so many to the point.
fn window<'a>(preset: &'static str, size: Vec2, pixels: Option<f32>) -> Screen<'a> {
    let builder = Harness::builder().with_size(size).with_step_dt(0.05).with_theme(Theme::Light);
    let builder = match pixels {
        Some(pixels) => builder.with_pixels_per_point(pixels).wgpu(),
        None => builder,
    };
    let mut screen: Screen<'a> = builder.build_ui_state(
        move |ui, console: &mut Option<Console>| {
            let console = console.get_or_insert_with(|| {
                let scenario = presets::load(preset).expect("shipped");
                let start = Start { scenario, edits: Edits::none(), notice: None };
                let mut console = sliced(Console::new(ui.ctx(), start));
                console.keep_files(kept_by_a_browser());
                console
            });
            console.ui(ui);
        },
        None,
    );
    screen.run_steps(3);
    press(&mut screen, Modifiers::NONE, Key::Space);
    press(&mut screen, Modifiers::NONE, Key::End);
    press(&mut screen, Modifiers::NONE, Key::PageUp);
    for _ in 0..24 {
        press(&mut screen, Modifiers::SHIFT, Key::ArrowLeft);
    }
    screen
}

fn press(screen: &mut Screen<'_>, modifiers: Modifiers, key: Key) {
    screen.key_press_modifiers(modifiers, key);
    screen.run_steps(2);
}

/// Presses what has this name, also where it is scrolled out of sight.
pub fn click(screen: &mut Screen<'_>, name: &str) {
    let found = screen.get_all_by_label(name).last();
    found.unwrap_or_else(|| panic!("no {name}")).click_accesskit();
    screen.run_steps(10);
}

/// Until what fades in has come, and what is worked out is there.
fn settle(screen: &mut Screen<'_>) {
    screen.run_steps(20);
    screen::rest(screen);
}

/// How many texts are seen, in part at least.
fn texts(screen: &Screen<'_>) -> usize {
    fn of(shape: &Shape, clip: Rect) -> usize {
        match shape {
            Shape::Vec(shapes) => shapes.iter().map(|shape| of(shape, clip)).sum(),
            Shape::Text(text) => usize::from(clip.intersects(text.visual_bounding_rect())),
            _ => 0,
        }
    }
    let whole = screen.ctx.content_rect();
    let shapes = screen.output().shapes.iter();
    shapes.map(|clipped| of(&clipped.shape, clipped.clip_rect.intersect(whole))).sum()
}

/// The view as it is, and as a page of any length; the former is a part of the latter, and not drawn as well.
fn whole(screen: &mut Screen<'_>, name: &str, look: Look<'_>) {
    settle(screen);
    let drawn = screen.ctx.pixels_per_point() != 1.0;
    if !drawn {
        look(screen, name);
    }
    let size = screen.ctx.content_rect().size();
    let heights = TALL[usize::from(size.x == PHONE.x)];
    let at = |screen: &mut Screen<'_>, height: f32| {
        screen.set_size(vec2(size.x, height));
        screen.run_steps(4);
        settle(screen);
        texts(screen)
    };
    let all = at(screen, heights[3]);
    if drawn {
        heights.into_iter().find(|height| at(screen, *height) >= all);
    }
    look(screen, &format!("{name}, whole"));
    screen.set_size(size);
    screen.run_steps(4);
}

/// Shows `look` every view in this size; `pixels` to the point are drawn, or none.
pub fn all(size: Vec2, pixels: Option<f32>, look: Look<'_>) {
    screens(size, pixels, look);
    overlays(size, pixels, look);
}

/// Every screen, and every part of it that has a button.
fn screens(size: Vec2, pixels: Option<f32>, look: Look<'_>) {
    let mut screen = window("first-cut", size, pixels);
    for panel in panels() {
        screen::show(&mut screen, panel.title());
        whole(&mut screen, panel.title(), look);
    }
    screen::show(&mut screen, "Block diagram");
    click(&mut screen, "Plot Feed");
    click(&mut screen, "What is this?");
    whole(&mut screen, "Block diagram, explained", look);
    screen::show(&mut screen, "Workpiece");
    click(&mut screen, "Profilometer");
    whole(&mut screen, "Workpiece, profilometer", look);
    screen::show(&mut screen, "Plan");
    click(&mut screen, "3-D");
    whole(&mut screen, "Plan, in space", look);
    screen::show(&mut screen, "Machine");
    for part in ["Wear and sound", "Stability"] {
        click(&mut screen, part);
        while screen.query_all_by_role(Role::ProgressIndicator).next().is_some() {
            screen.run_steps(5);
        }
        whole(&mut screen, &format!("Machine, {part}"), look);
    }
    screen::show(&mut screen, "Papers");
    for paper in ["as printed", "Dynamic model 2019, Table 1", "Combined system 2005, Table 1"] {
        click(&mut screen, paper);
        whole(&mut screen, &format!("Papers, {paper}"), look);
    }
    screen::show(&mut screen, "Compare");
    click(&mut screen, "Part: Experiment 2");
    click(&mut screen, "Run the comparison");
    screen.run_steps(40);
    click(&mut screen, "Pause the comparison");
    whole(&mut screen, "Compare, some runs", look);

    screen::show(&mut screen, "Identify");
    screen.get_by_role_and_label(Role::SpinButton, "Most batches").set_value_accesskit(6.0);
    screen.run_steps(2);
    click(&mut screen, "Search");
    whole(&mut screen, "Identify, a front", look);
    screen.get_by_role_and_label(Role::SpinButton, "Seed").set_value_accesskit(3.0);
    screen.run_steps(2);
    let bad = ("bad.csv".to_owned(), "a,b\n1,x\n".to_owned());
    let bad = FileCommand::Bring(BroughtFile::Table { name: bad.0, text: bad.1 });
    screen.state().as_ref().unwrap().push(Command::File(bad));
    whole(&mut screen, "Identify, changed, a bad table", look);
    click(&mut screen, "Fit settings");
    whole(&mut screen, "Identify, fits", look);
    for kind in ["Drive", "Forces", "Structure", "Noise", "Wear", "Material"] {
        click(&mut screen, &format!("Fitted: {kind}"));
        click(&mut screen, "Try with sample data");
        screen::rest(&mut screen);
        screen.run_steps(3);
        if kind != "Forces" {
            click(&mut screen, "Fit");
        }
        whole(&mut screen, &format!("Identify, fits, {kind}"), look);
    }

    let mut screen = window("depth-step", size, pixels);
    press(&mut screen, Modifiers::NONE, Key::M);
    whole(&mut screen, "Operator", look);
    press(&mut screen, Modifiers::NONE, Key::Minus);
    press(&mut screen, Modifiers::NONE, Key::End);
    whole(&mut screen, "Operator, a score", look);
    click(&mut screen, "Whole console");
    whole(&mut screen, "Operator, whole console", look);

    let mut screen = window("experiment-2", size, pixels);
    whole(&mut screen, "Console, several cuts", look);
    screen::show(&mut screen, "Block diagram");
    click(&mut screen, "Networks that learn");
    whole(&mut screen, "Networks", look);
    let mut screen = window("chatter", size, pixels);
    whole(&mut screen, "Console, chatter", look);
}

/// All that lies over the screens.
fn overlays(size: Vec2, pixels: Option<f32>, look: Look<'_>) {
    let mut screen = window("first-cut", size, pixels);
    let phone = size == PHONE;
    let over = |screen: &mut Screen<'_>, name: &str, look: Look<'_>| {
        settle(screen);
        look(screen, name);
        press(screen, Modifiers::NONE, Key::Escape);
        press(screen, Modifiers::NONE, Key::Escape);
        screen.run_steps(10);
    };
    press(&mut screen, Modifiers::NONE, Key::Questionmark);
    over(&mut screen, "keys", look);
    for words in ["dead time", "chatter", "nothing has these"] {
        press(&mut screen, Modifiers::NONE, Key::Slash);
        screen.event(Event::Text(words.to_owned()));
        over(&mut screen, &format!("search of {words}"), look);
    }
    let link = format!("https://example.org/steadycut/#z={}", "Qx7".repeat(60));
    let push = |screen: &Screen<'_>, command| screen.state().as_ref().unwrap().push(command);
    push(&screen, Command::Shell(ShellCommand::ShowLink { link, copied: false }));
    over(&mut screen, "link", look);
    push(&screen, Command::Library(LibraryCommand::Show { open: true, kind: None }));
    over(&mut screen, "my files", look);
    push(&screen, Command::notify("The scenario file was not read: it is empty.".to_owned()));
    screen.run_steps(2);
    settle(&mut screen);
    look(&mut screen, "message");
    click(&mut screen, "Messages");
    over(&mut screen, "messages", look);
    if phone {
        click(&mut screen, "Menu");
        over(&mut screen, "menu", look);
        click(&mut screen, "Settings");
    }
    click(&mut screen, "Scenario");
    over(&mut screen, "list of scenarios", look);
    click(&mut screen, "Within a revolution\u{2026}");
    over(&mut screen, "within a revolution, no teeth", look);
    let place = screen.get_by_label_contains("Ra in tolerance").rect().center();
    screen.event(Event::PointerMoved(place));
    over(&mut screen, "word explained", look);
    screen.event(Event::PointerGone);
    click(&mut screen, "More settings");
    whole(&mut screen, "settings", look);
    let groups =
        screen.query_all_by_role(Role::Button).filter_map(|node| node.accesskit_node().label());
    let groups: Vec<String> = groups.collect();
    for group in GROUPS.iter().filter(|group| groups.iter().any(|name| name == *group)) {
        click(&mut screen, group);
    }
    whole(&mut screen, "all settings", look);

    let mut screen = window("experiment-2", size, pixels);
    if phone {
        click(&mut screen, "Settings");
    }
    click(&mut screen, "Within a revolution\u{2026}");
    over(&mut screen, "within a revolution", look);
    click(&mut screen, "More settings");
    click(&mut screen, "Workpiece");
    click(&mut screen, "Edit depths\u{2026}");
    over(&mut screen, "cuts", look);
    let rows = (0..200).map(|i| format!("{}.{:02},{}\n", i / 50, 2 * (i % 50), (i * 7) % 31));
    for (name, text) in [
        ("measured data", format!("t [s],Fx [N]\n{}", rows.collect::<String>())),
        ("measured data, faulty", "t [s],Fx [N]\n0.0,1\n0.1,2\n0.2,x\n0.3,1\n".to_owned()),
    ] {
        let bytes = text.into_bytes().into();
        let file = MeasuredFile::read("cut.csv".to_owned(), bytes, DataLayout::default());
        let brought = FileCommand::Bring(BroughtFile::Measured(Box::new(file)));
        screen.state().as_ref().unwrap().push(Command::File(brought));
        screen.run_steps(5);
        settle(&mut screen);
        look(&mut screen, name);
    }
    press(&mut screen, Modifiers::NONE, Key::Escape);
}

/// Groups of settings with lists, tables and long texts in them.
const GROUPS: [&str; 6] =
    ["Target", "Workpiece", "CNC and dead time", "Off-line plan", "Roughness profile", "Name"];
