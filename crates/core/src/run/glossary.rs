//! The words and symbols that stand on the screen and in tables, in the papers' sense: one table, from which
//! the console explains what is pointed at and `steadycut list` prints them.
//!
//! Symbols and names are the same in every language; a term of words is found by those of the chosen one.

use crate::base::language::catalogue;

/// A word or symbol with its meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// How it is written, the usual way first. One with a capital letter or a figure in it is meant as
    /// written, others at the start of a sentence too.
    pub spellings: &'static [&'static str],
    /// What it is.
    pub meaning: &'static str,
    /// Whether it is of words, which another language has others for, rather than a symbol or a name.
    pub of_words: bool,
}

const fn term(spellings: &'static [&'static str], meaning: &'static str) -> Term {
    Term { spellings, meaning, of_words: false }
}

const fn words(spellings: &'static [&'static str], meaning: &'static str) -> Term {
    Term { spellings, meaning, of_words: true }
}

/// What parts the spellings of a term in the catalogue.
const APART: &str = ", ";
/// Stands in the catalogue for the letters that a word may go on with: its cases, and what it is put together with.
const ENDING: char = '*';

impl Term {
    /// The key of its spellings in the catalogue, for a term of words. The catalogue has them in the same form: the one
    /// that is shown first, and `*` where a word may go on.
    #[must_use]
    pub fn key(&self) -> Option<String> {
        self.of_words.then(|| format!("term: {}", self.spellings.join(APART)))
    }

    /// How the chosen language writes it, if it has words of its own for it.
    fn translated(&self) -> Option<&'static str> {
        catalogue()?.plain(&self.key()?)
    }

    /// How it is written in the chosen language, the usual way first; `*` stands for more letters.
    fn forms(&self) -> impl Iterator<Item = &'static str> {
        let (own, english) = match self.translated() {
            Some(forms) => (Some(forms.split(APART)), &[][..]),
            None => (None, self.spellings),
        };
        own.into_iter().flatten().chain(english.iter().copied())
    }

    /// How it is written in the chosen language, as people read it: forms that differ in their endings alone are not
    /// listed.
    #[must_use]
    pub fn written(&self) -> String {
        let shown: Vec<&str> = self.forms().filter(|form| !form.contains(ENDING)).collect();
        shown.join(APART)
    }
}

