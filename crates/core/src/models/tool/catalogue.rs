//! The shipped cutters. A new one is a file in `assets/tools` and an entry here.

use std::sync::LazyLock;

use super::{Tool, ToolFile};

macro_rules! tools {
    ($( $(#[doc = $doc:literal])+ $variant:ident = $id:literal, $label:literal; )+) => {
        crate::choice! {
            /// A shipped cutter.
            pub enum ShippedTool {
                $( $(#[doc = $doc])+ $variant = $id, $label; )+
            }
        }

        impl ShippedTool {
            /// Its file's text.
            #[must_use]
            pub fn text(self) -> &'static str {
                match self {
                    $( Self::$variant => include_str!(
                        concat!("../../../../../assets/tools/", $id, ".toml")
                    ), )+
                }
            }
        }
    };
}

tools! {
    /// The papers' ball end with two teeth and a rake of 12 degrees; the default.
    R21616B20 = "r216-16b20-040", "R216-16B20-040, ball 16 mm";
    /// Solid carbide ball end of 6 mm, two flutes.
    Ball6 = "ball-6-2", "Ball 6 mm, 2 flutes";
    /// Solid carbide ball end of 10 mm, two flutes.
    Ball10 = "ball-10-2", "Ball 10 mm, 2 flutes";
    /// Solid carbide square end of 12 mm, four flutes.
    Square12 = "square-12-4", "Square 12 mm, 4 flutes";
    /// Solid carbide bull nose of 16 mm with a corner of 2 mm, four flutes.
    BullNose16 = "bull-nose-16-4", "Bull nose 16 mm r 2, 4 flutes";
    /// Solid carbide square end of 20 mm, three flutes.
    Square20 = "square-20-3", "Square 20 mm, 3 flutes";
}

static TOOLS: LazyLock<Vec<Tool>> =
    LazyLock::new(|| ShippedTool::ALL.iter().map(|shipped| shipped.load().tool).collect());

impl ShippedTool {
    /// The cutter, read once.
    #[must_use]
    pub fn tool(self) -> &'static Tool {
        &TOOLS[Self::ALL.iter().position(|other| *other == self).unwrap_or_default()]
    }

    /// The cutter with its title and source.
    #[must_use]
    pub fn load(self) -> ToolFile {
        ToolFile::parse(self.text()).expect("the shipped tool files are checked by a test")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_the_papers_cutter_and_every_file_is_its_own() {
        let papers = ShippedTool::R21616B20.load();
        assert_eq!(Tool { name: ShippedTool::R21616B20, ..papers.tool }, Tool::default());
        for shipped in ShippedTool::ALL {
            let file = shipped.load();
            assert!(!file.source.is_empty() && file.title.len() > 5, "{shipped:?}");
            let same = ShippedTool::ALL.iter().filter(|other| other.load() == file).count();
            assert_eq!(same, 1, "{shipped:?}");
            assert_eq!(shipped.tool().shipped_alike(), Some(*shipped), "no two cut alike");
        }
    }
}
