//! The sample files, in the layouts that labs and public data have, against what other programs read in them: scipy
//! (MATLAB), nptdms (TDMS), polars (Parquet). Three forces at 25 kHz: 200 |sin|, 80 sin, 30 cos at 105 Hz with 1 N of
//! noise; `tests/data/README.md` says where they come from.

use super::{entry, guessed, layout, sample};
use steadycut_measured::base::math;
use steadycut_measured::channel::SampleTimes;
use steadycut_measured::reader::{DataFormat, MeasuredData, read};

/// The first two and the last sample of each force, as scipy, nptdms and polars read them.
const FORCES: [(&str, [f64; 3]); 3] = [
    ("Fx", [0.345_584_19, 3.974_105_86, 122.589_752_174_496_82]),
    ("Fy", [0.821_618_14, 3.016_261_1, 49.237_745_705_842_4]),
    ("Fz", [30.330_437_08, 30.435_929_19, -23.132_464_934_573_573]),
];

/// The forces are there at 25 kHz, as exact as the file has them.
fn has_forces(data: &MeasuredData, digits: f64) {
    assert_eq!(data.channels.len(), 3, "{:?}", data.layout);
    for (channel, (name, [first, second, last])) in data.channels.iter().zip(FORCES) {
        assert_eq!(channel.name, name);
        assert_eq!(channel.unit, "N");
        assert_eq!(channel.values.len(), 2000);
        assert_eq!(channel.times, SampleTimes::Even { rate_hz: 25_000.0, first_s: 0.0 });
        let found = [channel.values[0], channel.values[1], channel.values[1999]];
        for (found, known) in found.iter().zip([first, second, last]) {
            assert!((found - known).abs() <= digits, "{name}: {found} {known}");
        }
    }
}

/// What the values follow, from the samples' description.
fn follows_the_sines(data: &MeasuredData) {
    let angle = |i: usize| 2.0 * math::PI * 105.0 * i as f64 / 25_000.0;
    for (channel, law) in data.channels.iter().zip([
        (|a: f64| 200.0 * math::sin(a).abs()) as fn(f64) -> f64,
        |a| 80.0 * math::sin(a),
        |a| 30.0 * math::cos(a),
    ]) {
        let errors: Vec<f64> =
            channel.values.iter().enumerate().map(|(i, x)| x - law(angle(i))).collect();
        let rms = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
        assert!((0.9..1.1).contains(&rms), "{}: noise of {rms} N", channel.name);
    }
}

#[test]
fn a_spreadsheets_text_with_decimal_commas_and_units() {
    let data = guessed(&sample("excel.csv"));
    assert_eq!(data.format, DataFormat::Text);
    has_forces(&data, 5e-7);
    follows_the_sines(&data);
    for (key, value) in [
        ("encoding", "utf-8"),
        ("separator", "semicolon"),
        ("decimal", "comma"),
        ("thousands", "none"),
        ("names_line", "1"),
        ("units_line", "2"),
        ("first_line", "3"),
        ("names", "Zeit,Fx,Fy,Fz"),
        ("units", "s,N,N,N"),
        ("time", "Zeit"),
        ("rate_hz", "25000"),
    ] {
        assert_eq!(entry(&data, key), value, "{key}");
    }
    assert_eq!(data.notes, Vec::<String>::new());
}

#[test]
fn the_same_from_matlab_tdms_and_parquet_to_the_bit() {
    let [matlab, tdms, parquet] =
        ["force_v5.mat", "lab.tdms", "lab.parquet"].map(|name| guessed(&sample(name)));
    for (data, format) in
        [(&matlab, DataFormat::Matlab5), (&tdms, DataFormat::Tdms), (&parquet, DataFormat::Parquet)]
    {
        assert_eq!(data.format, format);
        follows_the_sines(data);
    }
    has_forces(&matlab, 5e-9);
    has_forces(&tdms, 5e-9);
    let parquet_with_units =
        read(&sample("lab.parquet"), &layout(&[("units", "s,N,N,N")])).unwrap();
    has_forces(&parquet_with_units, 5e-9);
    for (a, (b, c)) in matlab.channels.iter().zip(tdms.channels.iter().zip(&parquet.channels)) {
        assert_eq!(a.values, b.values);
        assert_eq!(a.values, c.values);
    }
    assert!(matlab.facts.contains(&("fs".to_owned(), "25000".to_owned())), "{:?}", matlab.facts);
    assert!(tdms.facts.contains(&("title".to_owned(), "cut 1".to_owned())), "{:?}", tdms.facts);
    // Sums of all samples, as polars has them.
    for (channel, sum) in parquet.channels.iter().zip([
        256_213.366_561_282_6,
        5_465.622_652_497_103,
        604.331_434_759_966_8,
    ]) {
        assert!((channel.values.iter().sum::<f64>() - sum).abs() < 1e-6, "{}", channel.name);
    }
}

