//! Other languages: that every text is asked for in them, has room in them, and that they are changed in the running
//! program.

use std::collections::BTreeSet;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, HarnessBuilder, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::Command;
use steadycut::app::remembered::Remembered;
use steadycut::base::language::{self, Catalogue, Language, tr};
use steadycut::base::settings::Value;
use steadycut::run::glossary::GLOSSARY;
use steadycut::study::opening::Opening;

use crate::drawn;
use crate::judged::Judge;
use crate::legible::each_text;
use crate::screen::{Screen, computed, rest, sliced, texts};
use crate::sharing::Shelf;
use crate::views::{DESKTOP, PHONE};

/// Words that are the same in every language: names, symbols, units and what people have written themselves.
const SAME: [&str; 46] = [
    "MHz",
    "steadycut",
    "run",
    "Radyn",
    "Ratarget",
    "Left",
    "Right",
    "Slash",
    "LINK",
    "SteadyCut",
    "English",
    "Slovenščina",
    "Deutsch",
    "SDNRP",
    "UNKS",
    "FAGOR",
    "Heller",
    "Table",
    "CSV",
    "TOML",
    "JSON",
    "AFC",
    "FMIN",
    "FMAX",
    "Alt",
    "Esc",
    "Tab",
    "Enter",
    "min",
    "max",
    "rpm",
    "mm",
    "deg",
    "log",
    "exp",
    "sqrt",
    "sin",
    "cos",
    "tanh",
    "Smith",
    "Taylor",
    "Kienzle",
    "Python",
    "LaTeX",
    "Rust",
    "Arrow",
];

/// What people have written themselves in the views: names of columns, and what they look for.
const OWN: [&str; 8] = [
    "final",
    "sim",
    "nothing has these",
    "speed [m/min]",
    "time [min]",
    "frequency [Hz]",
    "real [m/N]",
    "imaginary [m/N]",
];
/// What was said once and stays as it was said: messages, the score of a cut that is over, figures kept with a chart.
const SAID: [&str; 5] =
    ["The scenario file was not read", "not opened: bad.csv", "You held", "You have the feed", "•"];
/// Where a text that has no room is seen whole at once: in the open list of scenarios or settings, and on the card of
/// a block.
const SEEN_WHOLE: [&str; 3] = ["Scenario: ", "Conventional (constant feed)", "Block diagram"];

/// Whether a text has words that a language would write in another way: three letters and more beside each other, which
/// are no name, and no part of a formula, a path or a file's name.
fn has_words(text: &str) -> bool {
    let formula = |word: &str| word.contains(['=', '_', '/', '\\', '^', '·', '(', ')', '{', '.']);
    text.split_whitespace()
        .filter(|word| !formula(word.trim_end_matches(['.', ':', ',', ')', ';'])))
        .any(|word| {
            word.split(|letter: char| !letter.is_alphabetic()).any(|part| {
                part.chars().count() > 2
                    && !SAME.contains(&part)
                    && part.chars().any(char::is_lowercase)
            })
        })
}

/// Looks at every view in a language that is a third longer than English, and marks all that it knows.
#[derive(Default)]
pub struct Spoken {
    forgotten: BTreeSet<String>,
    elided: BTreeSet<String>,
    known: usize,
}

impl Spoken {
    fn look(&mut self, screen: &mut Screen<'_>, view: &str) {
        each_text(screen, |text, clip| {
            let words = &text.galley.job.text;
            if words.contains('«') {
                self.known += 1;
                let told = format!("{view}: {words}");
                let whole = SEEN_WHOLE.iter().any(|place| told.contains(place));
                if text.galley.elided && clip.intersects(text.visual_bounding_rect()) && !whole {
                    self.elided.insert(told);
                }
            } else if has_words(words)
                && !OWN.iter().chain(&SAID).any(|own| words.contains(own))
                && !GLOSSARY.iter().any(|term| {
                    term.spellings.contains(&words.trim()) || term.spellings.join(", ") == *words
                })
            {
                self.forgotten.insert(format!("{view}: {words}"));
            }
        });
    }
}

