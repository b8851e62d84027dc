//! The editor of the target roughness: its slider is marked with the grades of ISO 1302. Where a
//! force is to be held, that of the force.

use egui::Ui;

use super::super::command::Command;
use super::super::framed;
use super::super::theme::{self, Palette};
use super::focus::pointer_only;
use super::setting::{Size, setting, slider_rect};
use crate::base::language::{decimal, tr};
use crate::base::math::ln;
use crate::base::settings::{Kind, Value};
use crate::blocks::reference::Reference;
use crate::run::scenario::{Scenario, param};
use crate::study::uses::Screen;

/// Grades of ISO 1302 with their Ra in um, marked below the slider of the target.
const GRADES: [(&str, f64); 5] = [("N4", 0.2), ("N5", 0.4), ("N6", 0.8), ("N7", 1.6), ("N8", 3.2)];

/// The editor of the target roughness, its slider marked with the grades of ISO 1302; a click on
/// a grade sets it. Where a force is to be held, the editor of that force.
pub fn target(ui: &mut Ui, screen: Screen, scenario: &Scenario, commands: &mut Vec<Command>) {
    const PATH: &str = "target.ra_um";
    if scenario.target.reference == Reference::Force {
        return setting(ui, screen, "target.force_n", scenario, Size::Large, commands);
    }
    setting(ui, screen, PATH, scenario, Size::Large, commands);
    if framed::closed(ui.ctx(), PATH).is_some() {
        return;
    }
    let (Ok(param), Some(rail)) = (param(PATH), slider_rect(ui.ctx(), PATH)) else { return };
    let Kind::Float { min, max } = param.spec.allowed else { return };
    let palette = Palette::at(ui);
    // Fingers get more than the names of the grades take.
    let size = if theme::fingers(ui.ctx()) { [theme::FINGER; 2] } else { [30.0, 20.0] };
    let (row, _) = ui.allocate_exact_size(egui::vec2(rail.width(), size[1]), egui::Sense::hover());
    let handle = 0.4 * rail.height();
    let span = rail.x_range().shrink(handle);
    for (name, ra_um) in GRADES {
        let fraction = (ln(ra_um / min) / ln(max / min)) as f32;
        let x = egui::lerp(span.min..=span.max, fraction);
        let place = egui::Rect::from_center_size(egui::pos2(x, row.center().y), size.into());
        let id = ui.scope_id().with(name);
        let response = ui.interact(place, id, pointer_only(false));
        let chosen = (scenario.target.ra_um - ra_um).abs() < 1e-9;
        response.widget_info(|| {
            let label = format!("{name}: Ra {}\u{a0}µm", decimal(ra_um.to_string()));
            egui::WidgetInfo::selected(egui::Role::RadioButton, true, chosen, label)
        });
        let color = if chosen || response.hovered() { palette.accent } else { palette.weak };
        let tick = [egui::pos2(x, row.top() - 3.0), egui::pos2(x, row.top() + 3.0)];
        ui.painter().line_segment(tick, egui::Stroke::new(1.5, color));
        let font = egui::TextStyle::Small.resolve(ui.style());
        let at = egui::pos2(x, row.top() + 4.0);
        ui.painter().text(at, egui::Align2::CENTER_TOP, name, font, color);
        let help = tr!("ISO 1302 grade {grade}: Ra {ra_um} µm", grade = name, ra_um = ra_um);
        if response.on_hover_text(help).clicked() {
            commands.push(Command::set(PATH, Value::Float(ra_um)));
        }
    }
}
