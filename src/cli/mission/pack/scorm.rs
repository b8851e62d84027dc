//! The manifest of SCORM 1.2: IMS content packaging 1.1.2 with ADL's attributes. Each mission is an item, and all of
//! them open the one page with another parameter.

use std::fmt::Write;

use super::page::INDEX;
use super::{Pack, escaped};

/// The text of imsmanifest.xml for a package of this name with these files.
pub fn manifest(pack: &Pack, name: &str, files: &[&str]) -> String {
    let mut items = String::new();
    for mission in &pack.missions {
        let (id, title) = (&mission.id, escaped(&mission.title));
        // What is written into a text does not fail.
        let _ = write!(
            items,
            "      <item identifier=\"item-{id}\" identifierref=\"page\" isvisible=\"true\" parameters=\"?mission={id}\">\n\
             \x20       <title>{title}</title>\n      </item>\n"
        );
    }
    let listed: String =
        files.iter().map(|file| format!("      <file href=\"{}\"/>\n", escaped(file))).collect();
    let title = escaped(&pack.title);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <manifest identifier=\"steadycut-{name}\" version=\"1.0\"\n\
         \x20   xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\"\n\
         \x20   xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_rootv1p2\">\n\
         \x20 <metadata>\n    <schema>ADL SCORM</schema>\n    <schemaversion>1.2</schemaversion>\n  </metadata>\n\
         \x20 <organizations default=\"missions\">\n    <organization identifier=\"missions\">\n\
         \x20     <title>{title}</title>\n{items}    </organization>\n  </organizations>\n\
         \x20 <resources>\n\
         \x20   <resource identifier=\"page\" type=\"webcontent\" adlcp:scormtype=\"sco\" href=\"{INDEX}\">\n\
         {listed}    </resource>\n  </resources>\n</manifest>\n"
    )
}
