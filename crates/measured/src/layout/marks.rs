//! The closed choices of a text's layout.

steadycut_core::choice! {
    /// An encoding of text.
    pub enum TextEncoding {
        /// UTF-8, with a byte order mark or without.
        Utf8 = "utf-8", "UTF-8";
        /// UTF-16, the lower byte first.
        Utf16Le = "utf-16le", "UTF-16, little endian";
        /// UTF-16, the upper byte first.
        Utf16Be = "utf-16be", "UTF-16, big endian";
        /// Latin-1 with the letters that Windows-1252 adds.
        Latin1 = "latin-1", "Latin-1 (Windows-1252)";
    }
}

steadycut_core::choice! {
    /// What stands between two values of a line.
    pub enum FieldSeparator {
        /// A tab.
        Tab = "tab", "Tab";
        /// A semicolon.
        Semicolon = "semicolon", "Semicolon";
        /// A comma.
        Comma = "comma", "Comma";
        /// Any number of blanks and tabs.
        Blank = "blank", "Blanks";
    }
}

steadycut_core::choice! {
    /// The decimal sign.
    pub enum DecimalMark {
        /// 0.5
        Point = "point", "Point";
        /// 0,5
        Comma = "comma", "Comma";
    }
}

steadycut_core::choice! {
    /// What stands between thousands.
    pub enum ThousandsMark {
        /// 1234567
        None = "none", "Nothing";
        /// 1.234.567
        Point = "point", "Point";
        /// 1,234,567
        Comma = "comma", "Comma";
        /// 1 234 567, by any blank, also one that does not break.
        Blank = "blank", "Blank";
        /// 1'234'567
        Apostrophe = "apostrophe", "Apostrophe";
    }
}

impl FieldSeparator {
    /// Whether this byte separates.
    #[must_use]
    #[inline]
    pub fn is(self, byte: u8) -> bool {
        match self {
            Self::Tab => byte == b'\t',
            Self::Semicolon => byte == b';',
            Self::Comma => byte == b',',
            Self::Blank => byte == b' ' || byte == b'\t',
        }
    }
}

impl DecimalMark {
    /// The sign.
    #[must_use]
    #[inline]
    pub fn byte(self) -> u8 {
        match self {
            Self::Point => b'.',
            Self::Comma => b',',
        }
    }
}

impl ThousandsMark {
    /// Whether this character stands between thousands.
    #[must_use]
    pub fn is(self, sign: char) -> bool {
        match self {
            Self::None => false,
            Self::Point => sign == '.',
            Self::Comma => sign == ',',
            // Also the one that does not break, the narrow one and the thin one.
            Self::Blank => [' ', '\u{a0}', '\u{202f}', '\u{2009}'].contains(&sign),
            Self::Apostrophe => ['\'', '\u{2019}'].contains(&sign),
        }
    }
}
