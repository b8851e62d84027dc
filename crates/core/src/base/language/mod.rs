//! Languages of what people read. The program is written in English: every text that is shown goes through
//! [`tr`](tr()) or [`tr!`](crate::tr!) with its English words, which are looked up in the catalogue of the chosen
//! language (`assets/languages`, in Project Fluent's format). What a catalogue does not have stays English; a test finds
//! that, and what no program text asks for any more.
//!
//! The choice is one per thread: texts are made where they are shown, and tests of several languages run beside each
//! other. Files, links, CSV and the command line know nothing of it: they keep English words and the decimal point.

mod arg;
mod catalogue;
mod source;

use std::cell::Cell;

pub use arg::Arg;
pub use catalogue::{Catalogue, SourceText};
pub use source::{placeholders, plain_words};

pub use crate::text;
pub use crate::tr;

crate::choice! {
    /// A language that the program speaks.
    pub enum Language {
        /// The language that the program is written in.
        English = "en", "English";
        /// Slovenian.
        Slovenian = "sl", "Slovenščina";
        /// German.
        German = "de", "Deutsch";
    }
}

impl Language {
    /// The language of a tag as systems and browsers give it (`sl`, `de-AT`, `en_GB.UTF-8`), if the program has it.
    #[must_use]
    pub fn of_tag(tag: &str) -> Option<Self> {
        let code = tag.split(['-', '_', '.']).next().unwrap_or("").to_ascii_lowercase();
        Self::ALL.iter().copied().find(|language| language.id() == code)
    }
}

thread_local! {
    static CHOSEN: Cell<Option<&'static Catalogue>> = const { Cell::new(None) };
}

/// Chooses the language of the texts that this thread makes from now on.
pub fn choose(language: Language) {
    CHOSEN.set(Catalogue::of(language));
}

/// Makes texts of files in English, whatever this thread has chosen for people.
pub fn in_english<T>(make: impl FnOnce() -> T) -> T {
    /// Puts the choice back, after a panic too.
    struct Back(Option<&'static Catalogue>);

    impl Drop for Back {
        fn drop(&mut self) {
            CHOSEN.set(self.0);
        }
    }

    let _back = Back(CHOSEN.replace(None));
    make()
}

/// Uses a catalogue of one's own in this thread, for tests; none is English.
pub fn use_catalogue(catalogue: Option<&'static Catalogue>) {
    CHOSEN.set(catalogue);
}

/// The catalogue in use in this thread; none where English is chosen.
#[must_use]
pub fn catalogue() -> Option<&'static Catalogue> {
    CHOSEN.get()
}

/// The language of this thread.
#[must_use]
pub fn chosen() -> Language {
    catalogue().map_or(Language::English, Catalogue::language)
}

/// A text that stands in a table, for the search of texts alone: gives it unchanged. Where it is shown,
/// [`tr`](tr()) gives it in the chosen language.
#[macro_export]
macro_rules! text {
    ($text:literal) => {
        $text
    };
}

/// A text with values in it, in the chosen language. It is written like the text of [`format!`], every value by its
/// name: `tr!("computing, {share:.0} %", share = 100.0 * done)`. Without values it is [`tr`](tr()).
///
/// The catalogue has the same text with `{ $share }`. A precision (`:.1`) and a sign (`:+.1`) act in every language, with
/// the decimal comma where the language has it; whole numbers choose among plurals there. Texts given as values are to
/// be in the chosen language already.
#[macro_export]
macro_rules! tr {
    ($text:literal $(,)?) => {
        $crate::base::language::tr($text)
    };
    ($text:literal, $($name:ident = $value:expr),+ $(,)?) => {
        match $crate::base::language::catalogue() {
            None => format!($text, $($name = $value),+),
            Some(catalogue) => catalogue.filled(
                $text,
                &[$((stringify!($name), $crate::base::language::Arg::from(&$value))),+],
            ),
        }
    };
}

/// A text in the chosen language; as it is where the catalogue does not have it.
#[must_use]
pub fn tr(text: &str) -> &str {
    match catalogue() {
        None => text,
        Some(catalogue) => catalogue.plain(text).unwrap_or(text),
    }
}

/// The decimal sign of the chosen language.
#[must_use]
pub fn decimal_sign() -> char {
    match chosen() {
        Language::English => '.',
        Language::Slovenian | Language::German => ',',
    }
}

/// A number that is written with a decimal point, as the chosen language writes it.
#[must_use]
pub fn decimal(number: String) -> String {
    match decimal_sign() {
        '.' => number,
        sign => number.replace('.', sign.encode_utf8(&mut [0; 4])),
    }
}

/// A number with so many digits behind the decimal sign, as the chosen language writes it.
#[must_use]
pub fn fixed(value: f64, digits: usize) -> String {
    decimal(format!("{value:.digits$}"))
}

#[cfg(test)]
mod tests;
