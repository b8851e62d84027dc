//! The inhomogeneity of the material along a cut: how much more or less force it asks for than even
//! material, from the very field that the loop meets.

use egui::{Align2, Rect, RichText, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2};

use super::picture::PictureMap;
use crate::app::format;
use crate::app::theme::Palette;
use crate::base::language::tr;
use crate::base::units::percent_from_ratio;
use crate::blocks::cutting::field::MaterialField;
use crate::run::scenario::Scenario;

/// Height of the picture, points.
const HEIGHT: f32 = 46.0;
/// Room that the numbers at its end need, points.
const WORDS: f32 = 28.0;
/// Most points of the line.
const POINTS: f64 = 2000.0;
/// Least distance between them, mm: the field's own cells.
const CELL_MM: f64 = 0.1;

/// What a line was made of.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Source {
    seed: u32,
    correlation_mm: f64,
    deviation: f64,
    /// Where along the way the cut's material begins, and its length, mm.
    place_mm: [f64; 2],
}

/// The line of the cut that is shown.
#[derive(Default)]
pub struct MaterialPicture {
    made: Option<(Source, Vec<[f64; 2]>)>,
}

impl Source {
    /// Places along the cut in mm with the force's difference in percent.
    fn line(&self) -> Vec<[f64; 2]> {
        let [begin_mm, length_mm] = self.place_mm;
        let step_mm = (length_mm / POINTS).max(CELL_MM);
        let mut field = MaterialField::new(self.seed, self.correlation_mm);
        let count = (length_mm / step_mm).floor() as usize;
        let point = |i: usize| {
            let x_mm = i as f64 * step_mm;
            [x_mm, percent_from_ratio(self.deviation * field.at(begin_mm + x_mm))]
        };
        (0..=count).map(point).collect()
    }
}

impl MaterialPicture {
    /// The line under the pictures of a cut: `place_mm` is where along the way its material begins,
    /// and its length; the tool's axis is at `tool_mm`.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        scenario: &Scenario,
        map: &PictureMap,
        place_mm: [f64; 2],
        tool_mm: f64,
    ) {
        let palette = Palette::at(ui);
        let weak = |text: String| RichText::new(text).small().color(palette.weak);
        let noise = &scenario.noise;
        let source = Source {
            seed: scenario.run.seed,
            correlation_mm: noise.correlation_mm,
            deviation: noise.inhomogeneity(),
            place_mm,
        };
        if source.deviation <= 0.0 {
            let text = tr(
                "Material: even. “Noise” and “Inhomogeneity” above 0 make it uneven, by the seed.",
            );
            ui.label(weak(text.to_owned()));
            return;
        }
        if self.made.as_ref().is_none_or(|(made, _)| *made != source) {
            self.made = Some((source, source.line()));
        }
        let Some((_, line)) = &self.made else { return };
        let values = || line.iter().map(|point| point[1]);
        let (low, high) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
        let said = tr!(
            "Material under seed {seed}: force {low} to {high} along this cut",
            seed = source.seed.to_string(),
            low = format::deviation(low),
            high = format::deviation(high)
        );
        ui.label(weak(said.clone()));
        let (rect, response) = ui.allocate_exact_size(vec2(map.x.span(), HEIGHT), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, said.clone()));
        let most = high.max(-low).max(1e-9);
        let y = |percent: f64| rect.center().y - (percent / most) as f32 * (0.5 * HEIGHT - 2.0);
        let painter = ui.painter();
        let ends = [map.at(0.0), map.at(place_mm[1])];
        let strip = Rect::from_min_max(pos2(ends[0], rect.top()), pos2(ends[1], rect.bottom()));
        painter.rect_filled(strip, 0.0, palette.card);
        let zero = ends.map(|x| pos2(x, y(0.0)));
        painter.line_segment(zero, Stroke::new(1.0, palette.line));
        let points = line.iter().map(|[x_mm, percent]| pos2(map.at(*x_mm), y(*percent)));
        painter.add(Shape::line(points.collect(), Stroke::new(1.3, palette.produced)));
        if (0.0..=place_mm[1]).contains(&tool_mm) {
            painter.vline(map.at(tool_mm), strip.y_range(), Stroke::new(1.5, palette.command));
        }
        if map.x.max - strip.right() >= WORDS {
            let font = egui::TextStyle::Small.resolve(ui.style());
            let ends = [(most, Align2::LEFT_TOP), (-most, Align2::LEFT_BOTTOM)];
            for (percent, align) in ends {
                let at = pos2(strip.right() + 3.0, y(percent));
                let text = format::beside(format::signed(format!("{percent:+.0}")), "%");
                painter.text(at, align, text, font.clone(), palette.weak);
            }
        }
        if let Some(at) = response.hover_pos() {
            let near = line
                .iter()
                .min_by(|a, b| (map.at(a[0]) - at.x).abs().total_cmp(&(map.at(b[0]) - at.x).abs()));
            if let Some([x_mm, percent]) = near {
                let text = tr!(
                    "{change} at {place}",
                    change = format::deviation(*percent),
                    place = format::quantity(*x_mm, "mm")
                );
                response.on_hover_text(text);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::cutting::disturbance::DynamicForce;
    use crate::blocks::cutting::disturbance::NoiseSettings;

    #[test]
    fn the_line_is_what_the_loop_meets() {
        let noise = NoiseSettings {
            level: 1.0,
            band_percent: 0.0,
            ripple_percent: 0.0,
            inhomogeneity_percent: 5.0,
            ..NoiseSettings::default()
        };
        let source = Source {
            seed: 7,
            correlation_mm: noise.correlation_mm,
            deviation: noise.inhomogeneity(),
            place_mm: [107.6, 30.0],
        };
        let mut met = DynamicForce::new(&noise, 2, 7, 1e-3);
        for (tick, [x_mm, percent]) in source.line().into_iter().enumerate() {
            let factor = met.update(tick as u64, 107.6 + x_mm, 1500.0);
            assert!((100.0 * (factor - 1.0) - percent).abs() < 1e-9, "{x_mm} mm");
        }
    }
}
