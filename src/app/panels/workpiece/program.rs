//! The window of a program (G-code): the blank that it is cut from, what the tool meets in it, what is left of the blank,
//! and the button that makes it the part.

mod picture;

use egui::{Button, RichText, Ui};

use super::super::View;
use crate::app::command::{Command, SessionCommand};
use crate::app::format;
use crate::app::jobs::Work;
use crate::app::theme::{self, Palette};
use crate::app::widgets::number::NumberField;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::app::widgets::window::{self, WindowPlace};
use crate::base::language::{text, tr};
use crate::models::tool::Outline;
use crate::study::part::PartPath;
use crate::study::part::blank::{Blank, SIZES_MM};
use crate::study::part::carved::CarvedBlank;
use crate::study::part::gcode::GCodeProgram;
use crate::study::part::milling::{MilledPart, MilledRow, MillingJob, STEPS_MM};
use picture::LeftPicture;

/// Steps of the first slice of the work.
const FIRST: u64 = 8;
/// Step along the way that is offered, mm.
const STEP_MM: f64 = 0.5;
/// Material below the deepest feed move in the blank that is offered, mm.
const BELOW_MM: f64 = 5.0;
/// Least width of the blank that is offered, mm.
const NARROWEST_MM: f64 = 20.0;
/// Names of the axes.
const AXES: [&str; 3] = ["X", "Y", "Z"];

/// A program that was brought.
struct BroughtProgram {
    name: String,
    program: GCodeProgram,
    size_mm: [f64; 3],
    corner_mm: [f64; 3],
    step_mm: f64,
    work: Option<Work<MillingJob>>,
    done: Option<DoneProgram>,
}

/// A program that was cut, and with what.
struct DoneProgram {
    part: MilledPart,
    outline: Outline,
    left: LeftPicture,
    /// The same to be looked at as it is cut; none where the way is too long for that, with the reason.
    carved: Result<CarvedBlank, String>,
}

/// A program that became the part.
pub struct TakenProgram {
    /// Its name.
    pub name: String,
    /// Its path.
    pub path: PartPath,
    /// What the tool meets, step by step.
    pub rows: Vec<MilledRow>,
    /// Its blank as it is cut; none where the way is too long for that, with the reason.
    pub carved: Result<CarvedBlank, String>,
}

/// The window.
#[derive(Default)]
pub struct ProgramWindow {
    open: bool,
    brought: Option<BroughtProgram>,
    said: Option<String>,
    /// What was made the part in this frame.
    pub taken: Option<TakenProgram>,
}

/// A blank about the feed moves of a program, to begin with: size and corner, mm.
fn about(program: &GCodeProgram) -> [[f64; 3]; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for one in program.moves.iter().filter(|one| !one.rapid) {
        for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
            for (i, at) in one.at(share).into_iter().enumerate() {
                (low[i], high[i]) = (low[i].min(at), high[i].max(at));
            }
        }
    }
    if low[0] > high[0] {
        return [[100.0, 100.0, 20.0], [0.0, 0.0, -20.0]];
    }
    // The top of the material is where programs are zero, as a rule.
    let top = if low[2] < 0.0 { 0.0 } else { high[2] };
    (low[2], high[2]) = (low[2] - BELOW_MM, top);
    let [least, most] = SIZES_MM;
    let size = [NARROWEST_MM, NARROWEST_MM, least];
    let size = [0, 1, 2].map(|i: usize| (high[i] - low[i]).ceil().clamp(size[i], most));
    // A way along one axis lies in the middle.
    let [x, y] = [0, 1].map(|i: usize| low[i] - 0.5 * (size[i] - (high[i] - low[i]).ceil()));
    [size, [x, y, high[2] - size[2]]]
}

impl ProgramWindow {
    /// Takes the text of a program, and opens.
    pub fn bring(&mut self, name: &str, text: &str) {
        self.open = true;
        self.said = None;
        match GCodeProgram::read(text) {
            Ok(program) => {
                let [size_mm, corner_mm] = about(&program);
                self.brought = Some(BroughtProgram {
                    name: name.to_owned(),
                    program,
                    size_mm,
                    corner_mm,
                    step_mm: STEP_MM,
                    work: None,
                    done: None,
                });
            }
            Err(problem) => {
                self.brought = None;
                self.said = Some(format!("{name}: {problem}"));
            }
        }
    }

    /// Shows it, if it is open.
    pub fn show(&mut self, ui: &Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let size = [theme::OVERLAY_WIDTH, theme::OVERLAY_HEIGHTS[0]];
        let place = WindowPlace { screen: ui.max_rect(), narrow: view.narrow, size, share: 1.0 };
        let mut open = self.open;
        window::show(ui.ctx(), text!("Part of a program"), place, &mut open, |ui| {
            if let Some(brought) = &mut self.brought {
                self.taken =
                    brought.content(ui, view, &mut self.said, commands).or(self.taken.take());
            }
            if let Some(said) = &self.said {
                Standing::Bad.label(ui, said, |text| text);
            }
        });
        self.open = open;
    }
}

