//! The desktop's loudspeaker.

use cpal::traits::{DeviceTrait, HostTrait, StreamTrait};
use cpal::{FromSample, I24, SampleFormat, SizedSample, StreamConfig, U24};

use super::looped::Shared;
use crate::base::language::tr;

/// The default output of the system, playing until it is dropped.
pub struct Speaker {
    /// Keeps the stream running.
    _stream: cpal::Stream,
    shared: Shared,
    rate_hz: u32,
}

impl Speaker {
    /// Opens the default output, silent.
    ///
    /// # Errors
    /// There is none, or it takes no samples: in words for people.
    pub fn open() -> Result<Self, String> {
        let device = cpal::default_host().default_output_device();
        let device = device.ok_or_else(|| tr("this computer has no sound output"))?;
        let problem = |error: cpal::Error| {
            tr!("the sound output cannot be used: {error}", error = error.to_string())
        };
        let offered = device.default_output_config().map_err(problem)?;
        let config: StreamConfig = offered.into();
        let rate_hz = config.sample_rate;
        let shared = Shared::new(rate_hz);
        let ends = shared.clone();
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
            other => {
                return Err(tr!(
                    "the sound output takes only {kind} samples",
                    kind = other.to_string()
                ));
            }
        };
        let stream = stream.map_err(problem)?;
        stream.play().map_err(problem)?;
        Ok(Self { _stream: stream, shared, rate_hz })
    }

    /// Samples per second.
    #[must_use]
    pub fn rate_hz(&self) -> u32 {
        self.rate_hz
    }

    /// Plays `block`, samples within -1 to 1, over and over; an empty one is silence.
    pub fn play(&mut self, block: Vec<f32>) {
        self.shared.looped().play(block);
    }

    /// Sets the volume, 0 to 1.
    pub fn set_volume(&mut self, volume: f32) {
        self.shared.looped().set_volume(volume);
    }

    /// What has gone wrong since, if it plays no more: the output was unplugged, for example.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        self.shared.failure()
    }
}

fn stream<T: SizedSample + FromSample<f32>>(
    device: &cpal::Device,
    config: StreamConfig,
    ends: Shared,
) -> Result<cpal::Stream, cpal::Error> {
    let channels = usize::from(config.channels.max(1));
    let failing = ends.clone();
    let fill = move |data: &mut [T], _: &cpal::OutputCallbackInfo| {
        let mut looped = ends.looped();
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
            failing.fail(tr!("the sound output has failed: {error}", error = error.to_string()));
        }
    };
    device.build_output_stream(config, fill, complain, None)
}
