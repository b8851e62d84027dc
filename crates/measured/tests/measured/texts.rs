//! Texts in all encodings, with all separators and decimal signs, with and without heads: written here, read there.

use super::{entry, guessed, layout};
use steadycut_measured::channel::SampleTimes;
use steadycut_measured::layout::{
    DataLayout, DecimalMark, FieldSeparator, TextEncoding, ThousandsMark,
};
use steadycut_measured::reader::read;

/// A text in an encoding, with its mark or without.
fn encoded(text: &str, encoding: TextEncoding, mark: bool) -> Vec<u8> {
    let marked = if mark { format!("\u{feff}{text}") } else { text.to_owned() };
    match encoding {
        TextEncoding::Utf8 => marked.into_bytes(),
        TextEncoding::Utf16Le => marked.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        TextEncoding::Utf16Be => marked.encode_utf16().flat_map(u16::to_be_bytes).collect(),
        TextEncoding::Latin1 => text
            .chars()
            .map(|c| if c == '€' { 0x80 } else { u8::try_from(u32::from(c)).unwrap() })
            .collect(),
    }
}

/// A number with these signs.
fn number(x: f64, decimal: DecimalMark, thousands: ThousandsMark) -> String {
    let text = format!("{x:.3}");
    let (whole, behind) = text.split_once('.').unwrap();
    let (sign, digits) = whole.strip_prefix('-').map_or(("", whole), |digits| ("-", digits));
    let between = match thousands {
        ThousandsMark::None => "",
        ThousandsMark::Point => ".",
        ThousandsMark::Comma => ",",
        ThousandsMark::Blank => "\u{a0}",
        ThousandsMark::Apostrophe => "'",
    };
    let mut grouped = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place) % 3 == 0 {
            grouped.push_str(between);
        }
        grouped.push(digit);
    }
    let decimal = char::from(decimal.byte());
    format!("{sign}{grouped}{decimal}{behind}")
}

fn rows(count: usize) -> Vec<[f64; 3]> {
    (0..count)
        .map(|i| [i as f64 * 0.002, (i as f64 - 3.0) * 1234.5, 987_654.321 - i as f64])
        .collect()
}

/// The heads that files have above their values: lines, and how many there are.
fn heads(separator: &str) -> Vec<(String, [u64; 3])> {
    let names = ["Zeit", "Kräfte Fx", "Öl"].join(separator);
    let units = ["[s]", "[N]", "[µm]"].join(separator);
    let in_names = ["Zeit [s]", "Kräfte Fx (N)", "Öl [µm]"].join(separator);
    let kistler: Vec<String> = (0..17).map(|i| format!("Kopfzeile {i}:\tWert {i}")).collect();
    let kistler = format!("{}\nAbtastrate [Hz]:\t500", kistler.join("\n"));
    vec![
        (format!("{names}\n{units}\n"), [1, 2, 3]),
        (format!("{in_names}\n"), [1, 0, 2]),
        (format!("# {in_names}\n\n"), [1, 0, 3]),
        (format!("{kistler}\n\n{names}\n{units}\n"), [20, 21, 22]),
        (String::new(), [0, 0, 1]),
    ]
}

