//! Tables that programs read: columns by their names, rows, and the two as CSV or as JSON objects.

use super::value::{NamedColumn, Object, Value};
use csv::{Terminator, WriterBuilder};

/// A column with what stands in it, from any part of a row.
type Get<'t, R> = Box<dyn Fn(&R) -> Value + 't>;

/// The columns of a table, in their order.
pub(crate) struct Table<'t, R> {
    columns: Vec<(&'static str, Get<'t, R>)>,
}

impl<'t, R: 't> Table<'t, R> {
    /// Without columns.
    pub(crate) fn new() -> Table<'t, R> {
        Table { columns: Vec::new() }
    }

    /// With a column.
    pub(crate) fn with(
        mut self,
        name: &'static str,
        get: impl Fn(&R) -> Value + 't,
    ) -> Table<'t, R> {
        self.columns.push((name, Box::new(get)));
        self
    }

    /// With columns of a part of the row; empty where the row has no such part.
    pub(crate) fn part<P: 't>(
        self,
        columns: impl IntoIterator<Item = NamedColumn<P>>,
        part: impl Fn(&R) -> Option<&P> + Copy + 't,
    ) -> Table<'t, R> {
        columns.into_iter().fold(self, |table, (name, get)| {
            table.with(name, move |row| part(row).map_or(Value::None, get))
        })
    }

    /// With further columns if a condition holds.
    pub(crate) fn when(
        self,
        condition: bool,
        more: impl FnOnce(Table<'t, R>) -> Table<'t, R>,
    ) -> Table<'t, R> {
        if condition { more(self) } else { self }
    }

    /// A row as an object with the columns' names.
    pub(crate) fn object(&self, row: &R) -> Object {
        self.columns.iter().fold(Object::new(), |object, (name, get)| object.with(name, get(row)))
    }

    /// The names, then one line a row: lines end in a line feed, fields stand in quotes where RFC 4180
    /// wants them; `between` codes.
    pub(crate) fn csv(&self, rows: impl IntoIterator<Item = R>, between: &str) -> String {
        let mut builder = WriterBuilder::new();
        let mut out = builder.terminator(Terminator::Any(b'\n')).from_writer(Vec::new());
        // Writing to memory cannot fail.
        let _ = out.write_record(self.columns.iter().map(|column| column.0));
        for row in rows {
            let _ =
                out.write_record(self.columns.iter().map(|column| column.1(&row).cell(between)));
        }
        let bytes = out.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }

    /// Only the columns of these names.
    pub(crate) fn only(mut self, names: &[&str]) -> Table<'t, R> {
        self.columns.retain(|column| names.contains(&column.0));
        self
    }

    /// The names, then one line a row, with tabs between the cells; blanks stand for tabs and line ends
    /// in a text.
    pub(crate) fn tabs(&self, rows: impl IntoIterator<Item = R>, between: &str) -> String {
        let mut out = self.columns.iter().map(|column| column.0).collect::<Vec<_>>().join("\t");
        out.push('\n');
        for row in rows {
            let cell = |get: &Get<'t, R>| get(&row).cell(between).replace(['\t', '\n', '\r'], " ");
            let cells: Vec<String> = self.columns.iter().map(|column| cell(&column.1)).collect();
            out.push_str(&cells.join("\t"));
            out.push('\n');
        }
        out
    }
}

/// A CSV for spreadsheets whose numbers have a decimal comma: semicolons between the fields, commas in
/// the numbers, and a byte order mark, so that letters with marks are read right.
pub(crate) fn with_decimal_comma(csv: &str) -> String {
    let mut builder = csv::ReaderBuilder::new();
    let mut lines = builder.has_headers(false).flexible(true).from_reader(csv.as_bytes());
    let mut out = WriterBuilder::new()
        .delimiter(b';')
        .flexible(true)
        .terminator(Terminator::Any(b'\n'))
        .from_writer("\u{feff}".as_bytes().to_vec());
    // What was written here can be read, and writing to memory cannot fail.
    for line in lines.records().flatten() {
        let _ = out.write_record(line.iter().map(comma));
    }
    let bytes = out.into_inner().unwrap_or_default();
    String::from_utf8(bytes).unwrap_or_default()
}

/// A number with a decimal comma; anything else as it is.
fn comma(field: &str) -> String {
    let number = field.parse::<f64>().is_ok_and(f64::is_finite);
    if number { field.replace('.', ",") } else { field.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spreadsheet_with_decimal_comma_reads_numbers_and_leaves_names() {
        let plain = "layout,F_kN\n\"a, b\",24.01\nv1.2,-0.5\n\"x;y\",\n";
        assert_eq!(
            with_decimal_comma(plain),
            "\u{feff}layout;F_kN\na, b;24,01\nv1.2;-0,5\n\"x;y\";\n"
        );
    }

    #[test]
    fn a_name_that_begins_like_a_formula_is_a_text_to_a_spreadsheet() {
        let table = Table::<&str>::new()
            .with("layout", |name| name.to_string().into())
            .with("ex_m", |_| (-0.5).into());
        let out = table.csv(["=1+1", "+41 cut", "-5 m bench", "@SUM(A1:A9)", "3-4"], " ");
        let names: Vec<&str> = out.lines().skip(1).collect();
        assert_eq!(
            names,
            ["'=1+1,-0.5", "'+41 cut,-0.5", "'-5 m bench,-0.5", "'@SUM(A1:A9),-0.5", "3-4,-0.5"]
        );
    }
}
