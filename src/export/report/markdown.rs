//! A report as one Markdown text (CommonMark with tables). Its pictures stand at its end as data, so
//! that the text stays readable and the file stays whole.

use super::document::{Block, ReportDocument, TextSpan, Words};
use crate::export::escape::markdown;
use crate::words::shown;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::fmt::Write;

/// The whole text.
pub(crate) fn text(document: &ReportDocument) -> String {
    let mut out = format!("# {}\n", markdown(&document.title, true));
    let mut pictures = Vec::new();
    for block in &document.blocks {
        out.push('\n');
        self::block(block, &mut out, &mut pictures);
    }
    for (index, svg) in pictures.iter().enumerate() {
        let data = STANDARD.encode(svg);
        let _ = write!(out, "\n[picture-{}]: data:image/svg+xml;base64,{data}\n", index + 1);
    }
    out
}

// Writing to a string cannot fail.
fn block<'a>(block: &'a Block, out: &mut String, pictures: &mut Vec<&'a str>) {
    let _ = match block {
        Block::Heading(level, words) => {
            writeln!(out, "{} {}", "#".repeat(usize::from(*level)), line(words, true))
        }
        Block::Paragraph(words) => writeln!(out, "{}", line(words, true)),
        Block::Free(text) => {
            free(text, out);
            Ok(())
        }
        Block::List(items) => {
            items.iter().try_for_each(|item| writeln!(out, "- {}", line(item, true)))
        }
        Block::Table { head, rows, numbers } => {
            let _ = writeln!(out, "{}", row(head));
            let rule = if *numbers { "|---:" } else { "|---" };
            let _ = writeln!(out, "|---{}|", rule.repeat(head.len().saturating_sub(1)));
            rows.iter().try_for_each(|cells| writeln!(out, "{}", row(cells)))
        }
        Block::Equation(words, number) => {
            writeln!(out, "> {} &nbsp;&nbsp; ({number})", line(words, true))
        }
        Block::Pictures(all) => {
            for picture in all {
                pictures.push(&picture.svg);
                let number = pictures.len();
                let caption = markdown(&picture.caption, false);
                let _ = writeln!(out, "![{caption}][picture-{number}]");
            }
            Ok(())
        }
        Block::NewPage => Ok(()),
        Block::Commands(lines) => {
            let lines: Vec<String> = lines.iter().map(|l| one_line(l)).collect();
            let longest = lines.iter().map(|l| longest_run(l, '`')).max().unwrap_or(0);
            let fence = "`".repeat(longest.max(2) + 1);
            writeln!(out, "{fence}\n{}\n{fence}", lines.join("\n"))
        }
    };
}

fn row(cells: &[Words]) -> String {
    let cells: Vec<String> = cells.iter().map(|cell| line(cell, false)).collect();
    format!("| {} |", cells.join(" | "))
}

fn free(text: &str, out: &mut String) {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let paragraphs = lines.split(|line| line.is_empty()).filter(|p| !p.is_empty());
    let paragraphs: Vec<String> = paragraphs
        .map(|p| p.iter().map(|l| markdown(l, true)).collect::<Vec<_>>().join("\\\n"))
        .collect();
    out.push_str(&paragraphs.join("\n\n"));
    out.push('\n');
}

fn line(words: &Words, start: bool) -> String {
    let mut out = String::new();
    for span in &words.0 {
        match span {
            TextSpan::Plain(text) => out.push_str(&markdown(text, start && out.is_empty())),
            TextSpan::Strong(text) => {
                // A space before the closing stars would leave them without a meaning.
                let word = text.trim_end();
                let _ = write!(out, "**{}**{}", markdown(word, false), &text[word.len()..]);
            }
            TextSpan::Symbol(base, "") => out.push_str(base),
            TextSpan::Symbol(base, index) => {
                let _ = write!(out, "{base}\\_{}", markdown(index, false));
            }
            TextSpan::Code(text) => {
                let text = one_line(text).replace('|', "\\|");
                let tick = "`".repeat(longest_run(&text, '`') + 1);
                let space = if text.starts_with('`') || text.ends_with('`') { " " } else { "" };
                let _ = write!(out, "{tick}{space}{text}{space}{tick}");
            }
        }
    }
    out
}

fn one_line(text: &str) -> String {
    text.chars().map(|c| if shown(c) { c } else { ' ' }).collect()
}

/// Length of the longest run of a letter.
fn longest_run(text: &str, letter: char) -> usize {
    text.split(|c| c != letter).map(str::len).max().unwrap_or(0)
}
