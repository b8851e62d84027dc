//! How something stands, told by a painted sign as well as by a colour: not everybody sees the colours, and
//! no font needs to hold the signs.

use egui::text::LayoutJob;
use egui::text_selection::LabelSelectionState;
use egui::{
    Align, Color32, FontSelection, Label, Painter, Rect, Response, RichText, Role, Shape, Stroke,
    TextStyle, TextWrapMode, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use super::super::format;
use super::super::theme::Palette;
use crate::base::language::tr;

/// Side of a sign, as a fraction of the size of its text.
const SIDE: f32 = 0.72;

/// How something stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// As it should be: a tick.
    Good,
    /// The best of its kind: a star.
    Best,
    /// To be looked at: a triangle.
    Watch,
    /// Not as it should be: a cross.
    Bad,
    /// Not judged, without a sign.
    Plain,
}

impl Standing {
    /// Good or bad.
    #[must_use]
    pub fn either(good: bool) -> Self {
        if good { Self::Good } else { Self::Bad }
    }

    /// Good, bad, or neither.
    #[must_use]
    pub fn judged(good: bool, bad: bool) -> Self {
        match (good, bad) {
            (true, _) => Self::Good,
            (_, true) => Self::Bad,
            (false, false) => Self::Plain,
        }
    }

    /// What the sign says in words; empty where there is none.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Good => tr("as it should be"),
            Self::Best => tr("the best"),
            Self::Watch => tr("to be looked at"),
            Self::Bad => tr("not as it should be"),
            Self::Plain => "",
        }
    }

    /// Its colour.
    #[must_use]
    pub fn color(self, palette: &Palette) -> Color32 {
        match self {
            Self::Good | Self::Best => palette.good,
            Self::Watch => palette.warn,
            Self::Bad => palette.bad,
            Self::Plain => palette.text,
        }
    }

    /// A text behind its sign, typeset and in the style given to it.
    pub fn label(self, ui: &mut Ui, text: &str, style: impl Fn(RichText) -> RichText) -> Response {
        let mode = ui.wrap_mode();
        self.line(ui, style(RichText::new(format::typeset(text))), mode)
    }

    /// A text behind its sign, wrapped or cut as `mode` says.
    pub fn line(self, ui: &mut Ui, text: RichText, mode: TextWrapMode) -> Response {
        let said = text.text().to_owned();
        let text = text.color(self.color(Palette::at(ui)));
        let mut job = LayoutJob::default();
        let font = FontSelection::Style(TextStyle::Body);
        text.append_to(&mut job, ui.style(), font, Align::Center);
        let response = self.lead(ui, job, mode);
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.clone()));
        response
    }

    /// What the sign takes at the head of a text of a size, points; nothing where there is none.
    #[must_use]
    pub fn room(self, size: f32) -> f32 {
        // The sign and the space before it.
        if self == Self::Plain { 0.0 } else { 1.1 * size }
    }

    /// A text that is set already, behind the sign.
    pub fn lead(self, ui: &mut Ui, job: LayoutJob, mode: TextWrapMode) -> Response {
        let first = job.sections.first().map(|section| section.format.clone());
        let Some(first) = first.filter(|_| self != Self::Plain) else {
            return ui.add(Label::new(job).wrap_mode(mode));
        };
        let (size, color) = (first.font_id.size, self.color(Palette::at(ui)));
        // A space, and room for the sign behind it; no line is parted there.
        let mut whole = LayoutJob { wrap: job.wrap.clone(), ..LayoutJob::default() };
        whole.append("\u{a0}", 0.0, first);
        let mut room = SIDE * size;
        for section in job.sections {
            let part = section.byte_range.start.0..section.byte_range.end.0;
            let leading = section.leading_space + std::mem::take(&mut room);
            whole.append(&job.text[part], leading, section.format);
        }
        let label = Label::new(whole).wrap_mode(mode);
        let (at, galley, response) = label.layout_in_ui(ui);
        if let Some((row, glyph)) =
            galley.rows.first().and_then(|row| Some((row, row.glyphs.first()?)))
        {
            let left = at.x + row.pos.x + glyph.pos.x;
            let center = pos2(left + 0.5 * SIDE * size, at.y + row.pos.y + 0.5 * row.size.y);
            let square = Rect::from_center_size(center, Vec2::splat(SIDE * size));
            self.paint(ui.painter(), square, color, ui.visuals().panel_fill);
        }
        let cut = galley.elided.then(|| job.text.clone());
        if ui.style().interaction.selectable_labels {
            let stroke = Stroke::NONE;
            LabelSelectionState::label_text_selection(ui, &response, at, galley, color, stroke);
        } else {
            ui.painter().galley(at, galley, color);
        }
        cut.map_or(response.clone(), |text| response.on_hover_text(text))
    }

    /// Paints the sign into a square.
    pub fn paint(self, painter: &Painter, square: Rect, color: Color32, ground: Color32) {
        let at = |(x, y): (f32, f32)| square.lerp_inside(vec2(x, y));
        let stroke = Stroke::new(0.19 * square.width(), color);
        match self {
            Self::Plain => {}
            Self::Good => {
                let tick = [(0.04, 0.55), (0.36, 0.9), (0.98, 0.14)];
                painter.add(Shape::line(tick.map(at).to_vec(), stroke));
            }
            Self::Bad => {
                for ends in [[(0.1, 0.1), (0.9, 0.9)], [(0.9, 0.1), (0.1, 0.9)]] {
                    painter.line_segment(ends.map(at), stroke);
                }
            }
            Self::Watch => {
                let triangle = [(0.5, 0.0), (1.06, 1.0), (-0.06, 1.0)];
                let triangle = triangle.map(at).to_vec();
                painter.add(Shape::convex_polygon(triangle, color, Stroke::NONE));
                let mark = Stroke::new(0.14 * square.width(), ground);
                painter.line_segment([(0.5, 0.34), (0.5, 0.66)].map(at), mark);
                painter.line_segment([(0.5, 0.76), (0.5, 0.88)].map(at), mark);
            }
            Self::Best => {
                // Five triangles from the middle to every second point cover it.
                let (middle, radius) = (square.center(), 0.56 * square.width());
                let points: Vec<_> = DIRECTIONS
                    .iter()
                    .map(|(x, y)| pos2(middle.x + radius * x, middle.y + radius * y))
                    .collect();
                for i in 0..5 {
                    let part = [points[i], points[(i + 2) % 5], middle].to_vec();
                    painter.add(Shape::convex_polygon(part, color, Stroke::NONE));
                }
            }
        }
    }
}

/// The points of a star on the unit circle, from the top on.
const DIRECTIONS: [(f32, f32); 5] =
    [(0.0, -1.0), (0.951, -0.309), (0.588, 0.809), (-0.588, 0.809), (-0.951, -0.309)];
