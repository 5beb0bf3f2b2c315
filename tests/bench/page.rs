//! Writes what is measured into `MEASUREMENTS.md` beside this file: section by section, each with its
//! date, commit, processor, load and command, and what the command printed, word for word. Sections
//! that are not named stay as they are, and so does all that stands outside the sections' marks.
//!
//! `cargo bench --bench page` lists the sections, `cargo bench --bench page -- forecast kernel` measures
//! two of them again, `-- all` every one. Sections without times in them can also be written by
//! `cargo test --bench page -- paper bytes`, which needs no release build.

use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

/// Who does the measuring.
#[derive(Clone, Copy)]
enum Tool {
    /// The program itself.
    Meshcast,
    /// Cargo, for a bench or a test.
    Cargo,
}

/// A section of the page.
struct Section {
    name: &'static str,
    tool: Tool,
    arguments: &'static [&'static str],
    /// A line of the output is kept if it holds one of these words; all are where there is none.
    lines: &'static [&'static str],
    /// Whether there are times in it, which only a release build should be asked for.
    timed: bool,
}

const fn of(
    name: &'static str,
    tool: Tool,
    arguments: &'static [&'static str],
    lines: &'static [&'static str],
    timed: bool,
) -> Section {
    Section { name, tool, arguments, lines, timed }
}

/// `cargo test` of the physics, with the tests that take minutes.
const SURVEY: &[&str] = &[
    "test",
    "--release",
    "--test",
    "physics",
    "--",
    "--ignored",
    "--nocapture",
    "two_thousand",
    "beyond_the_bound",
];
const BYTES: &[&str] =
    &["test", "--test", "terminal", "cost", "--", "--nocapture", "--test-threads", "1"];

/// What names that build, see `terminal.rs`.
const BESIDE: &str = "MESHCAST_BENCH_BESIDE";

/// Whole checks, random beside placed; with `--svg` they draw the picture beside the page.
const QUESTIONS: &[&str] = &["bench", "--questions", "--scenes", "20", "--seed", "7"];
const PAIRS: &[&str] = &["bench", "--pairs", "--scenes", "60", "--seed", "20261127"];
const ESTIMATE: &[&str] = &["bench", "--estimate", "--scenes", "300", "--seed", "20261130"];

const SECTIONS: [Section; 13] = [
    of("forecast", Tool::Cargo, &["bench", "--bench", "forecast"], &["time:", "sweep"], true),
    of("terminal", Tool::Cargo, &["bench", "--bench", "terminal"], &[], true),
    of("bytes", Tool::Cargo, BYTES, &[" bytes"], false),
    of("errors", Tool::Meshcast, &["bench"], &[], true),
    of("yade", Tool::Cargo, &["bench", "--bench", "yade"], &[], true),
    of("questions", Tool::Meshcast, QUESTIONS, &[], true),
    of("pairs", Tool::Meshcast, PAIRS, &[], false),
    of("estimate", Tool::Meshcast, ESTIMATE, &[], false),
    of("convergence", Tool::Meshcast, &["bench", "--convergence"], &[], false),
    of("size", Tool::Meshcast, &["bench", "--size"], &[], true),
    of("stability", Tool::Cargo, SURVEY, &["scenes", "runs", "bound"], false),
    of(
        "kernel",
        Tool::Cargo,
        &["bench", "--bench", "kernel"],
        &["ns per", "A f32", "on avx", "on sse", "on portable"],
        true,
    ),
    of("paper", Tool::Meshcast, &["validate", "--dem"], &[], false),
];

