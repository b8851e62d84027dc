//! Regular two-level fractions: generators, defining relation, resolution, aliases.
//!
//! Factors have letters, A the first one. A generator says which product of others one of them is set by, D=ABC
//! or D=-ABC; all products of generators make the defining relation, whose shortest word is the resolution. Two
//! effects are aliased where their product is one of its words (Box, Hunter and Hunter, Statistics for
//! experimenters, ch. 6).

use serde::Serialize;

/// Letters of the factors.
pub const LETTERS: [char; 7] = ['A', 'B', 'C', 'D', 'E', 'F', 'G'];

/// Generators of the minimum aberration fractions of 3 to 7 factors (Box, Hunter and Hunter, table 6.22): number of factors, number of generators, the generators.
const STANDARD: [(usize, usize, &str); 11] = [
    (3, 1, "C=AB"),
    (4, 1, "D=ABC"),
    (5, 1, "E=ABCD"),
    (5, 2, "D=AB,E=AC"),
    (6, 1, "F=ABCDE"),
    (6, 2, "E=ABC,F=BCD"),
    (6, 3, "D=AB,E=AC,F=BC"),
    (7, 1, "G=ABCDEF"),
    (7, 2, "F=ABCD,G=ABDE"),
    (7, 3, "E=ABC,F=BCD,G=ACD"),
    (7, 4, "D=AB,E=AC,F=BC,G=ABC"),
];

/// A product of factors with a sign: bit 0 is A.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct EffectWord {
    /// The factors.
    pub factors: u32,
    /// Whether it has a minus sign.
    pub negative: bool,
}

impl EffectWord {
    /// Number of its factors.
    #[must_use]
    pub fn order(self) -> u32 {
        self.factors.count_ones()
    }

    /// The product of two.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self { factors: self.factors ^ other.factors, negative: self.negative ^ other.negative }
    }
}

impl std::fmt::Display for EffectWord {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.negative {
            f.write_str("-")?;
        }
        if self.factors == 0 {
            return f.write_str("I");
        }
        let letters = LETTERS.iter().enumerate().filter(|(i, _)| self.factors >> i & 1 == 1);
        letters.map(|(_, letter)| letter.to_string()).collect::<String>().fmt(f)
    }
}

impl Serialize for EffectWord {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// A regular fraction of the two-level designs of some factors.
#[derive(Clone, Debug, PartialEq)]
pub struct RegularFraction {
    count: usize,
    /// The factor set by each generator, and the product that sets it.
    generators: Vec<(usize, EffectWord)>,
}

/// Effects that a fraction does not tell apart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AliasSet {
    /// The first is one of the least order; each of the others is mixed up with it.
    pub effects: Vec<EffectWord>,
}

impl std::fmt::Display for AliasSet {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let all: Vec<String> = self.effects.iter().map(EffectWord::to_string).collect();
        f.write_str(&all.join(" = "))
    }
}

fn letters(count: usize) -> String {
    LETTERS[..count].iter().map(char::to_string).collect::<Vec<_>>().join(", ")
}

fn letter(c: char, count: usize) -> Result<usize, String> {
    let place = LETTERS[..count].iter().position(|letter| *letter == c.to_ascii_uppercase());
    place.ok_or_else(|| format!("`{c}` is no factor: the factors are {}", letters(count)))
}

impl RegularFraction {
    /// The full two-level design of some factors.
    ///
    /// # Errors
    /// More factors than letters.
    pub fn full(count: usize) -> Result<Self, String> {
        if count > LETTERS.len() {
            return Err(format!("{count} factors: allowed are at most {}", LETTERS.len()));
        }
        Ok(Self { count, generators: Vec::new() })
    }

    /// The fraction of `count` factors with `generators`, for example D=ABC.
    ///
    /// # Errors
    /// Says which generator does not do, and what is allowed.
    pub fn new(count: usize, generators: &[impl AsRef<str>]) -> Result<Self, String> {
        let mut fraction = Self::full(count)?;
        for text in generators {
            let text = text.as_ref();
            let generator = fraction.generator(text);
            let generator = generator.map_err(|problem| format!("generator {text}: {problem}"))?;
            fraction.generators.push(generator);
        }
        let set: u32 = fraction.generators.iter().map(|(factor, _)| 1_u32 << factor).sum();
        for ((factor, word), text) in fraction.generators.iter().zip(generators) {
            if word.factors & set != 0 {
                let (text, letter) = (text.as_ref(), LETTERS[*factor]);
                return Err(format!(
                    "generator {text}: `{letter}` can be set only by factors that no generator sets"
                ));
            }
        }
        Ok(fraction)
    }

