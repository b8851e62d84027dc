//! What goes on, in the bar: a button with the number of jobs, and a list of their names, how far they
//! are, how long they will take, each with a button that stops it and lets it go on again.

use egui::{ProgressBar, RichText, Role, Ui, WidgetInfo};

use super::{Jobs, Listed};
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
use crate::base::language::{fixed, tr};

/// Width of the list, points: it fits a phone.
const WIDTH: f32 = 300.0;

/// What the button says: how many are worked at, and how many are stopped; shorter, and for screen readers.
fn counted(running: usize, halted: usize) -> [String; 2] {
    match (running, halted) {
        (n, 0) => {
            let name = match n {
                1 => tr("1 job at work").to_owned(),
                n => tr!("{n} jobs at work", n = n),
            };
            [tr!("{n} at work", n = n), name]
        }
        (0, n) => {
            let name = match n {
                1 => tr("1 job stopped").to_owned(),
                n => tr!("{n} jobs stopped", n = n),
            };
            [tr!("{n} stopped", n = n), name]
        }
        (running, halted) => {
            let both =
                tr!("{running} at work, {halted} stopped", running = running, halted = halted);
            let name = tr!("jobs: {both}", both = both);
            [both, name]
        }
    }
}

/// The button, while something goes on or stands where it was stopped here.
pub fn show(ui: &mut Ui, jobs: &Jobs) {
    let all = jobs.all.borrow();
    let shown = || all.iter().filter(|job| job.is_listed() || job.is_halted());
    let halted = shown().filter(|job| job.is_halted()).count();
    let count = shown().count();
    let id = egui::Id::unique("jobs");
    if count == 0 {
        egui::Popup::close_id(ui.ctx(), id);
        return;
    }
    let palette = Palette::at(ui);
    let [text, name] = counted(count - halted, halted);
    let text = RichText::new(text).color(palette.accent);
    let response =
        ui.button(text).on_hover_text(tr("What is being worked out; also beside other screens"));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
    egui::Popup::menu(&response)
        .id(id)
        .close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| {
            ui.set_width(WIDTH);
            shown().for_each(|job| line(ui, job.as_ref(), palette));
        });
}

fn line(ui: &mut Ui, job: &dyn Listed, palette: &Palette) {
    // The part that is not done yet is to be seen on the light list too.
    ui.visuals_mut().extreme_bg_color = palette.line;
    let (progress, left_s) = job.progress();
    let halted = job.is_halted();
    ui.horizontal(|ui| {
        ui.strong(tr(job.name()));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if halted {
                let name = tr!("Go on with {job}", job = tr(job.name()));
                if icon::button(ui, Icon::Play, &name, tr("Goes on where it was stopped"), true)
                    .clicked()
                {
                    job.go_on();
                }
            } else {
                let name = tr!("Stop {job}", job = tr(job.name()));
                let help = tr("Stands still; what is found stays, and it can go on from here");
                if icon::button(ui, Icon::Pause, &name, help, true).clicked() {
                    job.halt();
                }
            }
        });
    });
    ui.add(ProgressBar::new(progress.share() as f32).desired_width(WIDTH).desired_height(8.0));
    let state = match left_s {
        _ if halted => {
            tr!("stopped at {progress}: what is found stays", progress = progress.to_string())
        }
        Some(left_s) => {
            tr!("{progress}, {time} left", progress = progress.to_string(), time = time(left_s))
        }
        None => progress.to_string(),
    };
    ui.label(RichText::new(state).color(palette.weak));
    ui.add_space(4.0);
}

/// A time in seconds for people; no more digits than an estimate has.
#[must_use]
pub fn time(s: f64) -> String {
    let s = s.ceil();
    match s {
        _ if s < 60.0 => format!("{s:.0} s"),
        _ if s < 3600.0 => format!("{:.0} min", (s / 60.0).ceil()),
        _ => format!("{} h", fixed(s / 3600.0, 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::{counted, time};

    #[test]
    fn the_button_tells_what_is_stopped_from_what_goes_on() {
        assert_eq!(counted(1, 0), ["1 at work", "1 job at work"]);
        assert_eq!(counted(0, 2), ["2 stopped", "2 jobs stopped"]);
        assert_eq!(counted(2, 1)[1], "jobs: 2 at work, 1 stopped");
    }

    #[test]
    fn times_have_the_unit_that_fits() {
        assert_eq!([0.2, 59.0, 61.0, 7200.0].map(time), ["1 s", "59 s", "2 min", "2.0 h"]);
    }
}
