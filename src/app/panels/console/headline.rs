//! The comparison at the head of the console: the chosen controller against constant feed.

use egui::{RichText, Ui};

use crate::app::panels::View;
use crate::app::theme::{self, Palette};

/// One number of the comparison.
struct Item {
    title: &'static str,
    help: &'static str,
    value: String,
    color: egui::Color32,
    /// The line below the value where there is room, and where there is little.
    below: [String; 2],
}

fn items(view: &View<'_>, palette: &Palette) -> Vec<Item> {
    let comparison = view.session.comparison();
    let (chosen, twin) = (&comparison.chosen, &comparison.twin);
    let twin_has = |value: String| [format!("constant feed {value}"), value];
    // Before the first contact, and in the air alone, there is no share.
    let share_of = |value: Option<f64>| value.map_or("-".to_owned(), |x| theme::quantity(x, "%"));
    let judged = |good: bool| if good { palette.good } else { palette.bad };
    let saved_s = comparison.time_saved_s;
    let (time_title, time_color) = match saved_s {
        saved if saved.abs() < 0.005 => ("Time saved", palette.text),
        saved if saved > 0.0 => ("Time saved", palette.good),
        _ => ("Time lost", palette.bad),
    };
    let share = if twin.time_of_cut_s > 0.0 { 100.0 * saved_s / twin.time_of_cut_s } else { 0.0 };
    vec![
        Item {
            title: "Ra in tolerance",
            help: "Share of the cut length on which the produced Ra lies within the tolerance \
                   around its target.",
            value: share_of(chosen.in_tolerance_percent),
            color: judged(chosen.in_tolerance_percent >= twin.in_tolerance_percent),
            below: twin_has(share_of(twin.in_tolerance_percent)),
        },
        Item {
            title: "Worst force deviation",
            help: "Largest deviation of the force from the desired force after the first second.",
            value: signed(chosen.force_worst_percent, "%"),
            color: judged(chosen.force_worst_percent.abs() <= twin.force_worst_percent.abs()),
            below: twin_has(signed(twin.force_worst_percent, "%")),
        },
        Item {
            title: "Time of cut",
            help: "Time since the start of the cut, and what constant feed takes for the same \
                   length of path.",
            value: theme::time(chosen.time_of_cut_s),
            color: palette.text,
            below: twin_has(theme::time(twin.time_of_cut_s)),
        },
        Item {
            title: time_title,
            help: "Time that constant feed takes for the same length of path, less the time taken.",
            value: theme::quantity(saved_s.abs(), "s"),
            color: time_color,
            below: [format!("{} of constant feed's time", signed(share, "%")), signed(share, "%")],
        },
        Item {
            title: "Metal removed",
            help: "Axial depth times radial depth, summed over the path.",
            value: theme::quantity(chosen.metal_removed_cm3, "cm^3"),
            color: palette.text,
            below: twin_has(theme::quantity(twin.metal_removed_cm3, "cm^3")),
        },
    ]
}

fn signed(value: f64, unit: &str) -> String {
    let text = theme::quantity(value, unit);
    if value > 0.0 && !text.starts_with("0.0 ") { format!("+{text}") } else { text }
}

/// The strip: five cards beside each other, three in a row where it is narrow.
pub fn show(ui: &mut Ui, view: &View<'_>) {
    let palette = Palette::at(ui);
    let items = items(view, palette);
    let columns = if view.narrow { 3 } else { items.len() };
    let gap = if view.narrow { 4.0 } else { 8.0 };
    let width = (ui.available_width() - gap * (columns - 1) as f32) / columns as f32;
    for row in items.chunks(columns) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            for item in row {
                // A short last row is stretched over the whole width.
                let width = width * columns as f32 / row.len() as f32
                    + gap * (columns as f32 / row.len() as f32 - 1.0);
                card(ui, item, width, view.narrow, palette);
            }
        });
    }
}

fn card(ui: &mut Ui, item: &Item, width: f32, narrow: bool, palette: &Palette) {
    let margin =
        if narrow { egui::Margin::symmetric(6, 3) } else { egui::Margin::symmetric(10, 5) };
    let frame = theme::card(palette).inner_margin(margin);
    let inside = width - frame.total_margin().sum().x;
    let response = frame
        .show(ui, |ui| {
            ui.set_width(inside);
            ui.vertical(|ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                let title = RichText::new(item.title).small().color(palette.weak);
                ui.add(egui::Label::new(title).truncate());
                let size = if narrow { 15.0 } else { 20.0 };
                let value = RichText::new(&item.value).size(size).color(item.color).strong();
                ui.add(egui::Label::new(value).truncate());
                let below = RichText::new(&item.below[usize::from(narrow)]).small();
                ui.add(egui::Label::new(below.color(palette.twin)).truncate());
            });
        })
        .response;
    response.on_hover_text(format!("{} Below: the same cut at constant feed.", item.help));
}
