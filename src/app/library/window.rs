//! The window on files of one's own: by kind, what each describes or what is wrong with it, and what is done with it.

use egui::{Button, CollapsingHeader, ComboBox, Context, RichText, Role, TextEdit, Ui, WidgetInfo};

use super::present::{BEGUN, PRESENT, present};
use super::shelf::Shelf;
use super::work::ShelfRead;
use super::{LONGEST_OPENED, MY_FILES};
use crate::app::command::{Command, LibraryCommand, OpenedFile};
use crate::app::format;
use crate::app::framed;
use crate::app::session::{NO_OTHER_SCENARIO, Session};
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::app::widgets::window::{self, WindowPlace};
use crate::base::language::tr;
use crate::study::formula_place::FormulaPlace;
use crate::study::library::{LibraryFile, LibraryHas, LibraryKind};

/// Width of the window, points.
const WIDTH: f32 = 440.0;
/// Share of a phone's screen that it takes.
const SHARE: f32 = 0.86;
/// Room at the head of the screen, points: the bar stays in sight.
const HEAD: f32 = 44.0;

/// What the window shows.
pub struct LibraryShown<'a> {
    /// Where files are kept, if anywhere.
    pub shelf: Option<&'a dyn Shelf>,
    /// What is there.
    pub read: &'a ShelfRead,
    /// Whether that was read at all.
    pub is_read: bool,
    /// What was opened from elsewhere.
    pub opened: &'a [OpenedFile],
    /// Which of the files is in use, where that can be told.
    pub in_use: &'a [Option<bool>],
    /// The present cut.
    pub session: &'a Session,
}

/// What is being done in it.
#[derive(Default)]
pub struct LibraryWindow {
    /// The kind to unfold in the next frame, with all others folded.
    unfold: Option<LibraryKind>,
    /// The path of another folder as it is typed.
    path: String,
    /// The file that is to be deleted if that is said again.
    deleting: Option<String>,
}

fn weak(ui: &Ui, text: &str) -> RichText {
    RichText::new(format::typeset(text)).small().color(Palette::at(ui).weak)
}

/// Why a file is not used from here, if it is not.
fn refused(ui: &Ui, file: &LibraryFile, session: &Session) -> Option<String> {
    if let Some(fault) = &file.fault {
        return Some(fault.clone());
    }
    match file.kind {
        LibraryKind::Formula => match &file.has {
            LibraryHas::Formula(_, places) if !places.is_empty() => None,
            LibraryHas::Formula(..)
            | LibraryHas::Unknown
            | LibraryHas::Settings(_)
            | LibraryHas::Whole(_) => Some(
                tr("No place in a run has the units of its inputs and of its result.").to_owned(),
            ),
        },
        LibraryKind::Result => {
            Some(tr("The result of a mission is verified by steadycut mission check.").to_owned())
        }
        LibraryKind::Scenario => session.has_locks().then(|| tr(NO_OTHER_SCENARIO).to_owned()),
        LibraryKind::Tool
        | LibraryKind::Material
        | LibraryKind::Machine
        | LibraryKind::Structure
        | LibraryKind::Part
        | LibraryKind::Script => match &file.has {
            LibraryHas::Settings(settings) => {
                settings.iter().find_map(|(path, _)| framed::closed(ui.ctx(), path))
            }
            LibraryHas::Unknown | LibraryHas::Whole(_) | LibraryHas::Formula(..) => None,
        },
        LibraryKind::Program
        | LibraryKind::Mission
        | LibraryKind::Measured
        | LibraryKind::Table
        | LibraryKind::Networks
        | LibraryKind::Search
        | LibraryKind::Unreadable => None,
    }
}

