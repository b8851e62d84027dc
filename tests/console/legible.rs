//! Whether everything can be read: sizes of all texts, and signs beside the colours that judge.

use egui::epaint::ClippedShape;
use egui::{Shape, Theme};

use steadycut::app::theme::Palette;

use crate::screen::Screen;
use crate::views::{self, PHONE, SIZES};

/// Smallest size of a text in logical pixels, on the desktop and on a phone.
const LEAST: [f32; 2] = [12.0, 13.0];

/// Calls `found` with every text shape in the last frame, and the rectangle that it is clipped to.
pub fn each_text(screen: &Screen<'_>, mut found: impl FnMut(&egui::epaint::TextShape, egui::Rect)) {
    fn inside(shape: &Shape, found: &mut dyn FnMut(&egui::epaint::TextShape)) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| inside(shape, found)),
            Shape::Text(text) => found(text),
            _ => {}
        }
    }
    for ClippedShape { clip_rect, shape, transform_after_tessellation } in &screen.output().shapes {
        assert_eq!(transform_after_tessellation.scaling, 1.0, "sizes are those on the screen");
        inside(shape, &mut |text| found(text, *clip_rect));
    }
}

#[test]
fn no_text_on_any_screen_is_smaller_than_can_be_read() {
    let mut small = Vec::new();
    for (name, size) in SIZES {
        let least = LEAST[usize::from(size == PHONE)];
        let mut seen = 0;
        views::all(size, Theme::Light, None, &mut |screen, view| {
            each_text(screen, |text, _| {
                seen += 1;
                for section in &text.galley.job.sections {
                    let size = section.format.font_id.size;
                    let range = section.byte_range.start.0..section.byte_range.end.0;
                    let part = &text.galley.job.text[range];
                    if size < least && !part.trim().is_empty() {
                        small.push(format!("{name}, {view}: {size} px: {part}"));
                    }
                }
            });
        });
        assert!(seen > 2000, "{seen} texts were seen");
    }
    small.sort();
    small.dedup();
    assert!(small.is_empty(), "{} texts:\n{}", small.len(), small.join("\n"));
}

#[test]
fn what_a_colour_judges_has_a_sign_as_well() {
    let (mut bare, mut signed) = (Vec::new(), 0);
    for theme in [Theme::Light, Theme::Dark] {
        let palette = Palette::of(theme);
        let judging = [palette.good, palette.warn, palette.bad];
        let others = [palette.reference, palette.produced, palette.command, palette.limit];
        assert!(
            judging.iter().all(|color| !others.contains(color)),
            "else they would be taken for it"
        );
    }
    let palette = Palette::of(Theme::Light);
    let judging = [palette.good, palette.warn, palette.bad];
    views::all(views::DESKTOP, Theme::Light, None, &mut |screen, view| {
        each_text(screen, |text, _| {
            let job = &text.galley.job;
            let judged = job.sections.iter().any(|part| judging.contains(&part.format.color))
                || text.override_text_color.is_some_and(|color| judging.contains(&color));
            // The sign has the room of a space before the text; a lamp has a mark behind its name.
            let room = job.text.starts_with('\u{a0}')
                && job.sections.get(1).is_some_and(|part| part.leading_space > 5.0);
            match (judged, room || job.text.ends_with(" !")) {
                (true, true) => signed += 1,
                (true, false) => bare.push(format!("{view}: {}", job.text)),
                (false, _) => {}
            }
        });
    });
    bare.sort();
    bare.dedup();
    assert!(bare.is_empty(), "{} texts:\n{}", bare.len(), bare.join("\n"));
    assert!(signed > 100, "{signed} texts with a sign were seen");
}
