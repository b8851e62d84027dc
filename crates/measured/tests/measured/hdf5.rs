//! HDF5 and MATLAB v7.3, as h5py, PyTables and hdf5storage write them: `tests/data/samples_hdf5.py` says what is in them.
//! Forty samples each: 1.5 i - 3, i^2 / 4 and 7 i - 100 at 100 Hz, and lists of whole numbers.

use super::{entry, guessed, layout, sample};
use steadycut_measured::channel::{MeasuredChannel, SampleTimes};
use steadycut_measured::reader::{DataFormat, MeasuredData, read};

const COUNT: usize = 40;

/// The value of a channel at each sample.
type Law = fn(f64) -> f64;

const FX: Law = |i| 1.5 * i - 3.0;
const FY: Law = |i| 0.25 * i * i;
const RAW: Law = |i| 7.0 * i - 100.0;

fn channel<'a>(data: &'a MeasuredData, title: &str) -> &'a MeasuredChannel {
    let titles: Vec<String> = data.channels.iter().map(MeasuredChannel::title).collect();
    let place = titles.iter().position(|known| known == title);
    &data.channels[place.unwrap_or_else(|| panic!("{title}: {titles:?}"))]
}

/// These channels are there, and no others, to the bit.
fn has(data: &MeasuredData, channels: &[(&str, Law)]) {
    for (title, law) in channels {
        let known: Vec<f64> = (0..COUNT).map(|i| law(i as f64)).collect();
        assert_eq!(channel(data, title).values, known, "{title}");
    }
    assert_eq!(data.channels.len(), channels.len());
}

const EVEN: SampleTimes = SampleTimes::Even { rate_hz: 100.0, first_s: 0.0 };

fn has_fact(data: &MeasuredData, name: &str, value: &str) {
    assert!(data.facts.contains(&(name.to_owned(), value.to_owned())), "{name}: {:?}", data.facts);
}

#[test]
fn groups_units_orders_of_bytes_and_chunks_of_the_older_format() {
    let data = guessed(&sample("h5py.h5"));
    assert_eq!(data.format, DataFormat::Hdf5);
    has(
        &data,
        &[
            ("force.Fx [N]", FX),
            ("force.Fy [kN]", FY),
            ("force.raw", RAW),
            ("sensors.table.acc_1", |i| i),
            ("sensors.table.acc_2", |i| 2.0 * i),
            ("sensors.table.acc_3", |i| -i),
        ],
    );
    assert!(data.channels.iter().all(|channel| channel.times == EVEN));
    has_fact(&data, "title", "cut 1");
    has_fact(&data, "sample_rate", "100");
    let names: Vec<&str> = data.entries.iter().map(|entry| entry.name.as_str()).collect();
    assert_eq!(names, ["empty", "force", "sensors"]);
    has_fact(&data, "comment", "free text");
    // A group, and what is in one, as paths are written in either way.
    let one = read(&sample("h5py.h5"), &layout(&[("variable", "/sensors/table")])).unwrap();
    assert_eq!(one.channels.len(), 3);
    assert_eq!(entry(&one, "variable"), "/sensors/table");
    let one = read(&sample("h5py.h5"), &layout(&[("variable", "force.Fy")])).unwrap();
    has(&one, &[("Fy [kN]", FY)]);
    let error = read(&sample("h5py.h5"), &layout(&[("variable", "force/Fz")])).unwrap_err();
    assert!(error.to_string().contains("there is no `Fz`"), "{error}");
}

#[test]
fn every_index_of_the_newest_format() {
    let data = guessed(&sample("h5py_latest.h5"));
    has(
        &data,
        &[
            ("fixed", FY),
            ("growing", |i| 1.5 * i - 4.0),
            ("implicit", |i| 0.25 * i * i + 1.0),
            ("packed", RAW),
            ("single [N]", FX),
        ],
    );
    assert_eq!(entry(&data, "time"), "time");
    assert!(data.channels.iter().all(|channel| channel.times == EVEN));
}