#[test]
fn records_of_the_milling_data_are_chosen_by_their_number() {
    let data = guessed(&sample("mill.mat"));
    assert_eq!(entry(&data, "variable"), "mill[1]");
    assert!(data.notes[0].contains("record 1 of 3 in `mill`"), "{:?}", data.notes);
    let about = &data.entries[0].about;
    assert!(
        about.contains("3 records of case, run, VB, time, DOC, feed, material, smcAC"),
        "{about}"
    );
    let names: Vec<&str> = data.channels.iter().map(|channel| channel.name.as_str()).collect();
    assert_eq!(names, ["smcAC", "smcDC", "vib_table", "vib_spindle", "AE_table", "AE_spindle"]);
    // Of scipy: first, second and last of record 3.
    let third =
        read(&sample("mill.mat"), &layout(&[("variable", "mill[3]"), ("rate_hz", "250")])).unwrap();
    for (channel, [first, second, last]) in third.channels.iter().zip([
        [1.046_889_37, 1.099_665_82, 1.071_585_01],
        [1.131_761_25, 0.899_935_56, 0.965_845_49],
        [0.898_671_59, 0.891_484_77, 1.169_091_42],
        [1.265_637_86, 1.170_909_24, 0.959_718_54],
        [0.983_131_86, 1.173_607_22, 0.868_534_48],
        [0.832_575_02, 1.020_138_58, 1.118_383_4],
    ]) {
        assert_eq!(channel.values.len(), 900);
        for (place, known) in [(0, first), (1, second), (899, last)] {
            assert!((channel.values[place] - known).abs() < 5e-9, "{}: {place}", channel.name);
        }
        assert_eq!(channel.times.rate_hz(), Some(250.0));
    }
    for (name, value) in
        [("case", "1"), ("run", "3"), ("VB", "0.2"), ("time", "4"), ("DOC", "1.5"), ("feed", "0.5")]
    {
        assert!(
            third.facts.contains(&(name.to_owned(), value.to_owned())),
            "{name}: {:?}",
            third.facts
        );
    }
    let one = read(&sample("mill.mat"), &layout(&[("variable", "mill(3).vib_table")])).unwrap();
    assert_eq!(one.channels.len(), 1);
    assert_eq!(one.channels[0].values, third.channels[2].values);
    let missing = read(&sample("mill.mat"), &layout(&[("variable", "mill[2]")])).unwrap();
    assert!(missing.facts.contains(&("VB".to_owned(), "NaN".to_owned())));
}

#[test]
fn what_a_matlab_file_does_not_hold_is_told_with_what_it_does() {
    for (variable, parts) in [
        ("mull", ["`mull`: there is no `mull`", "one of mill"]),
        ("mill", ["3 records", "as in mill[1]"]),
        ("mill[4]", ["number 4", "1 to 3"]),
        ("mill[0]", ["number 0", "1 to 3"]),
        ("mill[1].smc", ["there is no `smc`", "smcAC"]),
        ("mill[1].VB", ["1 x 1 numbers", "a vector of numbers"]),
        ("mill.VB", ["3 records", "mill[1]"]),
        ("mill[1].VB.x", ["1 x 1 numbers", "something with a x in it"]),
    ] {
        let error =
            read(&sample("mill.mat"), &layout(&[("variable", variable)])).unwrap_err().to_string();
        for part in parts {
            assert!(error.contains(part), "{variable}: {part}: {error}");
        }
    }
}

#[test]
fn the_challenge_of_2010_has_no_names_and_no_times() {
    let data = guessed(&sample("c1/c_1_001.csv"));
    assert_eq!(data.channels.len(), 7);
    assert!(data.channels.iter().all(|c| c.values.len() == 500 && c.times == SampleTimes::Unknown));
    assert_eq!(data.channels[0].values[..3], [0.346, 3.974, 10.014]);
    assert_eq!(data.channels[0].name, "column 1");
    assert_eq!(
        (entry(&data, "names_line"), entry(&data, "first_line")),
        ("0".to_owned(), "1".to_owned())
    );
    assert_eq!(entry(&data, "time"), "none");
    let said = layout(&[
        ("names", "Fx,Fy,Fz,vx,vy,vz,AE"),
        ("units", "N,N,N,g,g,g,V"),
        ("rate_hz", "50000"),
    ]);
    let named = read(&sample("c1/c_1_002.csv"), &said).unwrap();
    assert_eq!(named.channels[6].title(), "AE [V]");
    assert_eq!(named.channels[3].values[..2], [-0.102, -0.067]);
    assert_eq!(named.channels[3].times.at(50), Some(0.001));
}

#[test]
fn wear_of_three_lines_keeps_its_header() {
    let data = guessed(&sample("c1_wear.csv"));
    let names: Vec<&str> = data.channels.iter().map(|channel| channel.name.as_str()).collect();
    assert_eq!(names, ["cut", "flute_1", "flute_2", "flute_3"]);
    assert_eq!(data.channels[0].values, [1.0, 2.0]);
    assert_eq!(data.channels[3].values, [61.9, 62.4]);
}

#[test]
fn parquet_of_every_kind_of_column_and_compression() {
    for kind in ["snappy", "gzip", "small_pages"] {
        let data = guessed(&sample(&format!("kinds_{kind}.parquet")));
        let of = |name: &str| data.channels.iter().find(|channel| channel.name == name).unwrap();
        assert_eq!(entry(&data, "names"), "t,i,f32,u,b,k", "{kind}");
        assert_eq!(of("u").times, SampleTimes::Even { rate_hz: 100.0, first_s: 0.0 }, "{kind}");
        for row in 0..300 {
            let number = row as f64;
            let whole = of("i").values[row];
            assert_eq!(whole.is_nan(), row % 7 == 0, "{kind} {row}");
            assert!(row % 7 == 0 || whole == number - 5.0, "{kind} {row}: {whole}");
            let known = [number, f64::from(u8::from(row % 2 == 0)), f64::from((row / 100) as u8)];
            assert_eq!(["u", "b", "k"].map(|name| of(name).values[row]), known, "{kind} {row}");
        }
        assert!(of("f32").values.iter().all(|x| f64::from(*x as f32) == *x && x.abs() < 1000.0));
        assert!(
            data.notes.iter().any(|note| note.contains("`s` holds no numbers")),
            "{:?}",
            data.notes
        );
    }
}
