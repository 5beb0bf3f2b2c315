//! A report as one HTML page with its pictures inside. It loads nothing, and it is XML as well.

use super::document::{Block, Picture, ReportDocument, TextSpan, Words};
use crate::export::escape::xml;
use std::fmt::Write;

const STYLE: &str = "\
:root { color-scheme: light; }
body { font: 16px/1.45 sans-serif; color: #000; background: #fff; max-width: 54rem; margin: 2rem auto; padding: 0 1rem; overflow-wrap: anywhere; }
h1 { font-size: 1.7rem; line-height: 1.2; }
h2 { font-size: 1.3rem; margin-top: 2.2rem; border-bottom: 1px solid #888; break-after: avoid; }
h3 { font-size: 1.05rem; margin-bottom: 0.4rem; break-after: avoid; }
table { border-collapse: collapse; margin: 0.6rem 0 1rem; font-size: 0.92rem; }
th, td { border: 1px solid #999; padding: 0.2rem 0.55rem; text-align: left; vertical-align: top; overflow-wrap: break-word; }
th { background: #eee; }
tr { break-inside: avoid; }
table.numbers td + td, table.numbers th + th { text-align: right; }
div.wide { overflow-x: auto; }
div.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0.6rem 0; break-inside: avoid; max-width: 100%; }
figure.whole { flex: 1 1 100%; }
figure svg { max-width: 100%; height: auto; }
p.equation { margin: 0.4rem 0 0.4rem 2rem; display: flex; justify-content: space-between; gap: 2rem; }
var { font-style: italic; }
sub { font-size: 0.75em; line-height: 0; }
code { font: 0.9em monospace; }
pre { background: #f3f3f3; border: 1px solid #ccc; padding: 0.5rem; white-space: pre-wrap; }
@media print {
  body { margin: 0; padding: 0; max-width: none; font-size: 9.5pt; }
  pre { border-color: #999; }
  p, li { orphans: 3; widows: 3; }
  div.wide { overflow: visible; break-inside: avoid; }
  table { max-width: 100%; font-size: 8pt; line-height: 1.25; }
  thead { display: table-header-group; }
  th, td { padding: 0.4mm 1.2mm; overflow-wrap: anywhere; }
  table.numbers td + td, table.numbers th + th { overflow-wrap: break-word; }
  table.numbers td + td code { overflow-wrap: anywhere; }
  table.many { font-size: 7pt; }
  table.many th, table.many td { padding: 0.25mm 0.8mm; }
  table.numbers.many td + td { white-space: nowrap; }
  div.keep { break-inside: avoid; }
  div.page { break-before: page; }
  div.pictures { display: block; }
  figure { margin: 2mm 0; }
  figure svg { max-height: 62mm; width: auto; }
  figure.whole svg { max-height: 135mm; }
  body.short figure svg { max-height: 72mm; }
  body.short figure.whole svg { max-height: 106mm; }
}
@page { size: A4; margin: 16mm 16mm 18mm; @bottom-right { content: counter(page) \" / \" counter(pages); font: 8pt sans-serif; } }
";

/// Rows from which on a table of numbers is printed small, so that one of every layout has room on the first page.
const MANY: usize = 12;

/// The whole page.
pub(crate) fn page(document: &ReportDocument) -> String {
    let title = xml(&document.title);
    // A layout's page holds its pictures too, so that they are smaller when printed.
    let form = if document.short { " class=\"short\"" } else { "" };
    let mut out = format!(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body{form}>\n<h1>{title}</h1>\n"
    );
    for group in kept_together(&document.blocks) {
        if let [one] = group {
            block(one, &mut out);
            continue;
        }
        out.push_str("<div class=\"keep\">\n");
        for one in group {
            block(one, &mut out);
        }
        out.push_str("</div>\n");
    }
    out.push_str("</body>\n</html>\n");
    out
}

/// The blocks in groups that no page break may part: headings with what comes first below them, and where
/// that is words, with the table or picture after them.
fn kept_together(blocks: &[Block]) -> Vec<&[Block]> {
    let mut groups = Vec::new();
    let mut rest = blocks;
    while !rest.is_empty() {
        let headings = rest.iter().take_while(|b| matches!(b, Block::Heading(..))).count();
        let words = |b: &&Block| {
            matches!(b, Block::Paragraph(_) | Block::List(_) | Block::Equation(..) | Block::Free(_))
        };
        let said = rest[headings..].iter().take_while(words).count();
        let shown = matches!(
            rest.get(headings + said),
            Some(Block::Table { .. } | Block::Pictures(_) | Block::Commands(_))
        );
        let length = match (headings, shown) {
            (0, _) => 1,
            // Words alone may run over pages; their first block holds the heading.
            (_, false) => headings + 1,
            (_, true) => headings + said + 1,
        };
        let (group, after) = rest.split_at(length.min(rest.len()));
        groups.push(group);
        rest = after;
    }
    groups
}

// Writing to a string cannot fail.
fn block(block: &Block, out: &mut String) {
    let _ = match block {
        Block::Heading(level, words) => writeln!(out, "<h{level}>{}</h{level}>", line(words)),
        Block::Paragraph(words) => writeln!(out, "<p>{}</p>", line(words)),
        Block::Free(text) => {
            free(text, out);
            Ok(())
        }
        Block::List(items) => {
            let items: String = items.iter().map(|i| format!("<li>{}</li>\n", line(i))).collect();
            writeln!(out, "<ul>\n{items}</ul>")
        }
        Block::Table { head, rows, numbers } => {
            let class = match (*numbers, rows.len() > MANY) {
                (true, true) => " class=\"numbers many\"",
                (true, false) => " class=\"numbers\"",
                (false, _) => "",
            };
            let head: String = head.iter().map(|c| format!("<th>{}</th>", line(c))).collect();
            let _ = writeln!(
                out,
                "<div class=\"wide\"><table{class}>\n<thead><tr>{head}</tr></thead>\n<tbody>"
            );
            for row in rows {
                let cells: String = row.iter().map(|c| format!("<td>{}</td>", line(c))).collect();
                let _ = writeln!(out, "<tr>{cells}</tr>");
            }
            writeln!(out, "</tbody></table></div>")
        }
        Block::Equation(words, number) => {
            writeln!(
                out,
                "<p class=\"equation\"><span>{}</span><span>({number})</span></p>",
                line(words)
            )
        }
        Block::Pictures(pictures) => {
            let _ = writeln!(out, "<div class=\"pictures\">");
            for picture in pictures {
                figure(picture, out);
            }
            writeln!(out, "</div>")
        }
        Block::NewPage => writeln!(out, "<div class=\"page\"></div>"),
        Block::Commands(lines) => {
            let lines: Vec<String> = lines.iter().map(|l| xml(l)).collect();
            writeln!(out, "<pre><code>{}</code></pre>", lines.join("\n"))
        }
    };
}

fn figure(picture: &Picture, out: &mut String) {
    let class = if picture.wide { " class=\"whole\"" } else { "" };
    // The picture's own heading says what it shows.
    let _ = writeln!(out, "<figure{class}>\n{}</figure>", picture.svg);
}

/// Paragraphs and lines as they were written.
fn free(text: &str, out: &mut String) {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    for paragraph in lines.split(|line| line.is_empty()).filter(|p| !p.is_empty()) {
        let lines: Vec<String> = paragraph.iter().map(|l| xml(l)).collect();
        let _ = writeln!(out, "<p>{}</p>", lines.join("<br/>\n"));
    }
}

fn line(words: &Words) -> String {
    words
        .0
        .iter()
        .map(|span| match span {
            TextSpan::Plain(text) => xml(text),
            TextSpan::Strong(text) => format!("<strong>{}</strong>", xml(text)),
            TextSpan::Symbol(base, "") => format!("<var>{base}</var>"),
            TextSpan::Symbol(base, index) => format!("<var>{base}</var><sub>{}</sub>", xml(index)),
            TextSpan::Code(text) => format!("<code>{}</code>", xml(text)),
        })
        .collect()
}
