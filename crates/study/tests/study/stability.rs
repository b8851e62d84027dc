//! The stability chart's verdict and the running cut agree wherever the tool goes.

use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::signals::flag;
use steadycut_study::stability::StabilityCut;
use steadycut_study::stability::interrupted::multiplier;

/// The spindle of quality 17 at 1800 1/min: in the slot 0.8 mm chatter, and at 3 mm of width they do not.
#[test]
fn the_verdict_at_a_depth_is_that_of_the_coupled_run_in_the_slot_too() {
    for (radial_depth_mm, depth_mm, chatters) in [
        (16.0, 0.8, true),
        (16.0, 0.5, true),
        (16.0, 0.3, false),
        (8.0, 0.3, false),
        (3.0, 0.8, false),
    ] {
        let scenario = load("chatter").unwrap().with(|s| {
            s.workpiece.depth_steps.clear();
            s.workpiece.radial_depth_mm = radial_depth_mm;
            s.workpiece.axial_depth_mm = depth_mm;
            s.run.duration_s = 5.0;
        });
        let scenario = scenario.unwrap();
        let cut = StabilityCut::new(&scenario).unwrap();
        let grown = multiplier(&cut, scenario.program.spindle_rpm, depth_mm);
        assert_eq!(grown > 1.0, chatters, "{radial_depth_mm} x {depth_mm} mm: {grown}");
        let run = Run::complete(&scenario, &Edits::none());
        let rows = run.recording().rows();
        let last = &rows[rows.len() - 500..];
        let lost = last.iter().any(|row| row.has(flag::LOST_CONTACT));
        assert_eq!(lost, chatters, "{radial_depth_mm} x {depth_mm} mm");
    }
}
