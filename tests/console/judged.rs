//! Every view of the console, judged at once by all that can be said of it: to come to a view takes longer than to
//! look at it.

use egui::Vec2;

use crate::contrast::{self, Contrast};
use crate::drawn;
use crate::fingers::Fingers;
use crate::languages::Spoken;
use crate::legible::{Signs, Sizes, Typeset};
use crate::screen::Screen;
use crate::views::{self, DESKTOP, PHONE};

/// Looks at views, one after the other.
pub trait Judge {
    /// Looks at one, which is light and as it was when this is over.
    fn view(&mut self, screen: &mut Screen<'_>, view: &str);
    /// What it has to complain of; that it saw little is an error by itself.
    fn verdict(&mut self) -> Vec<String>;
}

fn judge(size: Vec2, mut judges: Vec<(&str, Box<dyn Judge>)>) {
    judges.push(("not typeset", Box::new(Typeset::default())));
    judges.push(("in other languages", Box::new(Spoken::default())));
    let software = drawn::in_software();
    if software {
        judges.push(("too faint", Box::new(Contrast::default())));
    }
    let pixels = software.then_some(contrast::PIXELS);
    views::all(size, pixels, &mut |screen, view| {
        judges.iter_mut().for_each(|(_, judge)| judge.view(screen, view));
    });
    let mut found = Vec::new();
    for (what, judge) in &mut judges {
        found.extend(judge.verdict().into_iter().map(|text| format!("{what}: {text}")));
    }
    found.sort();
    found.dedup();
    assert!(found.is_empty(), "{} at {size}:\n{}", found.len(), found.join("\n"));
}

#[test]
fn every_view_on_the_desktop_is_legible_in_both_themes_and_signed() {
    let sizes = Box::new(Sizes::at(DESKTOP));
    judge(DESKTOP, vec![("too small", sizes), ("without a sign", Box::new(Signs::default()))]);
}

#[test]
fn every_view_on_a_phone_is_legible_in_both_themes_and_has_room_for_fingers() {
    let sizes = Box::new(Sizes::at(PHONE));
    judge(PHONE, vec![("too small", sizes), ("small target", Box::new(Fingers::default()))]);
}
