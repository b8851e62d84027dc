//! MATLAB and TDMS files written here byte by byte, after the formats' descriptions: what no sample has.

use super::{entry, guessed, layout};
use steadycut_measured::channel::SampleTimes;
use steadycut_measured::layout::DataLayout;
use steadycut_measured::reader::{MeasuredData, read};

/// Writes MATLAB v5, in either order of bytes.
#[derive(Clone, Copy)]
struct Mat {
    big: bool,
}

impl Mat {
    fn u32(self, x: u32) -> [u8; 4] {
        if self.big { x.to_be_bytes() } else { x.to_le_bytes() }
    }

    fn element(self, kind: u32, data: &[u8]) -> Vec<u8> {
        let mut bytes = [self.u32(kind), self.u32(data.len() as u32)].concat();
        bytes.extend(data);
        bytes.resize(bytes.len().next_multiple_of(8), 0);
        bytes
    }

    /// An element of at most four bytes.
    fn small(self, kind: u32, data: &[u8]) -> Vec<u8> {
        let mut bytes = self.u32((data.len() as u32) << 16 | kind).to_vec();
        bytes.extend(data);
        bytes.resize(8, 0);
        bytes
    }

    fn matrix(self, class: u32, dims: &[u32], name: &str, parts: &[Vec<u8>]) -> Vec<u8> {
        let flags = [self.u32(class), self.u32(0)].concat();
        let sizes: Vec<u8> = dims.iter().flat_map(|x| self.u32(*x)).collect();
        let mut inside = [self.element(6, &flags), self.element(5, &sizes)].concat();
        inside.extend(self.element(1, name.as_bytes()));
        parts.iter().for_each(|part| inside.extend(part));
        self.element(14, &inside)
    }

    fn doubles(self, dims: &[u32], name: &str, values: &[f64]) -> Vec<u8> {
        let bytes = |x: &f64| if self.big { x.to_be_bytes() } else { x.to_le_bytes() };
        let data: Vec<u8> = values.iter().flat_map(bytes).collect();
        self.matrix(6, dims, name, &[self.element(9, &data)])
    }

    fn text(self, name: &str, text: &str) -> Vec<u8> {
        let unit = |x: u16| if self.big { x.to_be_bytes() } else { x.to_le_bytes() };
        let data: Vec<u8> = text.encode_utf16().flat_map(unit).collect();
        self.matrix(4, &[1, text.chars().count() as u32], name, &[self.element(17, &data)])
    }

    fn cells(self, name: &str, cells: &[Vec<u8>]) -> Vec<u8> {
        self.matrix(1, &[1, cells.len() as u32], name, cells)
    }

    /// Records; the values record by record.
    fn records(self, name: &str, count: u32, fields: &[&str], values: &[Vec<u8>]) -> Vec<u8> {
        let mut names = Vec::new();
        for field in fields {
            let mut name = field.as_bytes().to_vec();
            name.resize(16, 0);
            names.extend(name);
        }
        let mut parts = vec![self.small(5, &self.u32(16)), self.element(1, &names)];
        parts.extend(values.iter().cloned());
        self.matrix(2, &[1, count], name, &parts)
    }

    fn file(self, variables: &[Vec<u8>]) -> Vec<u8> {
        let mut bytes = b"MATLAB 5.0 MAT-file, written by a test".to_vec();
        bytes.resize(124, b' ');
        bytes.extend(if self.big { b"\x01\0MI" } else { b"\0\x01IM" });
        variables.iter().for_each(|variable| bytes.extend(variable));
        bytes
    }
}

const BOTH: [Mat; 2] = [Mat { big: false }, Mat { big: true }];

