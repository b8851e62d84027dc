use super::*;

/// A catalogue in use until it goes.
struct Use;

impl Use {
    fn of(language: Language) -> Self {
        choose(language);
        Self
    }
}

impl Drop for Use {
    fn drop(&mut self) {
        choose(Language::English);
    }
}

#[test]
fn tags_of_systems_and_browsers_choose_a_language() {
    for (tag, language) in [
        ("sl", Some(Language::Slovenian)),
        ("sl-SI", Some(Language::Slovenian)),
        ("de_AT.UTF-8", Some(Language::German)),
        ("DE", Some(Language::German)),
        ("en-GB", Some(Language::English)),
        ("fr-FR", None),
        ("C", None),
        ("", None),
    ] {
        assert_eq!(Language::of_tag(tag), language, "{tag}");
    }
}

#[test]
fn keys_are_words_with_the_names_of_their_values() {
    assert_eq!(plain_words("from {a:.1} to {b:+.2} %"), "from {a} to {b} %");
    assert_eq!(placeholders("from {a:.1} to {b:+.2} %"), ["a", "b"]);
    assert_eq!(plain_words("{{x}} is {x}"), "{x} is {x}");
    assert_eq!(plain_words("nothing before }, nor after {µ"), "nothing before }, nor after {µ");
}

#[test]
fn english_is_what_the_program_says() {
    assert_eq!(chosen(), Language::English);
    assert_eq!(tr("no catalogue has this text"), "no catalogue has this text");
    assert_eq!(tr!("computed to {share:.1} %", share = 12.34), "computed to 12.3 %");
    assert_eq!(fixed(0.25, 2), "0.25");
}

#[test]
fn what_no_catalogue_has_stays_english_with_the_numbers_of_the_language() {
    let _use = Use::of(Language::German);
    assert_eq!(chosen(), Language::German);
    assert_eq!(tr("no catalogue has this text"), "no catalogue has this text");
    let text =
        tr!("no catalogue has {share:+.1} of {n} {what}", share = 12.34, n = 3, what = "words");
    assert_eq!(text, "no catalogue has +12,3 of 3 words");
    assert_eq!(fixed(-0.25, 2), "-0,25");
}

#[test]
fn what_is_made_for_a_file_is_english_and_the_language_stays() {
    let _use = Use::of(Language::Slovenian);
    assert_eq!([in_english(|| fixed(0.5, 2)), fixed(0.5, 2)], ["0.50", "0,50"]);
    assert_eq!(in_english(chosen), Language::English);
    assert_eq!(chosen(), Language::Slovenian);
}