/// All of them: roughness and force, models, controllers, cutting, machine, judging.
pub const GLOSSARY: &[Term] = &[
    term(
        &["Ra"],
        "Arithmetic mean roughness of the surface, in µm: the mean distance of the profile from its mean line (ISO 4287).",
    ),
    term(
        &["N4", "N5", "N6", "N7", "N8"],
        "Roughness grades (ISO 1302): N4 is Ra 0.2 µm, and each grade doubles it, to N8 with 3.2 µm.",
    ),
    term(
        &["F_d", "Fd", "F_{ref}", "Fref"],
        "Desired force, in N: what the target Ra asks for, by K1 or M1.",
    ),
    term(
        &["F_m", "Fm"],
        "Measured force, in N: what the controller has read from the dynamometer.",
    ),
    term(&["F_s", "Fs"], "Force setpoint, in N: what the controller asks its models for."),
    term(
        &["F_{dyn}", "Fdyn", "F_dyn"],
        "Force with dynamics, in N: the cutting force with all that shakes it.",
    ),
    term(
        &["F_x", "F_y", "F_z", "Fx", "Fy", "Fz", "Fxy"],
        "Components of the cutting force, in N: x along the feed, y across it, z along the tool; xy together across the tool.",
    ),
    term(
        &["K1", "K2", "K3", "K4", "K5", "K6"],
        "Models of the 2007 paper: K1 Ra to force, K2 force to feed, K3 force to speed, K4 feed and speed to force, K5 force to Ra, K6 force with dynamics to Ra.",
    ),
    term(
        &["M1", "M2", "M3", "M4", "M5", "M6"],
        "Models of the 2013 paper, in the places of K1 to K6: M1 Ra to force, M2 force to feed, M3 force to speed, M4 feed, speed and depths to force, M5 and M6 force to Ra.",
    ),
    words(
        &["outside model", "outside its range", "outside"],
        "A model is asked for what it was not identified on: its answer is a guess there, and is marked.",
    ),
    term(
        &["SDNRP"],
        "Model-based system for the dynamic adjustment of cutting parameters (2007): proportional force feedback into K2 and K3, which give feed and speed.",
    ),
    words(
        &["Tracking"],
        "The controller of 2013 made whole: the model's inverse with integral action, anti-windup and a Smith predictor.",
    ),
    term(
        &["UNKS"],
        "Neural control scheme of 2005: two networks learn how the cut answers, a third one steers the feed.",
    ),
    term(
        &["NN"],
        "Neural network: here the 8-15-3 network of 2013, which gives the force from the cutting conditions.",
    ),
    term(
        &["NM", "NM-1", "NM-2", "NM-R"],
        "Networks of UNKS: NM-1 and NM-2 recognise the process and its inverse, NM-R steers.",
    ),
    term(
        &["AFC"],
        "Adaptive feed control, as the control of a machine tool has it: the feed follows the force that the first part has taught it.",
    ),
    term(&["FMIN"], "Least feed of AFC, in percent of the programmed one; never below 30 %."),
    term(&["FMAX"], "Largest feed of AFC, in percent of the programmed one."),
    words(
        &["teach-in", "taught in"],
        "First cut under AFC, at the programmed feed: the peak force of each cut becomes its reference.",
    ),
    term(
        &["MRAC"],
        "Model reference adaptive control (2005): the gains change until the force answers as a reference model does.",
    ),
    term(
        &["PI"],
        "Controller that acts on the error (proportional) and on its sum over time (integral).",
    ),
    term(&["Kp"], "Proportional gain: how much of the force error is added to what is asked for."),
    term(&["Ki"], "Integral gain: how fast the sum of the force error is acted on."),
    words(
        &["Smith predictor"],
        "Part of a controller that reckons with the dead time: it compares with what the command sent so far will do.",
    ),
    words(
        &["anti-windup"],
        "Keeps the integral part from growing while a command stands at a limit.",
    ),
    words(
        &["dead time"],
        "Time that passes before a command begins to act: the machine's control reads an override only now and then.",
    ),
    words(
        &["unstable", "limit cycle"],
        "A loop is unstable where feed and force swing without dying down, in a limit cycle: its gain is too large for its dead time.",
    ),
    term(
        &["DNCFRO"],
        "Feed override by the control computer: the feed sent to the machine, in percent of the programmed one.",
    ),
    term(
        &["DNCSPO"],
        "Spindle override by the control computer: the speed sent to the machine, in percent of the programmed one.",
    ),
    term(&["CNC"], "Computer numerical control: the machine's control, here a FAGOR 8040-M."),
    term(&["NC"], "Numerical control: the program that gives path, feed and speed."),
    words(&["programmed"], "Feed and speed as the NC program gives them, at an override of 100 %."),
    words(
        &["override"],
        "Share of the programmed feed or speed that is sent to the machine, in percent: by a controller, or by the knob of its panel.",
    ),
    words(
        &["by hand", "operator"],
        "The feed override is turned by a person at the machine, who sees the force and hears the cut; no controller has the feed.",
    ),
    words(
        &["constant feed"],
        "Conventional milling: feed and speed stay as programmed, whatever the cut does.",
    ),
    term(&["A_D", "AD"], "Axial depth of cut, in mm: along the tool's axis."),
    term(&["R_D", "RD"], "Radial depth of cut, in mm: across the tool."),
    term(&["HB"], "Brinell hardness of the workpiece."),
    term(&["VB"], "Width of the wear land at the tool's flank, in mm (ISO 8688)."),
    words(
        &["tool life", "remaining life"],
        "Time in the cut until the tool is worn out, by Taylor's law and the wear curve.",
    ),
    term(
        &["E_S", "ES"],
        "Sound of the cut: root mean square of the velocity between tooth and work, in mm/s (2019).",
    ),
    term(
        &["G_rel", "Grel"],
        "Compliance between tooth and work, in m/N: how far they move apart under one newton (2019).",
    ),
    term(&["H33"], "Compliance of the tooth's mass alone, in m/N (2019)."),
    term(
        &["Q", "Q2"],
        "Quality of the spindle's spring: how often it swings before it comes to rest; 5 is well damped, 17 lightly.",
    ),
    term(&["K_s", "Ks"], "Specific cutting force, in N/mm²: force over the chip's cross-section."),
    words(
        &["chatter"],
        "Vibration that feeds itself: each tooth cuts the waves that the last one has left, and they grow.",
    ),
    words(
        &["lost contact"],
        "A tooth that should cut has jumped out of the work: a sign of chatter.",
    ),
    words(&["run-out"], "The tool turns off its axis, so that the teeth cut unevenly deep."),
    term(
        &["Nsn"],
        "Normalised standard error of the force (2005): root mean square of the error over the desired force, in contact; 0 is perfect.",
    ),
    words(
        &["20 samples", "Nsn20", "Nsn of 20"],
        "Nsn over 20 samples, the form that the 2005 paper prints.",
    ),
    words(
        &["in tolerance"],
        "Share of the length cut on which Ra stands within the tolerance of its target.",
    ),
    words(
        &["held within 10 %", "held"],
        "Share of the samples in contact with the force within 10 % of its reference.",
    ),
    words(
        &["remaining error", "steady-state error"],
        "What is left between the value and its target when nothing moves any more; proportional control alone leaves one.",
    ),
    words(
        &["overshoot"],
        "How far the force swings beyond where it comes to rest, to the side away from the jump that the change itself makes, in percent of the force at rest.",
    ),
    words(
        &["settling", "settling time"],
        "Time after a change until the force stays for good within 2 %, and what noise adds, of where it comes to rest.",
    ),
    words(
        &["saturated", "at a limit"],
        "A command stands at the most or least that the machine allows: the controller cannot do what it wants.",
    ),
    words(&["as printed", "printed"], "Exactly as it stands in the paper."),
    words(
        &["restored"],
        "The printed form with the fewest coefficients corrected, where it cannot give the paper's own table.",
    ),
    words(&["identified"], "Fitted anew to the paper's own table."),
    term(&["CSV"], "Table as text, a line per row, that spreadsheets and programs read."),
    term(&["TOML"], "Form of a scenario file: text with a line per setting."),
    words(
        &["PSO", "swarm"],
        "Particle swarm optimisation (2013): points that fly over the map of feed and speed and draw each other to the best place.",
    ),
    term(&["1/min"], "Turns per minute of the spindle."),
    words(
        &["gain estimate"],
        "The controller's estimate of the true force over the one that its model expects: it grows with wear and harder material.",
    ),
];

