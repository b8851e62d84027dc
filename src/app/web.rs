//! The console in a web page: start, state for tests, the link kept current, downloads.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;

use wasm_bindgen::{JsCast, JsValue};

use super::Console;
use super::library::{LocalSlots, PageShelf};
use super::mirror::{Changes, Mirror};
use super::remembered::{PageStorage, Remembered};
use crate::base::language::Language;
use crate::study::opening::{Opening, page_to_share};

thread_local! {
    static SHOWN: RefCell<Option<Shown>> = const { RefCell::new(None) };
    static TAB_LEAVES: Cell<bool> = const { Cell::new(false) };
    static MIRRORED: Cell<bool> = const { Cell::new(false) };
}

/// What is on the page. The console is kept apart from eframe's runner, so that it outlives the
/// graphics that the runner has.
struct Shown {
    runner: eframe::WebRunner,
    ctx: egui::Context,
    console: Rc<RefCell<Console>>,
}

/// The console as eframe sees it.
struct Page(Rc<RefCell<Console>>);

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let mut console = self.0.borrow_mut();
        console.ui(ui);
        show_digits(ui.ctx());
        TAB_LEAVES.set(console.tab_leaves());
    }
}

/// Asks a phone for the digits alone while a number is typed: eframe has one field for all texts.
fn show_digits(ctx: &egui::Context) {
    thread_local! {
        static NOW: Cell<&str> = const { Cell::new("text") };
    }
    let wanted = if super::widgets::number::is_typed(ctx) { "decimal" } else { "text" };
    if NOW.replace(wanted) == wanted {
        return;
    }
    let document = web_sys::window().and_then(|window| window.document());
    let field =
        document.and_then(|document| document.query_selector("body > input").ok().flatten());
    if let Some(field) = field {
        // A page that refuses it keeps the keyboard of letters.
        let _ = field.set_attribute("inputmode", wanted);
    }
}

/// Whether the person has asked the system for less motion.
fn is_less_motion_wanted() -> bool {
    let asked = web_sys::window()
        .and_then(|window| window.match_media("(prefers-reduced-motion: reduce)").ok().flatten());
    asked.is_some_and(|asked| asked.matches())
}

/// Tells the browser, and screen readers by it, which language the page is in now.
pub fn speaks(language: Language) {
    let page = web_sys::window().and_then(|window| window.document()?.document_element());
    if let Some(page) = page {
        // Refused nowhere; the page would only be read aloud in the language it began in.
        let _ = page.set_attribute("lang", language.id());
    }
}

/// Shows the console on a canvas: at first with the scenario of the page's link, after [`stop`] as it was.
///
/// # Errors
/// The browser gives nothing to draw with.
pub async fn start(canvas: web_sys::HtmlCanvasElement) -> Result<(), JsValue> {
    let runner = eframe::WebRunner::new();
    // Eframe's own hook only logs, and would come after this one.
    std::panic::set_hook(Box::new(|info| tell_page("steadycutPanic", &info.to_string())));
    let options = eframe::WebOptions::default();
    let create: eframe::AppCreator<'static> = Box::new({
        let runner = runner.clone();
        move |cc| {
            let ctx = cc.egui_ctx.clone();
            let console = match SHOWN.take() {
                Some(before) => {
                    // What is open, scrolled and chosen, the theme too.
                    let memory = before.ctx.memory(Clone::clone);
                    ctx.memory_mut(|now| *now = memory);
                    super::theme::install(&ctx);
                    before.console
                }
                None => {
                    let mut console = Console::opened(&ctx, Opening::of_link(&href()));
                    console.remember(Remembered::of(Box::new(PageStorage)));
                    console.keep_files(Arc::new(PageShelf(LocalSlots)));
                    console.speak_as_asked(sys_locale::get_locales());
                    Rc::new(RefCell::new(console))
                }
            };
            if is_less_motion_wanted() || super::theme::is_still(&ctx) {
                super::theme::set_still(&ctx, true);
            }
            super::scene::prepare(cc);
            if let Some(state) = &cc.wgpu_render_state {
                tell_of_loss(&state.device);
            }
            SHOWN.set(Some(Shown { runner, ctx, console: console.clone() }));
            mirror(MIRRORED.get());
            Ok(Box::new(Page(console)))
        }
    });
    runner.start(canvas, options, create).await
}

