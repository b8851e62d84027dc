//! What a console opens with: a cut, a mission, what of the program is shown. A link says all of it behind `#`:
//! `embed=hide:files&mission=quiet-speed&v=1&...`; the flags may stand behind `?` as well.

mod frame;

pub use frame::{EMBED, Frame, FramePart};

use crate::base::language::tr;
use crate::mission::{Mission, MissionAnswer, of_link};
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::{Start, presets, scenario_link};

/// See the head of the module.
#[derive(Clone, Debug)]
pub struct Opening {
    /// The cut.
    pub start: Start,
    /// The mission that begins.
    pub mission: Option<LinkedMission>,
    /// What is shown.
    pub frame: Frame,
    /// Why the cut of a link is not open, where that is so.
    pub unread: Option<String>,
    /// What else of a link was not used, and why.
    pub problems: Vec<String>,
}

/// A mission that a link holds.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkedMission {
    /// The mission.
    pub mission: Mission,
    /// Its cut, with what the learner has changed of it.
    pub cut: (Scenario, Edits),
}

/// What a learning platform adds to an address to open a package: who learns, and the key to the store of records.
const OF_A_LAUNCH: [&str; 9] = [
    "actor",
    "activity_id",
    "activity_platform",
    "auth",
    "content_endpoint",
    "content_token",
    "endpoint",
    "grouping",
    "registration",
];

/// An address as it may be given to others: without its part from `#` on, and without what a learning platform has
/// added for one learner.
#[must_use]
pub fn page_to_share(address: &str) -> String {
    let page = address.split('#').next().unwrap_or_default();
    let Some((page, query)) = page.split_once('?') else { return page.to_owned() };
    let is_kept = |part: &&str| {
        let name = part.split('=').next().unwrap_or_default();
        !OF_A_LAUNCH.iter().any(|one| name.eq_ignore_ascii_case(one))
    };
    let kept: Vec<&str> = query.split('&').filter(is_kept).collect();
    if kept.is_empty() { page.to_owned() } else { format!("{page}?{}", kept.join("&")) }
}

impl Opening {
    /// A cut, and nothing else.
    #[must_use]
    pub fn of_cut(scenario: Scenario, edits: Edits) -> Self {
        Self {
            start: Start { scenario, edits, notice: None },
            mission: None,
            frame: Frame::default(),
            unread: None,
            problems: Vec::new(),
        }
    }

    /// The first shipped scenario.
    #[must_use]
    pub fn usual() -> Self {
        let first = presets::load(presets::PRESETS[0].name).unwrap_or_default();
        Self::of_cut(first, Edits::none())
    }

    /// What a link opens: an address, or its part from `#` on. What cannot be used is told, and the rest is obeyed.
    #[must_use]
    pub fn of_link(link: &str) -> Self {
        let mut opening = Self::usual();
        let (page, fragment) = link.split_once('#').unwrap_or(match link.contains("://") {
            true => (link, ""),
            false => ("", link),
        });
        let fragment = fragment.replace("&amp;", "&");
        let query = page.split_once('?').map_or("", |(_, query)| query);
        for flags in query.split('&').filter_map(|part| part.strip_prefix(EMBED)) {
            opening.take_flags(flags);
        }
        let (mut mission, mut cut) = (None, Vec::new());
        for part in fragment.split('&').filter(|part| !part.is_empty()) {
            if let Some(flags) = part.strip_prefix(EMBED) {
                opening.take_flags(flags);
            } else if let Some(read) = of_link(part) {
                match read {
                    Ok(read) => mission = Some(read),
                    Err(error) => opening.problems.push(error.to_string()),
                }
            } else {
                cut.push(part);
            }
        }
        let cut = (!cut.is_empty()).then(|| scenario_link::parse(&cut.join("&")));
        match (mission, cut) {
            (Some(mission), cut) => opening.begin(mission, cut.transpose()),
            (None, Some(Ok((scenario, edits)))) => {
                (opening.start.scenario, opening.start.edits) = (scenario, edits);
            }
            (None, Some(Err(error))) => {
                let name = &opening.start.scenario.info.name;
                let title = presets::title(name).unwrap_or(name);
                opening.start.notice = Some(tr!(
                    "The link was not used, \u{201c}{title}\u{201d} is open instead. {error}",
                    title = tr(title),
                    error = error.to_string()
                ));
                opening.unread = Some(error.to_string());
            }
            (None, None) => {}
        }
        opening
    }

    fn take_flags(&mut self, flags: &str) {
        match scenario_link::decode(&scenario_link::mended(flags)) {
            Ok(flags) => self.problems.extend(self.frame.take(&flags)),
            Err(error) => self.problems.push(tr!("embed: {error}", error = error.to_string())),
        }
    }

