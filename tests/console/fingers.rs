//! Targets for fingers: on a phone all that is pressed, dragged or written in is large enough.

use egui::accesskit::{Action, Role};
use egui_kittest::kittest::NodeT;

use crate::judged::Judge;
use crate::screen::Screen;

/// Least width and height of a target, points (WCAG 2.2, 2.5.5).
const LEAST: f32 = 44.0;

/// Targets that are too small.
#[derive(Default)]
pub struct Fingers {
    small: Vec<String>,
    seen: usize,
}

impl Judge for Fingers {
    fn view(&mut self, screen: &mut Screen<'_>, view: &str) {
        for node in screen.root().children_recursive() {
            let inner = node.accesskit_node();
            // Texts that can be marked take clicks as well; fingers scroll by what is scrolled, not by its bar.
            let does = |action| inner.data().supports_action(action);
            let other = matches!(inner.role(), Role::Label | Role::TextRun | Role::ScrollBar);
            let pressed = does(Action::Focus) || (does(Action::Click) && !other);
            if !pressed || inner.bounding_box().is_none() {
                continue;
            }
            self.seen += 1;
            let size = node.rect().size() + egui::Vec2::splat(0.1);
            if size.min_elem() < LEAST {
                let name = inner.label().or_else(|| inner.value()).unwrap_or_default();
                self.small.push(format!("{view}: {:?} {name}: {size:?}", inner.role()));
            }
        }
    }

    fn verdict(&mut self) -> Vec<String> {
        assert!(self.seen > 700, "{} targets were seen", self.seen);
        std::mem::take(&mut self.small)
    }
}