impl Judge for Spoken {
    fn view(&mut self, screen: &mut Screen<'_>, view: &str) {
        let speak = |screen: &mut Screen<'_>, catalogue| {
            language::use_catalogue(catalogue);
            screen.state_mut().as_mut().expect("there").tell_anew();
            screen.run_steps(3);
        };
        speak(screen, Some(Catalogue::padded()));
        self.look(screen, view);
        speak(screen, None);
    }

    fn verdict(&mut self) -> Vec<String> {
        assert!(self.known > 1500, "{} texts were known", self.known);
        let forgotten =
            self.forgotten.iter().map(|text| format!("not asked for in a language: {text}"));
        forgotten.chain(self.elided.iter().map(|text| format!("has no room: {text}"))).collect()
    }
}

#[test]
fn words_are_told_from_names_units_and_formulas() {
    for words in ["Play again", "no contact", "Speed max"] {
        assert!(has_words(words), "{words}");
    }
    for others in
        ["0.81 µm", "SDNRP", "430 mm/min", "F = k_c1.1 · h", "tool.teeth", "12.3 s", "K2 Kp 0.50 %"]
    {
        assert!(!has_words(others), "{others}");
    }
}

/// The console of a link on a system that asks for a language.
fn started<'a>(size: Vec2, link: &'a str, shelf: &'a Shelf, system: &'a str) -> Screen<'a> {
    built(Harness::builder().with_size(size), link, shelf, system)
}

fn built<'a>(
    builder: HarnessBuilder<Option<Console>>,
    link: &'a str,
    shelf: &'a Shelf,
    system: &'a str,
) -> Screen<'a> {
    let mut screen = builder.with_step_dt(0.05).build_ui_state(
        move |ui, console: &mut Option<Console>| {
            let console = console.get_or_insert_with(|| {
                let mut console = sliced(Console::opened(ui.ctx(), Opening::of_link(link)));
                console.remember(Remembered::of(Box::new(shelf.clone())));
                console.speak_as_asked([system.to_owned()]);
                console
            });
            console.ui(ui);
        },
        None,
    );
    screen.run_steps(4);
    screen
}

/// A text in a language, which has it.
fn told(language: Language, english: &str) -> &'static str {
    let told = Catalogue::of(language).expect("not English").plain(english);
    told.unwrap_or_else(|| panic!("{}: {english}", language.id()))
}

fn press(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click();
    screen.run_steps(4);
}

#[test]
fn the_language_is_changed_in_the_running_cut_and_remembered() {
    for size in [DESKTOP, PHONE] {
        let shelf = Shelf::empty();
        let mut screen = started(size, "#v=1", &shelf, "fr-FR");
        let phone = size == PHONE;
        press(&mut screen, if phone { "Menu" } else { "Language" });
        press(&mut screen, "Deutsch");
        let german = |english| told(Language::German, english);
        let target = german("Target Ra");
        let field = |screen: &Screen<'_>, name: &str| {
            let field = screen.get_by_role_and_label(Role::SpinButton, name);
            field.accesskit_node().value().unwrap_or_default()
        };
        assert!(field(&screen, target).contains(','), "{}", field(&screen, target));
        let said = texts(&screen);
        assert!(said.contains(german("Restart")), "{said}");
        // What was said of the cut is said anew.
        let mut story = screen.state().as_ref().unwrap().session().whole_story().events.iter();
        assert!(story.all(|event| !event.sentence.contains("the part gets")));
        drop(screen);
        // The next start, whatever the system says; a link that says another one is obeyed.
        assert!(texts(&started(size, "#v=1", &shelf, "sl-SI")).contains(german("Restart")));
        let slovenian = told(Language::Slovenian, "Restart");
        let linked = started(size, "#embed=lang:sl&v=1", &shelf, "en");
        assert!(texts(&linked).contains(slovenian), "{}", texts(&linked));
        let empty = Shelf::empty();
        let first = started(size, "#v=1", &empty, "sl_SI.UTF-8");
        assert!(texts(&first).contains(slovenian));
        let none = started(size, "#v=1", &empty, "fr");
        assert!(texts(&none).contains("Restart"));
    }
}