#[test]
fn every_way_of_writing_is_guessed_and_read_to_the_bit() {
    let separators = [
        (FieldSeparator::Tab, "\t"),
        (FieldSeparator::Semicolon, ";"),
        (FieldSeparator::Comma, ","),
        (FieldSeparator::Blank, "   "),
    ];
    let mut tried = 0;
    for (separator, sign) in separators {
        for decimal in DecimalMark::ALL {
            for thousands in ThousandsMark::ALL {
                let (decimal, thousands) = (*decimal, *thousands);
                let same = char::from(decimal.byte())
                    == number(1e6, decimal, thousands).chars().nth(1).unwrap();
                let parted = decimal == DecimalMark::Comma || thousands == ThousandsMark::Comma;
                let unreadable = same
                    || separator == FieldSeparator::Comma && parted
                    || separator == FieldSeparator::Blank && thousands != ThousandsMark::None;
                if unreadable {
                    continue;
                }
                for (head, lines) in heads(sign) {
                    for count in [1, 2, 3, 40] {
                        // Without a head, three lines at least tell what they are.
                        if head.is_empty() && count < 3 {
                            continue;
                        }
                        let body: Vec<String> = rows(count)
                            .iter()
                            .map(|row| row.map(|x| number(x, decimal, thousands)).join(sign))
                            .collect();
                        let text = format!("{head}{}\n", body.join("\n")).replace('\n', "\r\n");
                        let data = guessed(text.as_bytes());
                        let told = format!(
                            "{separator:?} {decimal:?} {thousands:?} {count}\n{text}\n{:?}",
                            data.layout
                        );
                        let found =
                            ["names_line", "units_line", "first_line"].map(|key| entry(&data, key));
                        assert_eq!(found, lines.map(|x| x.to_string()), "{told}");
                        let columns: Vec<&[f64]> =
                            data.channels.iter().map(|c| c.values.as_slice()).collect();
                        let first = if head.is_empty() && columns.len() == 3 { 0 } else { 1 };
                        for (i, row) in rows(count).iter().enumerate() {
                            let known = row.map(|x| format!("{x:.3}").parse::<f64>().unwrap());
                            let found: Vec<f64> = columns.iter().map(|column| column[i]).collect();
                            assert_eq!(found, known[first..], "{told}");
                        }
                        if !head.is_empty() {
                            assert_eq!(entry(&data, "units"), "s,N,µm", "{told}");
                            assert_eq!(entry(&data, "names"), "Zeit,Kräfte Fx,Öl", "{told}");
                            assert_eq!(entry(&data, "time"), "Zeit", "{told}");
                        }
                        tried += 1;
                    }
                }
            }
        }
    }
    assert!(tried > 150, "{tried}");
}

#[test]
fn every_encoding_is_guessed_or_said() {
    let text = "Größe [s]\tKräfte [N]\tµ\n0,5\t1,5\t2\n0,6\t1,6\t3\n0,7\t1,7\t4\n";
    for encoding in TextEncoding::ALL {
        for mark in [true, false] {
            let bytes = encoded(text, *encoding, mark);
            for data in
                [guessed(&bytes), read(&bytes, &layout(&[("encoding", encoding.id())])).unwrap()]
            {
                assert_eq!(data.layout.encoding, Some(*encoding));
                assert_eq!(entry(&data, "names"), "Größe,Kräfte,µ", "{encoding:?} {mark}");
                assert_eq!(data.channels.last().unwrap().values, [2.0, 3.0, 4.0]);
            }
        }
    }
    let windows = guessed(&encoded("t [s];Preis in €\n0;1\n1;2\n", TextEncoding::Latin1, false));
    assert_eq!(entry(&windows, "names"), "t,Preis in €");
}

#[test]
fn short_files_are_read_as_long_ones_are() {
    for (text, names, values) in [
        ("F\n1\n", "F", vec![1.0]),
        ("t;F\n0,5;1\n", "t,F", vec![1.0]),
        ("F [N]\n1,5\n2,5\n", "F", vec![1.5, 2.5]),
        ("a,b\n1,2\n", "a,b", vec![1.0]),
        ("1 2\n3 4", "column 1,column 2", vec![1.0, 3.0]),
        ("7\n", "column 1", vec![7.0]),
    ] {
        let data = guessed(text.as_bytes());
        assert_eq!(entry(&data, "names"), names, "{text}");
        assert_eq!(data.channels[0].values, values, "{text}");
    }
}

#[test]
fn samples_that_are_missing_stay_missing() {
    let data = guessed(b"t,F,G\n0,1,\n1,NaN,5\n2,-,6\n3,1.#QNAN,7\n");
    let [f, g] = [0, 1].map(|place| &data.channels[place]);
    assert_eq!((f.summary().count, f.summary().missing), (1, 3));
    assert_eq!((g.summary().count, g.summary().missing), (3, 1));
    assert_eq!(data.channels[0].times, SampleTimes::Even { rate_hz: 1.0, first_s: 0.0 });
}

