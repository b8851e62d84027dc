//! The console as elements of a page, for screen readers: what is drawn on a canvas has no other way to them.
//!
//! On the desktop AccessKit hands the tree to the system. eframe's page throws it away; this plugin takes it
//! out of the output before that, and tells what of it has changed. What is done with an element comes back as
//! a [`Deed`] and goes into the input as AccessKit's own request.

mod element;
mod names;

use std::collections::BTreeMap;

use egui::accesskit::{Action, ActionData, ActionRequest, Node, NodeId, TreeId, TreeUpdate};
use egui::{Context, Event, FullOutput, Key, Modifiers, Plugin, RawInput};
use serde::{Deserialize, Serialize};

pub use element::{Element, ElementKind};
pub use names::PlainNames;

use super::widgets::number;
use crate::base::language::tr;

/// Least time between two tellings, s: a number that runs is read once it is asked for, not written sixty times.
const EVERY_S: f64 = 0.2;

/// What has changed since the last telling.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Changes {
    /// The element that holds all others.
    pub root: String,
    /// New elements, and those that are not as they were.
    pub changed: Vec<Element>,
    /// Elements that are no more.
    pub removed: Vec<String>,
    /// The element with the keyboard, where there is one.
    pub focus: Option<String>,
}

/// What a person does with an element.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", tag = "deed")]
pub enum Deed {
    /// Presses it.
    Click {
        /// The element.
        id: String,
    },
    /// Moves the keyboard to it.
    Focus {
        /// The element.
        id: String,
    },
    /// Writes a text into it, or a number.
    Write {
        /// The element.
        id: String,
        /// What is written.
        text: String,
    },
    /// Moves a number by steps, down where they are negative.
    Step {
        /// The element.
        id: String,
        /// How many.
        by: i32,
    },
    /// Presses a key that is none of the element's own.
    Key {
        /// As the browser names it.
        key: String,
        /// With Ctrl, or the command key of a Mac.
        ctrl: bool,
        /// With Shift.
        shift: bool,
        /// With Alt.
        alt: bool,
    },
}

/// Takes changes of the tree to the page, and what is done there back.
pub struct Mirror {
    tell: fn(&Changes),
    told: BTreeMap<NodeId, Element>,
    told_focus: Option<NodeId>,
    told_at_s: f64,
    deeds: Vec<Event>,
    /// Whether an element of the page has the keyboard.
    held: bool,
}

impl Mirror {
    /// A mirror that has told nothing yet.
    #[must_use]
    pub fn new(tell: fn(&Changes)) -> Self {
        Self {
            tell,
            told: BTreeMap::new(),
            told_focus: None,
            told_at_s: f64::NEG_INFINITY,
            deeds: Vec::new(),
            held: false,
        }
    }

    /// Forgets what was told: all is told again.
    pub fn forget(&mut self) {
        self.told.clear();
        self.told_focus = None;
        self.told_at_s = f64::NEG_INFINITY;
        self.held = false;
    }

    /// Whether an element of the page has the keyboard from now on: the console then counts as used, though its
    /// canvas has not the keyboard.
    pub fn hold(&mut self, held: bool) {
        self.held = held;
    }

    /// Takes what was done into the next frame.
    ///
    /// # Errors
    /// In words for the person: the element is gone, or the text is no number of its range.
    pub fn act(&mut self, deed: Deed) -> Result<(), String> {
        let events = match deed {
            Deed::Click { id } => vec![request(self.known(&id)?.0, Action::Click, None)],
            Deed::Focus { id } => {
                let (id, _) = self.known(&id)?;
                vec![request(id, Action::Focus, None), request(id, Action::ScrollIntoView, None)]
            }
            Deed::Write { id, text } => {
                let (id, element) = self.known(&id)?;
                let data = match element.kind {
                    ElementKind::Slider | ElementKind::Number => {
                        ActionData::NumericValue(read(element, &text)?)
                    }
                    ElementKind::Text | ElementKind::Lines => ActionData::Value(text.into()),
                    ElementKind::Button
                    | ElementKind::List
                    | ElementKind::CheckBox
                    | ElementKind::Radio
                    | ElementKind::Link
                    | ElementKind::Label
                    | ElementKind::Picture
                    | ElementKind::Progress
                    | ElementKind::Window
                    | ElementKind::Group => {
                        return Err(tr!(
                            "{name}: nothing can be written there",
                            name = element.name
                        ));
                    }
                };
                vec![request(id, Action::SetValue, Some(data))]
            }
            Deed::Step { id, by } => {
                let (id, _) = self.known(&id)?;
                let action = if by < 0 { Action::Decrement } else { Action::Increment };
                vec![request(id, action, None); by.unsigned_abs().min(MOST_STEPS) as usize]
            }
            Deed::Key { key, ctrl, shift, alt } => match Key::from_name(&key) {
                Some(key) => {
                    let modifiers = Modifiers { alt, ctrl, shift, mac_cmd: false, command: ctrl };
                    let event = |pressed| Event::Key {
                        key,
                        physical_key: None,
                        pressed,
                        repeat: false,
                        modifiers,
                    };
                    vec![event(true), event(false)]
                }
                // The console knows no other keys either.
                None => Vec::new(),
            },
        };
        self.deeds.extend(events);
        Ok(())
    }

