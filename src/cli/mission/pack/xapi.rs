//! The description of a Tin Can package, by which platforms launch what sends xAPI statements: one activity for each
//! mission, and one around several.

use super::page::INDEX;
use super::{Pack, escaped};

/// Where types of activities have their names.
const TYPES: &str = "http://adlnet.gov/expapi/activities/";

/// The text of tincan.xml for a package of this name.
pub fn tincan(pack: &Pack, name: &str) -> String {
    let mut activities = String::new();
    if pack.missions.len() > 1 {
        let id = format!("urn:steadycut:pack:{name}");
        activities += &activity(&id, "course", &pack.title, &pack.title, INDEX);
    }
    for mission in &pack.missions {
        let launch = match pack.missions.len() {
            1 => INDEX.to_owned(),
            _ => format!("{INDEX}?mission={}", mission.id),
        };
        activities +=
            &activity(&mission.activity, "assessment", &mission.title, &mission.about, &launch);
    }
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<tincan xmlns=\"http://projecttincan.com/tincan.xsd\">\n\
         \x20 <activities>\n{activities}  </activities>\n</tincan>\n"
    )
}

fn activity(id: &str, kind: &str, name: &str, about: &str, launch: &str) -> String {
    format!(
        "    <activity id=\"{}\" type=\"{TYPES}{kind}\">\n      <name lang=\"en\">{}</name>\n\
         \x20     <description lang=\"en\">{}</description>\n      <launch lang=\"en\">{}</launch>\n    </activity>\n",
        escaped(id),
        escaped(name),
        escaped(about),
        escaped(launch)
    )
}