/// What pressing a file does, in a line.
fn help(kind: LibraryKind) -> &'static str {
    match kind {
        LibraryKind::Formula => tr("Take it for a model of plant and controller"),
        LibraryKind::Scenario => tr("Open it and cut it from its start"),
        LibraryKind::Mission => tr("Begin it, on the screen Learn"),
        LibraryKind::Measured => tr("Lay it over the plots"),
        LibraryKind::Program => tr("Cut it from a blank, on the screen Workpiece"),
        LibraryKind::Table | LibraryKind::Search => {
            tr("Search for formulas, on the screen Identify")
        }
        LibraryKind::Tool
        | LibraryKind::Material
        | LibraryKind::Machine
        | LibraryKind::Structure
        | LibraryKind::Part
        | LibraryKind::Script
        | LibraryKind::Networks
        | LibraryKind::Result
        | LibraryKind::Unreadable => tr("Use it in the present cut; Undo takes it back"),
    }
}

impl LibraryWindow {
    /// Unfolds one kind alone in the next frame.
    pub fn unfold(&mut self, kind: Option<LibraryKind>) {
        self.unfold = kind;
    }

    /// Shows it; `false` when it is closed.
    pub fn show(
        &mut self,
        ctx: &Context,
        shown: &LibraryShown<'_>,
        commands: &mut Vec<Command>,
    ) -> bool {
        let screen = ctx.content_rect();
        let narrow = screen.width() < theme::NARROW;
        let screen = screen.with_min_y(screen.top() + HEAD);
        let size = [WIDTH, theme::OVERLAY_HEIGHTS[0]];
        let place = WindowPlace { screen, narrow, size, share: SHARE };
        let mut open = true;
        window::show(ctx, MY_FILES, place, &mut open, |ui| self.content(ui, shown, commands));
        open
    }

    fn content(&mut self, ui: &mut Ui, shown: &LibraryShown<'_>, commands: &mut Vec<Command>) {
        let Some(shelf) = shown.shelf else {
            ui.label(tr("There is no place for files here: the system names none."));
            return;
        };
        if shelf.can_remove() {
            ui.label(tr("Files that this browser keeps for this page. Drop or open a file, then keep it here."));
        } else {
            self.folder(ui, shown, commands);
        }
        if let Some(fault) = &shown.read.fault {
            Standing::Bad.label(ui, fault, |text| text);
        }
        // Before the files, of which there may be many.
        new_ones(ui, shown, commands);
        opened(ui, shown, commands);
        ui.separator();
        self.files(ui, shelf, shown, commands);
        ui.separator();
        for remark in &shown.read.remarks {
            ui.label(weak(ui, remark));
        }
        match shown.read.others {
            0 => {}
            1 => {
                ui.label(weak(ui, tr("1 other file is of no use here and not listed.")));
            }
            n => {
                let text = tr!("{n} other files are of no use here and not listed.", n = n);
                ui.label(weak(ui, &text));
            }
        }
    }

    /// Where the folder is, and how to take another one.
    fn folder(&mut self, ui: &mut Ui, shown: &LibraryShown<'_>, commands: &mut Vec<Command>) {
        ui.label(tr("Cutters, materials, machines, parts and more in a folder of your own:"));
        if let Some(place) = &shown.read.place {
            ui.add(egui::Label::new(RichText::new(place).small().monospace()).wrap());
        }
        ui.horizontal_wrapped(|ui| {
            let least = touch::least(ui);
            let button = Button::new(tr("Another folder\u{2026}")).min_size(least);
            if ui.add(button).clicked() {
                commands.push(Command::Library(LibraryCommand::AskFolder));
            }
            let help = tr("It is read every two seconds while this window is open");
            let button = Button::new(tr("Read again")).min_size(least);
            if ui.add(button).on_hover_text(help).clicked() {
                commands.push(Command::Library(LibraryCommand::LookAgain));
            }
        });
        ui.horizontal(|ui| {
            let name = tr("Its path");
            ui.label(name);
            let field = TextEdit::singleline(&mut self.path)
                .hint_text(tr("a folder that is there; Enter takes it"))
                .char_limit(1000)
                .desired_width(ui.available_width())
                .min_size(touch::least(ui));
            let response = ui.add(field);
            let text = self.path.clone();
            response.widget_info(|| WidgetInfo::text_edit(true, "", &text, name));
            let entered = response.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
            if entered && !self.path.trim().is_empty() {
                let folder = std::mem::take(&mut self.path).trim().to_owned();
                commands.push(Command::Library(LibraryCommand::Choose(folder)));
            }
        });
    }