    fn known(&self, id: &str) -> Result<(NodeId, &Element), String> {
        let node = id.parse().ok().map(NodeId);
        let found = node.and_then(|id| self.told.get_key_value(&id));
        found
            .map(|(id, element)| (*id, element))
            .ok_or_else(|| tr("This is not shown any more.").to_owned())
    }

    /// What has changed in the tree since the last telling; `None` where nothing has.
    fn changes(&mut self, tree: &TreeUpdate, zoom: f64) -> Option<Changes> {
        let nodes: BTreeMap<NodeId, &Node> =
            tree.nodes.iter().map(|(id, node)| (*id, node)).collect();
        let mut changed = Vec::new();
        for (id, node) in &tree.nodes {
            let element = Element::new(*id, node, zoom, |id| nodes.get(&id).copied());
            if self.told.get(id) != Some(&element) {
                changed.push(element.clone());
                self.told.insert(*id, element);
            }
        }
        let mut removed = Vec::new();
        self.told.retain(|id, _| {
            let stays = nodes.contains_key(id);
            if !stays {
                removed.push(id.0.to_string());
            }
            stays
        });
        let root = tree.tree.as_ref().map(|tree| tree.root)?;
        let focus = Some(tree.focus).filter(|focus| *focus != root && nodes.contains_key(focus));
        if changed.is_empty() && removed.is_empty() && focus == self.told_focus {
            return None;
        }
        self.told_focus = focus;
        let focus = focus.map(|id| id.0.to_string());
        Some(Changes { root: root.0.to_string(), changed, removed, focus })
    }
}

/// Most steps of one deed: a key that is held comes again.
const MOST_STEPS: u32 = 100;

fn request(id: NodeId, action: Action, data: Option<ActionData>) -> Event {
    let target_tree = TreeId::ROOT;
    Event::AccessKitActionRequest(ActionRequest { action, target_tree, target_node: id, data })
}

/// The number that a text gives an element.
fn read(element: &Element, text: &str) -> Result<f64, String> {
    let name = &element.name;
    let range = match element.range {
        [Some(least), Some(most)] => tr!("from {least} to {most}", least = least, most = most),
        [Some(least), None] => tr!("from {least} on", least = least),
        [None, Some(most)] => tr!("up to {most}", most = most),
        [None, None] => tr("of any size").to_owned(),
    };
    // Its own text has its unit, which is written along by some.
    let own = element.value.as_deref().unwrap_or_default();
    let unit = own.trim_start_matches(|c: char| !c.is_alphabetic() && c != '%');
    let number = number::parse(text, unit).or_else(|| number::parse(text, ""));
    let number = number.ok_or_else(|| {
        tr!(
            "{name}: “{text}” is not a number: allowed is a number {range}",
            name = name,
            text = text,
            range = range
        )
    })?;
    let [least, most] = element.range;
    if least.is_some_and(|least| number < least) || most.is_some_and(|most| number > most) {
        return Err(tr!(
            "{name}: “{text}” is not in its range: allowed is a number {range}",
            name = name,
            text = text,
            range = range
        ));
    }
    Ok(number)
}

impl Plugin for Mirror {
    fn debug_name(&self) -> &'static str {
        "mirror for screen readers"
    }

    fn input_hook(&mut self, _: &Context, input: &mut RawInput) {
        input.focused |= self.held;
        input.events.append(&mut self.deeds);
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let Some(tree) = &output.platform_output.accesskit_update else { return };
        let now_s = ctx.input(|input| input.time);
        if now_s < self.told_at_s + EVERY_S {
            ctx.request_repaint_after_secs(EVERY_S as f32);
            return;
        }
        if let Some(changes) = self.changes(tree, f64::from(ctx.zoom_factor())) {
            self.told_at_s = now_s;
            (self.tell)(&changes);
        }
    }
}