fn main() -> ExitCode {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let known = |name: &String| name == "all" || SECTIONS.iter().any(|s| s.name == *name);
    if wanted.is_empty() || !wanted.iter().all(known) {
        let names: Vec<&str> = SECTIONS.iter().map(|s| s.name).collect();
        println!("sections: {}, or all", names.join(", "));
        return if wanted.is_empty() { ExitCode::SUCCESS } else { ExitCode::from(2) };
    }
    for section in &SECTIONS {
        if wanted.iter().any(|name| name == section.name || name == "all")
            && let Err(why) = measure(section)
        {
            eprintln!("{}: {why}", section.name);
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

/// Measures a section and writes it into the page.
fn measure(section: &Section) -> Result<(), String> {
    if section.timed && cfg!(debug_assertions) {
        return Err(
            "has times, which only a release build should tell: cargo bench --bench page".into()
        );
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bench/MEASUREMENTS.md");
    let page = std::fs::read_to_string(&file).map_err(|e| e.to_string())?;
    // Before anything takes minutes.
    replaced(&page, section.name, "")?;
    let head = conditions();
    let (program, shown) = match section.tool {
        Tool::Meshcast => (env!("CARGO_BIN_EXE_meshcast").to_string(), "meshcast"),
        Tool::Cargo => (std::env::var("CARGO").unwrap_or_else(|_| "cargo".into()), "cargo"),
    };
    // Another build that is measured beside this one: which, is for the page to say.
    let beside = section.name == "terminal" && std::env::var_os(BESIDE).is_some();
    let beside = if beside { format!("{BESIDE}=PROGRAM ") } else { String::new() };
    let shown = format!("{beside}{shown} {}", section.arguments.join(" "));
    eprintln!("{shown}");
    let ran = Command::new(program)
        .args(section.arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stderr(Stdio::inherit())
        .output()
        .map_err(|e| e.to_string())?;
    if !ran.status.success() {
        return Err(format!("{shown} ended with {}", ran.status));
    }
    let printed = String::from_utf8_lossy(&ran.stdout);
    let keep = |line: &&str| {
        section.lines.is_empty() || section.lines.iter().any(|word| line.contains(word))
    };
    // What a test prints first stands behind its name.
    let alone = |line: &'_ str| match line.split_once(" ... ") {
        Some((name, said)) if name.starts_with("test ") => said.trim_end().to_string(),
        _ => line.trim_end().to_string(),
    };
    let kept: Vec<String> = printed.lines().filter(keep).map(alone).collect();
    let body = format!("{head}\n`{shown}`:\n\n```text\n{}\n```\n", kept.join("\n").trim_end());
    // Read again: another section may have been written meanwhile.
    let page = std::fs::read_to_string(&file).map_err(|e| e.to_string())?;
    std::fs::write(&file, replaced(&page, section.name, &body)?).map_err(|e| e.to_string())
}

/// The page with another body of a section.
fn replaced(page: &str, name: &str, body: &str) -> Result<String, String> {
    let mark = format!("<!-- {name} -->\n");
    let no = || format!("MEASUREMENTS.md has no \"<!-- {name} -->\" with an \"<!-- end -->\"");
    let (before, rest) = page.split_once(&mark).ok_or_else(no)?;
    let (_, after) = rest.split_once("<!-- end -->").ok_or_else(no)?;
    Ok(format!("{before}{mark}{body}<!-- end -->{after}"))
}

/// When, of what, on what, and what else the machine did.
fn conditions() -> String {
    let told = |program: &str, arguments: &[&str]| {
        let out = Command::new(program).args(arguments).output().ok()?;
        let text = String::from_utf8_lossy(&out.stdout).trim().to_string();
        (out.status.success() && !text.is_empty()).then_some(text)
    };
    let unknown = || "unknown".to_string();
    let date = told("date", &["-u", "+%Y-%m-%d"]).unwrap_or_else(unknown);
    let commit = told("git", &["rev-parse", "--short", "HEAD"]).unwrap_or_else(unknown);
    let changed = told("git", &["status", "--porcelain", "--", "src"]).is_some();
    let edits = if changed { " with edits" } else { "" };
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|l| l.strip_prefix("model name")?.split_once(": "));
    let model = model.map_or_else(unknown, |(_, model)| model.to_string());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = load.split(' ').next().unwrap_or("").to_string();
    let build = if cfg!(debug_assertions) { "development build" } else { "release build" };
    format!(
        "{date}, commit {commit}{edits}, {build}; processor: {model}, {cores} cores, load {load} before it began.\n"
    )
}
