use super::*;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::presets;
use crate::study::compare::entrants::{TABLE_1, on};
use crate::study::compare::tournament::Tournament;

fn tournament() -> Tournament {
    let mut base = presets::load("table3-5-noise").unwrap();
    base.change(|settings| settings.run.duration_s = 2.0).unwrap();
    Tournament::new(on(&base, &TABLE_1[..3]), 2)
}

/// Pumps until the work rests.
fn finish<J: Job>(jobs: &Jobs, work: &Work<J>) {
    let ctx = egui::Context::default();
    for _ in 0..10_000 {
        if !work.is_running() {
            return;
        }
        jobs.pump(&ctx);
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    panic!("{}", work.progress());
}

#[test]
fn threads_and_slices_give_the_same_and_a_stop_keeps_what_was_found() {
    let mut whole = tournament();
    whole.to_end();
    for in_slices in [false, true] {
        let jobs = Jobs::default();
        if in_slices {
            jobs.work_in_slices();
        }
        let work = jobs.begin("Compare", tournament(), 100);
        // Stopped on the way.
        while work.progress().done < 1.0 {
            jobs.pump(&egui::Context::default());
        }
        work.stop();
        jobs.pump(&egui::Context::default());
        let (at, partial) = (work.progress(), work.partial());
        assert!(at.done >= 1.0 && partial[0].runs >= 1);
        work.go_on();
        finish(&jobs, &work);
        assert!(work.is_over());
        assert_eq!(*work.partial(), whole.table());
        // More to do, once it is wanted.
        work.change(|tournament| tournament.set_seeds(3));
        while work.progress().total < 9.0 {
            std::thread::yield_now();
        }
        assert!(!work.is_over() && !work.is_running());
        work.go_on();
        finish(&jobs, &work);
        assert!(work.partial().iter().all(|row| row.runs == 3));
    }
}

#[test]
fn what_nobody_wants_is_given_up() {
    let jobs = Jobs::default();
    let endless = presets::load("experiment-2").unwrap();
    let work = jobs.begin("Run", Run::new(&endless, &Edits::none()), 100);
    jobs.pump(&egui::Context::default());
    assert_eq!(jobs.all.borrow().len(), 1);
    drop(work);
    jobs.pump(&egui::Context::default());
    assert!(jobs.all.borrow().is_empty());
}
