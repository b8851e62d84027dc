//! The equation card of a block on the screen.

use egui::{Button, Color32, Label, Response, RichText, Role, TextWrapMode, Ui, WidgetInfo};

use super::moment::Now;
use crate::app::command::Command;
use crate::app::panels::equation_cards::formula::typeset;
use crate::app::panels::equation_cards::{Block, Live, live};
use crate::app::theme::{self, Palette};
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::run::diagram::{WIRES, Wire};
use crate::run::signals::signal;
use crate::study::uses::Screen;

const FORMULA: f32 = 14.0;

/// Shows the card of `block`, with the editors of its settings; gives back a signal that was asked to be
/// plotted.
pub fn show(
    ui: &mut Ui,
    block: Block,
    now: &Now<'_>,
    explain: &mut bool,
    commands: &mut Vec<Command>,
) -> Option<Wire> {
    let palette = Palette::at(ui);
    let info = block.info();
    theme::card(palette)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.horizontal(|ui| {
                ui.heading(info.title(now.moment.scenario));
                let what = tr("What is this?");
                let help = touch::choice(ui, *explain, "?").on_hover_text(what);
                help.widget_info(|| WidgetInfo::selected(Role::Button, true, *explain, what));
                if help.clicked() {
                    *explain = !*explain;
                }
            });
            if *explain {
                ui.label(tr(info.meaning));
            }
            // What is looked for mostly: in sight from the card's head.
            section(ui, tr("Set here"));
            for path in block.settings(now.moment.scenario) {
                setting(ui, Screen::Console, path, now.moment.scenario, Size::Small, commands);
            }
            ui.add_space(4.0);
            let asked = signals(ui, &block.signals(now.moment.scenario));
            section(ui, tr("As printed"));
            for printed in block.printed(now.moment.scenario) {
                formula(ui, printed.formula, palette.text);
                ui.label(RichText::new(tr(printed.source)).small().color(palette.weak));
            }
            section(ui, &block.now(now.moment.scenario));
            for line in live(block, &now.moment) {
                live_line(ui, &line, palette);
            }
            asked
        })
        .inner
}

fn section(ui: &mut Ui, title: &str) {
    ui.add_space(4.0);
    ui.label(RichText::new(title).strong());
}

/// A set formula; read out as it is written.
fn formula(ui: &mut Ui, text: &str, color: Color32) -> Response {
    let response =
        ui.add(Label::new(typeset(text, FORMULA, theme::note(ui.ctx()).size, color)).wrap());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    response
}

fn live_line(ui: &mut Ui, line: &Live, palette: &Palette) {
    formula(ui, &line.formula, palette.weak);
    formula(ui, &line.values, palette.text);
    if !line.range.is_empty() {
        let standing = Standing::either(line.valid);
        let text = if line.valid {
            tr!("holds: {range}", range = line.range)
        } else {
            tr!("OUTSIDE: {range}", range = line.range)
        };
        let job = typeset(&text, FORMULA, theme::note(ui.ctx()).size, standing.color(palette));
        let response = standing.lead(ui, job, TextWrapMode::Wrap);
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.clone()));
    }
    ui.add_space(3.0);
}

/// Buttons that plot the signals of the block.
fn signals(ui: &mut Ui, ids: &[&'static str]) -> Option<Wire> {
    let mut asked = None;
    ui.horizontal_wrapped(|ui| {
        ui.label(tr("Plot:"));
        for id in ids {
            let Some(info) = signal(id) else { continue };
            let button = ui.add(touch::small(ui, Button::new(tr(info.label))));
            if button.on_hover_text(tr(info.doc).trim()).clicked() {
                let known = WIRES.iter().find(|wire| wire.signal == *id && !wire.delayed);
                let bare =
                    Wire { signal: info.id, symbol: "", delayed: false, from: None, to: &[] };
                asked = Some(known.copied().unwrap_or(bare));
            }
        }
    });
    asked
}