/// Whether a character belongs to a word, so that no word begins or ends beside it.
fn in_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Where a form that begins at the head of a text ends there, in bytes; none where it does not stand there.
fn end_of(form: &str, text: &str) -> Option<usize> {
    let as_written = form.chars().any(|c| c.is_uppercase() || c.is_ascii_digit());
    let alike = |wanted: char, found: char| {
        let is_space = wanted == ' ' && found == '\u{a0}';
        let small = || wanted.to_lowercase().eq(found.to_lowercase());
        wanted == found || is_space || (!as_written && small())
    };
    let mut end = 0;
    for wanted in form.chars() {
        if wanted == ENDING {
            let rest = &text[end..];
            end += rest.find(|c| !in_word(c)).unwrap_or(rest.len());
        } else {
            let found = text[end..].chars().next().filter(|found| alike(wanted, *found))?;
            end += found.len_utf8();
        }
    }
    Some(end)
}

/// Places of a form in a text, as whole words: first byte and the byte behind the last.
fn places<'a>(text: &'a str, form: &'a str) -> impl Iterator<Item = (usize, usize)> + 'a {
    let starts = text.char_indices().map(|(at, _)| at);
    starts.filter_map(move |at| {
        let before = text[..at].chars().next_back().is_some_and(in_word);
        if before {
            return None;
        }
        let end = at + end_of(form, &text[at..])?;
        let after = text[end..].chars().next().is_some_and(in_word);
        let ends_free = !after || !text[..end].chars().next_back().is_some_and(in_word);
        ends_free.then_some((at, end))
    })
}