#[test]
fn times_of_day_and_dates_are_seconds_since_the_first() {
    let stamped = "Timestamp;F;G\n2024-02-29 23:59:59,9;1,5;7\n2024-03-01 00:00:00,0;2,5;8\n2024-03-01 00:00:00,1;3,5;9\n";
    let apart =
        "Datum,Zeit,F\n01.03.2024,12:00:00.0,5\n01.03.2024,12:00:00.5,6\n01.03.2024,12:00:01.0,7\n";
    let data = guessed(stamped.as_bytes());
    assert_eq!(entry(&data, "time"), "Timestamp");
    assert_eq!(data.channels[0].values, [1.5, 2.5, 3.5]);
    assert!(
        data.channels[0].times.rate_hz().is_some_and(|rate| (rate - 10.0).abs() < 1e-4),
        "{data:?}"
    );
    let data = guessed(apart.as_bytes());
    assert_eq!(entry(&data, "time"), "Zeit");
    assert_eq!(data.channels.last().unwrap().times.rate_hz(), Some(2.0));
    let more = "01.03.2024,12:00:01.5,8\n01.03.2024,12:00:02.0,8\n";
    let spoilt = apart.replace("12:00:00.5", "12:00:xx") + more;
    let error = read(spoilt.as_bytes(), &DataLayout::default()).unwrap_err().to_string();
    assert!(
        error.contains("line 3, column 2 (Zeit): `12:00:xx`") && error.contains("a time of day"),
        "{error}"
    );
}

#[test]
fn columns_of_words_and_of_nothing_are_left_out_and_told() {
    let text = "Werkzeug;Zeit;F;Status;\nR 216;0,1;5;ok;\nR 216;0,2;6;ok;\nR 216;0,3;7;ok;\n";
    let data = guessed(text.as_bytes());
    assert_eq!(entry(&data, "names"), "Zeit,F");
    assert_eq!(data.channels[0].values, [5.0, 6.0, 7.0]);
    assert_eq!(data.channels[0].times.rate_hz(), Some(10.0));
    let told = data.notes.join("\n");
    assert!(
        told.contains("`Werkzeug` holds no numbers") && told.contains("`Status` holds no numbers"),
        "{told}"
    );
}

#[test]
fn a_recording_that_broke_off_loses_its_last_line_and_says_so() {
    let data = guessed(b"t\tF\n0\t1\n1\t2\n2");
    assert_eq!(data.channels[0].values, [1.0, 2.0]);
    assert!(data.notes[0].contains("line 4 breaks off"), "{:?}", data.notes);
}

#[test]
fn what_a_person_says_counts_more_than_what_is_guessed() {
    let text = b"1,5\n2,5\n3,5\n";
    let guess = guessed(text);
    assert_eq!(guess.channels.len(), 2);
    assert!(
        guess.notes[0].contains("separator=") && guess.notes[0].contains("decimal=comma"),
        "{:?}",
        guess.notes
    );
    let said = read(text, &layout(&[("decimal", "comma")])).unwrap();
    assert_eq!(said.channels[0].values, [1.5, 2.5, 3.5]);
    let text = b"a;b\n9;9\n1;2\n3;4\n";
    let said = read(
        text,
        &layout(&[("first_line", "3"), ("names_line", "1"), ("time", "2"), ("units", "N,ms")]),
    )
    .unwrap();
    assert_eq!(said.channels.len(), 1);
    assert_eq!(said.channels[0].title(), "a [N]");
    assert_eq!(said.channels[0].values, [1.0, 3.0]);
    assert_eq!(said.channels[0].times.at(0), Some(0.002));
    // What was found, said again, gives the same.
    for text in ["t;F\n0,5;1\n0,6;2\n", "# x\nt F\n0.5 1\n0.6 2\n"] {
        let first = guessed(text.as_bytes());
        let mut again = first.layout.clone();
        again.rate_hz = None;
        assert_eq!(read(text.as_bytes(), &again).unwrap().channels, first.channels);
    }
}