    /// The minimum aberration fraction of `count` factors with 2^(count - dropped) runs.
    ///
    /// # Errors
    /// There is none; names what there is.
    pub fn standard(count: usize, dropped: usize) -> Result<Self, String> {
        if dropped == 0 {
            return Self::full(count);
        }
        let found = STANDARD.iter().find(|(n, p, _)| (*n, *p) == (count, dropped));
        let Some((.., text)) = found else {
            let of: Vec<String> = STANDARD
                .iter()
                .filter(|(n, ..)| *n == count)
                .map(|(_, p, _)| p.to_string())
                .collect();
            let of = if of.is_empty() { "none".to_owned() } else { of.join(", ") };
            return Err(format!(
                "2^({count}-{dropped}) is no fraction that is known: for {count} factors there is {of}"
            ));
        };
        let generators: Vec<&str> = text.split(',').collect();
        Self::new(count, &generators)
    }

    fn generator(&self, text: &str) -> Result<(usize, EffectWord), String> {
        let (left, right) = text.split_once('=').ok_or("allowed is D=ABC or D=-ABC")?;
        let mut left = left.trim().chars();
        let (Some(c), None) = (left.next(), left.next()) else {
            return Err("one factor stands on the left, as in D=ABC".to_owned());
        };
        let factor = letter(c, self.count)?;
        if self.generators.iter().any(|(other, _)| *other == factor) {
            return Err(format!("`{}` is set twice", LETTERS[factor]));
        }
        let right = right.trim();
        let (negative, right) = match right.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, right),
        };
        let mut factors = 0;
        for c in right.chars() {
            let bit = 1 << letter(c, self.count)?;
            if factors & bit != 0 {
                return Err(format!("`{c}` stands there twice"));
            }
            factors |= bit;
        }
        if factors == 0 || factors >> factor & 1 == 1 {
            return Err("other factors stand on the right, as in D=ABC".to_owned());
        }
        Ok((factor, EffectWord { factors, negative }))
    }

    /// Number of runs.
    #[must_use]
    pub fn runs(&self) -> usize {
        1 << (self.count - self.generators.len())
    }

    /// The runs in standard order, every factor at -1 or 1, the first one fastest.
    #[must_use]
    pub fn points(&self) -> Vec<Vec<f64>> {
        let is_set = |factor: usize| self.generators.iter().any(|(other, _)| *other == factor);
        let free: Vec<usize> = (0..self.count).filter(|factor| !is_set(*factor)).collect();
        let point = |run: usize| {
            let mut point = vec![0.0; self.count];
            for (bit, factor) in free.iter().enumerate() {
                point[*factor] = if run >> bit & 1 == 1 { 1.0 } else { -1.0 };
            }
            for (factor, word) in &self.generators {
                let parts = (0..self.count).filter(|i| word.factors >> i & 1 == 1);
                let product: f64 = parts.map(|i| point[i]).product();
                point[*factor] = if word.negative { -product } else { product };
            }
            point
        };
        (0..self.runs()).map(point).collect()
    }

    /// The words of the defining relation, the shortest first; none of a full design.
    #[must_use]
    pub fn defining(&self) -> Vec<EffectWord> {
        let mut words: Vec<EffectWord> = vec![EffectWord { factors: 0, negative: false }];
        for (factor, word) in &self.generators {
            let generator = EffectWord { factors: word.factors | 1 << factor, ..*word };
            let products: Vec<EffectWord> =
                words.iter().map(|word| word.times(generator)).collect();
            words.extend(products);
        }
        words.retain(|word| word.factors != 0);
        words.sort_by_key(|word| (word.order(), word.factors));
        words
    }

    /// The length of the shortest word; none of a full design.
    #[must_use]
    pub fn resolution(&self) -> Option<u32> {
        self.defining().first().map(|word| word.order())
    }

    /// Sets of main effects and interactions of two factors that are not told apart.
    #[must_use]
    pub fn aliases(&self) -> Vec<AliasSet> {
        let words = self.defining();
        let mut effects: Vec<EffectWord> = (1..1_u32 << self.count)
            .map(|factors| EffectWord { factors, negative: false })
            .filter(|effect| effect.order() <= 2)
            .collect();
        effects.sort_by_key(|effect| (effect.order(), effect.factors));
        let mut sets = Vec::new();
        let mut known: Vec<u32> = Vec::new();
        for effect in &effects {
            if known.contains(&effect.factors) {
                continue;
            }
            let mut mixed: Vec<EffectWord> = words.iter().map(|word| effect.times(*word)).collect();
            mixed.retain(|other| (1..=2).contains(&other.order()));
            mixed.sort_by_key(|other| (other.order(), other.factors));
            known.extend(mixed.iter().map(|other| other.factors));
            if !mixed.is_empty() {
                let effects = std::iter::once(*effect).chain(mixed).collect();
                sets.push(AliasSet { effects });
            }
        }
        sets
    }
}

