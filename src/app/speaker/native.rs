//! The desktop's loudspeaker.

use std::sync::{Arc, Mutex, PoisonError};

use cpal::traits::{DeviceTrait, HostTrait, StreamTrait};
use cpal::{FromSample, I24, SampleFormat, SizedSample, StreamConfig, U24};

use super::FADE_S;
use super::looped::Looped;

/// The default output of the system, playing until it is dropped.
pub struct Speaker {
    /// Keeps the stream running.
    _stream: cpal::Stream,
    looped: Arc<Mutex<Looped>>,
    failed: Arc<Mutex<Option<String>>>,
    rate_hz: u32,
}

impl Speaker {
    /// Opens the default output, silent.
    ///
    /// # Errors
    /// There is none, or it takes no samples: in words for people.
    pub fn open() -> Result<Self, String> {
        let device = cpal::default_host().default_output_device();
        let device = device.ok_or("this computer has no sound output")?;
        let problem = |error: cpal::Error| format!("the sound output cannot be used: {error}");
        let offered = device.default_output_config().map_err(problem)?;
        let config: StreamConfig = offered.into();
        let rate_hz = config.sample_rate;
        let looped = Arc::new(Mutex::new(Looped::new((FADE_S * f64::from(rate_hz)) as usize)));
        let failed = Arc::new(Mutex::new(None));
        let ends = (Arc::clone(&looped), Arc::clone(&failed));
        let stream = match offered.sample_format() {
            SampleFormat::I8 => stream::<i8>(&device, config, ends),
            SampleFormat::I16 => stream::<i16>(&device, config, ends),
            SampleFormat::I24 => stream::<I24>(&device, config, ends),
            SampleFormat::I32 => stream::<i32>(&device, config, ends),
            SampleFormat::U8 => stream::<u8>(&device, config, ends),
            SampleFormat::U16 => stream::<u16>(&device, config, ends),
            SampleFormat::U24 => stream::<U24>(&device, config, ends),
            SampleFormat::U32 => stream::<u32>(&device, config, ends),
            SampleFormat::F32 => stream::<f32>(&device, config, ends),
            SampleFormat::F64 => stream::<f64>(&device, config, ends),
            other => return Err(format!("the sound output takes only {other} samples")),
        };
        let stream = stream.map_err(problem)?;
        stream.play().map_err(problem)?;
        Ok(Self { _stream: stream, looped, failed, rate_hz })
    }

    /// Samples per second.
    #[must_use]
    pub fn rate_hz(&self) -> u32 {
        self.rate_hz
    }

    /// Plays `block`, samples within -1 to 1, over and over; an empty one is silence.
    pub fn play(&mut self, block: Vec<f32>) {
        lock(&self.looped).play(block);
    }

    /// Sets the volume, 0 to 1.
    pub fn set_volume(&mut self, volume: f32) {
        lock(&self.looped).set_volume(volume);
    }

    /// What has gone wrong since, if it plays no more: the output was unplugged, for example.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        lock(&self.failed).clone()
    }
}

/// No panic can leave the values behind a lock half done.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

type Ends = (Arc<Mutex<Looped>>, Arc<Mutex<Option<String>>>);

fn stream<T: SizedSample + FromSample<f32>>(
    device: &cpal::Device,
    config: StreamConfig,
    (looped, failed): Ends,
) -> Result<cpal::Stream, cpal::Error> {
    let channels = usize::from(config.channels.max(1));
    let fill = move |data: &mut [T], _: &cpal::OutputCallbackInfo| {
        let mut looped = lock(&looped);
        for frame in data.chunks_mut(channels) {
            frame.fill(T::from_sample(looped.sample()));
        }
    };
    let complain = move |error: cpal::Error| {
        // A gap or a change of device is mended by the system; the sound goes on.
        let mended = matches!(
            error.kind(),
            cpal::ErrorKind::Xrun
                | cpal::ErrorKind::DeviceChanged
                | cpal::ErrorKind::RealtimeDenied
        );
        if !mended {
            *lock(&failed) = Some(format!("the sound output has failed: {error}"));
        }
    };
    device.build_output_stream(config, fill, complain, None)
}
