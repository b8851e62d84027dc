//! A subcommand goes to the command line, none goes to the console; in the browser, the page
//! starts the console.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    let cli = steadycut::cli::parse();
    match &cli.command {
        Some(command) => steadycut::cli::execute(command),
        None => steadycut::cli::console(cli.scenario.as_deref(), &cli.embed, open_console),
    }
}

#[cfg(all(not(target_arch = "wasm32"), feature = "app"))]
use steadycut::app::open as open_console;

#[cfg(all(not(target_arch = "wasm32"), not(feature = "app")))]
fn open_console(_: steadycut::study::opening::Opening) -> Result<(), String> {
    Err("this program was built without the console; `steadycut --help` lists its commands, or \
         build it with the feature `app`"
        .to_owned())
}

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(target_arch = "wasm32")]
mod web_exports {
    use wasm_bindgen::prelude::*;

    /// Digests and metrics of all presets, as in `tests/golden.json`.
    #[wasm_bindgen]
    pub fn preset_digests() -> String {
        steadycut::study::golden::to_json()
    }

    /// The digest of a search for a formula, for the test of the bits: the table's text, its target and inputs.
    #[wasm_bindgen]
    pub fn search_digest(
        table: &str,
        target: &str,
        inputs: Vec<String>,
        seed: u32,
        batches: u32,
    ) -> Result<String, JsValue> {
        use steadycut::run::job::Job;
        use steadycut::study::identify::gp::job::{GpJob, GpSettings};
        use steadycut::study::identify::gp::problem::GpProblem;

        let told = |error: String| JsValue::from_str(&error);
        let problem = GpProblem::read(table, target, &inputs).map_err(|e| told(e.to_string()))?;
        let settings = GpSettings { seed: seed.into(), batches: batches.into(), paper: None };
        let mut job = GpJob::new(problem, &settings).map_err(|e| told(e.to_string()))?;
        job.to_end();
        Ok(job.report().digest)
    }

    /// Shows the console on a canvas.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub async fn start(canvas: web_sys::HtmlCanvasElement) -> Result<(), JsValue> {
        steadycut::app::web::start(canvas).await
    }

    /// Shows one plot and nothing else: what `web/test/frames.mjs` compares the console's frames with.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub async fn start_bare(canvas: web_sys::HtmlCanvasElement) -> Result<(), JsValue> {
        steadycut::app::web::start_bare(canvas).await
    }

    /// Takes the console off its canvas, whose graphics are lost; `start` shows it again on another one.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub fn stop() {
        steadycut::app::web::stop();
    }

    /// Whether the next Tab belongs to the browser, so that it leads out of the canvas.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub fn tab_leaves() -> bool {
        steadycut::app::web::tab_leaves()
    }

    /// Makes the page's elements for screen readers, or no more.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub fn mirror(on: bool) {
        steadycut::app::web::mirror(on);
    }

    /// Does with one of them what a person did.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub fn mirror_act(deed: &str) -> Result<(), JsValue> {
        steadycut::app::web::act(deed).map_err(|error| JsValue::from_str(&error))
    }

    /// Whether one of them has the keyboard.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub fn mirror_hold(held: bool) {
        steadycut::app::web::hold(held);
    }

    /// Whether a link pasted into the open page is not followed.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub fn keeps_address() -> bool {
        steadycut::app::web::keeps_address()
    }

    /// The console's state, for the browser test.
    #[cfg(feature = "app")]
    #[wasm_bindgen]
    pub fn state_json() -> String {
        steadycut::app::web::state_json()
    }
}
