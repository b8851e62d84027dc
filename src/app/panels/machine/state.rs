//! The machine that is shown: its modes and its frequency response, made again when its settings
//! change.

use crate::models::structure::frf::{FrequencyResponse, LAST_HZ, tree};
use crate::models::structure::modes::{UndampedMode, damped, undamped};
use crate::models::structure::{FiveMass, MachineSettings};

/// Step of the drawn response, Hz; the paper's own is 10 Hz.
const STEP_HZ: u32 = 2;

/// A mode for people.
pub struct ShownMode {
    /// Without damping.
    pub free: UndampedMode,
    /// Damping ratio; none where damping changes the number of vibrating modes.
    pub damping_ratio: Option<f64>,
}

/// The machine with what follows from it.
pub struct MachineState {
    settings: MachineSettings,
    /// Its masses, springs and dampers.
    pub model: FiveMass,
    /// Its modes by rising frequency; empty where the eigenvalues do not converge.
    pub modes: Vec<ShownMode>,
    /// Its response from 0 to 3000 Hz.
    pub sweep: Vec<FrequencyResponse>,
}

impl MachineState {
    /// The machine that the settings describe.
    #[must_use]
    pub fn new(settings: &MachineSettings) -> Self {
        let model = FiveMass::new(settings);
        let free = undamped(&model).unwrap_or_default();
        let vibrating: Vec<f64> = damped(&model)
            .unwrap_or_default()
            .iter()
            .filter(|mode| mode.pole.im > 0.0)
            .map(|mode| mode.damping_ratio())
            .collect();
        let all = vibrating.len() == free.len();
        let modes = free.into_iter().enumerate().map(|(i, free)| ShownMode {
            free,
            damping_ratio: vibrating.get(i).copied().filter(|_| all),
        });
        let frequencies = (0..=LAST_HZ).step_by(STEP_HZ as usize).map(f64::from);
        Self {
            settings: settings.clone(),
            model,
            modes: modes.collect(),
            sweep: frequencies.map(|f_hz| tree(&model, f_hz)).collect(),
        }
    }

    /// Whether it is the machine of these settings.
    #[must_use]
    pub fn is_of(&self, settings: &MachineSettings) -> bool {
        self.settings == *settings
    }
}
