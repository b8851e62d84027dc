//! Missions in links: a shipped one by its id, `mission=quiet-speed`, any other with its whole text, packed as a
//! scenario's link is, `mission.z=...`.

use super::file::MAX_BYTES;
use super::{Mission, MissionError, shipped};
use crate::base::language::tr;
use crate::run::digest::Digest;
use crate::run::packed::{pack, unpack};
use crate::run::scenario_link::mended;

/// What stands before the id of a shipped mission.
pub const SHIPPED: &str = "mission=";
/// What stands before the packed text of any other.
pub const PACKED: &str = "mission.z=";

impl Mission {
    /// The text without comments, its entries in one order: two files that say the same have the same one.
    #[must_use]
    pub fn plain_text(&self) -> String {
        let table = toml::from_str::<toml::Table>(&self.text).ok();
        let written = table.and_then(|table| toml::to_string(&table).ok());
        // It was read from this text.
        written.unwrap_or_else(|| self.text.clone())
    }

    /// What tells it from another one of the same id: XXH3 of [`Self::plain_text`], 16 hexadecimal digits.
    #[must_use]
    pub fn digest(&self) -> String {
        let mut digest = Digest::default();
        digest.text(&self.plain_text());
        digest.hex()
    }

    /// Whether it is shipped as it is.
    #[must_use]
    pub fn is_shipped(&self) -> bool {
        let mut all = shipped::MISSIONS.iter();
        all.any(|mission| mission.id == self.id && mission.text == self.text)
    }

    /// Its part of a link, which [`of_link`] reads.
    #[must_use]
    pub fn link(&self) -> String {
        match self.is_shipped() {
            true => format!("{SHIPPED}{}", self.id),
            false => format!("{PACKED}{}", pack(&self.plain_text())),
        }
    }
}

/// The mission of a part of a link, if it is one of a mission. Marks of the text around a link are taken off.
#[must_use]
pub fn of_link(part: &str) -> Option<Result<Mission, MissionError>> {
    if let Some(id) = part.strip_prefix(SHIPPED) {
        return Some(shipped::load(&mended(id)));
    }
    let packed = part.strip_prefix(PACKED)?;
    let text = unpack(packed, MAX_BYTES).or_else(|problem| {
        // Nothing is mended that can be read as it is.
        unpack(&mended(packed), MAX_BYTES).map_err(|_| problem)
    });
    Some(match text {
        Ok(text) => Mission::read(&text),
        Err(problem) => {
            Err(MissionError::of_mission(tr!("its link: {problem}", problem = problem.to_string())))
        }
    })
}

#[cfg(test)]
mod tests {
    use super::super::{MISSION_VERSION, TEMPLATE};
    use super::*;

    fn all() -> impl Iterator<Item = Mission> {
        let shipped = shipped::MISSIONS.iter().map(|mission| mission.text);
        shipped.chain([TEMPLATE]).map(|text| Mission::read(text).unwrap())
    }

    /// The same but for the text that it was read from.
    fn same(one: &Mission, other: &Mission) -> bool {
        Mission { text: String::new(), ..one.clone() }
            == Mission { text: String::new(), ..other.clone() }
    }

    #[test]
    fn the_plain_text_says_the_same_in_fewer_letters() {
        for mission in all() {
            let plain = Mission::read(&mission.plain_text()).unwrap();
            assert!(same(&plain, &mission), "{}", mission.id);
            assert_eq!(plain.digest(), mission.digest());
            assert_eq!(plain.plain_text(), mission.plain_text());
        }
        let template = Mission::read(TEMPLATE).unwrap();
        assert!(2 * template.plain_text().len() < TEMPLATE.len(), "comments are gone");
        let spaced = TEMPLATE.replacen("version = 1", "# mine\nversion   =  1", 1);
        assert_eq!(Mission::read(&spaced).unwrap().digest(), template.digest());
        let other = TEMPLATE.replace("minutes = 5", "minutes = 6");
        assert_ne!(Mission::read(&other).unwrap().digest(), template.digest());
    }

    #[test]
    fn a_link_gives_the_mission_again() {
        for mission in all() {
            let link = mission.link();
            assert_eq!(link.starts_with(SHIPPED), mission.is_shipped(), "{link}");
            let read = of_link(&link).unwrap().unwrap();
            assert!(same(&read, &mission), "{}", mission.id);
            assert_eq!(read.link(), link);
        }
        let changed =
            Mission::read(&shipped::MISSIONS[0].text.replace("[debrief]", "# own\n[debrief]"));
        assert!(changed.unwrap().link().starts_with(PACKED), "it is not the shipped one");
    }

    #[test]
    fn a_bad_link_says_what_is_wrong_and_marks_around_a_good_one_do_no_harm() {
        assert!(of_link("v=1").is_none());
        let said = |part: &str| of_link(part).unwrap().unwrap_err().to_string();
        let none = said("mission=quite-speed");
        assert!(none.contains("quite-speed") && none.contains("quiet-speed,"), "{none}");
        assert!(of_link("mission=quiet-speed>.").unwrap().is_ok());
        let packed = Mission::read(TEMPLATE).unwrap().link();
        assert!(of_link(&format!("{packed}).")).unwrap().is_ok());
        assert!(said(&packed[..packed.len() - 9]).contains("its link"));
        let text = format!("version = {}", MISSION_VERSION + 1);
        let later = said(&format!("{PACKED}{}", pack(&text)));
        assert!(later.contains("`version`"), "{later}");
    }
}
