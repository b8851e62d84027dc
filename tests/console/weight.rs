//! How much a frame draws. Time differs from machine to machine; what it is made of does not: under software
//! drawing the vertices are most of it.

use eframe::egui;
use egui::epaint::Primitive;
use egui::{Event, Key, Modifiers, Pos2, RawInput, Rect, vec2};
use steadycut::app::Console;
use steadycut::run::edits::Edits;
use steadycut::run::{Start, presets};

/// Most vertices and draw calls of a frame of each screen in the middle of a noisy cut, by its key. The console had
/// 102 538 vertices when its curves were drawn with four points a pixel, 57 600 with one and corners between; and 23
/// calls when shapes were drawn in the order in which they were painted.
const MOST: [(Key, usize, usize); 7] = [
    (Key::Num1, 25_000, 19),
    (Key::Num2, 30_000, 12),
    (Key::Num3, 30_000, 32),
    (Key::Num4, 30_000, 17),
    (Key::Num5, 30_000, 16),
    (Key::Num7, 30_000, 9),
    (Key::Num8, 30_000, 13),
];

fn drawn(screen: Key) -> (usize, usize) {
    let ctx = egui::Context::default();
    let scenario = presets::load("first-cut").unwrap();
    let mut console = Console::new(&ctx, Start { scenario, edits: Edits::none(), notice: None });
    let mut time_s = 0.0;
    let mut frame = |events: Vec<Event>| {
        time_s += 0.05;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 800.0))),
            time: Some(time_s),
            events,
            ..RawInput::default()
        };
        let mut output = ctx.run_ui(input, |ui| console.ui(ui));
        // Nobody takes the textures.
        output.textures_delta.clear();
        let drawn = ctx.tessellate(output.shapes, output.pixels_per_point);
        let of = |primitive: &Primitive| match primitive {
            Primitive::Mesh(mesh) => mesh.vertices.len(),
            Primitive::Callback(_) => 0,
        };
        (drawn.iter().map(|clipped| of(&clipped.primitive)).sum(), drawn.len())
    };
    frame(Vec::new());
    let key = Event::Key {
        key: screen,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::COMMAND,
    };
    frame(vec![key]);
    // 18 s of the cut: the plots are full.
    (0..360).map(|_| frame(Vec::new())).last().expect("frames")
}

#[test]
fn no_screen_draws_more_than_can_be_seen() {
    for (screen, most, most_calls) in MOST {
        let (vertices, calls) = drawn(screen);
        assert!((1000..most).contains(&vertices), "{screen:?}: {vertices} vertices");
        assert!((1..=most_calls).contains(&calls), "{screen:?}: {calls} draw calls");
    }
}
