//! Every text that the program shows is in the catalogues, and they have no others. `UPDATE_CATALOGUE=1` writes the
//! English files anew from the program, and takes out of the others what is gone.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr as _;

use fluent_syntax::ast::{
    Entry, Expression, InlineExpression, Message, Pattern, PatternElement, Resource,
};
use fluent_syntax::{parser, serializer};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use steadycut::base::language::{Catalogue, Language, placeholders, plain_words};

mod tables;

/// A text of the program: its words with the names of its values, and where it stands first.
#[derive(Clone, Debug)]
struct Text {
    words: String,
    has_values: bool,
    place: String,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            if path.file_name().is_none_or(|name| name != "tests" && name != "language") {
                sources(&path, found);
            }
        } else if path.extension().is_some_and(|ending| ending == "rs")
            && path.file_name().is_some_and(|name| name != "tests.rs")
        {
            found.push(path);
        }
    }
}

/// Texts of `tr("…")`, `tr!("…", …)` and `text!("…")` among the tokens, and what is wrong with them.
fn scan(tokens: TokenStream, place: &str, found: &mut Vec<Text>, wrong: &mut Vec<String>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < trees.len() {
        // Tests of the module: what they say is shown to nobody.
        if let [TokenTree::Ident(module), TokenTree::Ident(name), TokenTree::Group(_), ..] =
            &trees[at..]
            && module == "mod"
            && name == "tests"
        {
            at += 3;
            continue;
        }
        if let TokenTree::Ident(ident) = &trees[at] {
            let name = ident.to_string();
            let is_macro =
                matches!(trees.get(at + 1), Some(TokenTree::Punct(p)) if p.as_char() == '!');
            let group = trees.get(at + if is_macro { 2 } else { 1 });
            let named = name == "tr" || (name == "text" && is_macro);
            if named
                && let Some(TokenTree::Group(group)) = group
                && group.delimiter() == Delimiter::Parenthesis
            {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                if let Some(TokenTree::Literal(literal)) = inside.first()
                    && let Ok(text) = syn::parse_str::<syn::LitStr>(&literal.to_string())
                {
                    let text = text.value();
                    let line = ident.span().start().line;
                    let has_values = name == "tr" && is_macro && inside.len() > 2;
                    if has_values {
                        let given: BTreeSet<String> = inside
                            .windows(2)
                            .filter_map(|pair| match pair {
                                [TokenTree::Ident(name), TokenTree::Punct(sign)]
                                    if sign.as_char() == '=' =>
                                {
                                    Some(name.to_string())
                                }
                                _ => None,
                            })
                            .collect();
                        for name in placeholders(&text) {
                            if !given.contains(name) {
                                wrong.push(format!(
                                    "{place}:{line}: {{{name}}} is not among the values of {text:?}"
                                ));
                            }
                        }
                    } else if name == "tr" && is_macro && !placeholders(&text).is_empty() {
                        wrong.push(format!("{place}:{line}: no values for {text:?}"));
                    }
                    let words = if has_values { plain_words(&text) } else { text };
                    found.push(Text { words, has_values, place: place.to_owned() });
                } else if name == "text" {
                    wrong.push(format!("{place}: text! without words"));
                }
            }
        }
        if let TokenTree::Group(group) = &trees[at] {
            scan(group.stream(), place, found, wrong);
        }
        at += 1;
    }
}

/// Labels of the options of every `choice! { … }` among the tokens, and their comments, which are shown as help.
fn options(tokens: TokenStream, place: &str, found: &mut Vec<Text>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for at in 0..trees.len() {
        let TokenTree::Group(group) = &trees[at] else { continue };
        let is_choice = at >= 2
            && matches!(&trees[at - 2], TokenTree::Ident(name) if name == "choice")
            && matches!(&trees[at - 1], TokenTree::Punct(sign) if sign.as_char() == '!');
        if !is_choice {
            options(group.stream(), place, found);
            continue;
        }
        let literal = |tree: &TokenTree| match tree {
            TokenTree::Literal(literal) => {
                syn::parse_str::<syn::LitStr>(&literal.to_string()).ok().map(|text| text.value())
            }
            _ => None,
        };
        let braced = group.stream().into_iter().filter_map(|tree| match tree {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
            _ => None,
        });
        for variants in braced {
            let mut doc = String::new();
            for tree in variants.stream() {
                match &tree {
                    TokenTree::Group(attribute) => {
                        attribute
                            .stream()
                            .into_iter()
                            .filter_map(|tree| literal(&tree))
                            .for_each(|line| doc.push_str(&line));
                    }
                    // The label comes last, behind the id.
                    TokenTree::Literal(_) => {
                        let words = literal(&tree).unwrap();
                        found.push(Text { words, has_values: false, place: place.to_owned() });
                    }
                    TokenTree::Punct(sign) if sign.as_char() == ',' => {
                        found.pop();
                    }
                    TokenTree::Punct(sign) if sign.as_char() == ';' => {
                        let words = std::mem::take(&mut doc).trim_start().to_owned();
                        found.push(Text { words, has_values: false, place: place.to_owned() });
                    }
                    TokenTree::Punct(_) | TokenTree::Ident(_) => {}
                }
            }
        }
    }
}

