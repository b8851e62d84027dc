//! What is left of a blank, from above: the deeper, the darker, with the tool's way over it.

use egui::{Color32, Mesh, Rect, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2};

use crate::app::theme::{METAL, Palette};
use crate::base::language::tr;
use crate::study::part::blank::HeightMap;
use crate::study::part::milling::MilledPart;

/// Most cells of the picture along a side.
const CELLS: usize = 120;
/// Most height of the picture, points.
const HEIGHT: f32 = 220.0;
/// How much of the material's colour is left where it is cut through.
const DARKEST: f32 = 0.25;

/// Depths of a map at a grid of places.
pub struct LeftPicture {
    /// Cells along x and y.
    cells: [usize; 2],
    /// Depth as a share of the blank's height, row by row along x.
    depths: Vec<f32>,
    corner_mm: [f64; 2],
    size_mm: [f64; 2],
}

impl LeftPicture {
    /// The picture of a map.
    pub fn of(map: &HeightMap) -> Self {
        let blank = map.blank();
        let all = map.cells();
        let cells = all.map(|count| count.min(CELLS));
        let depth = |column: usize, row: usize| {
            let of = |i: usize, n: usize| (i * all[n] + all[n] / 2) / cells[n];
            let height = map.height_mm([of(column, 0), of(row, 1)]).unwrap_or(blank.top_mm());
            ((blank.top_mm() - height) / blank.size_mm[2]) as f32
        };
        let rows = 0..cells[1];
        let depths = rows.flat_map(|row| (0..cells[0]).map(move |column| (column, row)));
        Self {
            cells,
            depths: depths.map(|(column, row)| depth(column, row)).collect(),
            corner_mm: [blank.corner_mm[0], blank.corner_mm[1]],
            size_mm: [blank.size_mm[0], blank.size_mm[1]],
        }
    }

    /// Draws it to scale over the width of `ui`, x to the right and y upwards.
    pub fn show(&self, ui: &mut Ui, part: &MilledPart) {
        let [wide, high] = self.size_mm.map(|x| x as f32);
        let scale = (ui.available_width() / wide).min(HEIGHT / high);
        let size = Vec2::new(scale * wide, scale * high);
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        let label = tr("What is left of the blank, from above, with the way of the tool");
        response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, label));
        let cell = Vec2::new(size.x / self.cells[0] as f32, size.y / self.cells[1] as f32);
        let mut mesh = Mesh::default();
        for (i, depth) in self.depths.iter().enumerate() {
            let (column, row) = (i % self.cells[0], i / self.cells[0]);
            let left = rect.left() + column as f32 * cell.x;
            let bottom = rect.bottom() - row as f32 * cell.y;
            let place =
                Rect::from_min_max(pos2(left, bottom - cell.y), pos2(left + cell.x, bottom));
            mesh.add_colored_rect(place, shaded(*depth));
        }
        let painter = ui.painter().with_clip_rect(rect);
        painter.add(Shape::mesh(mesh));
        let way = part.rows.iter().map(|row| row.at_mm).chain([part.end_mm]);
        let points = way.map(|[x, y, _]| {
            let [x, y] = [x - self.corner_mm[0], y - self.corner_mm[1]].map(|mm| mm as f32);
            pos2(rect.left() + scale * x, rect.bottom() - scale * y)
        });
        painter.add(Shape::line(points.collect(), Stroke::new(1.2, Palette::at(ui).command)));
    }
}

/// Colour of the material at a depth as a share of the blank's height.
fn shaded(depth: f32) -> Color32 {
    // What is not cut is told from the slightest depth.
    let left = if depth > 0.0 { 0.8 - (0.8 - DARKEST) * depth.min(1.0) } else { 1.0 };
    METAL.gamma_multiply(left).to_opaque()
}
