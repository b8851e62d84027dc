//! Whether everything can be read: sizes of all texts, and signs beside the colours that judge.

use egui::epaint::ClippedShape;
use egui::{Shape, Theme, Vec2};

use steadycut::app::format;
use steadycut::app::theme::Palette;

use crate::judged::Judge;
use crate::screen::Screen;
use crate::views::PHONE;

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

/// Texts that are smaller than can be read.
pub struct Sizes {
    least: f32,
    small: Vec<String>,
    seen: usize,
}

impl Sizes {
    pub fn at(size: Vec2) -> Self {
        let least = LEAST[usize::from(size == PHONE)];
        Self { least, small: Vec::new(), seen: 0 }
    }
}

impl Judge for Sizes {
    fn view(&mut self, screen: &mut Screen<'_>, view: &str) {
        each_text(screen, |text, _| {
            self.seen += 1;
            for section in &text.galley.job.sections {
                let size = section.format.font_id.size;
                let range = section.byte_range.start.0..section.byte_range.end.0;
                let part = &text.galley.job.text[range];
                if size < self.least && !part.trim().is_empty() {
                    self.small.push(format!("{view}: {size} px: {part}"));
                }
            }
        });
    }

    fn verdict(&mut self) -> Vec<String> {
        assert!(self.seen > 1500, "{} texts were seen", self.seen);
        std::mem::take(&mut self.small)
    }
}

/// Texts that a colour alone judges.
#[derive(Default)]
pub struct Signs {
    bare: Vec<String>,
    signed: usize,
}

impl Judge for Signs {
    fn view(&mut self, screen: &mut Screen<'_>, view: &str) {
        let palette = Palette::of(Theme::Light);
        let judging = [palette.good, palette.warn, palette.bad];
        each_text(screen, |text, _| {
            let job = &text.galley.job;
            let judged = job.sections.iter().any(|part| judging.contains(&part.format.color))
                || text.override_text_color.is_some_and(|color| judging.contains(&color));
            // The sign has the room of a space before the text; a lamp has a mark behind its name.
            let room = job.text.starts_with('\u{a0}')
                && job.sections.get(1).is_some_and(|part| part.leading_space > 5.0);
            match (judged, room || job.text.ends_with(" !")) {
                (true, true) => self.signed += 1,
                (true, false) => self.bare.push(format!("{view}: {}", job.text)),
                (false, _) => {}
            }
        });
    }

    fn verdict(&mut self) -> Vec<String> {
        assert!(self.signed > 50, "{} texts with a sign were seen", self.signed);
        std::mem::take(&mut self.bare)
    }
}

#[test]
fn colours_that_judge_have_no_other_use() {
    for theme in [Theme::Light, Theme::Dark] {
        let palette = Palette::of(theme);
        let judging = [palette.good, palette.warn, palette.bad];
        let others = [palette.reference, palette.produced, palette.command, palette.limit];
        assert!(
            judging.iter().all(|color| !others.contains(color)),
            "else they would be taken for it"
        );
    }
}

/// Lines that are broken between a number and its unit.
#[derive(Default)]
pub struct Typeset {
    broken: Vec<String>,
    seen: usize,
}

impl Judge for Typeset {
    fn view(&mut self, screen: &mut Screen<'_>, view: &str) {
        each_text(screen, |text, _| {
            for rows in text.galley.rows.windows(2) {
                self.seen += 1;
                let [before, after] = [&rows[0], &rows[1]].map(|row| row.text());
                let (before, after) = (before.trim_end(), after.trim_start());
                let last = before.rsplit(' ').next().unwrap_or_default();
                let first = after.split(' ').next().unwrap_or_default();
                let line = format!("{last} {first}");
                if !rows[0].ends_with_newline && format::typeset(&line) != line {
                    self.broken.push(format!("{view}: {before} / {after}"));
                }
            }
        });
    }

    fn verdict(&mut self) -> Vec<String> {
        assert!(self.seen > 200, "{} broken lines were seen", self.seen);
        std::mem::take(&mut self.broken)
    }
}
