//! What is kept from one start to the next: stars won in missions, the language, the address of a page for links, and what was
//! said of the layouts of measured data. Where the
//! place for it is refused the program works as well, and says that it forgets.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::overlay::layouts::KnownLayouts;
use crate::base::language::Language;
use crate::measured::layout::DataLayout;

#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(target_arch = "wasm32")]
mod page;

#[cfg(not(target_arch = "wasm32"))]
pub use native::Folder;
#[cfg(target_arch = "wasm32")]
pub use page::PageStorage;

/// Version of what is kept.
const KEPT_VERSION: u32 = 1;

/// A place for a text that outlives the program.
pub trait Keeper {
    /// The text that was kept last, if there is one and it can be read.
    fn kept(&self) -> Option<String>;
    /// Keeps a text; `false` where that is refused.
    fn keep(&self, text: &str) -> bool;
}

#[derive(Default, Serialize, Deserialize)]
struct Kept {
    version: u32,
    #[serde(default)]
    stars: BTreeMap<String, u8>,
    #[serde(default)]
    page: String,
    #[serde(default)]
    language: String,
    #[serde(default)]
    layouts: Vec<[String; 2]>,
}

/// See the head of the module.
#[derive(Default)]
pub struct Remembered {
    stars: BTreeMap<String, u8>,
    page: String,
    language: Option<Language>,
    layouts: KnownLayouts,
    keeper: Option<Box<dyn Keeper>>,
    refused: bool,
}

impl Remembered {
    /// What `keeper` has kept; what cannot be read counts as nothing. What a newer program has kept stays as it is,
    /// and nothing is kept beside it.
    #[must_use]
    pub fn of(keeper: Box<dyn Keeper>) -> Self {
        let kept = keeper.kept().and_then(|text| serde_json::from_str::<Kept>(&text).ok());
        if kept.as_ref().is_some_and(|kept| kept.version > KEPT_VERSION) {
            return Self { refused: true, ..Self::default() };
        }
        let kept = kept.filter(|kept| kept.version == KEPT_VERSION);
        let Kept { stars, page, language, layouts, .. } = kept.unwrap_or_default();
        let layouts = KnownLayouts::of(&layouts);
        let language = Language::ALL.iter().copied().find(|known| known.id() == language);
        Self { stars, page, language, layouts, keeper: Some(keeper), refused: false }
    }

    /// The most stars that were won in a mission, 0 where it was handed in and not passed; none if it never was.
    #[must_use]
    pub fn stars(&self, mission: &str) -> Option<u8> {
        self.stars.get(mission).copied()
    }

    /// Whether there are any.
    #[must_use]
    pub fn has_stars(&self) -> bool {
        !self.stars.is_empty()
    }

    /// Whether the last thing to be kept will be forgotten when the program ends.
    #[must_use]
    pub fn forgets(&self) -> bool {
        self.refused
    }

    /// The address of a page of this program, empty where none is known.
    #[must_use]
    pub fn page(&self) -> &str {
        &self.page
    }

    /// Notes stars that were won; fewer than before change nothing.
    pub fn won(&mut self, mission: &str, stars: u8) {
        let most = self.stars.entry(mission.to_owned()).or_default();
        *most = stars.max(*most);
        self.keep();
    }

    /// Forgets all stars.
    pub fn forget_stars(&mut self) {
        self.stars.clear();
        self.keep();
    }

    /// Notes the address of a page.
    pub fn page_is(&mut self, page: &str) {
        if self.page != page {
            page.clone_into(&mut self.page);
            self.keep();
        }
    }

    /// The language that was chosen, if one ever was.
    #[must_use]
    pub fn language(&self) -> Option<Language> {
        self.language
    }

    /// Notes the language that was chosen.
    pub fn speaks(&mut self, language: Language) {
        if self.language != Some(language) {
            self.language = Some(language);
            self.keep();
        }
    }

    /// What was said of the layouts of measured data.
    #[must_use]
    pub fn layouts(&self) -> &KnownLayouts {
        &self.layouts
    }

