//! The cards of the headline: a number each, with what it is of above it and two lines below. Their height is that of
//! the longest words that they come to hold, so that nothing below them moves with a word.

use egui::text::LayoutJob;
use egui::{Color32, RichText, Role, TextStyle, TextWrapMode, Ui, WidgetInfo};

use super::headline::{WITH, shakes};
use crate::app::format;
use crate::app::panels::View;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::strip::strip;
use crate::base::language::tr;

/// One number of the comparison.
pub(super) struct Item {
    /// What it is of.
    pub title: &'static str,
    /// What it means, read by hovering.
    pub help: String,
    /// The value.
    pub value: String,
    /// How it stands.
    pub standing: Standing,
    /// The lines below the value.
    pub below: [String; 2],
}

/// Widths of the cards in a narrow window, points: the first three are in sight on a phone, the others are moved
/// into it.
const NARROW_WIDTHS: [f32; 5] = [116.0, 116.0, 124.0, 192.0, 152.0];

/// The strip: cards beside each other, as long as their numbers have room.
pub(super) fn show(ui: &mut Ui, view: &View<'_>, items: &[Item; 5]) {
    if view.narrow {
        return narrow(ui, view, items);
    }
    const GAP: f32 = 8.0;
    let most = ((ui.available_width() + GAP) / (theme::CARD_WIDTH + GAP)).floor().max(1.0) as usize;
    // Rows of about the same length.
    let columns = items.len().div_ceil(items.len().div_ceil(most));
    let width = (ui.available_width() - GAP * (columns - 1) as f32) / columns as f32;
    for (n, row) in items.chunks(columns).enumerate() {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            // A short last row is stretched over the whole width.
            let stretch = columns as f32 / row.len() as f32;
            let width = width * stretch + GAP * (stretch - 1.0);
            let sized: Vec<(&Item, f32)> = row.iter().map(|item| (item, width)).collect();
            let longest = &longest(view)[n * columns..][..row.len()];
            cards(ui, &sized, longest, egui::Margin::symmetric(10, 5));
        });
    }
}

fn narrow(ui: &mut Ui, view: &View<'_>, items: &[Item; 5]) {
    const GAP: f32 = 4.0;
    let taken: f32 = NARROW_WIDTHS.iter().sum::<f32>() + GAP * (NARROW_WIDTHS.len() - 1) as f32;
    let stretch = (ui.available_width() / taken).max(1.0);
    strip(ui, "headline", None, GAP, |ui| {
        let sized = items.iter().zip(NARROW_WIDTHS.map(|width| width * stretch));
        cards(ui, &sized.collect::<Vec<_>>(), &longest(view), egui::Margin::symmetric(6, 3));
    });
}

/// The longest texts of a card, as far as they are known: titles, values, and what stands in the two lines below.
struct Longest {
    titles: Vec<&'static str>,
    values: Vec<String>,
    below: [Vec<String>; 2],
}

/// Those of all cards. They give the cards their height, so that nothing below moves with a word.
fn longest(view: &View<'_>) -> [Longest; 5] {
    let (narrow, shakes) = (view.narrow, shakes(view));
    let um = || format::quantity(9.999, "um");
    let name = if narrow { tr("safe") } else { tr("safe feed") };
    let twin = |value: String| format!("{name} {value}");
    let outside = || tr("outside model").to_owned();
    let (share, over) = (format::quantity(88.8, "%"), format::number(88.8, "%"));
    let scrap = tr!("{share}, {over} % scrap", share = share, over = over);
    let error = format::deviation(-88.8);
    let [far, time] = [format::deviation(288.8), format::quantity(9.99, "s")];
    let titles = match shakes {
        false => [tr("Ra now"), tr("Ra in tolerance"), tr("Remaining error")],
        true => [tr(WITH[0]), tr("With dynamics in tolerance"), tr("Error without dynamics")],
    };
    let unjudged = match narrow {
        true => tr!("{share} % no Ra ({model})", share = over, model = "K5"),
        false => tr!("{share} % outside the Ra model ({model})", share = over, model = "K5"),
    };
    let [now, settled] = match narrow {
        true => [tr!("target {target}", target = um()), tr!("force rests {time}", time = time)],
        false => [
            tr!("within target {target}", target = um()),
            tr!(
                "force settles in {time} (±{band})",
                time = time,
                band = format::quantity(2.0, "%")
            ),
        ],
    };
    let swings = match (shakes, narrow) {
        (false, true) => tr!("overshoot {size}", size = share),
        (false, false) => tr!("jump {jump}, no overshoot", jump = format::deviation(88.8)),
        (true, true) => tr!("with dynamics {error}", error = far),
        (true, false) => tr!("with dynamics {error} outside", error = far),
    };
    let error = match narrow {
        true => error,
        false => tr!("{error} outside", error = error),
    };
    let whole = format::quantity(120.0, "mm");
    let both = tr!("{over} % rough, {under} % smoother", over = over, under = over);
    let both = Some(both).filter(|_| !narrow);
    let plain = [tr("of the length cut").to_owned(), unjudged].into_iter().chain(both);
    let shaken = [tr!("without dynamics {share}", share = share)].into_iter().filter(|_| shakes);
    [
        Longest {
            titles: vec![titles[0]],
            values: vec![um(), outside()],
            below: [vec![now], vec![twin(um()), twin(outside())]],
        },
        Longest {
            titles: vec![titles[1]],
            values: vec![share.clone(), tr("not judged").to_owned()],
            below: [
                plain.chain(shaken).collect(),
                vec![twin(scrap), twin(tr!("{share}, rest smoother", share = share))],
            ],
        },
        Longest {
            titles: vec![titles[2]],
            values: vec![error],
            below: [vec![settled], vec![swings]],
        },
        Longest {
            titles: vec![tr("Time of cut")],
            values: vec![format::time(99.99)],
            below: [
                vec![tr!("both scrap: {own} and {over} %", own = over, over = over)],
                vec![twin(format::time(99.99))],
            ],
        },
        Longest {
            titles: vec![tr("Metal removed")],
            values: vec![format::quantity(99.99, "cm^3")],
            below: [
                vec![tr!("on {path} of path", path = whole)],
                vec![twin(format::quantity(99.99, "cm^3"))],
            ],
        },
    ]
}

