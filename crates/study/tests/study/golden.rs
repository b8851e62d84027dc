//! Golden digests: the bits of every preset, here and (through `web/test`) in wasm.

use steadycut_study::golden;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden.json");

#[test]
fn every_preset_has_its_golden_digest() {
    let now = golden::to_json();
    if std::env::var_os("STEADYCUT_WRITE_GOLDEN").is_some() {
        std::fs::write(FILE, &now).unwrap();
    }
    let golden = std::fs::read_to_string(FILE).unwrap();
    assert_eq!(now, golden, "write it anew with STEADYCUT_WRITE_GOLDEN=1 if the change is meant");
}