    fn files(
        &mut self,
        ui: &mut Ui,
        shelf: &dyn Shelf,
        shown: &LibraryShown<'_>,
        commands: &mut Vec<Command>,
    ) {
        let read = shown.read;
        let unfold = self.unfold.take();
        if !shown.is_read {
            ui.label(tr("Being read\u{2026}"));
            // What was asked for waits until there is something.
            self.unfold = unfold;
            return;
        }
        let none = |kind: LibraryKind| !read.files.iter().any(|file| file.kind == kind);
        if let Some(kind) = unfold.filter(|kind| none(*kind)) {
            let text = tr!("None of these here yet: {kinds}.", kinds = tr(kind.several()));
            ui.label(text);
        } else if read.files.is_empty() && read.fault.is_none() {
            ui.label(tr("No files here yet: begin one below, or keep one that you opened."));
        }
        for kind in LibraryKind::ALL {
            let files = || read.files.iter().enumerate().filter(|(_, file)| file.kind == *kind);
            let count = files().count();
            if count == 0 {
                continue;
            }
            let title = format!("{} ({count})", tr(kind.several()));
            let open = unfold.filter(|unfold| !none(*unfold)).map(|unfold| unfold == *kind);
            let header = CollapsingHeader::new(RichText::new(title).strong())
                .id_salt(("own files", kind.id()))
                .default_open(true)
                .open(open);
            header.show_unindented(ui, |ui| {
                for (place, file) in files() {
                    let in_use = shown.in_use.get(place).copied().flatten();
                    ui.push_id(&file.name, |ui| {
                        self.file(ui, shelf, (file, in_use), shown.session, commands);
                    });
                }
            });
        }
    }

    /// One file: pressed, it is used.
    fn file(
        &mut self,
        ui: &mut Ui,
        shelf: &dyn Shelf,
        (file, in_use): (&LibraryFile, Option<bool>),
        session: &Session,
        commands: &mut Vec<Command>,
    ) {
        let why = refused(ui, file, session);
        let can = why.is_none();
        let used = in_use == Some(true);
        let about = [&file.title, &file.facts].into_iter().filter(|text| !text.is_empty());
        let about = about.map(|text| tr(text).to_owned()).collect::<Vec<_>>().join("; ");
        let button = Button::selectable(used, RichText::new(&file.name))
            .frame_when_inactive(true)
            .truncate()
            .min_size(touch::least(ui));
        let response = ui.add_enabled(can, button);
        if let LibraryHas::Formula(_, places) = &file.has {
            formula_places(&response, file, places, commands);
        }
        let spoken = if used { tr!("{name}, in use", name = file.name) } else { file.name.clone() };
        response.widget_info(|| WidgetInfo::labeled(Role::Button, can, spoken.clone()));
        let response = match &why {
            Some(why) => response.on_disabled_hover_text(format!("{}\n{why}", file.name)),
            None => response.on_hover_text(format!("{}\n{}", file.name, help(file.kind))),
        };
        if response.clicked() && file.kind != LibraryKind::Formula {
            commands.push(Command::Library(LibraryCommand::Use(file.name.clone())));
        }
        if used {
            Standing::Good.label(ui, tr("in use"), RichText::small);
        }
        match (&file.fault, why) {
            (Some(fault), _) => {
                Standing::Bad.label(ui, fault.trim_end(), RichText::small);
            }
            (None, why) => {
                if !about.is_empty() {
                    ui.label(weak(ui, &about));
                }
                if let Some(why) = why {
                    ui.label(weak(ui, &why));
                }
            }
        }
        if shelf.can_remove() {
            self.kept(ui, file, commands);
        }
        ui.add_space(4.0);
    }

