//! What a class needs: links with their codes, stars that are remembered, results as files, and what a page that
//! embeds the console hides and locks.

use std::cell::RefCell;
use std::rc::Rc;

use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, LinkText, PlaybackCommand, SessionCommand, ShellCommand};
use steadycut::app::remembered::{Keeper, Remembered};
use steadycut::base::settings::Value;
use steadycut::run::scenario_link;
use steadycut::study::mission::{Mission, MissionResult, TEMPLATE, shipped};
use steadycut::study::opening::Opening;

use crate::drawn;
use crate::screen::{self, Screen, computed, rest, texts};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);
const FIRST: &str = "depth-step-at-constant-feed";

/// A place for what is remembered, which a test can look into; none refuses.
#[derive(Clone)]
pub struct Shelf(Option<Rc<RefCell<String>>>);

impl Shelf {
    pub fn empty() -> Self {
        Self(Some(Rc::default()))
    }
}

impl Keeper for Shelf {
    fn kept(&self) -> Option<String> {
        self.0.as_ref().map(|text| text.borrow().clone())
    }

    fn keep(&self, text: &str) -> bool {
        self.0.as_ref().is_some_and(|kept| {
            text.clone_into(&mut kept.borrow_mut());
            true
        })
    }
}

/// The console on a link; drawn where there is a theme.
fn linked<'a>(link: &str, size: Vec2, theme: Option<Theme>, shelf: &Shelf) -> Screen<'a> {
    let (link, shelf) = (link.to_owned(), shelf.clone());
    let builder = Harness::builder().with_size(size).with_step_dt(0.05);
    let builder = match theme {
        Some(theme) => builder.with_theme(theme).wgpu(),
        None => builder,
    };
    let mut screen: Screen<'a> = builder.build_ui_state(
        move |ui, console: &mut Option<Console>| {
            let console = console.get_or_insert_with(|| {
                let mut console = Console::opened(ui.ctx(), Opening::of_link(&link));
                console.remember(Remembered::of(Box::new(shelf.clone())));
                screen::sliced(console)
            });
            console.ui(ui);
        },
        None,
    );
    screen.run_steps(4);
    screen
}

fn open<'a>(link: &str, size: Vec2) -> Screen<'a> {
    linked(link, size, None, &Shelf::empty())
}

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().unwrap()
}

fn state(screen: &Screen<'_>) -> serde_json::Value {
    serde_json::from_str(&console(screen).state_json()).unwrap()
}

fn push(screen: &mut Screen<'_>, command: Command) {
    console(screen).push(command);
    screen.run_steps(4);
}

fn click(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(4);
}

fn press(screen: &mut Screen<'_>, modifiers: Modifiers, key: Key) {
    screen.key_press_modifiers(modifiers, key);
    screen.run_steps(3);
}

/// The link that is put up now.
fn shown_link(screen: &Screen<'_>) -> String {
    state(screen)["link"].as_str().expect("a link is up").to_owned()
}

/// Hands in the first mission as it is, without predictions.
fn hand_in(screen: &mut Screen<'_>) {
    for leave in ["Go on without a prediction", "Go on without an answer"] {
        click(screen, leave);
        click(screen, "Go on all the same");
    }
    click(screen, "Check my answer");
    rest(screen);
    screen.run_steps(4);
}

/// The text of the code on a picture of the console, read by a decoder of other people's.
fn decoded(screen: &mut Screen<'_>) -> String {
    let picture = screen.render().expect("drawn");
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let grey = |x: usize, y: usize| {
        let [red, green, blue, _] = picture.get_pixel(x as u32, y as u32).0;
        ((u32::from(red) + u32::from(green) + u32::from(blue)) / 3) as u8
    };
    let mut prepared = rqrr::PreparedImage::prepare_from_greyscale(width, height, grey);
    let read = prepared.detect_grids().iter().find_map(|grid| grid.decode().ok());
    read.expect("a code that can be read").1
}

