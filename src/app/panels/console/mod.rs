//! The console: headline comparison, controls, and the plots of the run.

mod afc;
mod answer;
mod bands;
mod cards;
mod controls;
mod disturb;
mod headline;
pub(in crate::app::panels) mod measured;
pub(super) mod operator;
mod revolution;
mod story;
pub(super) mod workpiece;

use egui::{CentralPanel, CollapsingHeader, Ui};

use afc::AfcWindow;
pub use controls::group_title;
use disturb::DisturbWindow;
use measured::MeasuredWindow;
pub use operator::CUT_BY_HAND;
use operator::OperatorView;
use revolution::RevolutionWindow;
use workpiece::WorkpieceWindow;

use super::{BroughtFile, Panel, View};
use crate::app::command::{Command, PlaybackCommand};
use crate::app::format;
use crate::app::overlay::Overlays;
use crate::app::theme::{self, Look};
use crate::app::timeline::try_again;
use crate::app::widgets::chart::{self, Axes, Chart, ChartCurve};
use crate::app::widgets::scaffold;
use crate::base::language::{text, tr};
use crate::base::units::ratio_from_percent;
use crate::study::opening::FramePart;

/// The first screen.
#[derive(Default)]
pub struct ConsolePanel {
    axes: Axes,
    follow: bool,
    /// Whether the plots followed the playhead until they were zoomed, and will when they fit again.
    follows_again: bool,
    /// Whether the line that says what the program is was closed.
    introduced: bool,
    windows: Windows,
    /// Measured data over the plots.
    overlays: Overlays,
    operator: OperatorView,
}

/// The windows over this screen.
#[derive(Default)]
struct Windows {
    revolution: RevolutionWindow,
    workpiece: WorkpieceWindow,
    afc: AfcWindow,
    disturb: DisturbWindow,
    measured: MeasuredWindow,
}

const fn main(signal: &'static str) -> ChartCurve {
    ChartCurve { signal, look: Look::Produced, compared: true }
}

const fn other(signal: &'static str, look: Look) -> ChartCurve {
    ChartCurve { signal, look, compared: false }
}

/// The paper's six quantities, with overrides and depth of cut.
pub(in crate::app::panels) fn charts(view: &View<'_>) -> [Chart<'static>; 6] {
    let scenario = view.session.current();
    let tolerance = ratio_from_percent(scenario.target.tolerance_percent);
    let chart = |id, title, curves| Chart {
        id,
        title,
        curves,
        band: None,
        levels: Vec::new(),
        include: &[],
        measured: Vec::new(),
        write: format::quantity,
    };
    let cnc = &scenario.cnc;
    let limits = vec![
        (text!("Least override"), cnc.override_min_percent),
        (text!("Largest override"), cnc.override_max_percent),
    ];
    [
        Chart {
            band: Some(("ra_target_um", tolerance)),
            ..chart(
                "roughness",
                text!("Roughness"),
                const {
                    &[
                        other("ra_dyn_um", Look::Dynamics),
                        other("ra_target_um", Look::Reference),
                        main("ra_um"),
                    ]
                },
            )
        },
        Chart {
            band: Some(("force_ref_n", theme::FORCE_BAND)),
            ..chart(
                "force",
                text!("Force"),
                const {
                    &[
                        other("force_dyn_n", Look::Dynamics),
                        other("force_setpoint_n", Look::Setpoint),
                        other("force_ref_n", Look::Reference),
                        main("force_n"),
                    ]
                },
            )
        },
        chart(
            "feed",
            text!("Feed"),
            const { &[other("feed_command_mm_min", Look::Command), main("feed_mm_min")] },
        ),
        chart(
            "spindle",
            text!("Spindle speed"),
            const { &[other("spindle_command_rpm", Look::Command), main("spindle_rpm")] },
        ),
        Chart {
            levels: limits,
            include: &[90.0, 110.0],
            write: if cnc.override_quantised {
                |value, _| format::override_percent(value, true)
            } else {
                format::quantity
            },
            ..chart(
                "override",
                text!("Override"),
                const {
                    &[
                        other("spindle_override_percent", Look::Command),
                        other("feed_override_percent", Look::Produced),
                    ]
                },
            )
        },
        // From the data alone: a step of a tenth of the depth must be seen.
        chart("depth", text!("Depth of cut"), const { &[main("axial_depth_mm")] }),
    ]
}

/// How many charts stand beside each other.
fn columns(ui: &Ui) -> usize {
    if ui.available_width() >= 2.0 * theme::CONTROLS_WIDTH { 2 } else { 1 }
}

