//! The console in a web page: start, state for tests, the link kept current, downloads.

use std::cell::RefCell;

use wasm_bindgen::{JsCast, JsValue};

use super::Console;
use crate::run::edits::Edits;
use crate::run::{Start, presets, scenario_link};

thread_local! {
    static STATE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Starts the console on a canvas, with the scenario of the page's link.
///
/// # Errors
/// The browser gives nothing to draw with.
pub async fn start(canvas: web_sys::HtmlCanvasElement) -> Result<(), JsValue> {
    // Set before eframe's own hook, which logs and then calls this one.
    std::panic::set_hook(Box::new(|info| report_panic(&info.to_string())));
    let options = eframe::WebOptions::default();
    let create: eframe::AppCreator<'static> = Box::new(|cc| {
        super::scene::prepare(cc);
        Ok(Box::new(Console::new(&cc.egui_ctx, start_of_link())))
    });
    eframe::WebRunner::new().start(canvas, options, create).await
}

/// Reports to the page, which shows the message and offers to reload.
fn report_panic(message: &str) {
    let Some(window) = web_sys::window() else { return };
    let report = js_sys::Reflect::get(&window, &JsValue::from_str("steadycutPanic"));
    if let Some(report) = report.ok().and_then(|found| found.dyn_into::<js_sys::Function>().ok()) {
        // A page without a listener has no way to show it: the browser's log has it.
        let _ = report.call1(&window, &JsValue::from_str(message));
    }
}

fn start_of_link() -> Start {
    let hash = web_sys::window().and_then(|window| window.location().hash().ok());
    let hash = hash.unwrap_or_default();
    let first = presets::load(presets::PRESETS[0].name).unwrap_or_default();
    if hash.trim_start_matches('#').is_empty() {
        return Start { scenario: first, edits: Edits::none(), notice: None };
    }
    match scenario_link::parse(&hash) {
        Ok((scenario, edits)) => Start { scenario, edits, notice: None },
        Err(error) => {
            let name = first.info.name.clone();
            let notice = format!("The link was not used, {name} is open instead. {error}");
            Start { scenario: first, edits: Edits::none(), notice: Some(notice) }
        }
    }
}

/// The state of the console, for tests: see [`Console::state_json`].
#[must_use]
pub fn state_json() -> String {
    STATE.with_borrow(Clone::clone)
}

/// Keeps the state for [`state_json`].
pub(super) fn publish(state: String) {
    STATE.set(state);
}

/// Puts scenario and edits into the page's address, without a step in its history.
pub(super) fn write_link(fragment: &str) {
    let Some(window) = web_sys::window() else { return };
    if let Ok(history) = window.history() {
        // Refused only where the page is embedded without rights: the console goes on.
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&format!("#{fragment}")));
    }
}

/// The page's address with another fragment.
pub(super) fn address(fragment: &str) -> String {
    let href = web_sys::window().and_then(|window| window.location().href().ok());
    let href = href.unwrap_or_default();
    let page = href.split('#').next().unwrap_or_default();
    format!("{page}#{fragment}")
}

/// Offers a file for download.
pub(super) fn download(name: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document());
    let document = document.ok_or_else(|| JsValue::from_str("no document"))?;
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    let blob = web_sys::Blob::new_with_u8_array_sequence(&parts)?;
    let url = web_sys::Url::create_object_url_with_blob(&blob)?;
    let anchor: web_sys::HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    anchor.set_href(&url);
    anchor.set_download(name);
    anchor.click();
    web_sys::Url::revoke_object_url(&url)
}