#[test]
fn a_mission_opens_by_its_link_and_the_address_follows_what_the_learner_does() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open(&format!("https://a.org/#mission={FIRST}"), size);
        let mission = shipped::load(FIRST).unwrap();
        assert!(texts(&screen).contains(&mission.title), "{}", texts(&screen));
        assert_eq!(state(&screen)["mission"], format!("mission={FIRST}"));
        assert_eq!(console(&screen).session().scenario(), &mission.scenario);
        press(&mut screen, Modifiers::COMMAND, Key::L);
        assert_eq!(shown_link(&screen), format!("#mission={FIRST}"));
        press(&mut screen, Modifiers::NONE, Key::Escape);
        let kind = ("controller.kind".to_owned(), Value::Text("tracking".to_owned()));
        push(&mut screen, Command::Session(SessionCommand::SetUp(vec![kind])));
        press(&mut screen, Modifiers::COMMAND, Key::L);
        let link = shown_link(&screen);
        assert!(link.starts_with(&format!("#mission={FIRST}&v=1")), "{link}");
        // It opens the mission with what was changed.
        let again = open(&link, size);
        assert_eq!(console(&again).session().scenario(), console(&screen).session().scenario());
        assert!(texts(&again).contains(&mission.title));
        press(&mut screen, Modifiers::NONE, Key::Escape);
        click(&mut screen, "Leave");
        press(&mut screen, Modifiers::COMMAND, Key::L);
        assert!(shown_link(&screen).starts_with("#v=1"), "{}", shown_link(&screen));
    }
}

#[test]
fn a_trainers_own_mission_travels_whole_and_a_bad_link_says_what_is_wrong() {
    let mission = Mission::read(TEMPLATE).unwrap();
    let mut screen = open(&format!("#{}", mission.link()), DESKTOP);
    assert!(texts(&screen).contains(&mission.title), "{}", texts(&screen));
    click(&mut screen, &format!("Link: {}", mission.title));
    assert_eq!(shown_link(&screen), format!("#{}", mission.link()));
    let screen = open("#mission=quite-speed", DESKTOP);
    let said = texts(&screen);
    assert!(said.contains("quite-speed") && said.contains("quiet-speed"), "{said}");
    let screen = open(&format!("#mission={FIRST}&v=1&target.ra_um=3"), DESKTOP);
    let said = texts(&screen);
    assert!(
        said.contains("begins anew") && said.contains("the mission opens controller.kind"),
        "{said}"
    );
}

#[test]
fn the_desktop_asks_for_the_page_of_a_code_once() {
    let shelf = Shelf::empty();
    let mut screen = linked("#v=1&target.ra_um=0.6", DESKTOP, None, &shelf);
    press(&mut screen, Modifiers::COMMAND, Key::L);
    assert!(screen.query_by_label("QR code of the link").is_none());
    let field = screen.get_by_role_and_label(
        Role::TextInput,
        "For a QR code: the address of a page with SteadyCut on it",
    );
    field.focus();
    screen.run_steps(2);
    screen.event(egui::Event::Text("example.org".to_owned()));
    screen.run_steps(2);
    assert!(texts(&screen).contains("begins with https://"), "{}", texts(&screen));
    press(&mut screen, Modifiers::COMMAND, Key::A);
    screen.event(egui::Event::Text("https://example.org/".to_owned()));
    screen.run_steps(2);
    click(&mut screen, "Make the code");
    screen.get_by_label("QR code of the link");
    assert_eq!(shown_link(&screen), "https://example.org/#v=1&target.ra_um=0.6");
    assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    // At the next start it is known.
    let mut screen = linked("#v=1&target.ra_um=0.7", DESKTOP, None, &shelf);
    press(&mut screen, Modifiers::COMMAND, Key::L);
    assert_eq!(shown_link(&screen), "https://example.org/#v=1&target.ra_um=0.7");
    screen.get_by_label("QR code of the link");
}

/// What a click on a button puts into the clipboard.
fn copied(screen: &mut Screen<'_>, name: &str) -> String {
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    let mut copied = None;
    for _ in 0..4 {
        screen.run_steps(1);
        for command in &screen.output().platform_output.commands {
            if let egui::OutputCommand::CopyText(text) = command {
                copied = Some(text.clone());
            }
        }
    }
    copied.expect("something is copied")
}

