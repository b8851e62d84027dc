//! Files that were cut off or spoilt: read, or refused with a fault; never a panic, and never more memory than a file
//! of its size can have a use for.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use proptest::prelude::*;
use steadycut_measured::layout::DataLayout;
use steadycut_measured::reader::read;

use super::sample;

/// Bytes taken at present, and the most since it was set back.
static TAKEN: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

struct Counting;

// SAFETY: hands all on to the system's allocator.
#[expect(unsafe_code, reason = "an allocator is unsafe by nature")]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let taken = TAKEN.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        MOST.fetch_max(taken, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        TAKEN.fetch_sub(layout.size(), Ordering::Relaxed);
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Most memory that reading one of the samples may take, spoilt or not. All tests of the program share the count.
const MOST_BYTES: usize = 400_000_000;

const SAMPLES: [&str; 9] = [
    "excel.csv",
    "force_v5.mat",
    "mill.mat",
    "lab.tdms",
    "lab.parquet",
    "c1/c_1_001.csv",
    "c1_wear.csv",
    "kinds_snappy.parquet",
    "kinds_gzip.parquet",
];

/// Samples of HDF5: small, so that every byte of them is spoilt.
const HDF5_SAMPLES: [&str; 7] = [
    "h5py.h5",
    "h5py_latest.h5",
    "h5py_dense.h5",
    "h5py_groups.h5",
    "pytables.h5",
    "hdf5storage.mat",
    "hdf5storage_records.mat",
];

/// From place to place where a sample is spoilt: a byte of a text means no more than the next one.
fn stride(name: &str) -> usize {
    if name.ends_with(".csv") { 9 } else { 1 }
}

/// Reads bytes that may be anything.
fn try_read(bytes: &[u8]) {
    match read(bytes, &DataLayout::default()) {
        Ok(data) => assert!(!data.channels.is_empty()),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

#[test]
fn files_that_were_cut_off_anywhere_are_read_or_refused() {
    MOST.store(0, Ordering::Relaxed);
    for name in SAMPLES {
        let bytes = sample(name);
        // Every place in the head, and many behind it.
        let places = (0..bytes.len().min(700))
            .step_by(stride(name))
            .chain((700..bytes.len()).step_by(bytes.len() / 400 + 1));
        for place in places {
            try_read(&bytes[..place]);
        }
    }
    assert!(MOST.load(Ordering::Relaxed) < MOST_BYTES, "{}", MOST.load(Ordering::Relaxed));
}

#[test]
fn files_with_spoilt_bytes_are_read_or_refused() {
    MOST.store(0, Ordering::Relaxed);
    for name in SAMPLES {
        let bytes = sample(name);
        let from_end = bytes.len().saturating_sub(800).max(600);
        let places = (0..bytes.len().min(600))
            .step_by(stride(name))
            .chain((600..bytes.len()).step_by(bytes.len() / 100 + 1))
            .chain((from_end..bytes.len()).step_by(stride(name)));
        for place in places {
            let mut spoilt = bytes.clone();
            spoilt[place] ^= [0xff, 0x80, 0x01][place % 3];
            try_read(&spoilt);
        }
    }
    assert!(MOST.load(Ordering::Relaxed) < MOST_BYTES, "{}", MOST.load(Ordering::Relaxed));
}

#[test]
fn hdf5_that_was_cut_off_anywhere_is_read_or_refused() {
    MOST.store(0, Ordering::Relaxed);
    for name in HDF5_SAMPLES {
        let bytes = sample(name);
        (0..bytes.len()).for_each(|place| try_read(&bytes[..place]));
    }
    assert!(MOST.load(Ordering::Relaxed) < MOST_BYTES, "{}", MOST.load(Ordering::Relaxed));
}

/// Spoils every byte of these samples, one after the other; of zeros among zeros, which the format leaves free, some.
fn spoil_each_byte(samples: &[&str]) {
    MOST.store(0, Ordering::Relaxed);
    for name in samples {
        let mut bytes = sample(name);
        for place in 0..bytes.len() {
            let around = place.saturating_sub(16)..bytes.len().min(place + 17);
            if place % 16 != 0 && bytes[around].iter().all(|byte| *byte == 0) {
                continue;
            }
            let spoilt = [0xff, 0x80, 0x01, 0x10][place % 4];
            bytes[place] ^= spoilt;
            try_read(&bytes);
            bytes[place] ^= spoilt;
        }
    }
    assert!(MOST.load(Ordering::Relaxed) < MOST_BYTES, "{}", MOST.load(Ordering::Relaxed));
}

#[test]
fn hdf5_with_any_byte_spoilt_is_read_or_refused() {
    spoil_each_byte(&HDF5_SAMPLES[..5]);
}

#[test]
fn matlab_7_3_with_any_byte_spoilt_is_read_or_refused() {
    spoil_each_byte(&HDF5_SAMPLES[5..]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_bytes_behind_any_beginning_are_read_or_refused(
        begin in 0usize..6,
        bytes in proptest::collection::vec(any::<u8>(), 0..400),
    ) {
        let mut header = vec![b' '; 124];
        header.extend(b"\0\x01IM\x0e\0\0\0\xff\0\0\0");
        let begins: [&[u8]; 6] = [b"", b"PAR1", b"TDSm\x0e\0\0\0\x68\x12\0\0", b"t;F\n0,5;1\n", b"1 2\n3 4\n", &header];
        let mut file = begins[begin].to_vec();
        file.extend(bytes);
        if begin == 1 {
            file.extend(40u32.to_le_bytes());
            file.extend(b"PAR1");
        }
        try_read(&file);
    }

    #[test]
    fn any_text_is_read_or_refused(text in r"[0-9a,.;\t\n \r'#\[\]N+e-]{0,200}") {
        try_read(text.as_bytes());
    }

    #[test]
    fn many_spoilt_bytes_at_once(
        sample_of in 0usize..16,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..20),
    ) {
        let mut bytes = sample([&SAMPLES[..], &HDF5_SAMPLES].concat()[sample_of]);
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        try_read(&bytes);
    }
}
