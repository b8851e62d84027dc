//! The texts of one language, read from its files.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use fluent_syntax::parser;
use fluent_syntax::unicode::unescape_unicode_to_string;

use super::source::{Spec, plain_words, specs};
use super::{Arg, Language};

/// The files of a language, which have the same names in each.
macro_rules! files {
    ($($name:literal),+ $(,)?) => {
        impl Catalogue {
            /// Names of the files of each language, without the ending.
            pub const FILES: &[&str] = &[$($name),+];
        }
        const ENGLISH: &[&str] = &[$(include_str!(concat!("../../../../../assets/languages/en/", $name, ".ftl"))),+];
        const SLOVENIAN: &[&str] = &[$(include_str!(concat!("../../../../../assets/languages/sl/", $name, ".ftl"))),+];
        const GERMAN: &[&str] = &[$(include_str!(concat!("../../../../../assets/languages/de/", $name, ".ftl"))),+];
    };
}
files!("console", "screens", "core", "measured", "study", "tables", "missions");

/// The texts of a language.
pub struct Catalogue {
    language: Language,
    /// English words to the text of this language, for texts without values.
    plain: BTreeMap<String, String>,
    /// English words to the name of the message, for texts with values.
    with_values: BTreeMap<String, String>,
    bundle: FluentBundle<FluentResource>,
    /// Whether its texts are made longer and marked, for tests.
    padded: bool,
}

/// An English text of the catalogue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceText {
    /// Name of its file in the folder of each language, without the ending.
    pub file: &'static str,
    /// Name of the message in the files.
    pub id: String,
    /// Its words, as [`plain_words`] has them.
    pub words: String,
    /// Whether it has places for values.
    pub has_values: bool,
}

/// The words of a pattern, with its places by name; none if it has anything else (English has no choices: each is a text
/// of its own in the program).
fn words_of(pattern: &Pattern<String>) -> Option<(String, bool)> {
    let (mut words, mut has_values) = (String::new(), false);
    for element in &pattern.elements {
        match element {
            PatternElement::TextElement { value } => words.push_str(value),
            PatternElement::Placeable {
                expression: Expression::Inline(InlineExpression::VariableReference { id }),
            } => {
                words.push('{');
                words.push_str(&id.name);
                words.push('}');
                has_values = true;
            }
            PatternElement::Placeable {
                expression: Expression::Inline(InlineExpression::StringLiteral { value }),
            } => words.push_str(&unescape_unicode_to_string(value)),
            PatternElement::Placeable { .. } => return None,
        }
    }
    Some((words, has_values))
}

/// A text that is marked, and a third longer than its words, without the values in it, by the first of them.
fn longer(text: &str, words: &str) -> String {
    let words = words.replace(['{', '}'], "");
    let third = words.chars().count().div_ceil(3);
    let more: String = words.chars().take(third).collect();
    format!("«{text} {more}»")
}

impl Catalogue {
    /// The catalogue of a language; none for English, whose words are in the program itself.
    #[must_use]
    pub fn of(language: Language) -> Option<&'static Self> {
        static OF_SLOVENIAN: OnceLock<Catalogue> = OnceLock::new();
        static OF_GERMAN: OnceLock<Catalogue> = OnceLock::new();
        match language {
            Language::English => None,
            Language::Slovenian => {
                Some(OF_SLOVENIAN.get_or_init(|| Self::read(language, SLOVENIAN)))
            }
            Language::German => Some(OF_GERMAN.get_or_init(|| Self::read(language, GERMAN))),
        }
    }

    /// A catalogue for tests of layouts: every text it knows stands between « and » and is a third longer. What is seen
    /// without these signs was not asked for in a language.
    #[must_use]
    pub fn padded() -> &'static Self {
        static PADDED: OnceLock<Catalogue> = OnceLock::new();
        PADDED.get_or_init(|| {
            let mut catalogue = Self::read(Language::English, ENGLISH);
            catalogue.padded = true;
            catalogue.plain.values_mut().for_each(|text| *text = longer(text, text));
            catalogue
        })
    }

    /// The English texts, in the order of the files.
    #[must_use]
    pub fn sources() -> &'static [SourceText] {
        static SOURCES: OnceLock<Vec<SourceText>> = OnceLock::new();
        SOURCES.get_or_init(|| {
            let mut found = Vec::new();
            for (file, text) in Self::FILES.iter().zip(ENGLISH) {
                let resource = parser::parse((*text).to_owned()).unwrap_or_else(|(read, _)| read);
                for entry in resource.body {
                    if let Entry::Message(message) = entry
                        && let Some((words, has_values)) = message.value.as_ref().and_then(words_of)
                    {
                        found.push(SourceText { file, id: message.id.name, words, has_values });
                    }
                }
            }
            found
        })
    }

    fn read(language: Language, files: &[&str]) -> Self {
        let tag = language.id().parse().expect("a code of ISO 639-1");
        let mut bundle = FluentBundle::new_concurrent(vec![tag]);
        // Marks of direction around values, which the fonts have no signs for.
        bundle.set_use_isolating(false);
        for text in files {
            let resource =
                FluentResource::try_new((*text).to_owned()).unwrap_or_else(|(read, _)| read);
            bundle.add_resource_overriding(resource);
        }
        let mut catalogue = Self {
            language,
            plain: BTreeMap::new(),
            with_values: BTreeMap::new(),
            bundle,
            padded: false,
        };
        for source in Self::sources() {
            let Some(pattern) = catalogue.bundle.get_message(&source.id).and_then(|m| m.value())
            else {
                continue;
            };
            if !source.has_values {
                let text = catalogue.bundle.format_pattern(pattern, None, &mut Vec::new());
                let text = text.into_owned();
                catalogue.plain.insert(source.words.clone(), text);
            } else {
                catalogue.with_values.insert(source.words.clone(), source.id.clone());
            }
        }
        catalogue
    }

    /// Its language.
    #[must_use]
    pub fn language(&self) -> Language {
        self.language
    }

    /// A text without values in this language, if the catalogue has it.
    #[must_use]
    pub fn plain(&'static self, english: &str) -> Option<&'static str> {
        self.plain.get(english).map(String::as_str)
    }

    /// A text with values in this language; see [`tr!`](crate::tr!). English words where the catalogue does not have it.
    #[must_use]
    pub fn filled(&self, english: &str, values: &[(&'static str, Arg<'_>)]) -> String {
        let (words, specs) = (plain_words(english), specs(english));
        let mut args = FluentArgs::new();
        for (name, value) in values {
            let spec = specs.iter().find(|(place, _)| place == name);
            args.set(*name, value.value(spec.map_or_else(Spec::default, |(_, spec)| *spec)));
        }
        let id = self.with_values.get(&words);
        let message = id.and_then(|id| self.bundle.get_message(id)).and_then(|m| m.value());
        match message {
            Some(pattern) => {
                let text = self.bundle.format_pattern(pattern, Some(&args), &mut Vec::new());
                if self.padded { longer(&text, &words) } else { text.into_owned() }
            }
            None => {
                let mut text = words;
                for (name, value) in args.iter() {
                    let value = match value {
                        FluentValue::String(value) => value.clone().into_owned(),
                        FluentValue::Number(number) => number.as_string().into_owned(),
                        FluentValue::Custom(_) | FluentValue::None | FluentValue::Error => {
                            String::new()
                        }
                    };
                    text = text.replace(&format!("{{{name}}}"), &value);
                }
                text
            }
        }
    }
}