#[test]
fn link_command_line_and_digest_are_of_one_run_and_can_be_copied() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("#v=1&target.ra_um=0.6", size);
        press(&mut screen, Modifiers::NONE, Key::Space);
        computed(&mut screen);
        let digest =
            |screen: &Screen<'_>| console(screen).session().chosen().run().recording().digest();
        let first = digest(&screen);
        press(&mut screen, Modifiers::COMMAND, Key::L);
        let link = shown_link(&screen);
        let said = texts(&screen);
        assert!(said.contains(&first) && !said.contains('`'), "{said}");
        assert_eq!(copied(&mut screen, "Copy the command line"), format!("steadycut run '{link}'"));
        let said = texts(&screen);
        assert!(said.contains("The command line is in the clipboard."), "{said}");
        // As with a link, the text is put up where the clipboard is denied.
        let (what, denied) = (LinkText::CommandLine, false);
        push(&mut screen, Command::Shell(ShellCommand::Copied { what, copied: denied }));
        let line = format!("steadycut run '{link}'");
        let field = screen
            .get_by(|node| node.role() == Role::TextInput && node.value().as_ref() == Some(&line));
        assert!(field.accesskit_node().is_focused());
        assert_eq!(copied(&mut screen, "Copy the link"), link);
        // The run is changed while the window is open.
        let changed = |screen: &Screen<'_>| texts(screen).contains("The cut has changed since");
        assert!(!changed(&screen));
        push(&mut screen, Command::set("noise.level", Value::Float(1.0)));
        computed(&mut screen);
        let said = texts(&screen);
        assert!(
            changed(&screen) && said.contains(&first) && !said.contains(&digest(&screen)),
            "{said}"
        );
        assert_eq!(shown_link(&screen), link);
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
        click(&mut screen, "Take a new link");
        let said = texts(&screen);
        assert!(
            !changed(&screen) && said.contains(&digest(&screen)) && !said.contains(&first),
            "{said}"
        );
        assert_ne!(shown_link(&screen), link);
    }
}

#[test]
fn a_link_too_long_for_a_code_says_so() {
    let mut screen = open("", PHONE);
    let link = format!("https://example.org/#v=1&z={}", "Qx7".repeat(1200));
    push(&mut screen, Command::Shell(ShellCommand::ShowLink { link, copied: true }));
    assert!(screen.query_by_label("QR code of the link").is_none());
    assert!(texts(&screen).contains("holds 2953 at most"), "{}", texts(&screen));
}

#[test]
fn the_code_on_the_screen_is_read_again() {
    if !drawn::in_software() {
        return;
    }
    let packed = Mission::read(TEMPLATE).unwrap().link();
    for (size, theme) in [(DESKTOP, Theme::Light), (PHONE, Theme::Dark)] {
        for link in [format!("https://example.org/steadycut/#mission={FIRST}"), {
            format!("https://example.org/steadycut/#{packed}")
        }] {
            let mut screen = linked("", size, Some(theme), &Shelf::empty());
            press(&mut screen, Modifiers::NONE, Key::Space);
            let up = ShellCommand::ShowLink { link: link.clone(), copied: true };
            push(&mut screen, Command::Shell(up));
            screen.run_steps(20);
            assert_eq!(decoded(&mut screen), link);
        }
    }
}

#[test]
fn stars_are_remembered_until_they_are_forgotten() {
    let shelf = Shelf::empty();
    let size = vec2(1280.0, 2400.0);
    let link = format!("#mission={FIRST}");
    let mut screen = linked(&link, size, None, &shelf);
    hand_in(&mut screen);
    let result = state(&screen)["result"].clone();
    assert_eq!(
        (&result["mission"]["id"], &result["verdict"]["passed"]),
        (&FIRST.into(), &false.into())
    );
    assert_eq!(state(&screen)["stars"], 0);
    let mut screen = linked("#embed=screen:learn", size, None, &shelf);
    assert!(texts(&screen).contains("not passed yet"), "{}", texts(&screen));
    click(&mut screen, "Forget my stars\u{2026}");
    click(&mut screen, "Keep them");
    assert!(texts(&screen).contains("not passed yet"));
    click(&mut screen, "Forget my stars\u{2026}");
    click(&mut screen, "Forget them");
    assert!(!texts(&screen).contains("not passed yet"));
    let screen = linked("#embed=screen:learn", size, None, &shelf);
    assert!(!texts(&screen).contains("not passed yet"));
    // Where it is refused nothing fails, and it is said.
    let mut screen = linked(&link, size, None, &Shelf(None));
    hand_in(&mut screen);
    click(&mut screen, "Leave");
    let said = texts(&screen);
    assert!(said.contains("not passed yet") && said.contains("until the program ends"), "{said}");
}

