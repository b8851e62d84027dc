//! From an edit to the redrawn console: what a person waits for after moving a slider.
//!
//! Each iteration drags the target-Ra slider by one step and runs whole frames (input, edit, both
//! runs repeated from the playhead to their end, metrics, layout, tessellation) without a GPU.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use eframe::egui;
use steadycut::app::Console;
use steadycut::app::cut::Cut;
use steadycut::base::settings::Value;
use steadycut::run::edits::{Edit, Edits};
use steadycut::run::metrics;
use steadycut::run::one_run::Run;
use steadycut::run::{Start, presets};
use steadycut::run::{against_twin, constant_feed_twin};
use steadycut::study::compare::contest::ContestJob;
use steadycut::study::compare::entrants::{TABLE_1, experiment_2, on};

const SIZE: egui::Vec2 = egui::vec2(1280.0, 800.0);

struct Bench {
    ctx: egui::Context,
    console: Console,
    time_s: f64,
}

impl Bench {
    fn new(preset: &str) -> Self {
        let ctx = egui::Context::default();
        let scenario = presets::load(preset).expect("a shipped preset");
        let start = Start { scenario, edits: Edits::none(), notice: None };
        let console = Console::new(&ctx, start);
        let mut bench = Self { ctx, console, time_s: 0.0 };
        for _ in 0..20 {
            bench.frame(Vec::new());
        }
        bench
    }

    fn frame(&mut self, events: Vec<egui::Event>) -> usize {
        self.time_s += 1.0 / 60.0;
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, SIZE)),
            time: Some(self.time_s),
            events,
            ..egui::RawInput::default()
        };
        let mut output = self.ctx.run_ui(input, |ui| self.console.ui(ui));
        // Nobody takes the textures.
        output.textures_delta.clear();
        self.ctx.tessellate(output.shapes, output.pixels_per_point).len()
    }

    fn state(&self) -> serde_json::Value {
        serde_json::from_str(&self.console.state_json()).expect("the state is JSON")
    }

    fn slider(&self) -> [f32; 4] {
        let state = self.state();
        let rect = &state["rects"]["target_ra_slider"];
        [0, 1, 2, 3].map(|i| rect[i].as_f64().expect("the slider is shown") as f32)
    }
}

fn console(criterion: &mut Criterion) {
    let mut bench = Bench::new("first-cut");
    criterion.bench_function("frame without an edit", |bencher| {
        bencher.iter(|| black_box(bench.frame(Vec::new())));
    });

    let mut bench = Bench::new("first-cut");
    let [left, top, right, bottom] = bench.slider();
    let at = |fraction: f32| egui::pos2(left + fraction * (right - left), 0.5 * (top + bottom));
    let press = egui::Event::PointerButton {
        pos: at(0.5),
        button: egui::PointerButton::Primary,
        pressed: true,
        modifiers: egui::Modifiers::NONE,
    };
    bench.frame(vec![egui::Event::PointerMoved(at(0.5)), press]);
    let mut k = 0_u32;
    let before = bench.state()["target_ra_um"].clone();
    criterion.bench_function("edit to redraw", |bencher| {
        bencher.iter(|| {
            k += 1;
            let fraction = 0.4 + 0.2 * (k % 7) as f32 / 7.0;
            black_box(bench.frame(vec![egui::Event::PointerMoved(at(fraction))]))
        });
    });
    assert_ne!(bench.state()["target_ra_um"], before, "the slider must have moved");
}