#[test]
fn matlabs_types_in_both_orders_of_bytes() {
    for mat in BOTH {
        let whole =
            |class, kind, data: &[u8]| mat.matrix(class, &[1, 3], "x", &[mat.element(kind, data)]);
        let order = |little: &[u8]| {
            if mat.big { little.iter().rev().copied().collect() } else { little.to_vec() }
        };
        let three = |one: &dyn Fn(i16) -> Vec<u8>| {
            [-1, 0, 5].into_iter().flat_map(one).collect::<Vec<u8>>()
        };
        for (class, kind, data) in [
            (8, 1, three(&|x| vec![x as i8 as u8])),
            (10, 3, three(&|x| order(&x.to_le_bytes()))),
            (12, 5, three(&|x| order(&i32::from(x).to_le_bytes()))),
            (14, 12, three(&|x| order(&i64::from(x).to_le_bytes()))),
            (7, 7, three(&|x| order(&f32::from(x).to_le_bytes()))),
            // Doubles that MATLAB has stored as smaller whole numbers.
            (6, 3, three(&|x| order(&x.to_le_bytes()))),
        ] {
            let data = guessed(&mat.file(&[whole(class, kind, &data)]));
            assert_eq!(data.channels[0].values, [-1.0, 0.0, 5.0], "class {class}, big {}", mat.big);
        }
        let bytes = mat.matrix(9, &[1, 3], "x", &[mat.small(2, &[255, 0, 7])]);
        assert_eq!(guessed(&mat.file(&[bytes])).channels[0].values, [255.0, 0.0, 7.0]);
    }
}

#[test]
fn structures_in_structures_with_cells_texts_and_what_tells_of_them() {
    for mat in BOTH {
        let inner = mat.records(
            "",
            1,
            &["force", "note"],
            &[mat.doubles(&[4, 1], "", &[1.0, 2.0, 3.0, 4.0]), mat.text("", "Öl")],
        );
        let outer = mat.records(
            "run",
            1,
            &["dt", "data", "empty"],
            &[mat.doubles(&[1, 1], "", &[0.001]), inner, mat.element(14, &[])],
        );
        let data = guessed(&mat.file(&[outer, mat.text("operator", "none")]));
        assert_eq!(entry(&data, "variable"), "run");
        assert_eq!(data.channels[0].name, "data.force");
        assert_eq!(data.channels[0].times, SampleTimes::Even { rate_hz: 1000.0, first_s: 0.0 });
        for (name, value) in [("dt", "0.001"), ("data.note", "Öl"), ("operator", "none")] {
            assert!(
                data.facts.contains(&(name.to_owned(), value.to_owned())),
                "{name}: {:?}",
                data.facts
            );
        }
        let two = mat.records(
            "r",
            2,
            &["x"],
            &[
                mat.cells(
                    "",
                    &[mat.doubles(&[1, 2], "", &[1.0, 2.0]), mat.doubles(&[1, 2], "", &[3.0, 4.0])],
                ),
                mat.doubles(&[1, 3], "", &[5.0, 6.0, 7.0]),
            ],
        );
        let file = mat.file(&[two]);
        assert_eq!(entry(&guessed(&file), "variable"), "r[2]");
        let cell = read(&file, &layout(&[("variable", "r[1].x{2}")])).unwrap();
        assert_eq!(cell.channels[0].values, [3.0, 4.0]);
        let none = read(&file, &layout(&[("variable", "r[1].x")])).unwrap_err().to_string();
        assert!(none.contains("2 cells") && none.contains("numbers or a record"), "{none}");
    }
}