#[test]
fn a_comma_and_a_point_are_the_same_in_every_language() {
    for tag in ["en", "sl", "de"] {
        let shelf = Shelf::empty();
        let mut screen = started(DESKTOP, "#v=1", &shelf, tag);
        let name = tr("Target Ra").to_owned();
        for (typed, ra_um) in [("1,2", 1.2), ("0.7", 0.7)] {
            let field = screen.get_by_role_and_label(Role::SpinButton, &name);
            field.click();
            screen.run_steps(3);
            screen.key_press_modifiers(Modifiers::COMMAND, Key::A);
            screen.run_steps(2);
            screen.event(Event::Text(typed.to_owned()));
            screen.key_press(Key::Enter);
            screen.run_steps(4);
            let now = screen.state().as_ref().unwrap().session().current().target.ra_um;
            assert_eq!(now, ra_um, "{typed} in {tag}");
        }
    }
}

/// Keys have the names that stand on the keyboards of the language.
#[test]
fn keys_are_named_as_the_keyboards_of_the_language_name_them() {
    for (tag, named, foreign) in [
        (
            "de",
            ["Leertaste", "Umschalt+Pos1", "Pos1", "Ende", "Strg+Z", "Strg+Umschalt+Z", "Bild auf"],
            ["Space", "Home", "End", "Shift+Home", "Ctrl+Z"],
        ),
        (
            "sl",
            ["preslednica", "Shift+Home", "Home", "End", "Ctrl+Z", "Page Up", "vračalka"],
            ["Space", "PageUp", "Backspace", "Umschalt+Pos1", "Ende"],
        ),
    ] {
        let shelf = Shelf::empty();
        let mut screen = started(vec2(1280.0, 2400.0), "#v=1", &shelf, tag);
        screen.key_press(Key::Questionmark);
        screen.run_steps(6);
        let said = texts(&screen);
        let is_there = |name: &str| said.lines().any(|line| line == name);
        for name in named {
            assert!(is_there(name), "{tag}: {name} in {said}");
        }
        for name in foreign {
            assert!(!is_there(name), "{tag}: {name} in {said}");
        }
    }
}

/// A negative number has the sign minus, and its unit stays with it; a hyphen that is typed is a minus as well.
#[test]
fn numbers_are_typeset_and_either_minus_can_be_typed() {
    let path = "plant.force_offset_n";
    for tag in ["en", "sl", "de"] {
        for typed in ["-7", "\u{2212}7"] {
            let shelf = Shelf::empty();
            let mut screen = started(vec2(1280.0, 800.0), "#v=1", &shelf, tag);
            screen.key_press(Key::Slash);
            screen.run_steps(4);
            screen.event(Event::Text(path.to_owned()));
            screen.run_steps(6);
            let name = tr("Force offset").to_owned();
            let field = screen.get_by_role_and_label(Role::SpinButton, &name);
            field.click();
            screen.run_steps(3);
            screen.key_press_modifiers(Modifiers::COMMAND, Key::A);
            screen.run_steps(2);
            screen.event(Event::Text(typed.to_owned()));
            screen.key_press(Key::Enter);
            screen.run_steps(4);
            let now = screen.state().as_ref().unwrap().session().current().get(path).unwrap();
            assert_eq!(now, Value::Float(-7.0), "{typed} in {tag}");
            let mut drawn = Vec::new();
            each_text(&screen, |text, _| drawn.push(text.galley.job.text.clone()));
            assert!(drawn.iter().any(|text| text.starts_with("\u{2212}7")), "{drawn:?}");
        }
    }
    for tag in ["en", "sl", "de"] {
        let shelf = Shelf::empty();
        let mut screen = started(DESKTOP, "#v=1", &shelf, tag);
        computed(&mut screen);
        screen.key_press(Key::End);
        screen.run_steps(10);
        let mut drawn = Vec::new();
        each_text(&screen, |text, _| drawn.push(text.galley.job.text.clone()));
        let broken = |line: &&str| {
            let unit = [" mm/min", " N", " \u{b5}m", " %"].into_iter();
            unit.clone().any(|unit| {
                line.match_indices(unit).any(|(at, _)| {
                    line[..at].ends_with(|c: char| c.is_ascii_digit())
                        && !line[at + unit.len()..].starts_with(char::is_alphanumeric)
                })
            }) || line.starts_with('-') && line[1..].starts_with(|c: char| c.is_ascii_digit())
        };
        let broken: Vec<&str> = drawn.iter().flat_map(|text| text.lines()).filter(broken).collect();
        assert!(broken.is_empty(), "{tag}: {broken:?}");
    }
}

