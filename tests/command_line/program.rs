//! The program as its user starts it.

use std::path::PathBuf;
use std::process::{Command, Output};

/// The program with these arguments, to its end.
pub fn steadycut(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_steadycut")).args(args).output().unwrap()
}

/// The JSON that it prints; it must succeed.
pub fn json(args: &[&str]) -> serde_json::Value {
    let output = steadycut(args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// What it says where it must fail; it then prints nothing else.
pub fn refused(args: &[&str]) -> String {
    let output = steadycut(args);
    assert!(!output.status.success(), "{args:?} must fail");
    assert!(output.stdout.is_empty() || args[0] == "check", "{args:?}");
    String::from_utf8(output.stderr).unwrap() + String::from_utf8(output.stdout).unwrap().as_str()
}

/// A file in the tests' own folder.
pub fn temporary(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}
