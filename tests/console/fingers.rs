//! Targets for fingers: on a phone all that is pressed, dragged or written in is large enough.

use egui::Theme;
use egui::accesskit::{Action, Role};
use egui_kittest::kittest::NodeT;

use crate::views::{self, PHONE};

/// Least width and height of a target, points (WCAG 2.2, 2.5.5).
const LEAST: f32 = 44.0;

#[test]
fn whatever_is_pressed_on_a_phone_is_large_enough_for_a_finger() {
    let (mut small, mut seen) = (Vec::new(), 0);
    views::all(PHONE, Theme::Light, None, &mut |screen, view| {
        for node in screen.root().children_recursive() {
            let inner = node.accesskit_node();
            // Texts that can be marked take clicks as well; fingers scroll by what is scrolled, not by its bar.
            let does = |action| inner.data().supports_action(action);
            let other = matches!(inner.role(), Role::Label | Role::TextRun | Role::ScrollBar);
            let pressed = does(Action::Focus) || (does(Action::Click) && !other);
            if !pressed || inner.bounding_box().is_none() {
                continue;
            }
            seen += 1;
            let size = node.rect().size() + egui::Vec2::splat(0.1);
            if size.min_elem() < LEAST {
                let name = inner.label().or_else(|| inner.value()).unwrap_or_default();
                small.push(format!("{view}: {:?} {name}: {size:?}", inner.role()));
            }
        }
    });
    assert!(seen > 1000, "{seen} targets were seen");
    small.sort();
    small.dedup();
    assert!(small.is_empty(), "{} targets:\n{}", small.len(), small.join("\n"));
}