/// One plot of one line that moves, for measuring what drawing alone costs on a page.
struct Bare;

impl eframe::App for Bare {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        use crate::base::math::sin;
        let time_s = ui.input(|input| input.time);
        let points = (0..800).map(|i| f64::from(i) * 0.02).map(|x| [x, sin(x + time_s)]);
        let line = egui_plot::Line::new("sine", points.collect::<egui_plot::PlotPoints<'_>>());
        egui::CentralPanel::default().show(ui, |ui| {
            egui_plot::Plot::new("bare").show(ui, |plot| plot.line(line));
        });
        ui.ctx().request_repaint();
    }
}

/// Shows one plot on a canvas instead of the console.
///
/// # Errors
/// The browser gives nothing to draw with.
pub async fn start_bare(canvas: web_sys::HtmlCanvasElement) -> Result<(), JsValue> {
    let options = eframe::WebOptions::default();
    let create: eframe::AppCreator<'static> = Box::new(|_| Ok(Box::new(Bare)));
    eframe::WebRunner::new().start(canvas, options, create).await
}

/// Takes the console off its canvas, whose graphics are lost; the next [`start`] shows it again.
pub fn stop() {
    SHOWN.with_borrow(|shown| {
        if let Some(shown) = shown {
            shown.runner.destroy();
        }
    });
}

/// A WebGPU device that is lost tells nobody but those who asked; WebGL tells the canvas.
fn tell_of_loss(device: &eframe::wgpu::Device) {
    device.set_device_lost_callback(|reason, message| match reason {
        eframe::wgpu::DeviceLostReason::Unknown => tell_page("steadycutGraphicsLost", &message),
        eframe::wgpu::DeviceLostReason::Destroyed => {}
    });
}

/// Calls a function of the page: it shows what it is told and offers a way on.
pub(super) fn tell_page(listener: &str, message: &str) {
    let Some(window) = web_sys::window() else { return };
    let listener = js_sys::Reflect::get(&window, &JsValue::from_str(listener));
    if let Some(listener) =
        listener.ok().and_then(|found| found.dyn_into::<js_sys::Function>().ok())
    {
        // A page without a listener has no way to show it: the browser's log has it.
        let _ = listener.call1(&window, &JsValue::from_str(message));
    }
}

/// The page's address.
fn href() -> String {
    let href = web_sys::window().and_then(|window| window.location().href().ok());
    href.unwrap_or_default()
}

/// Whether a link that was pasted into the open page is not followed: then the address is as before again. See
/// [`Console::keeps_its_address`].
#[must_use]
pub fn keeps_address() -> bool {
    SHOWN.with_borrow(|shown| {
        let Some(shown) = shown else { return false };
        let Ok(mut console) = shown.console.try_borrow_mut() else { return false };
        let keeps = console.keeps_its_address();
        if keeps {
            write_link(&console.fragment());
            shown.ctx.request_repaint();
        }
        keeps
    })
}

/// The state of the console, for tests: see [`Console::state_json`].
#[must_use]
pub fn state_json() -> String {
    // Written when it is asked for: a frame has no use for it.
    SHOWN.with_borrow(|shown| {
        let console = shown.as_ref().and_then(|shown| shown.console.try_borrow().ok());
        console.map_or_else(String::new, |console| console.state_json())
    })
}

/// Whether the next Tab belongs to the browser: see [`Console::tab_leaves`].
#[must_use]
pub fn tab_leaves() -> bool {
    TAB_LEAVES.get()
}