    /// Begins a mission with the learner's cut, if there is one that fits.
    fn begin<E: std::fmt::Display>(
        &mut self,
        mission: Mission,
        cut: Result<Option<(Scenario, Edits)>, E>,
    ) {
        let given = || (mission.scenario.clone(), mission.edits.clone());
        let fitting = cut.map_err(|error| error.to_string()).and_then(|cut| {
            let Some((scenario, edits)) = cut else { return Ok(given()) };
            let answer = MissionAnswer { scenario, edits, ..MissionAnswer::untouched(&mission) };
            answer.check(&mission).map_err(|error| error.to_string())?;
            Ok((answer.scenario, answer.edits))
        });
        let cut = fitting.unwrap_or_else(|problem| {
            let title = &mission.title;
            self.problems.push(tr!(
                "The mission \u{201c}{title}\u{201d} begins anew: the cut of the link was not used. {problem}",
                title = tr(title),
                problem = problem
            ));
            given()
        });
        self.mission = Some(LinkedMission { mission, cut });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::mission::{TEMPLATE, shipped};

    fn target_um(opening: &Opening) -> f64 {
        opening.start.scenario.target.ra_um
    }

    #[test]
    fn a_link_opens_its_cut_with_its_flags_wherever_they_stand() {
        for link in [
            "https://a.org/x/?embed=hide:bar&utm_source=mail#v=1&target.ra_um=0.6",
            "https://a.org/x/#embed=hide:bar&v=1&target.ra_um=0.6",
            "#v=1&target.ra_um=0.6&embed=hide%3Abar",
            "v=1&amp;target.ra_um=0.6&amp;embed=hide:bar.",
        ] {
            let opening = Opening::of_link(link);
            assert_eq!(opening.problems, [""; 0], "{link}");
            assert_eq!(target_um(&opening), 0.6, "{link}");
            assert!(opening.frame.hides(FramePart::Bar), "{link}");
            assert!(opening.mission.is_none());
        }
        for nothing in ["", "#", "https://a.org/x/", "https://a.org/?v=2"] {
            let opening = Opening::of_link(nothing);
            assert_eq!(opening.start.scenario, Opening::usual().start.scenario, "{nothing}");
            assert_eq!(opening.problems, [""; 0]);
        }
    }

    #[test]
    fn a_link_opens_a_mission_with_what_the_learner_has_changed() {
        let mission = shipped::load("depth-step-at-constant-feed").unwrap();
        let opened = |link: &str| {
            let opening = Opening::of_link(link);
            (opening.mission.expect("a mission"), opening.problems)
        };
        let (found, problems) = opened("#mission=depth-step-at-constant-feed");
        assert_eq!((&found.mission, problems.len()), (&mission, 0));
        assert_eq!(found.cut, (mission.scenario.clone(), mission.edits.clone()));
        let mut own = mission.scenario.clone();
        own.set("controller.kind", Value::Text("tracking".to_owned())).unwrap();
        let link =
            format!("#mission={}&{}", mission.id, scenario_link::write(&own, &mission.edits));
        let (found, problems) = opened(&link);
        assert_eq!((found.cut.0, problems.len()), (own.clone(), 0));
        // What the mission does not open is not taken from a link.
        own.set("target.ra_um", Value::Float(2.0)).unwrap();
        let link =
            format!("#mission={}&{}", mission.id, scenario_link::write(&own, &mission.edits));
        let (found, problems) = opened(&link);
        assert_eq!(found.cut.0, mission.scenario);
        assert!(
            problems[0].contains("target.ra_um") && problems[0].contains("begins anew"),
            "{problems:?}"
        );
        let own = Mission::read(TEMPLATE).unwrap();
        let (found, problems) = opened(&format!("https://a.org/#{}", own.link()));
        assert_eq!((found.mission.id, problems.len()), (own.id, 0));
    }

    #[test]
    fn a_link_gives_nobody_the_key_of_a_learner() {
        let launched = "https://a.org/p/index.html?mission=x&endpoint=https%3A%2F%2Fb&auth=Basic%20c&Actor=%7B%7D&registration=1#v=1";
        assert_eq!(page_to_share(launched), "https://a.org/p/index.html?mission=x");
        assert_eq!(page_to_share("https://a.org/?auth=x"), "https://a.org/");
        for page in ["https://a.org/", "https://a.org/?graphics=webgl&embed=hide:bar"] {
            assert_eq!(page_to_share(&format!("{page}#v=1")), page);
        }
    }

    #[test]
    fn what_is_wrong_is_told_and_the_rest_is_obeyed() {
        let opening = Opening::of_link("#mission=nowhere&embed=hide:bar,hide:x");
        assert!(opening.mission.is_none() && opening.frame.hides(FramePart::Bar));
        assert_eq!(opening.problems.len(), 2, "{:?}", opening.problems);
        let opening = Opening::of_link("#v=1&target.ra_um=abc");
        let notice = opening.start.notice.unwrap();
        assert!(notice.contains("target.ra_um") && notice.contains("is open instead"), "{notice}");
        assert!(opening.unread.unwrap().starts_with("`target.ra_um`"));
    }
}
