//! What an element of the mirrored page is: a node of AccessKit's tree in the words of the page.

use egui::accesskit::{Action, Live, Node, NodeId, Role, Toggled};
use serde::Serialize;

/// What an element is to be in the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ElementKind {
    /// Pressed.
    Button,
    /// Pressed, and opens a list.
    List,
    /// On, off or mixed.
    CheckBox,
    /// One of several.
    Radio,
    /// A number along a rail.
    Slider,
    /// A number that is typed.
    Number,
    /// A line of text.
    Text,
    /// Several lines of text.
    Lines,
    /// A link.
    Link,
    /// Text that is read.
    Label,
    /// A picture with a name.
    Picture,
    /// How far something is.
    Progress,
    /// A window over others.
    Window,
    /// Holds others.
    Group,
}

/// What nodes of a role of their own become.
const KINDS: [(Role, ElementKind); 15] = [
    (Role::Button, ElementKind::Button),
    (Role::DefaultButton, ElementKind::Button),
    (Role::Tab, ElementKind::Button),
    (Role::MenuItem, ElementKind::Button),
    (Role::ComboBox, ElementKind::List),
    (Role::CheckBox, ElementKind::CheckBox),
    (Role::Switch, ElementKind::CheckBox),
    (Role::RadioButton, ElementKind::Radio),
    (Role::Slider, ElementKind::Slider),
    (Role::SpinButton, ElementKind::Number),
    (Role::TextInput, ElementKind::Text),
    (Role::MultilineTextInput, ElementKind::Lines),
    (Role::Link, ElementKind::Link),
    (Role::Label, ElementKind::Label),
    (Role::ProgressIndicator, ElementKind::Progress),
];

impl ElementKind {
    fn of(node: &Node) -> Self {
        let role = node.role();
        if let Some((_, kind)) = KINDS.iter().find(|(of, _)| *of == role) {
            return *kind;
        }
        if node.label().is_none() && node.value().is_none() {
            return Self::Group;
        }
        if [Role::Window, Role::Dialog, Role::AlertDialog].contains(&role) {
            Self::Window
        } else if node.supports_action(Action::Click) {
            // What was made for clicks without a role of its own is a button, whatever is drawn.
            Self::Button
        } else if [Role::Image, Role::Canvas, Role::Unknown].contains(&role) {
            Self::Picture
        } else {
            Self::Group
        }
    }
}

/// An element as the page gets it. Names of nodes are numbers too long for the page's own, so they are texts.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Element {
    /// The node's name.
    pub id: String,
    /// What it is.
    pub kind: ElementKind,
    /// What it is called.
    pub name: String,
    /// What it shows, as text.
    pub value: Option<String>,
    /// What a person hears besides.
    pub description: Option<String>,
    /// The number that it shows.
    pub number: Option<f64>,
    /// Its least and largest number.
    pub range: [Option<f64>; 2],
    /// `true`, `false` or `mixed`.
    pub toggled: Option<&'static str>,
    /// Whether what it opens is open.
    pub expanded: Option<bool>,
    /// It cannot be used now.
    pub disabled: bool,
    /// It is a stop of the keyboard.
    pub focusable: bool,
    /// Changes are read aloud.
    pub live: bool,
    /// Left, top, width and height in the page, CSS pixels.
    pub bounds: Option<[f64; 4]>,
    /// What it holds, in reading order.
    pub children: Vec<String>,
}

impl Element {
    /// The element of a node; `zoom` are the page's pixels in a point, `named` gives other nodes.
    pub fn new<'a>(
        id: NodeId,
        node: &Node,
        zoom: f64,
        named: impl Fn(NodeId) -> Option<&'a Node>,
    ) -> Self {
        let kind = ElementKind::of(node);
        let labels = node.labelled_by().iter().filter_map(|id| named(*id));
        let labels: Vec<&str> =
            labels.filter_map(|label| label.value().or_else(|| label.label())).collect();
        let name = match (node.label(), labels.is_empty()) {
            (Some(label), _) => label.to_owned(),
            (None, false) => labels.join(" "),
            // A label's text is its value.
            (None, true) if kind == ElementKind::Label => {
                node.value().unwrap_or_default().to_owned()
            }
            (None, true) => String::new(),
        };
        // Text runs are the letters of a text that its parent holds as a whole.
        let shown = |id: &&NodeId| named(**id).is_some_and(|child| child.role() != Role::TextRun);
        Self {
            id: id.0.to_string(),
            kind,
            name,
            value: node.value().map(str::to_owned).filter(|_| kind != ElementKind::Label),
            description: node.description().map(str::to_owned),
            number: node.numeric_value(),
            range: [node.min_numeric_value(), node.max_numeric_value()],
            toggled: node.toggled().map(|toggled| match toggled {
                Toggled::True => "true",
                Toggled::False => "false",
                Toggled::Mixed => "mixed",
            }),
            expanded: node.is_expanded(),
            disabled: node.is_disabled(),
            focusable: node.supports_action(Action::Focus),
            live: node.live().is_some_and(|live| live != Live::Off),
            bounds: node.bounds().map(|at| {
                // Whole pixels: what only trembles is not told.
                [at.x0, at.y0, at.width(), at.height()].map(|points| (points * zoom).round())
            }),
            children: node.children().iter().filter(shown).map(|id| id.0.to_string()).collect(),
        }
    }
}