#[test]
fn the_sample_rate_of_a_head_is_used_and_can_be_overruled() {
    let text = "File: x\nSampling rate [Hz]: 2000\nFx [N]\tFy [N]\n1\t2\n3\t4\n5\t6\n";
    assert_eq!(guessed(text.as_bytes()).channels[1].times.rate_hz(), Some(2000.0));
    let said = read(text.as_bytes(), &layout(&[("rate_hz", "100")])).unwrap();
    assert_eq!(said.channels[1].times.rate_hz(), Some(100.0));
    assert!(guessed(text.as_bytes()).facts.contains(&("File".to_owned(), "x".to_owned())));
}

#[test]
fn what_is_wrong_is_told_with_line_column_and_what_was_expected() {
    let long: String = (0..400).map(|i| format!("{i},{i}\n")).collect();
    for (text, parts) in [
        (
            "t;F\n0,5;1\n0,6;x\n0,7;3\n0,8;4\n0,9;5\n",
            vec!["line 3, column 2 (F): `x`", "decimal comma"],
        ),
        (
            "t;F\n0,5;1\n0,6;1.5\n0,7;3\n0,8;4\n0,9;5\n",
            vec!["line 3, column 2 (F): `1.5`", "decimal comma"],
        ),
        (
            "t;F\n0,5;1\n0,6;1;2\n0,7;3\n0,8;4\n0,9;5\n",
            vec!["line 3: the value `2`", "no more than 2 values"],
        ),
        (
            "t;F\n0,5;1\n0,6\n0,7;3\n0,8;4\n0,9;5\n",
            vec!["line 3: 1 values", "expected is 2 values"],
        ),
        ("0,5;1\nx;2\n0,7;3\n0,8;4\n0,9;5\n0,9;5\n", vec!["line 2, column 1 (column 1): `x`"]),
        (
            &long.replace("300,300", "300,***"),
            vec!["line 301, column 2 (column 2): `***`", "decimal point"],
        ),
        ("nothing\nhere\n", vec!["line 1: no line with numbers", "`nothing`"]),
        ("\n\n", vec!["the text ends after 2 lines"]),
        ("", vec!["the file is empty"]),
        ("a\u{1}b", vec!["byte 1: byte 0x01 stands in no text"]),
    ] {
        let error = read(text.as_bytes(), &DataLayout::default()).unwrap_err().to_string();
        for part in parts {
            assert!(error.contains(part), "{part}: {error}");
        }
    }
    for (entries, parts) in [
        (&[("first_line", "9")][..], ["the text ends after 4 lines", ""]),
        (&[("names_line", "3"), ("first_line", "2")], ["`names_line` is 3", "begin in line 2"]),
        (&[("names", "a,b,c")], ["`names` has 3 entries", "2 columns: t, F"]),
        (&[("time", "x")], ["there is no column `x`", "t, F"]),
        (&[("time", "3")], ["there is no column `3`", "t, F"]),
        (&[("variable", "F")], ["`variable` means nothing", "text"]),
        (&[("separator", "tab")], ["no line with numbers", "tabs, semicolons"]),
        (&[("encoding", "utf-16le")], ["", "UTF-16"]),
    ] {
        let error = read(b"t;F\n0,5;1\n0,6;2\n0,7;3", &layout(entries)).unwrap_err().to_string();
        for part in parts {
            assert!(error.contains(part), "{entries:?}: {part}: {error}");
        }
    }
    let tdms =
        read(&super::sample("lab.tdms"), &layout(&[("decimal", "comma")])).unwrap_err().to_string();
    assert!(tdms.contains("`decimal` means nothing for a file of the format TDMS"), "{tdms}");
}
