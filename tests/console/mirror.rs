//! The console as elements of a page, as a person with a screen reader meets it.

use std::cell::RefCell;
use std::collections::BTreeMap;

use steadycut::app::mirror::{Changes, Deed, Element, ElementKind, Mirror};
use steadycut::app::panels::panels;

use crate::screen::{Screen, open, show};
use crate::views::DESKTOP;

/// The page's elements, put together from what was told.
#[derive(Default)]
struct Page {
    elements: BTreeMap<String, Element>,
    root: String,
    focus: Option<String>,
    tellings: usize,
}

thread_local! {
    static PAGE: RefCell<Page> = RefCell::default();
}

fn tell(changes: &Changes) {
    PAGE.with_borrow_mut(|page| {
        page.tellings += 1;
        for element in &changes.changed {
            page.elements.insert(element.id.clone(), element.clone());
        }
        for id in &changes.removed {
            assert!(page.elements.remove(id).is_some(), "{id} was never told");
        }
        page.root.clone_from(&changes.root);
        page.focus.clone_from(&changes.focus);
    });
}

fn mirrored<'a>(preset: &str, title: &str) -> Screen<'a> {
    PAGE.set(Page::default());
    let mut screen = open(preset, DESKTOP, title, &[]);
    screen.ctx.add_plugin(Mirror::new(tell));
    screen.run_steps(6);
    screen
}

fn act(screen: &mut Screen<'_>, deed: Deed) -> Result<(), String> {
    let done = screen.ctx.plugin::<Mirror>().lock().act(deed);
    // Longer than the least time between two tellings.
    screen.run_steps(12);
    done
}

/// The one element of this kind and name.
fn element(kind: ElementKind, name: &str) -> Element {
    PAGE.with_borrow(|page| {
        let of_kind = page.elements.values().filter(|element| element.kind == kind);
        let found: Vec<&Element> = of_kind.clone().filter(|element| element.name == name).collect();
        let names: Vec<&str> = of_kind.map(|element| element.name.as_str()).collect();
        assert_eq!(found.len(), 1, "{name} among {names:?}");
        found[0].clone()
    })
}

#[test]
fn all_that_is_told_hangs_together_and_has_a_name() {
    let mut screen = mirrored("first-cut", "Console");
    for panel in panels() {
        let title = panel.title();
        show(&mut screen, title);
        screen.run_steps(8);
        PAGE.with_borrow(|page| {
            let mut seen = 0;
            let mut left = vec![page.root.as_str()];
            while let Some(id) = left.pop() {
                let element = page.elements.get(id).unwrap_or_else(|| panic!("{title}: no {id}"));
                left.extend(element.children.iter().map(String::as_str));
                seen += 1;
                if element.focusable && !matches!(element.kind, ElementKind::Group) {
                    assert!(!element.name.is_empty(), "{title}: {element:?}");
                }
            }
            assert!(seen > 40, "{title}: {seen} elements");
        });
    }
}

#[test]
fn a_slider_takes_a_number_with_a_comma_and_refuses_others_in_words() {
    let mut screen = mirrored("first-cut", "Console");
    let slider = element(ElementKind::Slider, "Target Ra");
    let write = |text: &str| Deed::Write { id: slider.id.clone(), text: text.to_owned() };
    act(&mut screen, write("0,9")).unwrap();
    assert_eq!(element(ElementKind::Slider, "Target Ra").number, Some(0.9));
    let error = act(&mut screen, write("90")).unwrap_err();
    assert!(
        error.starts_with("Target Ra: “90” is not in its range: allowed is a number from"),
        "{error}"
    );
    let error = act(&mut screen, write("much")).unwrap_err();
    assert!(error.starts_with("Target Ra: “much” is not a number"), "{error}");
    assert_eq!(element(ElementKind::Slider, "Target Ra").number, Some(0.9));
    act(&mut screen, Deed::Step { id: slider.id.clone(), by: 1 }).unwrap();
    assert!(element(ElementKind::Slider, "Target Ra").number.unwrap() > 0.9);
}

#[test]
fn buttons_are_pressed_and_keys_go_on_to_the_console() {
    let mut screen = mirrored("first-cut", "Console");
    let pause = element(ElementKind::Button, "Pause");
    act(&mut screen, Deed::Click { id: pause.id.clone() }).unwrap();
    element(ElementKind::Button, "Play");
    let key = |key: &str| Deed::Key { key: key.to_owned(), ctrl: false, shift: false, alt: false };
    act(&mut screen, key("End")).unwrap();
    let state = screen.state().as_ref().unwrap().session().playback().at_end;
    assert!(state, "the key End goes to the end of the cut");
    // Names that no key has are no keys.
    act(&mut screen, key("BrowserBack")).unwrap();
    let gone = Deed::Click { id: "1".to_owned() };
    assert_eq!(act(&mut screen, gone).unwrap_err(), "This is not shown any more.");
}

#[test]
fn the_keyboard_follows_the_page() {
    let mut screen = mirrored("first-cut", "Console");
    let slider = element(ElementKind::Slider, "Target Ra");
    screen.ctx.plugin::<Mirror>().lock().hold(true);
    act(&mut screen, Deed::Focus { id: slider.id.clone() }).unwrap();
    assert_eq!(PAGE.with_borrow(|page| page.focus.clone()), Some(slider.id));
}

#[test]
fn a_cut_that_stands_still_is_told_once() {
    let mut screen = mirrored("first-cut", "Console");
    let key = |key: &str| Deed::Key { key: key.to_owned(), ctrl: false, shift: false, alt: false };
    act(&mut screen, key("End")).unwrap();
    screen.run_steps(40);
    let before = PAGE.with_borrow(|page| page.tellings);
    screen.run_steps(40);
    assert_eq!(PAGE.with_borrow(|page| page.tellings), before);
}
