//! The window on the desktop.

use std::sync::Arc;

use super::library::FolderShelf;
use super::remembered::{Folder, Remembered};
use super::{Console, theme};
use crate::base::language::tr;
use crate::study::opening::Opening;

/// Opens the window and stays until it is closed.
///
/// # Errors
/// There is no display, or nothing to draw with: what is missing, and how to get it.
pub fn run(opening: Opening) -> Result<(), String> {
    let viewport = egui::ViewportBuilder::default()
        .with_title("SteadyCut")
        .with_app_id("steadycut")
        .with_inner_size(theme::WINDOW)
        .with_min_inner_size(theme::WINDOW_MIN)
        .with_icon(icon());
    let options = eframe::NativeOptions {
        viewport,
        renderer: eframe::Renderer::Wgpu,
        ..eframe::NativeOptions::default()
    };
    let create: eframe::AppCreator<'_> = Box::new(|cc| {
        super::scene::prepare(cc);
        let mut console = Console::opened(&cc.egui_ctx, opening);
        console.remember(Remembered::of(Box::new(Folder::of_user())));
        if let Some(folder) = FolderShelf::of_user() {
            console.keep_files(Arc::new(folder));
        }
        console.speak_as_asked(sys_locale::get_locales());
        Ok(Box::new(console))
    });
    eframe::run_native("SteadyCut", options, create).map_err(|error| explain(&error))
}

/// The failure in words that help.
#[expect(
    clippy::wildcard_enum_match_arm,
    reason = "the library's variants differ with its features, and one of them needs other advice"
)]
fn explain(error: &eframe::Error) -> String {
    let advice = match error {
        eframe::Error::Wgpu(_) => tr(
            "No graphics adapter could be used. A driver for Vulkan is needed; without a graphics \
                card, Mesa's software driver does (Debian, Ubuntu: apt install mesa-vulkan-drivers).",
        ),
        _ => tr(
            "No window could be opened. A display is needed: on Linux, DISPLAY or WAYLAND_DISPLAY \
                must be set, and X11 needs libxkbcommon-x11 (Debian, Ubuntu: apt install \
                libxkbcommon-x11-0). Without a display, `xvfb-run steadycut` opens one that is not \
                seen, and `steadycut run` needs none.",
        ),
    };
    let text = error.to_string();
    let problem = without_place(&text);
    let said = tr!("the console cannot be shown: {problem}", problem = problem);
    format!("{said}\n{advice}")
}

/// The window library names the place in its own source; only what follows helps a user.
fn without_place(error: &str) -> &str {
    let after = error.rsplit_once(".rs:").and_then(|(_, rest)| rest.split_once(": "));
    after.map_or(error, |(_, message)| message)
}

/// The icon: a steady profile between two tolerance lines.
fn icon() -> egui::IconData {
    const SIZE: usize = 64;
    let palette = theme::Palette::of(egui::Theme::Light);
    let mut rgba = Vec::with_capacity(4 * SIZE * SIZE);
    for y in 0..SIZE {
        for x in 0..SIZE {
            // Teeth that get smaller towards the right.
            let (fx, fy) = (x as f32, y as f32 - 32.0);
            let tooth = ((fx / 8.0).fract() - 0.5).abs() * 4.0 - 1.0;
            let profile = tooth * (18.0 - 0.26 * fx);
            let rounded = (fx - 31.5).abs().max(fy.abs()) + 0.4 * (fx - 31.5).abs().min(fy.abs());
            let color = if rounded > 38.0 {
                egui::Color32::TRANSPARENT
            } else if (fy - profile).abs() < 3.2 {
                egui::Color32::WHITE
            } else if (fy.abs() - 21.0).abs() < 1.5 {
                theme::Palette::of(egui::Theme::Dark).command
            } else {
                palette.accent
            };
            rgba.extend(color.to_srgba_unmultiplied());
        }
    }
    egui::IconData { rgba, width: SIZE as u32, height: SIZE as u32 }
}

#[cfg(test)]
mod tests {
    use super::without_place;

    #[test]
    fn an_error_is_told_without_its_place_in_the_source() {
        assert_eq!(without_place("os error at /x/mod.rs:765: no display"), "no display");
        assert_eq!(without_place("no adapter: none"), "no adapter: none");
    }
}
