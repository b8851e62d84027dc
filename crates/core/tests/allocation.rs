//! No allocation per step: counted by the allocator itself.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;

struct Counting;

static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: passes every call on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_step_with_recording_allocates_nothing() {
    let all = ControllerKind::ALL.iter();
    let all = all.flat_map(|kind| ForceModel::ALL.iter().map(move |force| (*kind, *force)));
    for (kind, force_model) in all {
        let mut scenario = load("table3-5-noise").unwrap();
        scenario
            .change(|s| {
                s.controller.kind = kind;
                s.plant.force_model = force_model;
                if force_model == ForceModel::Mechanistic {
                    // The least rate at which teeth may be simulated.
                    s.run.steps_per_control = 200;
                }
                s.cnc.override_quantised = true;
                s.cnc.override_rate_limited = true;
            })
            .unwrap();
        let mut run = Run::new(&scenario, &Edits::none());
        run.advance(100);
        let before = ALLOCATIONS.load(Ordering::Relaxed);
        // Short of the first snapshot, which may allocate: it is one in ten thousand steps.
        run.advance(9_000);
        let after = ALLOCATIONS.load(Ordering::Relaxed);
        assert_eq!(after - before, 0, "{} {}", kind.id(), force_model.id());
    }
}