#[test]
fn a_result_is_saved_with_the_name_that_was_typed() {
    for size in [vec2(1280.0, 2400.0), vec2(390.0, 5200.0)] {
        let mut screen = open(&format!("#mission={FIRST}"), size);
        hand_in(&mut screen);
        let field = screen.get_by_role_and_label(Role::TextInput, "Your name");
        field.focus();
        screen.run_steps(2);
        screen.event(egui::Event::Text("Ada".to_owned()));
        screen.run_steps(2);
        let field = screen.get_by_role_and_label(Role::TextInput, "Your name");
        assert_eq!(field.accesskit_node().value().as_deref(), Some("Ada"));
        screen.get_by_role_and_label(Role::Button, "Save result");
        assert!(state(&screen)["rects"]["lesson"]["check"].is_array());
        let text = state(&screen)["result"].to_string();
        let result = MissionResult::read(&text).unwrap();
        let mission = shipped::load(FIRST).unwrap();
        let answer = result.answer(&mission).unwrap();
        assert_eq!(answer.scenario, mission.scenario);
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

#[test]
fn flags_hide_what_they_name_and_keys_do_not_lead_there_either() {
    for size in [DESKTOP, PHONE] {
        let shown = |screen: &Screen<'_>, name: &str| {
            let all = screen.root().children_recursive();
            all.filter_map(|node| node.accesskit_node().label()).any(|label| label == name)
        };
        let screen = open("#v=1", size);
        assert!(shown(&screen, "Messages") || shown(&screen, "Menu") || shown(&screen, "Undo"));
        assert!(shown(&screen, "Restart") && shown(&screen, "Target Ra"));
        let screen = open("#embed=hide:transport,hide:bar", size);
        for name in ["Restart", "Undo", "Menu", "Learn"] {
            assert!(!shown(&screen, name), "{name}");
        }
        let mut screen = open("#embed=hide:screens,hide:files,hide:find,hide:settings", size);
        if size == PHONE {
            click(&mut screen, "Menu");
        }
        for name in ["Learn", "Link", "Find", "Scenario", "Settings"] {
            assert!(!shown(&screen, name), "{name}");
        }
        assert!(shown(&screen, "Undo"));
        press(&mut screen, Modifiers::NONE, Key::Escape);
        press(&mut screen, Modifiers::COMMAND, Key::Num3);
        assert_eq!(state(&screen)["screen"], "console");
        press(&mut screen, Modifiers::COMMAND, Key::L);
        assert_eq!(state(&screen)["link"], serde_json::Value::Null);
        press(&mut screen, Modifiers::NONE, Key::Slash);
        let said = texts(&screen);
        assert!(said.contains("hide:find") && !said.contains("Type a word"), "{said}");
    }
}

#[test]
fn a_locked_setting_is_shown_locked_and_nothing_changes_it() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("#v=1&target.ra_um=0.6&embed=lock:target,lock:controller", size);
        let target = |screen: &Screen<'_>| console(screen).session().current().target.ra_um;
        assert!(texts(&screen).contains("Locked"), "{}", texts(&screen));
        let field = screen.get_by_role_and_label(Role::SpinButton, "Target Ra");
        assert!(field.accesskit_node().is_disabled());
        push(&mut screen, Command::set("target.ra_um", Value::Float(2.0)));
        let said = texts(&screen);
        assert!(said.contains("locked by the address"), "{said}");
        let both = vec![
            ("noise.level".to_owned(), Value::Float(1.0)),
            ("controller.kind".to_owned(), Value::Text("afc".to_owned())),
        ];
        push(&mut screen, Command::Session(SessionCommand::SetUp(both)));
        for key in [Key::Z, Key::Y] {
            press(&mut screen, Modifiers::COMMAND, key);
        }
        let preset = SessionCommand::LoadPreset("chatter".to_owned());
        push(&mut screen, Command::Session(preset));
        let text =
            SessionCommand::LoadText { name: "x.toml".to_owned(), text: "version = 1".to_owned() };
        push(&mut screen, Command::Session(text));
        push(&mut screen, Command::Playback(PlaybackCommand::SeekTo(1.0)));
        push(&mut screen, Command::set("target.ra_um", Value::Float(1.0)));
        assert_eq!(target(&screen), 0.6);
        assert_eq!(console(&screen).session().edits().list().len(), 0);
        // What is not locked is changed as ever.
        push(&mut screen, Command::set("noise.level", Value::Float(1.0)));
        assert_eq!(console(&screen).session().current().noise.level, 1.0);
        let console = screen.state_mut().as_mut().unwrap();
        assert!(console.keeps_its_address(), "a link pasted into the page is not followed");
    }
    let mut free = open("#v=1", DESKTOP);
    assert!(!free.state_mut().as_mut().unwrap().keeps_its_address());
}

