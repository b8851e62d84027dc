//! A table of results as CSV, whatever it holds: titles and rows, names and numbers.

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// A name or a word.
    Word(String),
    /// A number, in the shortest form that reads back to the same bits.
    Number(f64),
    /// Nothing is known.
    Empty,
}

impl From<&str> for Entry {
    fn from(word: &str) -> Self {
        Self::Word(word.to_owned())
    }
}

impl From<String> for Entry {
    fn from(word: String) -> Self {
        Self::Word(word)
    }
}

impl From<f64> for Entry {
    fn from(number: f64) -> Self {
        if number.is_nan() { Self::Empty } else { Self::Number(number) }
    }
}

impl From<Option<f64>> for Entry {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Empty, Self::from)
    }
}

/// Titles, each with its unit in brackets where it has one, and rows as long as they.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    titles: Vec<String>,
    rows: Vec<Vec<Entry>>,
}

impl Sheet {
    /// A table without rows.
    #[must_use]
    pub fn new<T: Into<String>>(titles: impl IntoIterator<Item = T>) -> Self {
        Self { titles: titles.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// Adds a row; what is missing at its end is empty.
    ///
    /// # Panics
    /// The row is longer than the titles.
    pub fn row(&mut self, row: impl IntoIterator<Item = Entry>) {
        let mut row: Vec<Entry> = row.into_iter().collect();
        assert!(row.len() <= self.titles.len(), "a row longer than the titles");
        row.resize(self.titles.len(), Entry::Empty);
        self.rows.push(row);
    }

    /// The table with one more column, which says the same in all rows.
    #[must_use]
    pub fn with(mut self, title: &str, word: &str) -> Self {
        let titles = self.titles.len();
        self.titles.push(title.to_owned());
        for row in &mut self.rows {
            row.resize(titles, Entry::Empty);
            row.push(word.into());
        }
        self
    }

    /// The table as RFC 4180 has it: quoted where it must be, a line feed at the end of every line.
    ///
    /// ```
    /// use steadycut_study::export::sheet::Sheet;
    ///
    /// let mut sheet = Sheet::new(["control", "time [s]", "remark"]);
    /// sheet.row(["P".into(), 56.25.into(), "slow, but steady".into()]);
    /// sheet.row(["PI".into(), f64::NAN.into()]);
    /// assert_eq!(sheet.csv(), "control,time [s],remark\nP,56.25,\"slow, but steady\"\nPI,,\n");
    /// ```
    #[must_use]
    pub fn csv(&self) -> String {
        let mut writer = csv::WriterBuilder::new().from_writer(Vec::new());
        let lines = std::iter::once(self.titles.clone());
        let rows = self.rows.iter().map(|row| {
            let cells = row.iter().map(|entry| match entry {
                Entry::Word(word) => word.clone(),
                Entry::Number(number) => number.to_string(),
                Entry::Empty => String::new(),
            });
            cells.collect::<Vec<_>>()
        });
        for line in lines.chain(rows) {
            // Into memory, and all rows are of one length: it does not fail.
            let _ = writer.write_record(line);
        }
        let bytes = writer.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }
}
