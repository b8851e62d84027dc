//! The machine that reads a program line by line: its modes, and where its tool is.

use super::arc::{GCodeArc, Given};
use super::words::{Word, words};
use super::{GCodeMove, GCodeProgram, NotFollowed};
use crate::base::language::tr;

/// Millimetres of an inch.
const INCH_MM: f64 = 25.4;
/// Most lines that are read: more is no program of one part.
const MOST_LINES: usize = 1_000_000;

/// What a G-code does, by its number in tenths.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Does {
    Motion(Motion),
    Unit(f64),
    Absolute(bool),
    /// The mode that holds here anyway.
    Nothing,
    /// Goes to a place that only the machine knows.
    Away,
    /// Changes where the tool goes in a way that is not followed.
    Refused,
    /// Is told and not acted on.
    Told,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Motion {
    Rapid,
    Straight,
    Clockwise,
    Counterclockwise,
}

fn meaning(tenths: i64) -> Does {
    match tenths {
        0 => Does::Motion(Motion::Rapid),
        10 => Does::Motion(Motion::Straight),
        20 => Does::Motion(Motion::Clockwise),
        30 => Does::Motion(Motion::Counterclockwise),
        170 | 911 => Does::Nothing,
        200 => Does::Unit(INCH_MM),
        210 => Does::Unit(1.0),
        900 => Does::Absolute(true),
        910 => Does::Absolute(false),
        280 | 300 | 530 => Does::Away,
        // Splines, polar places, other planes, offsets, compensation, scale, rotation, cycles, other centres, feeds.
        50
        | 51
        | 52
        | 60
        | 70
        | 71
        | 100
        | 151
        | 160
        | 161
        | 180
        | 190
        | 281
        | 301
        | 310
        | 380..=389
        | 410..=429
        | 500
        | 510
        | 511
        | 520
        | 680
        | 690
        | 720..=769
        | 810..=899
        | 901
        | 920..=923
        | 930
        | 950 => Does::Refused,
        // Other systems of coordinates than the first one.
        550..=599 => Does::Refused,
        _ => Does::Told,
    }
}

/// The machine.
struct Machine {
    motion: Option<Motion>,
    unit_mm: f64,
    absolute: bool,
    feed_mm_min: Option<f64>,
    speed_rpm: Option<f64>,
    /// Where the tool's tip is, as far as it is known, mm.
    at_mm: [Option<f64>; 3],
    program: GCodeProgram,
}

/// What a line says.
#[derive(Default)]
struct Said {
    /// X, Y, Z; I, J; R.
    axes: [Option<f64>; 3],
    offsets: [Option<f64>; 2],
    radius: Option<f64>,
    /// The motion, where the line names one.
    motion: Option<Motion>,
    away: bool,
    over: bool,
}

/// See [`GCodeProgram::read`].
pub(super) fn read(text: &str) -> Result<GCodeProgram, String> {
    let mut machine = Machine {
        motion: None,
        unit_mm: 1.0,
        absolute: true,
        feed_mm_min: None,
        speed_rpm: None,
        at_mm: [None; 3],
        program: GCodeProgram::default(),
    };
    let mut lines = text.lines().enumerate();
    for (i, line) in &mut lines {
        let number = i + 1;
        let told =
            |problem: String| tr!("line {line}: {problem}", line = number, problem = problem);
        if number > MOST_LINES {
            return Err(told(tr!("at most {n} lines are read", n = MOST_LINES)));
        }
        let said = words(line).and_then(|words| machine.line(number, &words)).map_err(told)?;
        if said {
            break;
        }
    }
    let rest = lines.filter(|(_, line)| !["", "%"].contains(&line.trim()));
    machine.program.left_out = rest.count();
    Ok(machine.program)
}

/// Sets what a line says once.
fn once(place: &mut Option<f64>, word: Word) -> Result<(), String> {
    match place.replace(word.value) {
        None => Ok(()),
        Some(_) => Err(tr!("`{letter}` stands there twice", letter = word.letter)),
    }
}

impl Machine {
    /// Does what a line says; whether the program is over.
    fn line(&mut self, number: usize, words: &[Word]) -> Result<bool, String> {
        let mut said = Said::default();
        // Modes hold for their line wherever they stand in it.
        for word in words.iter().filter(|word| word.letter == 'G') {
            self.mode(number, *word, &mut said)?;
        }
        for word in words {
            self.word(number, *word, &mut said)?;
        }
        if said.away {
            self.go_away(&said);
        } else {
            self.go(number, &said)?;
        }
        Ok(said.over)
    }

    fn mode(&mut self, number: usize, word: Word, said: &mut Said) -> Result<(), String> {
        match word.tenths().map_or(Does::Told, meaning) {
            Does::Motion(motion) => match said.motion.replace(motion) {
                Some(other) if other != motion => {
                    return Err(tr("two kinds of motion in one line").to_owned());
                }
                Some(_) | None => self.motion = Some(motion),
            },
            Does::Unit(unit_mm) => self.unit_mm = unit_mm,
            Does::Absolute(absolute) => self.absolute = absolute,
            Does::Nothing => {}
            Does::Away => {
                said.away = true;
                self.tell(number, word.text());
            }
            Does::Refused => {
                return Err(tr!(
                    "{word} changes where the tool goes in a way that is not followed",
                    word = word.text()
                ));
            }
            Does::Told => self.tell(number, word.text()),
        }
        Ok(())
    }