#[test]
fn an_unknown_flag_is_named_with_what_is_allowed_and_the_address_keeps_the_others() {
    let mut screen = open("#embed=hide:transprt,lang:fr,screen:plans,hide:find&v=1", DESKTOP);
    let said = texts(&screen);
    for word in
        ["`hide:transprt`", "transport", "`lang:fr`", "en, sl, de", "`screen:plans`", "plan, "]
    {
        assert!(said.contains(word), "{said} lacks {word}");
    }
    press(&mut screen, Modifiers::COMMAND, Key::L);
    let link = shown_link(&screen);
    assert!(link.starts_with("#embed=screen:plans,hide:find&"), "{link}");
    assert!(scenario_link::parse("v=1").is_ok());
}

/// Pictures of the link window, a result, and locked settings.
#[test]
fn what_a_class_sees_looks_as_it_should() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, theme, look) in
        [(DESKTOP, Theme::Light, "desktop-light"), (PHONE, Theme::Dark, "phone-dark")]
    {
        let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
        let mut picture = |screen: &mut Screen<'_>, name: &str| {
            screen.run_steps(20);
            rest(screen);
            results.add(screen.try_snapshot_options(format!("{name}-{look}"), &options));
        };
        let mut screen = linked("", size, Some(theme), &Shelf::empty());
        press(&mut screen, Modifiers::NONE, Key::Space);
        press(&mut screen, Modifiers::COMMAND, Key::L);
        picture(&mut screen, "link-page");
        press(&mut screen, Modifiers::NONE, Key::Escape);
        let link = format!("https://example.org/steadycut/#mission={FIRST}");
        push(&mut screen, Command::Shell(ShellCommand::ShowLink { link, copied: true }));
        picture(&mut screen, "link-mission");
        let link = format!("https://example.org/#{}", Mission::read(TEMPLATE).unwrap().link());
        push(&mut screen, Command::Shell(ShellCommand::ShowLink { link, copied: true }));
        picture(&mut screen, "link-own-mission");
        let locks =
            "#v=1&target.ra_um=0.6&embed=lock:target,lock:controller.kind,hide:screens,hide:files";
        let mut screen = linked(locks, size, Some(theme), &Shelf::empty());
        press(&mut screen, Modifiers::NONE, Key::Space);
        push(&mut screen, Command::set("target.ra_um", Value::Float(2.0)));
        picture(&mut screen, "locked");
        let bare = "#embed=hide:bar,hide:transport,hide:settings&v=1";
        let mut screen = linked(bare, size, Some(theme), &Shelf::empty());
        push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
        rest(&mut screen);
        picture(&mut screen, "embedded");
        let mut screen = linked(&format!("#mission={FIRST}"), size, Some(theme), &Shelf::empty());
        push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
        hand_in(&mut screen);
        picture(&mut screen, "result");
    }
}