    /// Notes what was said of the layout of files with a signature; nothing forgets it.
    pub fn was_said(&mut self, signature: &str, layout: &DataLayout) {
        let before = self.layouts.clone();
        self.layouts.put(signature, layout);
        if self.layouts != before {
            self.keep();
        }
    }

    fn keep(&mut self) {
        let Some(keeper) = &self.keeper else { return };
        let text = serde_json::to_string(&Kept {
            version: KEPT_VERSION,
            stars: self.stars.clone(),
            page: self.page.clone(),
            language: self.language.map_or_else(String::new, |language| language.id().to_owned()),
            layouts: self.layouts.kept(),
        });
        self.refused = !text.is_ok_and(|text| keeper.keep(&text));
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::rc::Rc;

    use super::*;

    #[derive(Clone, Default)]
    struct Shelf(Rc<RefCell<Option<String>>>);

    impl Keeper for Shelf {
        fn kept(&self) -> Option<String> {
            self.0.borrow().clone()
        }

        fn keep(&self, text: &str) -> bool {
            *self.0.borrow_mut() = Some(text.to_owned());
            true
        }
    }

    #[test]
    fn stars_are_there_at_the_next_start_until_they_are_forgotten() {
        let shelf = Shelf::default();
        let again = || Remembered::of(Box::new(shelf.clone()));
        let mut first = again();
        assert!(!first.has_stars());
        first.won("quiet-speed", 2);
        first.won("quiet-speed", 1);
        first.won("smith-predictor", 0);
        first.page_is("https://example.org/");
        let mut second = again();
        let stars =
            [second.stars("quiet-speed"), second.stars("smith-predictor"), second.stars("x")];
        assert_eq!(stars, [Some(2), Some(0), None]);
        assert!(!second.forgets());
        second.forget_stars();
        assert!(!again().has_stars());
        assert_eq!(again().page(), "https://example.org/");
    }

    #[test]
    fn what_was_said_of_a_layout_is_there_at_the_next_start() {
        let shelf = Shelf::default();
        let again = || Remembered::of(Box::new(shelf.clone()));
        let layout = DataLayout { rate_hz: Some(200.0), ..DataLayout::default() };
        let mut first = again();
        first.won("quiet-speed", 1);
        first.was_said("a", &layout);
        let mut second = again();
        assert_eq!(second.layouts().get("a"), Some(&layout));
        assert_eq!(second.stars("quiet-speed"), Some(1));
        second.was_said("a", &DataLayout::default());
        assert_eq!(again().layouts().get("a"), None);
    }

    #[test]
    fn what_cannot_be_read_is_nothing_and_what_is_refused_is_said() {
        for text in
            ["", "{", "[]", r#"{"version":2,"stars":{"a":3}}"#, r#"{"version":1,"stars":7}"#]
        {
            let shelf = Shelf(Rc::new(RefCell::new(Some(text.to_owned()))));
            assert!(!Remembered::of(Box::new(shelf)).has_stars(), "{text}");
        }
        let newer = r#"{"version":2,"stars":{"a":3}}"#;
        let shelf = Shelf(Rc::new(RefCell::new(Some(newer.to_owned()))));
        let mut older = Remembered::of(Box::new(shelf.clone()));
        older.won("b", 1);
        assert!(older.forgets());
        assert_eq!(shelf.kept().as_deref(), Some(newer), "a newer program's stars are not lost");
        struct Refused;
        impl Keeper for Refused {
            fn kept(&self) -> Option<String> {
                None
            }

            fn keep(&self, _: &str) -> bool {
                false
            }
        }
        let mut here = Remembered::of(Box::new(Refused));
        assert!(!here.forgets(), "nothing was to be kept yet");
        here.won("a", 3);
        assert_eq!(here.stars("a"), Some(3));
        assert!(here.forgets());
        let mut nowhere = Remembered::default();
        nowhere.won("a", 1);
        assert!(!nowhere.forgets(), "a console that was given no place promises nothing");
    }
}
