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

#[test]
fn a_slice_grows_with_frames_that_are_slow_anyway() {
    assert_eq!(frame_slice_s(0.0), FRAME_SLICE_S);
    // Sixty frames a second leave it as it is.
    assert_eq!(frame_slice_s(0.0087), FRAME_SLICE_S);
    assert!((frame_slice_s(0.15) - 0.075).abs() < 1e-12);
    assert_eq!(frame_slice_s(5.0), MOST_SLICE_S);
}

#[test]
fn slow_frames_bring_a_job_on_by_a_share_of_their_time() {
    let endless = presets::load("experiment-2").unwrap();
    let jobs = Jobs::default();
    jobs.work_in_slices();
    let work = jobs.begin("Run", Run::new(&endless, &Edits::none()), 100);
    // Steps have to grow to the slice first.
    for _ in 0..14 {
        jobs.pump(&egui::Context::default());
    }
    let before_s = work.shared.slot().worked_s;
    for _ in 0..6 {
        std::thread::sleep(std::time::Duration::from_millis(80));
        jobs.pump(&egui::Context::default());
    }
    let worked_s = work.shared.slot().worked_s - before_s;
    // Six slices of a fast frame would be 0.05 s, of these 0.24 s.
    assert!(worked_s > 0.1, "{worked_s} s in six frames of 80 ms");
}

/// Counts two of ten only after some work on what is not counted.
struct Counting(u32);

impl Job for Counting {
    type Partial = u32;

    fn advance(&mut self, _: &Budget<'_>) -> bool {
        std::thread::sleep(std::time::Duration::from_millis(20));
        self.0 += 1;
        self.0 >= 14
    }

    fn progress(&self) -> Progress {
        Progress { done: f64::from(self.0.saturating_sub(4)), total: 10.0, unit: "runs" }
    }

    fn partial(&self) -> u32 {
        self.0
    }
}

#[test]
fn the_time_left_goes_by_what_is_counted_alone() {
    let jobs = Jobs::default();
    jobs.work_in_slices();
    let work = jobs.begin("Counting", Counting(0), 1);
    for _ in 0..4 {
        jobs.pump(&egui::Context::default());
    }
    assert_eq!(work.left_s(), None);
    for _ in 0..2 {
        jobs.pump(&egui::Context::default());
    }
    // Two of ten took 40 ms: eight are left, and the 80 ms before them say nothing.
    let left_s = work.left_s().unwrap();
    assert!((0.12..0.3).contains(&left_s), "{left_s}");
}

#[test]
fn what_is_stopped_in_the_list_stays_there_and_goes_on_from_it() {
    let endless = presets::load("experiment-2").unwrap();
    let jobs = Jobs::default();
    jobs.work_in_slices();
    let work = jobs.begin("Run", Run::new(&endless, &Edits::none()), 100);
    jobs.pump(&egui::Context::default());
    let listed = || jobs.all.borrow().iter().map(|job| job.is_halted()).collect::<Vec<bool>>();
    let done = work.progress().done;
    jobs.all.borrow()[0].halt();
    assert_eq!((work.is_running(), listed()), (false, vec![true]));
    jobs.pump(&egui::Context::default());
    assert_eq!(work.progress().done, done);
    jobs.all.borrow()[0].go_on();
    assert_eq!((work.is_running(), listed()), (true, vec![false]));
    jobs.pump(&egui::Context::default());
    assert!(work.progress().done > done);
}
