//! The command line: what it takes, one file a subcommand, and exit codes.
//!
//! - [`flags`]: flags of the interactive program; [`quantity`]: lengths, forces and factors.
//! - [`forecast`], [`check`], [`mesh`], [`new`], [`export`], [`report`]: the subcommands;
//!   [`interactive`]: none of them; [`lab`]: those of the makers, `bench`, `calibrate`,
//!   `campaign`, `derive`, `held-out`, `validate`.
//! - [`sensitivity`], [`sweep`], [`compare`], [`design`]: the studies; [`dem`]: checks beside the
//!   forecasts of the first three.
//! - [`destination`]: standard output or a file; [`written`]: files, whole or not at all; [`source`]: the project that a text is made from.
//! - [`case`]: one layout to forecast or check, from a project file, flags and defaults;
//!   [`wire`]: the wires of a check.
//! - [`output`]: results to standard output, errors to standard error, exit codes; [`watch`]: progress, time left and Ctrl+C.
//!
//! Exit codes: 0 for a result, 1 for a failure, 2 for bad input, 130 for what Ctrl+C ended early.

pub(crate) mod case;
pub(crate) mod check;
mod choice;
pub(crate) mod compare;
pub(crate) mod dem;
pub(crate) mod design;
pub(crate) mod destination;
pub(crate) mod export;
pub(crate) mod flags;
pub(crate) mod forecast;
mod input_flags;
pub(crate) mod interactive;
pub(crate) mod lab;
pub(crate) mod mesh;
pub(crate) mod new;
mod opening;
pub(crate) mod output;
mod page;
pub(crate) mod quantity;
pub(crate) mod report;
pub(crate) mod sensitivity;
pub(crate) mod source;
pub(crate) mod sweep;
pub(crate) mod tolerance;
mod verdict;
pub(crate) mod watch;
pub(crate) mod wire;
pub(crate) mod written;

pub(crate) use crate::VERSION;
pub(crate) use flags::{StartFlags, UiFlags};

use crate::words::nearest;
use clap::{CommandFactory, Parser, Subcommand};
use output::{CommandEnd, Fault};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "meshcast [OPTIONS] [PROJECT.ron]\n       meshcast [OPTIONS] <COMMAND>";

const AFTER_HELP: &str = "\
Examples:
  meshcast road-cut.ron                          open a project in the terminal
  meshcast forecast -d 250mm -L 2.5 -D 0.6       one layout, as a text
  meshcast forecast road-cut.ron --format json   every layout of a project
  meshcast forecast road-cut.ron --layout 'bench 2' --format csv > curve.csv
  meshcast compare road-cut.ron --sort utilisation --descending
  meshcast sensitivity road-cut.ron --layout portal
  meshcast sensitivity -L 2.5 --dem              the same by discrete elements beside it
  meshcast sweep -d 0.25 --vary L --from 2 --to 4.5 --steps 11
  meshcast sweep --vary L --from 2 --to 4 --vary2 D --from2 0.4 --to2 1.6
  meshcast design -d 0.25 --force 20 --gamma-load 1.3 --solve L
  meshcast export road-cut.ron --what chart -o road-cut.svg
  meshcast report road-cut.ron -o road-cut.html  all numbers and how to repeat them
  meshcast check -d 0.32 -L 3 -D 1               the same by discrete elements

Bare numbers are metres and kilonewtons. A project that is named like a command is
opened by its path: meshcast ./mesh";

/// Forecasts the force-deflection response of anchored wire mesh panels on rock slopes.
///
/// Without a command, opens a project in the terminal: the one named, or the last one.
#[derive(Debug, Parser)]
#[command(name = "meshcast", version = VERSION, after_help = AFTER_HELP, override_usage = USAGE, max_term_width = 100)]
struct Root {
    /// Project file to open in the terminal.
    #[arg(value_name = "PROJECT.ron")]
    project: Option<PathBuf>,
    #[command(flatten)]
    ui: UiFlags,
    #[command(flatten)]
    start: StartFlags,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::NewArgs),
    Forecast(Box<forecast::ForecastArgs>),
    Sensitivity(Box<sensitivity::SensitivityArgs>),
    Sweep(Box<sweep::SweepArgs>),
    Compare(Box<compare::CompareArgs>),
    Tolerance(Box<tolerance::ToleranceArgs>),
    Design(Box<design::DesignArgs>),
    Export(export::ExportArgs),
    Report(report::ReportArgs),
    Check(Box<check::CheckArgs>),
    Adopt(Box<lab::adopt::AdoptArgs>),
    Calibrate(lab::calibrate::CalibrateArgs),
    Campaign(lab::campaign::CampaignArgs),
    Derive(lab::derive::DeriveArgs),
    HeldOut(lab::held_out::HeldOutArgs),
    Reproduce(lab::reproduce::ReproduceArgs),
    Bench(lab::bench::BenchArgs),
    Mesh(mesh::MeshArgs),
    Validate(lab::validate::ValidateArgs),
    /// The manual page of the program or of a command, to standard output.
    ///
    /// To read it: meshcast man check > meshcast-check.1; man ./meshcast-check.1
    Man {
        /// A command.
        #[arg(value_name = "COMMAND")]
        command: Option<String>,
    },
    /// Completions of a shell, to standard output.
    ///
    /// For bash: meshcast completions bash > ~/.local/share/bash-completion/completions/meshcast
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
}