impl BroughtProgram {
    fn content(
        &mut self,
        ui: &mut Ui,
        view: &View<'_>,
        said: &mut Option<String>,
        commands: &mut Vec<Command>,
    ) -> Option<TakenProgram> {
        let outline = view.session.current().tool.outline();
        self.follow();
        let moves = tr!("{name}: {n} moves", name = self.name, n = self.program.moves.len());
        ui.label(RichText::new(moves).strong());
        let help = tr(
            "Size and corner of the rectangular blank in the coordinates of the program; at first it lies \
             about the feed moves, with 5 mm below the deepest one.",
        );
        ui.label(RichText::new(help).small().color(Palette::at(ui).weak));
        self.fields(ui, said);
        let working = self.work.as_ref().is_some_and(Work::is_running);
        let cut = ui.add_enabled(!working, Button::new(tr("Cut it from the blank")));
        if cut.on_hover_text(tr("With the cutter of the scenario")).clicked() {
            self.begin(view, outline, said);
        }
        if let Some(work) = self.work.as_ref().filter(|work| work.is_running()) {
            ui.label(work.progress().to_string());
        }
        self.done.as_ref().and_then(|done| done.show(ui, &self.name, outline, commands))
    }

    /// The numbers of the blank, and the step.
    fn fields(&mut self, ui: &mut Ui, said: &mut Option<String>) {
        let mut field = |ui: &mut Ui, name: String, value: &mut f64, range: [f64; 2]| {
            let mut now = None;
            let field = NumberField {
                name: &name,
                unit: "mm",
                range,
                speed: 0.5,
                decimals: 3,
                least: 0,
                suffix: "",
            };
            let response = field.show(ui, value, &mut now);
            response.widget_info(|| egui::WidgetInfo {
                label: Some(name.clone()),
                ..egui::WidgetInfo::drag_value(true, *value)
            });
            if now.is_some() || response.changed() {
                *said = now;
            }
        };
        touch::grid(ui, "blank").num_columns(4).show(ui, |ui| {
            ui.label("");
            for axis in AXES {
                ui.label(format!("{axis} mm"));
            }
            ui.end_row();
            ui.label(tr("Size"));
            for (size, axis) in self.size_mm.iter_mut().zip(AXES) {
                field(ui, tr!("Size of the blank along {axis}", axis = axis), size, SIZES_MM);
            }
            ui.end_row();
            ui.label(tr("Least corner"));
            for (corner, axis) in self.corner_mm.iter_mut().zip(AXES) {
                let name = tr!("Least corner of the blank along {axis}", axis = axis);
                field(ui, name, corner, [-1e5, 1e5]);
            }
            ui.end_row();
            ui.label(tr("Step"));
            let name = tr("Step along the way").to_owned();
            field(ui, name, &mut self.step_mm, STEPS_MM);
            ui.end_row();
        });
    }

    fn begin(&mut self, view: &View<'_>, outline: Outline, said: &mut Option<String>) {
        let job = Blank::new(self.size_mm, Some(self.corner_mm))
            .and_then(|blank| MillingJob::new(&self.program, blank, outline, self.step_mm));
        match job {
            Ok(job) => {
                (self.done, *said) = (None, None);
                let name = tr!("Milling: {name}", name = self.name);
                self.work = Some(view.jobs.begin(name, job, FIRST));
            }
            Err(problem) => *said = Some(problem),
        }
    }

    /// Takes what is done.
    fn follow(&mut self) {
        let Some(work) = self.work.take_if(|work| work.is_over()) else { return };
        let Some(job) = work.into_job() else { return };
        if let Some(part) = job.part().cloned() {
            let left = LeftPicture::of(job.map());
            let (blank, outline) = (*job.map().blank(), job.outline());
            let carved = CarvedBlank::new(&self.program, blank, outline, job.step_mm());
            self.done = Some(DoneProgram { part, outline, left, carved });
        }
    }
}

impl DoneProgram {
    fn show(
        &self,
        ui: &mut Ui,
        name: &str,
        outline: Outline,
        commands: &mut Vec<Command>,
    ) -> Option<TakenProgram> {
        let path = self.part.path();
        let [axial_mm, radial_mm] = path.deepest_mm();
        let in_mm = |x: f64| format::quantity(x, "mm");
        ui.label(tr!(
            "{length} long, {air} of it air; up to {axial} deep and {radial} wide",
            length = in_mm(path.length_mm),
            air = in_mm(path.air_mm()),
            axial = in_mm(axial_mm),
            radial = in_mm(radial_mm)
        ));
        self.left.show(ui, &self.part);
        for remark in self.part.remarks() {
            Standing::Watch.label(ui, &remark, |text| text);
        }
        let same = self.outline == outline;
        let take = ui.add_enabled(same, Button::new(tr("Make it the part")));
        let other = tr("It was cut with another cutter: cut it again");
        if !take.on_disabled_hover_text(other).clicked() {
            return None;
        }
        let (name, boxed) = (name.to_owned(), Box::new(path.clone()));
        commands
            .push(Command::Session(SessionCommand::TakePart { name: name.clone(), path: boxed }));
        let (rows, carved) = (self.part.rows.clone(), self.carved.clone());
        Some(TakenProgram { name, path, rows, carved })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_blank_that_is_offered_lies_about_the_feed_moves() {
        let program = "G0 X-50 Y0 Z5\nG0 X0\nG1 Z-2 F100\nG1 X60 Y0\nG3 X60 Y20 I0 J10\nG0 X500";
        let [size, corner] = about(&GCodeProgram::read(program).unwrap());
        assert_eq!(size, [70.0, 20.0, 7.0]);
        assert_eq!(corner, [0.0, 0.0, -7.0]);
        let mut window = ProgramWindow::default();
        window.bring("bad.nc", "G41 X5");
        assert!(window.brought.is_none() && window.said.unwrap().contains("bad.nc: line 1"));
    }
}
