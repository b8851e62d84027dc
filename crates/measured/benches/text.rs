//! Speed of reading a text, layout and all, against a bare pass of the `csv` crate over the same bytes that parses
//! every field as a number and keeps it: a million rows of time and three forces, as spreadsheets of two countries
//! write them, and as instruments do, with tabs.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use steadycut_measured::layout::DataLayout;
use steadycut_measured::reader::read;

const ROWS: usize = 1_000_000;

/// Separator, decimal sign and name of a file.
const WAYS: [(&str, u8, char); 3] =
    [("commas", b',', '.'), ("decimal commas", b';', ','), ("tabs", b'\t', '.')];

/// A file: name and unit of four columns, and rows of 6 decimals.
fn file(separator: u8, decimal: char) -> Vec<u8> {
    let separator = char::from(separator);
    let mut text = ["time [s]", "Fx [N]", "Fy [N]", "Fz [N]\n"].join(&separator.to_string());
    for row in 0..ROWS {
        let time_s = row as f64 / 25_000.0;
        // Digits that look like those of a measurement, by a linear congruence.
        let noise = |k: usize| ((row * 7919 + k * 104_729) % 1_000_003) as f64 / 1_000_003.0 - 0.5;
        let forces = [200.0, 80.0, 30.0].map(|size| size * noise(size as usize));
        let line = format!("{time_s:.6}|{:.6}|{:.6}|{:.6}\n", forces[0], forces[1], forces[2]);
        text.push_str(
            &line.replace('.', &decimal.to_string()).replace('|', &separator.to_string()),
        );
    }
    text.into_bytes()
}

/// A pass of the `csv` crate with the usual parse of every field.
fn bare(bytes: &[u8], separator: u8, decimal: char) -> [Vec<f64>; 4] {
    let mut reader = csv::ReaderBuilder::new().delimiter(separator).from_reader(bytes);
    let mut columns = [const { Vec::new() }; 4];
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).expect("a sound file") {
        for (column, field) in columns.iter_mut().zip(&record) {
            let value: f64 = match decimal {
                ',' => field.replace(',', ".").parse().expect("a number"),
                _ => field.parse().expect("a number"),
            };
            column.push(value);
        }
    }
    columns
}

/// Best of alternating runs: the ratio that the project promises, and fails without.
#[expect(clippy::disallowed_methods, reason = "a bench needs a clock")]
fn ratio() {
    const LIMIT: f64 = 1.5;
    for (name, separator, decimal) in WAYS {
        let bytes = file(separator, decimal);
        let columns = bare(&bytes, separator, decimal);
        let data = read(&bytes, &DataLayout::default()).expect("a sound file");
        for (channel, column) in data.channels.iter().zip(&columns[1..]) {
            assert_eq!(channel.values, *column, "{name}: the same bits");
        }
        let (mut pass, mut whole) = (f64::INFINITY, f64::INFINITY);
        for run in 0..30 {
            if run >= 5 && whole <= LIMIT * pass {
                break;
            }
            let start = std::time::Instant::now();
            black_box(bare(black_box(&bytes), separator, decimal));
            let middle = std::time::Instant::now();
            black_box(read(black_box(&bytes), &DataLayout::default()).expect("a sound file"));
            pass = pass.min((middle - start).as_secs_f64());
            whole = whole.min(middle.elapsed().as_secs_f64());
        }
        let ratio = whole / pass;
        println!(
            "{name}: {ROWS} rows in {:.1} MB, read in {:.0} ms, a bare pass {:.0} ms, ratio {ratio:.3} (limit {LIMIT})",
            bytes.len() as f64 * 1e-6,
            whole * 1e3,
            pass * 1e3
        );
        assert!(ratio <= LIMIT, "{name}: reading costs {ratio:.3} times a bare pass");
    }
}

fn texts(criterion: &mut Criterion) {
    ratio();
    let mut group = criterion.benchmark_group("text");
    group.sample_size(10);
    for (name, separator, decimal) in WAYS {
        let bytes = file(separator, decimal);
        group.throughput(Throughput::Bytes(bytes.len() as u64));
        group.bench_function(format!("{name}: bare pass"), |bencher| {
            bencher.iter(|| bare(&bytes, separator, decimal));
        });
        group.bench_function(format!("{name}: read"), |bencher| {
            bencher.iter(|| read(&bytes, &DataLayout::default()).expect("a sound file"));
        });
    }
    group.finish();
}

criterion_group!(benches, texts);
criterion_main!(benches);