    fn word(&mut self, number: usize, word: Word, said: &mut Said) -> Result<(), String> {
        match word.letter {
            'X' => once(&mut said.axes[0], word)?,
            'Y' => once(&mut said.axes[1], word)?,
            'Z' => once(&mut said.axes[2], word)?,
            'I' => once(&mut said.offsets[0], word)?,
            'J' => once(&mut said.offsets[1], word)?,
            'R' => once(&mut said.radius, word)?,
            'F' | 'S' if word.value < 0.0 => {
                return Err(tr!("{word}: allowed is 0 or more", word = word.text()));
            }
            'F' => self.feed_mm_min = Some(word.value * self.unit_mm),
            'S' => self.speed_rpm = Some(word.value),
            // G was looked at before; N numbers lines.
            'G' | 'N' => {}
            'M' => match word.tenths() {
                Some(20 | 300) => said.over = true,
                Some(980 | 990) => {
                    return Err(tr!("{word}: subprograms are not followed", word = word.text()));
                }
                Some(_) | None => self.tell(number, word.text()),
            },
            'A' | 'B' | 'C' | 'E' | 'K' | 'U' | 'V' | 'W' => {
                return Err(tr!(
                    "{word}: only X, Y, Z, I, J and R say where the tool goes",
                    word = word.text()
                ));
            }
            'O' => {
                return Err(tr!("{word}: subprograms are not followed", word = word.text()));
            }
            letter => self.tell(number, letter.to_string()),
        }
        Ok(())
    }

    fn tell(&mut self, line: usize, word: String) {
        let all = &mut self.program.not_followed;
        match all.iter_mut().find(|told| told.word == word) {
            Some(told) => told.lines.push(line),
            None => all.push(NotFollowed { word, lines: vec![line] }),
        }
    }

    /// The axes of a line, or all of them, are at a place that only the machine knows.
    fn go_away(&mut self, said: &Said) {
        let all = said.axes.iter().all(Option::is_none);
        for (at, axis) in self.at_mm.iter_mut().zip(said.axes) {
            if all || axis.is_some() {
                *at = None;
            }
        }
    }

    /// Where the axes of a line go; none where that is not known.
    fn target(&self, said: &Said) -> Result<[Option<f64>; 3], String> {
        let mut to = self.at_mm;
        for (i, axis) in said.axes.into_iter().enumerate() {
            let Some(value) = axis.map(|value| value * self.unit_mm) else { continue };
            to[i] = Some(match (self.absolute, self.at_mm[i]) {
                (true, _) => value,
                (false, Some(at)) => at + value,
                (false, None) => {
                    return Err(tr!(
                        "`{axis}` is relative, and where the tool is along it is not known",
                        axis = ['X', 'Y', 'Z'][i]
                    ));
                }
            });
        }
        Ok(to)
    }

    /// Goes where a line says.
    fn go(&mut self, number: usize, said: &Said) -> Result<(), String> {
        let is_arc = said.offsets.iter().chain([&said.radius]).any(Option::is_some);
        let moves = said.axes.iter().any(Option::is_some) || is_arc;
        if !moves {
            return Ok(());
        }
        let Some(motion) = self.motion else {
            return Err(tr("a place without a motion: G0, G1, G2 or G3 comes first").to_owned());
        };
        let to = self.target(said)?;
        let places = [self.at_mm, to].map(|at| match at {
            [Some(x), Some(y), Some(z)] => Some([x, y, z]),
            _ => None,
        });
        let rapid = motion == Motion::Rapid;
        let [Some(from), Some(end)] = places else {
            if rapid {
                self.at_mm = to;
                return Ok(());
            }
            return Err(tr(
                "a feed move from a place that is not known: rapid moves to X, Y and Z come first",
            )
            .to_owned());
        };
        let arc = self.arc(motion, is_arc, said, [from, end])?;
        self.at_mm = to;
        if from == end && arc.is_none() {
            return Ok(());
        }
        let (feed_mm_min, speed_rpm) = (self.feed_mm_min, self.speed_rpm);
        let ends_mm = [from, end];
        self.program.moves.push(GCodeMove {
            line: number,
            rapid,
            ends_mm,
            arc,
            feed_mm_min,
            speed_rpm,
        });
        Ok(())
    }

    fn arc(
        &self,
        motion: Motion,
        is_arc: bool,
        said: &Said,
        [from, to]: [[f64; 3]; 2],
    ) -> Result<Option<GCodeArc>, String> {
        let clockwise = match motion {
            Motion::Rapid | Motion::Straight if is_arc => {
                return Err(tr("I, J and R belong to arcs, G2 and G3").to_owned());
            }
            Motion::Rapid | Motion::Straight => return Ok(None),
            Motion::Clockwise => true,
            Motion::Counterclockwise => false,
        };
        let given = match (said.radius, said.offsets) {
            (Some(radius), [None, None]) => Given::Radius(radius * self.unit_mm),
            (Some(_), _) => {
                return Err(tr("an arc has I and J, or R, not both").to_owned());
            }
            (None, [None, None]) => {
                return Err(tr("an arc without I, J or R").to_owned());
            }
            (None, offsets) => Given::Centre(offsets.map(|x| x.unwrap_or(0.0) * self.unit_mm)),
        };
        let [start, end] = [from, to].map(|at| [at[0], at[1]]);
        GCodeArc::new(start, end, clockwise, given).map(Some)
    }
}