/// Reads the command line (the program's name first), does what it says and returns the exit code.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let root = match Root::try_parse_from(arguments) {
        Ok(root) => root,
        Err(said) => {
            // Help and version go to standard output, all else to standard error; where nobody
            // reads there is nothing to do about it.
            let _ = said.print();
            return ExitCode::from(u8::try_from(said.exit_code()).unwrap_or(output::FAILURE));
        }
    };
    match root.command {
        None => open(root.project, root.ui, root.start),
        Some(_) if root.start.any() => output::finish(Err(Fault::input(
            "--fidelity, --runs, --live and --tour before a command are for the interactive \
             program; a command takes its own behind its name: meshcast check --fidelity quick",
        ))),
        Some(command) => output::finish(headless(command, root.project.as_deref(), &root.ui)),
    }
}

fn headless(command: Command, project: Option<&Path>, ui: &UiFlags) -> CommandEnd {
    if let Some(path) = project {
        return Err(Fault::input(format!(
            "a project ({:?}) stands before the command; it belongs behind it: meshcast forecast PROJECT.ron",
            path.display().to_string()
        )));
    }
    match command {
        Command::New(args) => new::run(&args),
        Command::Forecast(args) => forecast::run(&args, ui),
        Command::Sensitivity(args) => sensitivity::run(&args, ui),
        Command::Sweep(args) => sweep::run(&args, ui),
        Command::Compare(args) => compare::run(&args, ui),
        Command::Tolerance(args) => tolerance::run(&args, ui),
        Command::Design(args) => design::run(&args, ui),
        Command::Export(args) => export::run(&args, ui),
        Command::Report(args) => report::run(&args, ui),
        Command::Check(args) => check::run(&args, ui),
        Command::Adopt(args) => lab::adopt::run(&args),
        Command::Calibrate(args) => lab::calibrate::run(&args),
        Command::Campaign(args) => lab::campaign::run(&args),
        Command::Derive(args) => lab::derive::run(&args),
        Command::HeldOut(args) => lab::held_out::run(&args),
        Command::Reproduce(args) => lab::reproduce::run(&args),
        Command::Bench(args) => lab::bench::run(&args),
        Command::Mesh(args) => mesh::run(&args),
        Command::Validate(args) => lab::validate::run(&args),
        Command::Man { command } => manual(command.as_deref()),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Root::command(), "meshcast", &mut script);
            output::result(String::from_utf8_lossy(&script).into_owned())
        }
    }
}

/// The manual page of a command, or of the program.
fn manual(command: Option<&str>) -> CommandEnd {
    let mut root = Root::command();
    root.build();
    let about = match command {
        None => root,
        Some(name) => match root.find_subcommand(name) {
            Some(found) => found.clone(),
            None => {
                let names: Vec<&str> =
                    root.get_subcommands().map(clap::Command::get_name).collect();
                let meant = nearest(name, &names);
                let meant = meant.map_or(String::new(), |m| format!("; did you mean {m}?"));
                return Err(Fault::input(format!("there is no command {name:?}{meant}")));
            }
        },
    };
    let mut page = Vec::new();
    clap_mangen::Man::new(about)
        .render(&mut page)
        .map_err(|e| Fault::Failure(format!("the manual page cannot be made: {e}")))?;
    output::result(String::from_utf8_lossy(&page).into_owned())
}

fn open(project: Option<PathBuf>, ui: UiFlags, start: StartFlags) -> ExitCode {
    if let Some(path) = &project
        && let Some(meant) = mistyped_command(path)
    {
        return output::finish(Err(Fault::input(format!(
            "there is no project file {:?}; did you mean the command: meshcast {meant}",
            path.display().to_string()
        ))));
    }
    interactive::interactive(project, ui, start)
}

/// The command that a missing file without an ending looks like.
fn mistyped_command(path: &Path) -> Option<String> {
    let text = path.to_str()?;
    if path.exists() || text.contains(['.', '/', '\\']) {
        return None;
    }
    let root = Root::command();
    let names: Vec<&str> = root.get_subcommands().map(clap::Command::get_name).collect();
    nearest(text, &names).map(str::to_string)
}

/// The help that stands in for the interactive program where there is no terminal.
fn headless_help() -> String {
    Root::command().render_help().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_definition_of_the_command_line_is_sound() {
        Root::command().debug_assert();
    }
}
