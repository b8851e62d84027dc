//! Whether pictures can be compared here: only a software adapter draws the same everywhere.

use std::task::{Context, Poll, Waker};

use eframe::egui_wgpu::wgpu;

/// The adapter that pictures are drawn with: its name, and whether it is software.
fn adapter() -> Option<(String, bool)> {
    let setup = egui_kittest::wgpu::default_wgpu_setup();
    let eframe::egui_wgpu::WgpuSetup::CreateNew(setup) = setup else { return None };
    let instance = wgpu::Instance::new(setup.instance_descriptor);
    let mut adapters = std::pin::pin!(instance.enumerate_adapters(wgpu::Backends::all()));
    // On the desktop the answer is there at once.
    let Poll::Ready(adapters) = adapters.as_mut().poll(&mut Context::from_waker(Waker::noop()))
    else {
        return None;
    };
    let mut found: Vec<(String, bool)> = adapters
        .iter()
        .map(|adapter| adapter.get_info())
        .map(|info| (info.name, info.device_type == wgpu::DeviceType::Cpu))
        .collect();
    found.sort_by_key(|(_, software)| !software);
    found.into_iter().next()
}

/// Whether there is one in software; if not, says what is missing, and fails in CI.
pub fn in_software() -> bool {
    let problem = match adapter() {
        Some((_, true)) => return true,
        Some((name, false)) => format!("pictures are compared in software only, this is {name}"),
        None => "no graphics adapter: install a Vulkan driver (Debian: mesa-vulkan-drivers)".into(),
    };
    assert!(std::env::var_os("CI").is_none(), "{problem}");
    eprintln!("skipped: {problem}");
    false
}