/// The tables of the papers are read with the language's decimal sign, units as they are written, and words for what
/// their columns hold.
#[test]
fn identify_speaks_the_language() {
    let shelf = Shelf::empty();
    let mut screen = started(vec2(1280.0, 2400.0), "#embed=screen:identify&v=1", &shelf, "de");
    rest(&mut screen);
    let said = texts(&screen);
    assert!(said.contains("Kraft, Ende"), "{said}");
    let is_cell = |line: &&str| line.parse::<f64>().is_ok() && line.contains('.');
    let points: Vec<&str> = said.lines().filter(is_cell).collect();
    assert!(points.is_empty(), "{points:?}");
    for raw in ["force_final_n", "feed_final_mm_min"] {
        assert!(!said.contains(raw), "{raw} in {said}");
    }
    assert!(!said.lines().any(|line| line == "um"), "{said}");
}

#[test]
fn other_languages_look_as_their_pictures() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
    for (size, theme, language, look) in
        [(DESKTOP, Theme::Light, "de", "de-desktop"), (PHONE, Theme::Dark, "sl", "sl-phone")]
    {
        let shelf = Shelf::empty();
        for (screen, title) in [("console", "Console"), ("learn", "Learn"), ("compare", "Compare")]
        {
            let link = format!("#embed=screen:{screen}&v=1");
            let builder = Harness::builder().with_size(size).with_theme(theme).wgpu();
            let mut screen = built(builder, &link, &shelf, language);
            screen.key_press(Key::Space);
            screen.run_steps(2);
            screen.key_press(Key::End);
            screen.run_steps(10);
            rest(&mut screen);
            screen.run_steps(10);
            let name = format!("language-{}-{look}", title.to_lowercase());
            results.add(screen.try_snapshot_options(name, &options));
        }
    }
}

/// Names of screens are short enough for tabs, in every language, on a window of 1280 points.
#[test]
fn the_screens_are_tabs_in_every_language() {
    for tag in ["en", "sl", "de"] {
        let shelf = Shelf::empty();
        let mut screen = started(DESKTOP, "#v=1", &shelf, tag);
        screen.run_steps(5);
        let list = screen.query_by_role_and_label(Role::ComboBox, tr("Screen"));
        assert!(list.is_none(), "{tag}: {}", texts(&screen));
    }
}

/// What the strip at the foot of a phone says of a cut that is over has room, within a mission and without one.
#[test]
fn the_end_of_a_cut_is_told_whole_on_a_phone_in_every_language() {
    for tag in ["en", "sl", "de"] {
        for link in [
            "#v=1",
            "#mission=depth-step-at-constant-feed",
            // It swings, within the mission and without it.
            "#mission=dead-time-against-gain",
            "#v=1&controller.kind=p&controller.p.ki=0.8&cnc.dead_time_s=0.16",
        ] {
            let shelf = Shelf::empty();
            let mut screen = started(PHONE, link, &shelf, tag);
            for name in [tr("Go on without a prediction"), tr("Go on all the same")] {
                if let Some(button) = screen.query_by_role_and_label(Role::Button, name) {
                    button.click_accesskit();
                    screen.run_steps(4);
                }
            }
            computed(&mut screen);
            screen.key_press(Key::End);
            screen.run_steps(10);
            let foot = screen.get_by_role_and_label(Role::Button, tr("Play")).rect().top();
            let mut elided = Vec::new();
            let mut seen = 0;
            each_text(&screen, |text, _| {
                let at = text.visual_bounding_rect();
                if at.bottom() < foot && at.top() > foot - 60.0 {
                    seen += 1;
                    if text.galley.elided {
                        elided.push(text.galley.job.text.clone());
                    }
                }
            });
            assert!(seen > 0 && elided.is_empty(), "{tag} {link}: {elided:?}");
        }
    }
}

/// What is over the screen is not in another language than the screen.
#[test]
fn messages_go_with_the_language_that_they_were_said_in() {
    let shelf = Shelf::empty();
    let mut screen = started(DESKTOP, "#v=1", &shelf, "en");
    let say = Command::notify("No hard spot at 99 mm".to_owned());
    screen.state().as_ref().unwrap().push(say);
    screen.run_steps(3);
    assert_eq!(screen.state().as_ref().unwrap().messages().count(), 1);
    press(&mut screen, "Language");
    press(&mut screen, "Deutsch");
    assert_eq!(screen.state().as_ref().unwrap().messages().count(), 0);
}