/// Space between the lines of a card, points.
const BETWEEN: f32 = 1.0;

/// Rows of a card: of its value, and of its title with the lines below.
#[derive(Clone, Copy, Default)]
struct Rows {
    value: usize,
    small: usize,
}

/// Cards of one height.
fn cards(ui: &mut Ui, items: &[(&Item, f32)], longest: &[Longest], margin: egui::Margin) {
    let inside = |ui: &Ui, width: f32| {
        let frame = theme::card(Palette::at(ui)).inner_margin(margin);
        width - frame.total_margin().sum().x
    };
    let rows = |style: TextStyle, text: &str, width: f32| {
        let font = style.resolve(ui.style());
        let color = Color32::PLACEHOLDER;
        ui.painter().layout(format::typeset(text), font, color, width).rows.len()
    };
    let mut most = Rows::default();
    for ((_, width), of) in items.iter().zip(longest) {
        let width = inside(ui, *width);
        let small = |text: &str| rows(TextStyle::Small, text, width);
        let below = of.below.iter().map(|texts| texts.iter().map(|text| small(text)).max());
        let below: usize = below.map(Option::unwrap_or_default).sum();
        let title = of.titles.iter().map(|text| small(text)).max().unwrap_or(1);
        // Beside the sign of how it stands.
        let room = width - Standing::Good.room(theme::figure().resolve(ui.style()).size);
        let value = of.values.iter().map(|text| rows(theme::figure(), text, room)).max();
        most.small = most.small.max(title + below);
        most.value = most.value.max(value.unwrap_or(1));
    }
    let [figure, small] =
        [theme::figure(), TextStyle::Small].map(|style| ui.text_style_height(&style));
    let height = most.value as f32 * figure + most.small as f32 * small + 3.0 * BETWEEN;
    for (item, width) in items {
        card(ui, item, (inside(ui, *width), height), most.small, margin);
    }
}

/// Draws a card with room for so many small lines inside; what has no room there is read by hovering.
fn card(
    ui: &mut Ui,
    item: &Item,
    (inside, height): (f32, f32),
    lines: usize,
    margin: egui::Margin,
) {
    let palette = Palette::at(ui);
    let frame = theme::card(palette).inner_margin(margin);
    let shown = frame.show(ui, |ui| {
        ui.set_width(inside);
        ui.set_height(height);
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = BETWEEN;
            let mut left = lines;
            // Each takes what the ones after it do not need.
            let mut small = |ui: &mut Ui, text: &str, kept: usize| {
                let font = TextStyle::Small.resolve(ui.style());
                let mut job = LayoutJob::simple(format::typeset(text), font, palette.weak, inside);
                job.wrap.max_rows = left.saturating_sub(kept).max(1);
                let galley = ui.painter().layout_job(job);
                left = left.saturating_sub(galley.rows.len());
                let label = ui.add(egui::Label::new(galley));
                label.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
            };
            let below = item.below.iter().filter(|line| !line.is_empty());
            let mut after = below.clone().count();
            small(ui, item.title, after);
            let value = RichText::new(&item.value).text_style(theme::figure()).strong();
            let label = item.standing.line(ui, value, TextWrapMode::Wrap);
            let words = item.standing.words();
            let said = format!("{} {words}", item.value);
            label.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.trim_end()));
            for line in below {
                after -= 1;
                small(ui, line, after);
            }
        });
    });
    let whole = format!("{}: {}\n{}", item.title, item.value, item.below.join("\n"));
    shown.response.on_hover_text(format!("{}\n\n{}", whole.trim_end(), item.help));
}
