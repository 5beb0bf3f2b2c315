//! The text of a campaign's file: a header, then a line a run, each JSON. A file that was cut off at any
//! byte goes on where its last whole line ends.

use super::Header;
use super::row::Row;

/// Name of the file in a campaign's folder.
pub(crate) const NAME: &str = "campaign.jsonl";

/// A campaign's file as far as it is whole.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CampaignText {
    /// Its first line.
    pub(crate) header: Header,
    /// The runs.
    pub(crate) rows: Vec<Row>,
    /// Bytes up to the end of the last whole line.
    pub(crate) whole: usize,
}

/// A line of the file.
pub(crate) fn line(of: &impl serde::Serialize) -> String {
    // Plain data of finite numbers can always be written.
    serde_json::to_string(of).unwrap_or_default() + "\n"
}

/// Reads a file. Nothing where not even its header is whole.
///
/// # Errors
/// What is no line of a campaign, with its number: only a last line may be torn.
pub(crate) fn read(text: &[u8]) -> Result<Option<CampaignText>, String> {
    let mut lines = text.split_inclusive(|byte| *byte == b'\n');
    let Some(first) = lines.next().filter(|line| line.ends_with(b"\n")) else {
        let torn =
            text.is_empty() || text.starts_with(b"{\"campaign\":") || BEGINS.starts_with(text);
        return if torn { Ok(None) } else { Err("this is no campaign".into()) };
    };
    let header: Header =
        serde_json::from_slice(first).map_err(|_| "line 1 is no campaign's header".to_string())?;
    let mut found = CampaignText { header, rows: Vec::new(), whole: first.len() };
    for line in lines {
        if !line.ends_with(b"\n") {
            break; // Torn: it is made again.
        }
        let number = found.rows.len();
        match serde_json::from_slice::<Row>(line) {
            Ok(row) if row.run == number => found.rows.push(row),
            Ok(row) => {
                return Err(format!("line {}: run {} out of its place", number + 2, row.run));
            }
            Err(e) => return Err(format!("line {} is no run: {e}", number + 2)),
        }
        found.whole += line.len();
    }
    Ok(Some(found))
}

/// How every such file begins.
const BEGINS: &[u8] = b"{\"campaign\":";

#[cfg(test)]
mod tests {
    use super::super::row::RowEnd;
    use super::super::{CampaignPlan, Header};
    use super::*;
    use crate::mesh::laws;

    #[test]
    fn a_file_cut_off_at_any_byte_is_read_up_to_its_last_whole_line() {
        let plan = CampaignPlan { runs: 3, ..CampaignPlan::default() };
        let header = Header::new(&plan, "m", &laws::bench());
        let rows: Vec<Row> = (0..3)
            .map(|k| Row::without(k, &plan.sample(k), RowEnd::NoScene, Some("why".into())))
            .collect();
        let mut text = line(&header);
        let mut ends = vec![text.len()];
        for row in &rows {
            text += &line(row);
            ends.push(text.len());
        }
        for cut in 0..=text.len() {
            let found = read(&text.as_bytes()[..cut]).unwrap();
            let whole = ends.iter().filter(|end| **end <= cut).count();
            match found {
                None => assert_eq!(whole, 0),
                Some(found) => {
                    assert_eq!((found.rows.len() + 1, found.whole), (whole, ends[whole - 1]));
                    assert_eq!(found.rows[..], rows[..whole - 1]);
                    assert_eq!(found.header, header);
                }
            }
        }
    }

    #[test]
    fn what_is_no_campaign_is_refused_with_its_line() {
        assert!(read(b"something").is_err() && read(b"(\n)\n").is_err());
        let plan = CampaignPlan { runs: 3, ..CampaignPlan::default() };
        let header = line(&Header::new(&plan, "m", &laws::bench()));
        let row = |k| line(&Row::without(k, &plan.sample(k), RowEnd::Slipped, None));
        let said = |text: String| read(text.as_bytes()).unwrap_err();
        assert!(said(header.clone() + &row(1)).contains("line 2: run 1"));
        assert!(said(header + &row(0) + "{}\n" + &row(2)).contains("line 3 is no run"));
    }
}
