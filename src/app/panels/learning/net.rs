//! A network as a picture: its neurons, and a link for every weight, thick where the weight is
//! large, its colour its sign.

use egui::{Align2, Pos2, Rect, RichText, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

use crate::app::format::fine;
use crate::app::theme::{self, Look, Palette};
use crate::base::language::{decimal, tr};
use crate::models::unks::SIZES;

/// How positive and negative weights are drawn.
pub const POSITIVE: Look = Look::Produced;
/// See [`POSITIVE`].
pub const NEGATIVE: Look = Look::Command;

/// Radius of a neuron, points, and thickness of the largest weight's link.
const NEURON: f32 = 6.0;
const THICKEST: f32 = 5.0;
/// Links thinner than this are left out, points.
const THINNEST: f32 = 0.15;
/// Room for the names of inputs and output, points.
const NAME_WIDTH: f32 = 72.0;

/// The meaning of the links.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    /// The weights as they are.
    #[default]
    Weights,
    /// What was learned since the start of the cut.
    Change,
}

impl Shown {
    pub const ALL: [Self; 2] = [Self::Weights, Self::Change];

    pub fn label(self) -> &'static str {
        match self {
            Self::Weights => tr("Weights"),
            Self::Change => tr("Change since the start"),
        }
    }

    pub fn help(self) -> &'static str {
        match self {
            Self::Weights => {
                tr("Links as thick as their weights; rings mark what has changed most")
            }
            Self::Change => tr("Links as thick as what the weights have changed by in this cut"),
        }
    }
}

/// A network to be drawn.
pub struct DrawnNet<'a> {
    title: &'static str,
    role: &'static str,
    inputs: [&'static str; 4],
    output: &'static str,
    start: &'a [f64],
    now: &'a [f64],
    lessons: u32,
}

impl<'a> DrawnNet<'a> {
    /// NM-1 (0) or NM-2 (1) with its weights at the start of the cut and now.
    pub fn new(i: usize, cold: bool, start: &'a [f64], now: &'a [f64], lessons: u32) -> Self {
        let (title, role, inputs, output) = match (i, cold) {
            (0, false) => {
                let inputs = ["ln F", "ln F/F1", "ln F/F2", "ln u/a"];
                ("NM-1", tr("predicts the force"), inputs, tr("change of ln F"))
            }
            (0, true) => {
                let inputs = ["ln F", "ln F/F1", "ln F/F2", "ln u/a"];
                ("NM-1", tr("has no part in the cold start"), inputs, tr("change of ln F"))
            }
            (_, false) => {
                let inputs = ["ln F", "ln F/F1", "ln F/F2", "ln Fref/F"];
                ("NM-2", tr("asks for the override"), inputs, "ln u/a")
            }
            (_, true) => {
                let inputs = ["ln F/a", "ln F/F1", "ln F/F2", "ln Fref"];
                ("NM-2", tr("asks for the override"), inputs, "ln u")
            }
        };
        Self { title, role, inputs, output, start, now, lessons }
    }

    fn values(&self, shown: Shown) -> Vec<f64> {
        match shown {
            Shown::Weights => self.now.to_vec(),
            Shown::Change => {
                self.now.iter().zip(self.start).map(|(now, then)| now - then).collect()
            }
        }
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

/// The picture with its title, `height` points high.
pub fn show(ui: &mut Ui, drawn: &DrawnNet<'_>, shown: Shown, height: f32) {
    let palette = Palette::at(ui);
    let (weight, change) =
        (largest(&drawn.values(Shown::Weights)), largest(&drawn.values(Shown::Change)));
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(drawn.title).strong());
        ui.label(RichText::new(drawn.role).color(palette.weak));
    });
    let said = tr!(
        "{n} lessons; largest weight {weight}, largest change {change}",
        n = drawn.lessons,
        weight = fine(weight, ""),
        change = scientific(change)
    );
    ui.label(RichText::new(&said).small().color(palette.weak));
    let size = vec2(ui.available_width(), height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let name = format!("{} {}: {said}", drawn.title, shown.label());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name.clone()));
    paint(ui, rect, drawn, &drawn.values(shown), shown == Shown::Weights);
}

/// A small number in full digits is hard to read.
fn scientific(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { decimal(format!("{value:.1e}")) }
}

/// Where the neurons of a layer of `count` stand.
fn place(rect: Rect, layer: usize, count: usize, i: usize) -> Pos2 {
    let x =
        egui::lerp(rect.left() + NAME_WIDTH..=rect.right() - NAME_WIDTH - 20.0, layer as f32 / 2.0);
    let fraction = (i as f32 + 0.5) / count as f32;
    pos2(x, egui::lerp(rect.top()..=rect.bottom(), fraction))
}

fn paint(ui: &Ui, rect: Rect, drawn: &DrawnNet<'_>, values: &[f64], mark: bool) {
    let palette = Palette::at(ui);
    let painter = ui.painter_at(rect);
    let most = largest(values);
    let changes = drawn.values(Shown::Change);
    let most_changed = largest(&changes);
    let sizes = SIZES[1];
    let stroke = |value: f64| {
        let look = if value < 0.0 { NEGATIVE } else { POSITIVE };
        let fraction = if most > 0.0 { (value.abs() / most) as f32 } else { 0.0 };
        Stroke::new(THICKEST * fraction, look.line(palette).0.color)
    };
    let mut at = 0;
    // Biases, and by how much a neuron's weights have changed at most.
    let mut neurons = Vec::new();
    for layer in 1..sizes.len() {
        for to in 0..sizes[layer] {
            let end = place(rect, layer, sizes[layer], to);
            let width = sizes[layer - 1];
            for from in 0..width {
                let stroke = stroke(values[at + from]);
                if stroke.width >= THINNEST {
                    let begin = place(rect, layer - 1, width, from);
                    painter.line_segment([begin, end], stroke);
                }
            }
            let changed = largest(&changes[at..=at + width]);
            neurons.push((end, values[at + width], changed));
            at += width + 1;
        }
    }
    for (center, bias, changed) in neurons {
        painter.circle(center, NEURON, palette.card, Stroke::new(1.2, palette.text));
        let inner = stroke(bias);
        painter.circle_filled(center, NEURON * inner.width / THICKEST, inner.color);
        if mark && changed > 0.0 {
            let ring = Stroke::new(3.0 * (changed / most_changed) as f32, palette.ghost);
            painter.circle_stroke(center, NEURON + 3.0, ring);
        }
    }
    let font = theme::note(ui.ctx());
    for (i, name) in drawn.inputs.iter().enumerate() {
        let center = place(rect, 0, sizes[0], i);
        painter.circle(center, NEURON, palette.card, Stroke::new(1.2, palette.text));
        let left = center - vec2(NEURON + 5.0, 0.0);
        painter.text(left, Align2::RIGHT_CENTER, name, font.clone(), palette.weak);
    }
    let right = place(rect, 2, 1, 0) + vec2(NEURON + 8.0, 0.0);
    painter.text(right, Align2::LEFT_CENTER, drawn.output, font, palette.weak);
}