impl Panel for ConsolePanel {
    fn id(&self) -> &'static str {
        "console"
    }

    fn title(&self) -> &'static str {
        text!("Console")
    }

    fn words(&self) -> &'static str {
        text!("start home plots run simulation digest")
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let follow = view.session.playback().follow;
        if follow != self.follow {
            (self.follow, self.follows_again) = (follow, false);
            self.axes.fit();
        }
        self.operator.follow(ui, view);
        self.overlays.follow(view.session, view.jobs);
        if self.operator.show(ui, view, commands) {
            return;
        }
        if view.narrow {
            self.narrow(ui, view, commands);
        } else {
            self.wide(ui, view, commands);
        }
        // A range that was zoomed to stays where it is: what is ticked is what the plots do.
        let zoomed = self.axes.is_zoomed();
        if self.follow && zoomed || self.follows_again && !zoomed {
            (self.follow, self.follows_again) = (!zoomed, zoomed);
            commands.push(Command::Playback(PlaybackCommand::Follow(self.follow)));
        }
        self.windows.revolution.show(ui, view, commands);
        self.windows.workpiece.show(ui, view, commands);
        self.windows.afc.show(ui, view, commands);
        self.windows.disturb.show(ui, view, commands);
        let over = (&mut self.overlays, &mut self.axes);
        self.windows.measured.show(ui, view, over, commands);
    }

    fn take(&mut self, file: &BroughtFile) {
        match file {
            BroughtFile::Measured(file) => self.windows.measured.take(file, &mut self.overlays),
            BroughtFile::Table { .. }
            | BroughtFile::Search { .. }
            | BroughtFile::Mission { .. }
            | BroughtFile::Linked(_)
            | BroughtFile::ToFit(_)
            | BroughtFile::Program { .. } => {}
        }
    }

    fn left(&mut self) {
        self.operator.left();
    }

    fn tell_anew(&mut self) {
        self.overlays.tell_anew();
    }
}

impl ConsolePanel {
    fn wide(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        if !view.frame.hides(FramePart::Settings) {
            scaffold::controls(ui, "controls", |ui| self.settings(ui, view, commands));
        }
        scaffold::middle(ui, |ui| {
            headline::show(ui, view);
            ui.add_space(2.0);
            story::sentences(ui, view);
            story::events(ui, view, commands);
            self.plots(ui, view, columns(ui), false, commands);
        });
    }

    fn settings(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        controls::scenarios(ui, view, commands);
        ui.add_space(6.0);
        controls::first(ui, view, commands);
        ui.add_space(6.0);
        disturb::buttons(ui, view, &mut self.windows.disturb.open, commands);
        ui.add_space(6.0);
        controls::more(ui, view, &mut self.windows, commands);
        // Below everything: as it goes it moves nothing.
        ui.add_space(8.0);
        story::introduction(ui, view, &mut self.introduced);
    }

    /// In one column, but for the plots where there is room beside each other.
    fn narrow(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        CentralPanel::no_frame().frame(scaffold::narrow()).show(ui, |ui| {
            // Where it is low as well, headline and target are scrolled with the plots.
            let low = ui.available_height() < theme::LOW;
            if !low {
                headline::show(ui, view);
                if !view.frame.hides(FramePart::Settings) {
                    controls::target(ui, view, commands);
                }
            }
            self.plots(ui, view, columns(ui), low, commands);
        });
    }

    /// The charts in columns, and the bands below them; scrolled where they do not fit.
    fn plots(
        &mut self,
        ui: &mut Ui,
        view: &View<'_>,
        columns: usize,
        with_headline: bool,
        commands: &mut Vec<Command>,
    ) {
        let mut charts: [Chart<'_>; 6] = charts(view);
        self.overlays.over(&mut charts);
        let rows = charts.len() / columns;
        scaffold::column(ui, "plots").show(ui, |ui| {
            let settings = !view.frame.hides(FramePart::Settings);
            if with_headline {
                headline::show(ui, view);
                if settings {
                    controls::target(ui, view, commands);
                }
            }
            if view.narrow && settings {
                // With the plots in one page: a page in a page is hard to scroll.
                let header = CollapsingHeader::new(tr("Settings")).id_salt("Settings");
                let header = header.show_unindented(ui, |ui| {
                    controls::scenarios(ui, view, commands);
                    controls::first_but_target(ui, view, commands);
                    controls::more(ui, view, &mut self.windows, commands);
                });
                disturb::switch(ui, header.header_response.rect, &mut self.windows.disturb.open);
            }
            // Room for the last label of each time axis.
            let gap = egui::vec2(18.0, ui.spacing().item_spacing.y);
            let beside = columns > 1;
            let mut axis = None;
            chart::legend_of_all(ui, view.session, &mut self.axes);
            let room = ui.available_height() - bands::total_height(view, beside) - gap.y;
            let height = room / rows as f32 - gap.y;
            let least =
                if columns == 1 { theme::PLOT_HEIGHT_SCROLLED } else { theme::PLOT_HEIGHT_MIN };
            let height = height.max(least);
            let width =
                (ui.available_width() - gap.x * columns as f32) / columns as f32 + 0.5 * gap.x;
            for (i, row) in charts.chunks(columns).enumerate() {
                // On a phone the first plot comes first, to be in sight.
                if view.narrow && i == 1 {
                    // The events before the sentences, which may take all that is left below the plot.
                    story::events(ui, view, commands);
                    story::introduction(ui, view, &mut self.introduced);
                    story::sentences(ui, view);
                    if settings {
                        try_again(ui, view, commands);
                    }
                }
                ui.horizontal_top(|ui| {
                    ui.spacing_mut().item_spacing.x = 0.5 * gap.x;
                    for chart in row {
                        ui.allocate_ui(egui::vec2(width, height), |ui| {
                            ui.vertical(|ui| {
                                ui.set_width(width);
                                let axes = &mut self.axes;
                                let drawn = chart::show(ui, chart, view.session, axes, height);
                                axis.get_or_insert(drawn);
                            });
                        });
                    }
                });
            }
            let range = self.axes.range(view.session);
            if let Some(axis) = axis {
                bands::show(ui, view, bands::BandPlace { axis, range, beside });
            }
        });
    }
}
