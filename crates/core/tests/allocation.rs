//! No allocation per step: counted by the allocator itself.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::models::structure::RoughnessFrom;
use steadycut_core::models::wear::WearModel;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;

struct Counting;

thread_local! {
    /// Allocations of a thread: the test's own, not those of the harness beside it.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: passes every call on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocates_nothing(scenario: &Scenario, case: &str) {
    let mut run = Run::new(scenario, &Edits::none());
    run.advance(100);
    let before = ALLOCATIONS.get();
    // Short of the first snapshot, which may allocate: it is one in ten thousand steps.
    run.advance(9_000);
    let after = ALLOCATIONS.get();
    assert!(run.ticks() == 9_100, "{case} ended");
    assert_eq!(after - before, 0, "{case}");
}

/// Noise and every limit of the overrides, at a rate at which the force model can run.
fn scenario(kind: ControllerKind, force_model: ForceModel) -> Scenario {
    let mut scenario = load("table3-5-noise").unwrap();
    scenario
        .change(|s| {
            s.controller.kind = kind;
            s.plant.force_model = force_model;
            if force_model.tooth_by_tooth() {
                // The least rate at which teeth may be simulated.
                s.run.steps_per_control = 200;
            }
            s.cnc.override_quantised = true;
            s.cnc.override_rate_limited = true;
        })
        .unwrap();
    scenario
}

/// What is left out is the measurement of the marks' profile, once in a sampling length of a coupled run
/// that takes its roughness from them.
#[test]
fn a_step_with_recording_allocates_nothing() {
    for kind in ControllerKind::ALL.iter().filter(|kind| !kind.allocates()) {
        for force_model in ForceModel::ALL {
            let case = format!("{} {}", kind.id(), force_model.id());
            allocates_nothing(&scenario(*kind, *force_model), &case);
        }
    }
    for force_model in ForceModel::ALL {
        let mut several = scenario(ControllerKind::Tracking, *force_model);
        let cuts = vec![vec![[5.0, 2.0, 2.0], [3.0, 2.5, 1.0]], vec![[200.0, 2.5, 2.0]]];
        several.change(|s| s.workpiece.cuts = cuts).unwrap();
        allocates_nothing(&several, &format!("several cuts, {}", force_model.id()));
        let mut coupled = scenario(ControllerKind::Tracking, *force_model);
        coupled
            .change(|s| {
                s.machine.coupled = true;
                s.machine.roughness_from = RoughnessFrom::Random;
            })
            .unwrap();
        allocates_nothing(&coupled, &format!("coupled, {}", force_model.id()));
        let mut adjusted = coupled;
        adjusted
            .change(|s| {
                s.controller.kind = ControllerKind::ConstantFeed;
                s.wear.model = WearModel::Life;
                s.wear.adjust_speed = true;
                // A minute of the tool's life in half a second, and more than one adjustment.
                s.wear.time_scale = 120.0;
            })
            .unwrap();
        allocates_nothing(&adjusted, &format!("speed adjusted, {}", force_model.id()));
    }
}