/// All texts of the program, by the files of the catalogue, each text once.
fn wanted() -> (BTreeMap<&'static str, Vec<Text>>, Vec<String>) {
    let (mut files, mut wrong) = (Vec::new(), Vec::new());
    for folder in
        ["src/app", "src/disk", "crates/core/src", "crates/measured/src", "crates/study/src"]
    {
        sources(&root().join(folder), &mut files);
    }
    let mut all: Vec<(&'static str, Text)> = Vec::new();
    for path in files {
        let place = path.strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/");
        let tokens = TokenStream::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let mut found = Vec::new();
        scan(tokens.clone(), &place, &mut found, &mut wrong);
        if place.starts_with("src/app") {
            options(tokens, &place, &mut found);
        }
        let file = if place.starts_with("crates/core") {
            "core"
        } else if place.starts_with("crates/measured") {
            "measured"
        } else if place.starts_with("crates/study") {
            "study"
        } else if place.starts_with("src/app/panels/")
            && !place.starts_with("src/app/panels/console")
        {
            "screens"
        } else {
            "console"
        };
        all.extend(found.into_iter().map(|text| (file, text)));
    }
    for (file, place, words) in tables::texts() {
        all.push((file, Text { words, has_values: false, place }));
    }
    let mut seen = BTreeMap::new();
    let mut by_file: BTreeMap<&'static str, Vec<Text>> = BTreeMap::new();
    for (file, text) in all {
        if text.words.trim().is_empty() {
            continue;
        }
        match seen.insert(text.words.clone(), text.has_values) {
            None => by_file.entry(file).or_default().push(text),
            Some(had) if had != text.has_values => {
                wrong.push(format!("{}: {:?} with and without values", text.place, text.words));
            }
            Some(_) => {}
        }
    }
    (by_file, wrong)
}

fn path_of(language: Language, file: &str) -> PathBuf {
    root().join("assets/languages").join(language.id()).join(format!("{file}.ftl"))
}

fn parsed(language: Language, file: &str) -> Resource<String> {
    let path = path_of(language, file);
    let text = fs::read_to_string(&path).unwrap_or_default();
    parser::parse(text).unwrap_or_else(|(_, problems)| panic!("{}: {problems:?}", path.display()))
}

fn messages(language: Language, file: &str) -> Vec<Message<String>> {
    let body = parsed(language, file).body.into_iter();
    body.filter_map(|entry| match entry {
        Entry::Message(message) => Some(message),
        _ => None,
    })
    .collect()
}

/// Words as the value of a message in a file.
fn written(text: &Text) -> String {
    let literal = |text: &str| format!("{{ \"{text}\" }}");
    let mut value = String::new();
    let lines: Vec<&str> = text.words.split('\n').collect();
    for (row, line) in lines.iter().enumerate() {
        if row > 0 {
            value.push_str("\n    ");
        }
        let mut rest = *line;
        // Blanks at the ends would be lost, and some signs begin something else there.
        let blanks = rest.len() - rest.trim_start().len();
        if blanks > 0 && row == 0 {
            value.push_str(&literal(&rest[..blanks]));
            rest = &rest[blanks..];
        } else if rest.starts_with(['[', '*', '.']) {
            value.push_str(&literal(&rest[..1]));
            rest = &rest[1..];
        }
        let end = rest.trim_end().len();
        let (middle, tail) = rest.split_at(if row + 1 == lines.len() { end } else { rest.len() });
        let mut in_place = false;
        for sign in middle.chars() {
            match sign {
                '{' if text.has_values => {
                    value.push_str("{ $");
                    in_place = true;
                }
                '}' if in_place => {
                    value.push_str(" }");
                    in_place = false;
                }
                '{' | '}' => value.push_str(&literal(&sign.to_string())),
                sign => value.push(sign),
            }
        }
        if !tail.is_empty() {
            value.push_str(&literal(tail));
        }
    }
    if lines.len() > 1 { format!("\n    {value}") } else { value }
}

/// A name of a message after its first words.
fn named(words: &str, taken: &BTreeSet<String>) -> String {
    let mut slug = String::new();
    for sign in words.chars() {
        match sign.to_ascii_lowercase() {
            letter @ ('a'..='z' | '0'..='9') => slug.push(letter),
            _ if slug.ends_with('-') || slug.is_empty() => {}
            _ => slug.push('-'),
        }
        if slug.len() >= 44 {
            break;
        }
    }
    let slug = slug.trim_matches('-');
    let slug = if slug.starts_with(|c: char| c.is_ascii_lowercase()) {
        slug.to_owned()
    } else {
        format!("t-{slug}").trim_end_matches('-').to_owned()
    };
    if !taken.contains(&slug) {
        return slug;
    }
    (2..).map(|n| format!("{slug}-{n}")).find(|name| !taken.contains(name)).unwrap()
}

fn write_catalogues(wanted: &BTreeMap<&'static str, Vec<Text>>) {
    let known: BTreeMap<(String, bool), String> = Catalogue::sources()
        .iter()
        .map(|source| ((source.words.clone(), source.has_values), source.id.clone()))
        .collect();
    let mut taken: BTreeSet<String> = known.values().cloned().collect();
    let files = Catalogue::FILES;
    let mut kept: BTreeMap<Language, BTreeMap<String, Message<String>>> = BTreeMap::new();
    for language in Language::ALL.iter().copied().filter(|language| *language != Language::English)
    {
        let all = files.iter().flat_map(|file| messages(language, file));
        kept.insert(language, all.map(|message| (message.id.name.clone(), message)).collect());
    }
    for file in files {
        let none = Vec::new();
        let texts = wanted.get(file).unwrap_or(&none);
        let mut english =
            "# Texts of the program, written by its tests: see ARCHITECTURE.md.\n".to_owned();
        let mut others: BTreeMap<Language, String> = BTreeMap::new();
        for language in kept.keys() {
            others.insert(*language, format!("# {}\n", language.label()));
        }
        let mut place = "";
        for text in texts {
            if text.place != place {
                place = &text.place;
                write!(english, "\n## {place}\n\n").unwrap();
                others.values_mut().for_each(|other| write!(other, "\n## {place}\n\n").unwrap());
            }
            let id = known.get(&(text.words.clone(), text.has_values)).cloned();
            let id = id.unwrap_or_else(|| named(&text.words, &taken));
            taken.insert(id.clone());
            writeln!(english, "{id} = {}", written(text)).unwrap();
            for (language, other) in &mut others {
                if let Some(message) = kept[language].get(&id) {
                    let body = vec![Entry::Message(message.clone())];
                    other.push_str(&serializer::serialize(&Resource { body }));
                }
            }
        }
        let end = |text: &str| format!("{}\n", text.trim_end());
        fs::create_dir_all(path_of(Language::English, file).parent().unwrap()).unwrap();
        fs::write(path_of(Language::English, file), end(&english)).unwrap();
        for (language, other) in others {
            fs::write(path_of(language, file), end(&other)).unwrap();
        }
    }
}

#[test]
fn the_english_catalogue_has_every_text_of_the_program_and_no_other() {
    let (wanted, wrong) = wanted();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    if std::env::var_os("UPDATE_CATALOGUE").is_some() {
        write_catalogues(&wanted);
        return;
    }
    let mut has: BTreeSet<(&str, bool)> = Catalogue::sources()
        .iter()
        .map(|source| (source.words.as_str(), source.has_values))
        .collect();
    let mut missing = Vec::new();
    for text in wanted.values().flatten() {
        if !has.remove(&(text.words.as_str(), text.has_values)) {
            missing.push(format!("{}: {:?}", text.place, text.words));
        }
    }
    assert!(
        missing.is_empty() && has.is_empty(),
        "UPDATE_CATALOGUE=1 writes it anew; missing:\n{}\nno text any more:\n{has:?}",
        missing.join("\n")
    );
}

/// Names of the values in a message, in all its variants.
fn values_in(pattern: &Pattern<String>, found: &mut BTreeSet<String>) {
    for element in &pattern.elements {
        let PatternElement::Placeable { expression } = element else { continue };
        let inline = match expression {
            Expression::Inline(inline) => inline,
            Expression::Select { selector, variants } => {
                variants.iter().for_each(|variant| values_in(&variant.value, found));
                selector
            }
        };
        if let InlineExpression::VariableReference { id } = inline {
            found.insert(id.name.clone());
        }
    }
}

#[test]
fn every_language_has_every_text_with_its_values() {
    let mut wrong = Vec::new();
    let english: BTreeMap<String, (&str, BTreeSet<String>)> = Catalogue::FILES
        .iter()
        .flat_map(|file| {
            messages(Language::English, file).into_iter().map(move |message| (*file, message))
        })
        .map(|(file, message)| {
            let mut values = BTreeSet::new();
            values_in(message.value.as_ref().unwrap(), &mut values);
            (message.id.name, (file, values))
        })
        .collect();
    for language in Language::ALL.iter().copied().filter(|language| *language != Language::English)
    {
        let mut missing = english.clone();
        for file in Catalogue::FILES.iter().copied() {
            for message in messages(language, file) {
                let id = message.id.name;
                let Some((of, values)) = missing.remove(&id) else {
                    wrong.push(format!(
                        "{}/{file}: {id} is no text of the program, or there twice",
                        language.id()
                    ));
                    continue;
                };
                if of != file {
                    wrong.push(format!("{}/{file}: {id} belongs to {of}", language.id()));
                }
                let mut has = BTreeSet::new();
                message.value.iter().for_each(|pattern| values_in(pattern, &mut has));
                if has != values {
                    wrong.push(format!(
                        "{}/{file}: {id} has {has:?} where English has {values:?}",
                        language.id()
                    ));
                }
            }
        }
        wrong.extend(
            missing.into_iter().map(|(id, (file, _))| format!("{}/{file}: no {id}", language.id())),
        );
    }
    assert!(wrong.is_empty(), "{} of them:\n{}", wrong.len(), wrong.join("\n"));
}
