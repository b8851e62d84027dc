//! A page's loudspeaker: Web Audio.

use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{AudioBufferSourceNode, AudioContext, AudioScheduledSourceNode, Document, GainNode};

use super::FADE_S;
use crate::base::language::tr;

/// The page's sound output, until it is dropped.
pub struct Speaker {
    context: AudioContext,
    master: GainNode,
    /// The block that sounds, with its share.
    playing: Option<(AudioBufferSourceNode, GainNode)>,
    failure: Option<String>,
    /// Lives as long as the output.
    _hidden: Hidden,
}

/// Silences the output while the page is hidden: frames that could do it may not come then.
struct Hidden {
    document: Document,
    listener: Closure<dyn FnMut()>,
}

/// What it listens to.
const VISIBILITY: &str = "visibilitychange";

impl Hidden {
    fn new(context: &AudioContext) -> Result<Self, JsValue> {
        let document = web_sys::window().and_then(|window| window.document());
        let document = document.ok_or_else(|| JsValue::from_str("no document"))?;
        let (page, context) = (document.clone(), context.clone());
        let listener = Closure::<dyn FnMut()>::new(move || {
            // Refused only where it is closed already.
            let _ = if page.hidden() { context.suspend() } else { context.resume() };
        });
        let called = listener.as_ref().unchecked_ref();
        document.add_event_listener_with_callback(VISIBILITY, called)?;
        Ok(Self { document, listener })
    }
}

impl Drop for Hidden {
    fn drop(&mut self) {
        let called = self.listener.as_ref().unchecked_ref();
        // It was added, so it can be removed.
        let _ = self.document.remove_event_listener_with_callback(VISIBILITY, called);
    }
}

fn problem(error: &JsValue) -> String {
    let said = js_sys::Reflect::get(error, &JsValue::from_str("message"));
    let said = said.ok().and_then(|said| said.as_string()).unwrap_or_default();
    tr!("the browser gives no sound output {said}", said = said).trim_end().to_owned()
}

impl Speaker {
    /// Opens the page's output, silent.
    ///
    /// # Errors
    /// The browser has none: in words for people.
    pub fn open() -> Result<Self, String> {
        let made = || {
            let context = AudioContext::new()?;
            let master = context.create_gain()?;
            master.gain().set_value(0.0);
            master.connect_with_audio_node(&context.destination())?;
            // Browsers begin in silence until a click; this is called in the wake of one.
            let _ = context.resume()?;
            let playing = None;
            Ok(Self { _hidden: Hidden::new(&context)?, context, master, playing, failure: None })
        };
        made().map_err(|error: JsValue| problem(&error))
    }

    /// Samples per second.
    #[must_use]
    pub fn rate_hz(&self) -> u32 {
        self.context.sample_rate() as u32
    }

    /// Plays `block`, samples within -1 to 1, over and over; an empty one is silence.
    pub fn play(&mut self, block: Vec<f32>) {
        if let Err(error) = self.try_play(&block) {
            self.failure = Some(problem(&error));
        }
    }

    fn try_play(&mut self, block: &[f32]) -> Result<(), JsValue> {
        let now_s = self.context.current_time();
        if let Some((source, share)) = self.playing.take() {
            share.gain().set_target_at_time(0.0, now_s, FADE_S / 3.0)?;
            AudioScheduledSourceNode::stop_with_when(&source, now_s + 4.0 * FADE_S)?;
        }
        if block.is_empty() {
            return Ok(());
        }
        let length = block.len() as u32;
        let buffer = self.context.create_buffer(1, length, self.context.sample_rate())?;
        buffer.copy_to_channel(block, 0)?;
        let (source, share) = (self.context.create_buffer_source()?, self.context.create_gain()?);
        source.set_buffer(Some(&buffer));
        source.set_loop(true);
        share.gain().set_value(0.0);
        share.gain().set_target_at_time(1.0, now_s, FADE_S / 3.0)?;
        source.connect_with_audio_node(&share)?;
        share.connect_with_audio_node(&self.master)?;
        source.start()?;
        self.playing = Some((source, share));
        Ok(())
    }

    /// Sets the volume, 0 to 1.
    pub fn set_volume(&mut self, volume: f32) {
        let now_s = self.context.current_time();
        let gain = self.master.gain();
        if let Err(error) = gain.set_target_at_time(volume.clamp(0.0, 1.0), now_s, FADE_S / 3.0) {
            self.failure = Some(problem(&error));
        }
    }

    /// What has gone wrong since, if it plays no more.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        self.failure.clone()
    }
}

impl Drop for Speaker {
    fn drop(&mut self) {
        // Refused only where it is closed already.
        let _ = self.context.close();
    }
}