/// Makes the elements of the page that screen readers know, or no more: the page's `steadycutMirror` is called with
/// [`Changes`] as JSON.
pub fn mirror(on: bool) {
    MIRRORED.set(on);
    SHOWN.with_borrow(|shown| {
        let Some(Shown { ctx, .. }) = shown else { return };
        if on {
            if ctx.plugin_opt::<Mirror>().is_none() {
                ctx.add_plugin(Mirror::new(tell_changes));
            }
            ctx.plugin::<Mirror>().lock().forget();
            ctx.enable_accesskit();
        } else {
            ctx.disable_accesskit();
        }
        ctx.request_repaint();
    });
}

fn tell_changes(changes: &Changes) {
    if let Ok(text) = serde_json::to_string(changes) {
        tell_page("steadycutMirror", &text);
    }
}

/// Does with an element of the page what a person did: a [`Deed`](super::mirror::Deed) as JSON.
///
/// # Errors
/// What is wrong with it, in words for the person.
pub fn act(deed: &str) -> Result<(), String> {
    let deed = serde_json::from_str(deed).map_err(|error| error.to_string())?;
    with_mirror(|mirror| mirror.act(deed)).unwrap_or(Ok(()))
}

/// Whether an element of the page has the keyboard.
pub fn hold(held: bool) {
    with_mirror(|mirror| mirror.hold(held));
}

fn with_mirror<T>(what: impl FnOnce(&mut Mirror) -> T) -> Option<T> {
    SHOWN.with_borrow(|shown| {
        let Shown { ctx, .. } = shown.as_ref()?;
        let done = what(&mut ctx.plugin_opt::<Mirror>()?.lock());
        ctx.request_repaint();
        Some(done)
    })
}

/// Whether the page is in a tab or window that nobody sees.
pub(super) fn is_hidden() -> bool {
    let document = web_sys::window().and_then(|window| window.document());
    document.is_some_and(|document| document.hidden())
}

/// Puts a text into the clipboard; it is there when this is over.
pub(super) async fn copy(text: &str) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or_else(|| JsValue::from_str("no window"))?;
    let navigator = window.navigator();
    // Pages without https have none, which the bindings do not know.
    let clipboard = js_sys::Reflect::get(&navigator, &JsValue::from_str("clipboard"))?;
    if clipboard.is_undefined() {
        return Err(JsValue::from_str("no clipboard"));
    }
    wasm_bindgen_futures::JsFuture::from(navigator.clipboard().write_text(text)).await?;
    Ok(())
}

/// Puts scenario and edits into the page's address, without a step in its history.
pub(super) fn write_link(fragment: &str) {
    let Some(window) = web_sys::window() else { return };
    if let Ok(history) = window.history() {
        // Refused only where the page is embedded without rights: the console goes on.
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&format!("#{fragment}")));
    }
}

/// The page's address with another fragment, as it may be given to others.
pub(super) fn address(fragment: &str) -> String {
    format!("{}#{fragment}", page_to_share(&href()))
}

/// Time after which every browser has read a file that was offered for download, ms.
const FILE_IS_READ_AFTER_MS: i32 = 60_000;

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
    // Firefox follows only a link that stands in the page; Safari and Firefox read the bytes after the
    // click has returned, so that the address must live on for a while.
    let body =
        document.body().ok_or_else(|| JsValue::from_str("no page to put the file's link in"))?;
    body.append_child(&anchor)?;
    anchor.click();
    anchor.remove();
    wasm_bindgen_futures::spawn_local(async move {
        sleep(FILE_IS_READ_AFTER_MS).await;
        // An address that is gone already is what is wanted.
        let _ = web_sys::Url::revoke_object_url(&url);
    });
    Ok(())
}

/// Waits; the page goes on meanwhile.
async fn sleep(ms: i32) {
    let wait = js_sys::Promise::new(&mut |resolve, _| {
        if let Some(window) = web_sys::window() {
            // Without a timer the wait ends with the page.
            let _ = window.set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, ms);
        }
    });
    // The promise is never rejected.
    let _ = wasm_bindgen_futures::JsFuture::from(wait).await;
}