#[test]
fn a_matrix_has_a_channel_in_every_column_or_row() {
    let mat = BOTH[0];
    let names = mat.cells("channel_names", &[mat.text("", "Fx"), mat.text("", "Fy")]);
    let units = mat.cells("units", &[mat.text("", "N"), mat.text("", "kN")]);
    let long = mat.doubles(&[3, 2], "data", &[1.0, 2.0, 3.0, 10.0, 20.0, 30.0]);
    let wide = mat.doubles(&[2, 3], "data", &[1.0, 10.0, 2.0, 20.0, 3.0, 30.0]);
    for matrix in [long, wide] {
        let data = guessed(&mat.file(&[
            matrix,
            names.clone(),
            units.clone(),
            mat.doubles(&[1, 1], "Fs", &[50.0]),
        ]));
        let titles: Vec<String> = data.channels.iter().map(|channel| channel.title()).collect();
        assert_eq!(titles, ["Fx [N]", "Fy [kN]"]);
        assert_eq!(data.channels[0].values, [1.0, 2.0, 3.0]);
        assert_eq!(data.channels[1].values, [10.0, 20.0, 30.0]);
        assert_eq!(data.channels[1].times.rate_hz(), Some(50.0));
    }
    let times = mat.doubles(&[1, 3], "t", &[0.0, 0.5, 1.0]);
    let forces = mat.doubles(&[3, 2], "F", &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    let data = guessed(&mat.file(&[times, forces, names, units]));
    let titles: Vec<String> = data.channels.iter().map(|channel| channel.title()).collect();
    assert_eq!(titles, ["Fx [N]", "Fy [kN]"]);
    assert_eq!(data.channels[0].times.rate_hz(), Some(2.0));
    let cube = mat.doubles(&[2, 2, 2], "cube", &[0.0; 8]);
    let data = guessed(&mat.file(&[cube, mat.doubles(&[2, 1], "x", &[1.0, 2.0])]));
    assert!(data.notes[0].contains("`cube` was left out: 2 x 2 x 2 numbers"), "{:?}", data.notes);
}

#[test]
fn complex_numbers_are_said_and_refused() {
    let mat = BOTH[0];
    let part = mat.element(9, &[0; 16]);
    let complex = mat.matrix(6 | 0x800, &[2, 1], "h", &[part.clone(), part]);
    let file = mat.file(&[complex, mat.doubles(&[2, 1], "x", &[1.0, 2.0])]);
    let data = guessed(&file);
    assert_eq!(data.channels.len(), 1);
    assert!(data.notes[0].contains("`h` was left out: 2 x 1 complex numbers"), "{:?}", data.notes);
    let error = read(&file, &layout(&[("variable", "h")])).unwrap_err().to_string();
    assert!(error.contains("complex") && error.contains("real numbers"), "{error}");
}

#[test]
fn a_matlab_file_without_vectors_says_what_it_has() {
    let mat = BOTH[0];
    let file = mat.file(&[mat.text("title", "x"), mat.doubles(&[1, 1], "n", &[1.0])]);
    let error = read(&file, &DataLayout::default()).unwrap_err().to_string();
    assert!(error.contains("title: the text `x`; n: 1 x 1 numbers"), "{error}");
    let error = read(&mat.file(&[]), &DataLayout::default()).unwrap_err().to_string();
    assert!(error.contains("no variables"), "{error}");
    // More values than bytes.
    let claims =
        mat.file(&[mat.matrix(6, &[0x7fff_ffff, 0x7fff_ffff], "x", &[mat.element(9, &[0; 8])])]);
    let error = read(&claims, &DataLayout::default()).unwrap_err().to_string();
    assert!(error.contains("2147483647 x 2147483647 values"), "{error}");
}

/// A segment of a TDMS file.
fn segment(contents: u32, meta: &[u8], raw: &[u8]) -> Vec<u8> {
    let mut bytes = b"TDSm".to_vec();
    bytes.extend(contents.to_le_bytes());
    bytes.extend(4713u32.to_le_bytes());
    bytes.extend(((meta.len() + raw.len()) as u64).to_le_bytes());
    bytes.extend((meta.len() as u64).to_le_bytes());
    bytes.extend(meta);
    bytes.extend(raw);
    bytes
}

fn string(text: &str) -> Vec<u8> {
    [&(text.len() as u32).to_le_bytes()[..], text.as_bytes()].concat()
}

/// What a segment says of an object: how its values are stored, and its properties as they stand in the file.
fn object(path: &str, index: Option<(u32, u64)>, properties: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = string(path);
    match index {
        None => bytes.extend(u32::MAX.to_le_bytes()),
        Some((kind, count)) => {
            bytes.extend(20u32.to_le_bytes());
            bytes.extend(kind.to_le_bytes());
            bytes.extend(1u32.to_le_bytes());
            bytes.extend(count.to_le_bytes());
        }
    }
    bytes.extend((properties.len() as u32).to_le_bytes());
    properties.iter().for_each(|property| bytes.extend(property));
    bytes
}

fn real(name: &str, x: f64) -> Vec<u8> {
    [string(name), 10u32.to_le_bytes().to_vec(), x.to_le_bytes().to_vec()].concat()
}

fn words(name: &str, text: &str) -> Vec<u8> {
    [string(name), 0x20u32.to_le_bytes().to_vec(), string(text)].concat()
}

fn tdms(bytes: &[u8]) -> MeasuredData {
    guessed(bytes)
}

#[test]
fn tdms_channels_have_rates_of_their_own_and_go_on_in_the_next_segment() {
    let count = |n: u32| n.to_le_bytes().to_vec();
    let meta = [
        count(3),
        object("/'A'", None, &[words("note", "first")]),
        object(
            "/'A'/'F''x'",
            Some((2, 2)),
            &[real("wf_increment", 0.001), words("unit_string", "N")],
        ),
        object(
            "/'B'/'T'",
            Some((9, 1)),
            &[real("wf_increment", 0.5), real("wf_start_offset", 2.0)],
        ),
    ]
    .concat();
    let raw = |a: [i16; 2], b: f32| {
        [&a[0].to_le_bytes()[..], &a[1].to_le_bytes(), &b.to_le_bytes()].concat()
    };
    // Two chunks in the first segment; the second one goes on without a word.
    let first = segment(2 | 4 | 8, &meta, &[raw([-1, 2], 0.5), raw([3, 4], 1.5)].concat());
    let second = segment(8, &[], &raw([5, 6], 2.5));
    let data = tdms(&[first.clone(), second].concat());
    let [force, temperature] = [&data.channels[0], &data.channels[1]];
    assert_eq!((force.title(), temperature.title()), ("A/F'x [N]".to_owned(), "B/T".to_owned()));
    assert_eq!(force.values, [-1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(temperature.values, [0.5, 1.5, 2.5]);
    assert_eq!(force.times, SampleTimes::Even { rate_hz: 1000.0, first_s: 0.0 });
    assert_eq!(temperature.times, SampleTimes::Even { rate_hz: 2.0, first_s: 2.0 });
    assert!(data.facts.contains(&("A/note".to_owned(), "first".to_owned())));
    let one = read(&first, &layout(&[("variable", "B/T")])).unwrap();
    assert_eq!(one.channels.len(), 1);
    let error = read(&first, &layout(&[("variable", "C")])).unwrap_err().to_string();
    assert!(error.contains("there is no `C`") && error.contains("A/F'x, B/T"), "{error}");
    // A chunk that was cut off: what is whole of it counts.
    let cut = segment(2 | 4 | 8, &meta, &raw([7, 8], 0.5)[..3]);
    assert_eq!(tdms(&cut).channels[0].values, [7.0]);
}

#[test]
fn tdms_values_in_turn_scaled_and_of_times() {
    let count = |n: u32| n.to_le_bytes().to_vec();
    let scale = [
        [string("NI_Number_Of_Scales"), 3u32.to_le_bytes().to_vec(), count(1)].concat(),
        words("NI_Scale[0]_Scale_Type", "Linear"),
        real("NI_Scale[0]_Linear_Slope", 2.0),
        real("NI_Scale[0]_Linear_Y_Intercept", 10.0),
    ];
    let meta = [
        count(2),
        object("/'G'/'t'", Some((0x44, 3)), &[]),
        object("/'G'/'F'", Some((1, 3)), &scale),
    ]
    .concat();
    let time = |half_seconds: u64| {
        let fraction = if half_seconds % 2 == 1 { 1u64 << 63 } else { 0 };
        [fraction.to_le_bytes(), (3_850_000_000 + half_seconds / 2).to_le_bytes()].concat()
    };
    let raw: Vec<u8> = [(0, 0), (1, 1), (2, 255)]
        .iter()
        .flat_map(|(t, x)| [time(*t), vec![*x]].concat())
        .collect();
    let data = tdms(&segment(2 | 4 | 8 | 32, &meta, &raw));
    assert_eq!(data.channels.len(), 1);
    assert_eq!(data.channels[0].values, [10.0, 12.0, 8.0]);
    assert_eq!(data.channels[0].times, SampleTimes::Even { rate_hz: 2.0, first_s: 0.0 });
}

#[test]
fn daqmx_and_what_is_no_segment_are_named() {
    let count = |n: u32| n.to_le_bytes().to_vec();
    let daqmx = [count(1), string("/'G'/'F'"), 0x1269u32.to_le_bytes().to_vec()].concat();
    for (bytes, part) in [
        (segment(2 | 4 | 8, &daqmx, &[0; 8]), "raw values of DAQmx"),
        (
            [segment(8, &[], &[]), b"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxx".to_vec()].concat(),
            "begins with `TDSm`",
        ),
        (segment(2, &count(u32::MAX), &[]), "the file ends"),
        (b"TDSh....".to_vec(), "index of a TDMS file"),
        (b"PK\x03\x04".to_vec(), "spreadsheet"),
        (b"\x89HDF\r\n\x1a\n....".to_vec(), "version 46 of HDF5"),
    ] {
        let error = read(&bytes, &DataLayout::default()).unwrap_err().to_string();
        assert!(error.contains(part), "{part}: {error}");
    }
}
