//! What goes on, in the bar: a button with the number of jobs, and a list of their names, how far they
//! are, how long they will take, each with a button that stops it.

use egui::{ProgressBar, RichText, Role, Ui, WidgetInfo};

use super::{Jobs, Listed};
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};

/// Width of the list, points: it fits a phone.
const WIDTH: f32 = 300.0;

/// The button, while something goes on.
pub fn show(ui: &mut Ui, jobs: &Jobs) {
    let all = jobs.all.borrow();
    let running = || all.iter().filter(|job| job.is_listed());
    let count = running().count();
    let id = egui::Id::unique("jobs");
    if count == 0 {
        egui::Popup::close_id(ui.ctx(), id);
        return;
    }
    let palette = Palette::at(ui);
    let text = RichText::new(format!("{count} at work")).color(palette.accent);
    let response =
        ui.button(text).on_hover_text("What is being worked out; also beside other screens");
    let name =
        if count == 1 { "1 job at work".to_owned() } else { format!("{count} jobs at work") };
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
    egui::Popup::menu(&response)
        .id(id)
        .close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| {
            ui.set_width(WIDTH);
            running().for_each(|job| line(ui, job.as_ref(), palette));
        });
}

fn line(ui: &mut Ui, job: &dyn Listed, palette: &Palette) {
    // The part that is not done yet is to be seen on the light list too.
    ui.visuals_mut().extreme_bg_color = palette.line;
    let (progress, left_s) = job.progress();
    ui.horizontal(|ui| {
        ui.strong(job.name());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let (name, help) = (format!("Stop {}", job.name()), "Stands still; what is done stays");
            if icon::button(ui, Icon::Close, &name, help, true).clicked() {
                job.stop();
            }
        });
    });
    ui.add(ProgressBar::new(progress.share() as f32).desired_width(WIDTH).desired_height(8.0));
    let left = left_s.map_or(String::new(), |left_s| format!(", {} left", time(left_s)));
    ui.label(RichText::new(format!("{progress}{left}")).color(palette.weak));
    ui.add_space(4.0);
}

/// A time in seconds for people; no more digits than an estimate has.
#[must_use]
pub fn time(s: f64) -> String {
    let s = s.ceil();
    match s {
        _ if s < 60.0 => format!("{s:.0} s"),
        _ if s < 3600.0 => format!("{:.0} min", (s / 60.0).ceil()),
        _ => format!("{:.1} h", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::time;

    #[test]
    fn times_have_the_unit_that_fits() {
        assert_eq!([0.2, 59.0, 61.0, 7200.0].map(time), ["1 s", "59 s", "2 min", "2.0 h"]);
    }
}