    /// What only what the browser keeps can have done with it.
    fn kept(&mut self, ui: &mut Ui, file: &LibraryFile, commands: &mut Vec<Command>) {
        let name = &file.name;
        let button = |ui: &mut Ui, text: &str| {
            let button = touch::small(ui, Button::new(text));
            let response = ui.add(button);
            let spoken = format!("{text}: {name}");
            response.widget_info(|| WidgetInfo::labeled(Role::Button, true, spoken.clone()));
            response.clicked()
        };
        ui.horizontal_wrapped(|ui| {
            if self.deleting.as_ref() == Some(name) {
                ui.label(tr("Delete it for good?"));
                if button(ui, tr("Delete it")) {
                    self.deleting = None;
                    commands.push(Command::Library(LibraryCommand::Remove(name.clone())));
                }
                if button(ui, tr("Keep it")) {
                    self.deleting = None;
                }
                return;
            }
            if button(ui, tr("Download")) {
                commands.push(Command::Library(LibraryCommand::Download(name.clone())));
            }
            if button(ui, tr("Delete\u{2026}")) {
                self.deleting = Some(name.clone());
            }
        });
    }
}

/// Where the formula of a file can stand, to choose from when it is pressed.
fn formula_places(
    response: &egui::Response,
    file: &LibraryFile,
    places: &[FormulaPlace],
    commands: &mut Vec<Command>,
) {
    egui::Popup::menu(response).show(|ui| {
        ui.label(tr("Take it for"));
        for place in places {
            let closed = framed::closed(ui.ctx(), &place.path());
            let choice = ui.add_enabled(closed.is_none(), Button::new(tr(place.label())));
            let choice = match closed {
                Some(why) => choice.on_disabled_hover_text(why),
                None => choice,
            };
            if choice.clicked() {
                let (name, path) = (file.name.clone(), place.path());
                commands.push(Command::Library(LibraryCommand::UseFormula { name, path }));
                ui.close();
            }
        }
    });
}

/// What was opened from elsewhere, to be kept.
fn opened(ui: &mut Ui, shown: &LibraryShown<'_>, commands: &mut Vec<Command>) {
    if shown.opened.is_empty() {
        return;
    }
    ui.separator();
    ui.label(RichText::new(tr("Opened from elsewhere")).strong());
    for file in shown.opened {
        ui.horizontal(|ui| {
            let keep = tr("Keep it");
            let can = file.bytes.len() <= LONGEST_OPENED;
            let button = Button::new(keep).min_size(touch::least(ui));
            let response = ui.add_enabled(can, button);
            let spoken = format!("{keep}: {}", file.name);
            response.widget_info(|| WidgetInfo::labeled(Role::Button, can, spoken.clone()));
            if response.clicked() {
                commands.push(Command::Library(LibraryCommand::KeepOpened(file.name.clone())));
            }
            ui.add(egui::Label::new(&file.name).truncate());
        });
    }
}

/// Files that come from here: begun, or of the present cut.
fn new_ones(ui: &mut Ui, shown: &LibraryShown<'_>, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        let begin = tr("Begin a new one");
        let list = ComboBox::from_id_salt("begin").selected_text(begin).show_ui(ui, |ui| {
            for kind in BEGUN {
                if ui.selectable_label(false, tr(kind.label())).clicked() {
                    commands.push(Command::Library(LibraryCommand::Begin(kind)));
                    ui.close();
                }
            }
        });
        let about = tr("A file in which every entry is explained; nothing is overwritten");
        let list = list.response.on_hover_text(about);
        list.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, begin));
        let keep = tr("Keep of the present cut");
        let list = ComboBox::from_id_salt("present").selected_text(keep).show_ui(ui, |ui| {
            for kind in PRESENT {
                let why = present(kind, shown.session).err();
                let choice = Button::selectable(false, tr(kind.label()));
                let choice = ui.add_enabled(why.is_none(), choice);
                let choice = match why {
                    Some(why) => choice.on_disabled_hover_text(why),
                    None => choice,
                };
                if choice.clicked() {
                    commands.push(Command::Library(LibraryCommand::KeepPresent(kind)));
                    ui.close();
                }
            }
        });
        list.response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, keep));
    });
}