#[test]
fn many_links_and_attributes_and_chunks_that_grow_in_two_directions() {
    let data = guessed(&sample("h5py_dense.h5"));
    assert_eq!(data.channels.len(), 14);
    for n in 0..12 {
        let title = format!("c{n:02}{}", if n == 3 { " [mm]" } else { "" });
        let known: Vec<f64> = (0..COUNT).map(|i| (i + n) as f64).collect();
        assert_eq!(channel(&data, &title).values, known, "{title}");
        has_fact(&data, &format!("c03.note{n}"), &n.to_string());
    }
    let grid: Vec<f64> = (0..COUNT).map(|i| 3.0 * i as f64).collect();
    assert_eq!(channel(&data, "grid_2").values, grid);
}

#[test]
fn groups_have_times_and_rates_of_their_own_and_attributes_say_what_columns_are() {
    let data = guessed(&sample("h5py_groups.h5"));
    has(
        &data,
        &[
            ("cut1.Fx [N]", FX),
            ("cut2.Fx [N]", |i| 0.75 * i - 1.5),
            ("more.ax [g]", |i| i),
            ("more.ay [m/s2]", |i| -i),
            ("more.packed", |i| 3.5 * i - 40.0),
            ("more.flags", |i| if i % 3.0 == 0.0 { 1.0 } else { 0.0 }),
            ("more.holes", |i| if (10.0..20.0).contains(&i) { i } else { 7.0 }),
        ],
    );
    for (title, rate_hz) in [("cut1.Fx [N]", 100.0), ("cut2.Fx [N]", 200.0), ("more.ax [g]", 50.0)]
    {
        assert_eq!(channel(&data, title).times.rate_hz(), Some(rate_hz), "{title}");
    }
    for note in [
        "`more.complex` was left out: 40 x 1 complex numbers",
        "`more.whole` was left out: compressed in a way that is not read",
        "`more.endless` was left out: more values than a file of this size can have",
    ] {
        assert!(data.notes.iter().any(|known| known == note), "{note}: {:?}", data.notes);
    }
}

#[test]
fn a_table_of_records_has_its_fields_as_channels() {
    let data = guessed(&sample("pytables.h5"));
    has(&data, &[("Fx", FX), ("count", RAW), ("axes_1", |i| i), ("axes_2", |i| -i)]);
    assert_eq!(entry(&data, "time"), "time");
    assert!(data.channels.iter().all(|channel| channel.times == EVEN));
}

#[test]
fn structures_cells_and_texts_of_matlab_7_3() {
    let data = guessed(&sample("hdf5storage.mat"));
    assert_eq!(data.format, DataFormat::Matlab73);
    assert_eq!(entry(&data, "variable"), "data");
    has(
        &data,
        &[("Fx [N]", FX), ("Fy [N]", FY), ("first [N]", |i| i), ("second [N]", |i| i + 0.5)],
    );
    assert!(data.channels.iter().all(|channel| channel.times == EVEN));
    has_fact(&data, "fs", "100");
    let about: Vec<&str> = data.entries.iter().map(|entry| entry.about.as_str()).collect();
    assert!(about[0].starts_with("1 records of Fx, Fy"), "{about:?}");
    assert_eq!(about[1], "2 cells");
}

#[test]
fn arrays_of_structures_of_matlab_7_3_are_chosen_as_those_of_version_5() {
    let bytes = sample("hdf5storage_records.mat");
    let data = guessed(&bytes);
    assert_eq!(entry(&data, "variable"), "mill[1]");
    assert!(data.notes[0].contains("record 1 of 2 in `mill`"), "{:?}", data.notes);
    has(&data, &[("smcAC", FX)]);
    let second = read(&bytes, &layout(&[("variable", "mill[2]")])).unwrap();
    has(&second, &[("smcAC", |i| 1.5 * i - 2.0)]);
    has_fact(&second, "run", "2");
    has_fact(&second, "VB", "0.1");
    assert_eq!(second.entries[0].about, "2 records of run, VB, smcAC");
}

#[test]
fn values_that_were_spoilt_on_the_way_are_refused_by_their_checksum() {
    let bytes = sample("h5py_latest.h5");
    let places = (0..bytes.len()).step_by(5).filter(|place| {
        let mut spoilt = bytes.clone();
        spoilt[*place] ^= 1;
        read(&spoilt, &layout(&[])).is_err_and(|error| error.to_string().contains("checksum"))
    });
    // Of what describes the arrays, most bytes are under one.
    assert!(places.count() > 200);
}
