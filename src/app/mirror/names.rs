//! Names as they are said and typed: what is drawn has minus signs and firm spaces, which a screen reader, a voice that
//! says a button's name, and a search need not know.

use egui::{Context, FullOutput, Plugin};

use crate::app::format;

/// Takes typesetting out of what assistive technology is told.
pub struct PlainNames;

impl Plugin for PlainNames {
    fn debug_name(&self) -> &'static str {
        "plain names for assistive technology"
    }

    fn output_hook(&mut self, _: &Context, output: &mut FullOutput) {
        let Some(tree) = &mut output.platform_output.accesskit_update else { return };
        for (_, node) in &mut tree.nodes {
            if let Some(plain) = node.label().and_then(format::typed) {
                node.set_label(plain);
            }
            if let Some(plain) = node.value().and_then(format::typed) {
                node.set_value(plain);
            }
            if let Some(plain) = node.description().and_then(format::typed) {
                node.set_description(plain);
            }
        }
    }
}