/// The terms that a text contains, each once, in the order in which they stand. A term within a longer one
/// does not count: "Nsn of 20" is not "Nsn".
///
/// ```
/// use steadycut_core::run::glossary::terms_in;
///
/// let found: Vec<&str> = terms_in("SDNRP: Kp over the dead time").map(|term| term.spellings[0]).collect();
/// assert_eq!(found, ["SDNRP", "Kp", "dead time"]);
/// ```
pub fn terms_in(text: &str) -> impl Iterator<Item = &'static Term> {
    let mut found: Vec<(usize, usize, usize)> = Vec::new();
    for (which, term) in GLOSSARY.iter().enumerate() {
        for form in term.forms() {
            found.extend(places(text, form).map(|(from, to)| (from, to, which)));
        }
    }
    found.sort_by_key(|&(from, to, _)| (from, std::cmp::Reverse(to)));
    let mut free_from = 0;
    found.retain(|&(from, to, _)| {
        let free = from >= free_from;
        if free {
            free_from = to;
        }
        free
    });
    let mut seen: Vec<usize> = Vec::new();
    for (_, _, which) in found {
        if !seen.contains(&which) {
            seen.push(which);
        }
    }
    seen.into_iter().map(|which| &GLOSSARY[which])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Vec<&'static str> {
        terms_in(text).map(|term| term.spellings[0]).collect()
    }

    #[test]
    fn whole_words_are_found_and_the_longest_counts() {
        assert_eq!(found("Nsn of 20"), ["20 samples"]);
        assert_eq!(found("Nsn, 20 samples"), ["Nsn", "20 samples"]);
        assert_eq!(found("Nsn / s / kN"), ["Nsn"]);
        assert_eq!(found("Ra with dynamics, Radial"), ["Ra"]);
        assert_eq!(found("Outside model: K1, K2 now"), ["outside model", "K1"]);
        assert_eq!(found("2800 1/min"), ["1/min"]);
        assert_eq!(found("held within 10 %"), ["held within 10 %"]);
        assert_eq!(found("CNCs, nsn, RADIAL, K7"), [""; 0]);
        assert_eq!(found("µm Ra µ"), ["Ra"]);
        assert_eq!(found(""), [""; 0]);
    }

    #[test]
    fn terms_are_found_by_the_words_of_the_chosen_language() {
        use crate::base::language::{Language, choose};
        for (language, text, wanted) in [
            (
                Language::German,
                "Mit der Totzeit wächst das Überschwingen; Vorschub-Override, Kp, Rattern im Schnitt",
                ["dead time", "overshoot", "override", "Kp", "chatter"],
            ),
            (
                Language::Slovenian,
                "Zaradi mrtvega časa raste prenihaj; korekcija podajanja, Kp, drdranje med rezom",
                ["dead time", "overshoot", "override", "Kp", "chatter"],
            ),
        ] {
            choose(language);
            assert_eq!(found(text), wanted, "{language:?}");
            // English words are no terms there, unless the language uses them.
            assert_eq!(found("settling, dead time"), [""; 0], "{language:?}");
            for term in GLOSSARY.iter().filter(|term| term.of_words) {
                let written = term.written();
                assert!(!written.is_empty() && !written.contains('*'), "{:?}", term.spellings);
                assert!(term.translated().is_some(), "{language:?}: {:?}", term.spellings);
                let first = term.forms().next().unwrap();
                let names = found(first);
                assert!(names.contains(&term.spellings[0]), "{language:?}: {first} is {names:?}");
            }
        }
        choose(Language::English);
    }

    #[test]
    fn no_spelling_stands_twice_and_every_meaning_is_a_sentence() {
        let all: Vec<&str> = GLOSSARY.iter().flat_map(|term| term.spellings).copied().collect();
        for (i, spelling) in all.iter().enumerate() {
            assert!(!all[..i].contains(spelling), "{spelling}");
            assert!(!spelling.is_empty());
        }
        for term in GLOSSARY {
            assert!(term.meaning.ends_with('.') && term.meaning.len() > 20, "{:?}", term.spellings);
        }
    }
}