/// A resolution as it is written: III, IV, V.
#[must_use]
pub fn roman(resolution: u32) -> String {
    ["I", "II", "III", "IV", "V", "VI", "VII"]
        .get(resolution.saturating_sub(1) as usize)
        .map_or_else(|| resolution.to_string(), |&text| text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(fraction: &RegularFraction) -> (Vec<String>, Option<u32>, Vec<String>) {
        let words = fraction.defining().iter().map(EffectWord::to_string).collect();
        let aliases = fraction.aliases().iter().map(AliasSet::to_string).collect();
        (words, fraction.resolution(), aliases)
    }

    /// Box, Hunter and Hunter, section 6.3; Montgomery, Design and analysis of experiments, table 8.3.
    #[test]
    fn the_half_of_four_factors_has_resolution_four_and_three_pairs() {
        let half = RegularFraction::new(4, &["D=ABC"]).unwrap();
        let (words, resolution, aliases) = told(&half);
        assert_eq!((words, resolution), (vec!["ABCD".to_owned()], Some(4)));
        assert_eq!(aliases, ["AB = CD", "AC = BD", "BC = AD"]);
        assert_eq!((half.runs(), half.points().len()), (8, 8));
        assert_eq!(half, RegularFraction::standard(4, 1).unwrap());
    }

    /// Montgomery, table 8.11: I = ABD = ACE = BCDE.
    #[test]
    fn the_quarter_of_five_factors_has_resolution_three() {
        let (words, resolution, aliases) = told(&RegularFraction::standard(5, 2).unwrap());
        assert_eq!((words, resolution), (vec!["ABD".into(), "ACE".into(), "BCDE".into()], Some(3)));
        assert_eq!(
            aliases,
            ["A = BD = CE", "B = AD", "C = AE", "D = AB", "E = AC", "BC = DE", "CD = BE"]
        );
    }

    /// Resolutions of the standard fractions: Montgomery, table 8.14.
    #[test]
    fn standard_fractions_have_the_resolutions_of_the_textbook() {
        let resolutions = [3, 4, 5, 3, 6, 4, 3, 7, 4, 4, 3];
        for ((count, dropped, _), expected) in STANDARD.iter().zip(resolutions) {
            let fraction = RegularFraction::standard(*count, *dropped).unwrap();
            assert_eq!(fraction.resolution(), Some(expected), "2^({count}-{dropped})");
            assert_eq!(fraction.runs(), 1 << (count - dropped));
        }
    }

    /// The words against the columns themselves: a word is one whose product is the same in all runs.
    #[test]
    fn words_are_the_products_that_are_constant_over_the_runs() {
        for (count, dropped, _) in STANDARD {
            let fraction = RegularFraction::standard(count, dropped).unwrap();
            let points = fraction.points();
            let words = fraction.defining();
            for factors in 1..1_u32 << count {
                let product = |point: &Vec<f64>| {
                    let parts = (0..count).filter(|i| factors >> i & 1 == 1);
                    parts.map(|i| point[i]).product::<f64>()
                };
                let sum: f64 = points.iter().map(product).sum();
                let word = words.iter().find(|word| word.factors == factors);
                let expected = word.map_or(0.0, |word| if word.negative { -1.0 } else { 1.0 });
                assert_eq!(sum / points.len() as f64, expected, "{factors:b}");
            }
        }
    }

    #[test]
    fn signs_go_through_to_the_aliases() {
        let half = RegularFraction::new(3, &["C=-AB"]).unwrap();
        let (words, resolution, aliases) = told(&half);
        assert_eq!((words, resolution), (vec!["-ABC".to_owned()], Some(3)));
        assert_eq!(aliases, ["A = -BC", "B = -AC", "C = -AB"]);
        assert!(half.points().iter().all(|point| point[2] == -point[0] * point[1]));
    }

    #[test]
    fn generators_that_do_not_do_are_refused() {
        for (generators, part) in [
            (&["D=ABD"][..], "other factors"),
            (&["D"], "D=ABC"),
            (&["DE=AB"], "one factor"),
            (&["E=AB"], "A, B, C, D"),
            (&["D=AAB"], "twice"),
            (&["D=AB", "D=BC"], "set twice"),
            (&["C=AD", "D=AB"], "no generator sets"),
        ] {
            let error = RegularFraction::new(4, generators).unwrap_err();
            assert!(error.contains("generator") && error.contains(part), "{error}");
        }
        assert!(RegularFraction::standard(4, 2).unwrap_err().contains("there is 1"));
    }
}