/// The screen with the part in space: turned under a drag, so that all of it is made again in every
/// frame, and at rest. What the graphics adapter does comes on top.
fn part(criterion: &mut Criterion) {
    let mut bench = Bench::new("first-cut");
    let key = |key, modifiers| egui::Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    };
    bench.frame(vec![key(egui::Key::Num3, egui::Modifiers::COMMAND)]);
    assert_eq!(bench.state()["screen"], "workpiece");
    bench.frame(vec![key(egui::Key::End, egui::Modifiers::NONE)]);
    for _ in 0..20 {
        bench.frame(Vec::new());
    }
    criterion.bench_function("frame of the part at rest", |bencher| {
        bencher.iter(|| black_box(bench.frame(Vec::new())));
    });
    let at = |k: u32| egui::pos2(300.0 + (k % 100) as f32, 300.0);
    let press = egui::Event::PointerButton {
        pos: at(0),
        button: egui::PointerButton::Primary,
        pressed: true,
        modifiers: egui::Modifiers::NONE,
    };
    bench.frame(vec![egui::Event::PointerMoved(at(0))]);
    bench.frame(vec![press]);
    let mut k = 0;
    criterion.bench_function("frame of the part turned", |bencher| {
        bencher.iter(|| {
            k += 1;
            black_box(bench.frame(vec![egui::Event::PointerMoved(at(k))]))
        });
    });
}

/// The parts of an edit: repeating one run, the same with its min-max levels, the comparison.
fn parts(criterion: &mut Criterion) {
    let scenario = presets::load("first-cut").expect("a shipped preset");
    let plans = [0.9, 1.0].map(|ra_um| {
        let mut edits = Edits::none();
        let (path, value) = ("target.ra_um".to_owned(), Value::Float(ra_um));
        edits.push(&scenario, Edit { at_s: 5.0, path, value }).expect("it fits");
        edits
    });
    let mut run = Run::complete(&scenario, &plans[0]);
    let mut k = 0;
    criterion.bench_function("repeat a run from an edit at 5 s", |bencher| {
        bencher.iter(|| {
            k += 1;
            run.branch(5.0, &plans[k % 2]);
            run.advance(u64::MAX);
        });
    });
    let mut cut = Cut::new(&scenario, &plans[0]);
    criterion.bench_function("the same with min-max levels", |bencher| {
        bencher.iter(|| {
            k += 1;
            cut.change(&scenario, &plans[k % 2]);
            cut.advance(u64::MAX);
        });
    });
    let mut twin = Cut::new(&constant_feed_twin::scenario(&scenario), &plans[0]);
    [&mut cut, &mut twin].into_iter().for_each(|cut| cut.advance(u64::MAX));
    let rows = cut.run().recording().rows().len();
    // As while it plays: 400 ms more each time, from the start again at the end.
    let mut shown = 0;
    criterion.bench_function("compare with the twin, counted on", |bencher| {
        bencher.iter(|| {
            shown = (shown + 400) % rows;
            black_box(against_twin::compare_on(cut.counted(), shown, twin.counted()))
        });
    });
    criterion.bench_function("the same counted from the start each time", |bencher| {
        bencher.iter(|| {
            shown = (shown + 400) % rows;
            let of = |cut: &Cut| {
                let run = cut.run();
                metrics::metrics(run.recording(), shown, run.scenario(), run.edits())
            };
            black_box([of(&cut), of(&twin)])
        });
    });
}

/// A frame while the runs of Table 1 go on, on threads and in the frames as in a page.
fn at_work(criterion: &mut Criterion) {
    for (name, in_slices) in [("threads", false), ("slices", true)] {
        let mut bench = Bench::new("first-cut");
        if in_slices {
            bench.console.jobs().work_in_slices();
        }
        let contest = ContestJob::new(on(&experiment_2(), &TABLE_1), 500);
        let work = bench.console.jobs().begin("Compare", contest, 20_000);
        criterion.bench_function(&format!("frame while Compare runs, {name}"), |bencher| {
            bencher.iter(|| black_box(bench.frame(Vec::new())));
        });
        // As a test it is one frame, which may be over before the first slice.
        let worked = (0..10_000).any(|_| {
            bench.frame(Vec::new());
            work.progress().done > 0.0
        });
        assert!(worked && work.is_running());
    }
}

criterion_group!(benches, console, part, parts, at_work);
criterion_main!(benches);
