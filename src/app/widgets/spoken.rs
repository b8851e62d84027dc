//! What a screen reader says by itself.

use egui::Response;
use egui::accesskit::Live;

/// Has a text read aloud when it changes, after what is being read.
pub fn read_aloud(text: &Response) {
    text.ctx.accesskit_node_builder(text.id, |node| node.set_live(Live::Polite));
}
