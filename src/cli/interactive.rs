//! The interactive program: `meshcast [PROJECT.ron]`.

use super::flags::{ColorFlag, GlyphFlag};
use super::output::Fault;
use super::{UiFlags, headless_help, output};
use crate::app::look::{ColorChoice, Glyphs};
use crate::app::{self, App};
use crate::project::home::{Home, Start};
use crate::project::{self, Document, Opened};
use crate::term::capabilities::Surroundings;
use crate::term::{Ending, FileHost, Options, Session, TermError};
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

/// Opens a project in the terminal: the one named, or the last one. Without a terminal on standard
/// input and output, prints the help of the headless commands to standard error: exit code 2.
pub fn interactive(path: Option<PathBuf>, flags: UiFlags) -> ExitCode {
    if !(io::stdin().is_terminal() && io::stdout().is_terminal()) {
        output::say(
            "error",
            "the interactive program needs a terminal; without one, use a command",
        );
        let _ = write!(io::stderr(), "\n{}", headless_help());
        return ExitCode::from(output::BAD_INPUT);
    }
    start(path, flags)
}

/// Opens the project and hands the terminal over.
fn start(path: Option<PathBuf>, flags: UiFlags) -> ExitCode {
    let home = Home::find();
    let start = match path {
        Some(path) => project::load(&path).map(|opened| Start { opened, note: None }),
        None => home.start_project(),
    };
    let Start { opened, note } = match start {
        Ok(start) => start,
        Err(error) => return output::finish(Err(Fault::from(error))),
    };
    match run(opened, note, flags, home) {
        Ok(Ending::Quit) => ExitCode::SUCCESS,
        Ok(Ending::HungUp) => ExitCode::from(output::FAILURE),
        Err(error) => {
            output::say("error", &error.to_string());
            ExitCode::from(output::FAILURE)
        }
    }
}

fn run(
    opened: Opened,
    note: Option<String>,
    flags: UiFlags,
    home: Home,
) -> Result<Ending, TermError> {
    let Opened { document, project } = opened;
    let surroundings = Surroundings::of_process();
    let glyphs = flags.glyphs.map(Glyphs::from);
    let color = flags.color.map_or(ColorChoice::Auto, ColorChoice::from);
    let session =
        Session::open(Options { charset: surroundings.charset(glyphs), ..Options::default() })?;
    if let Some(path) = document.path() {
        // Not being able to remember the file is no reason not to open it.
        let _ = home.remember(path);
    }
    let mut note = note.or_else(|| migrated(&document));
    let kept = document.find_recovery(&home).and_then(|kept| {
        let project = document.recover(&kept);
        if project.is_err() {
            let path = kept.path.display();
            note = Some(format!("edits kept from a lost session cannot be read: {path}"));
        }
        project.ok()
    });
    let mut app = App::new(app::Start {
        project: Arc::new(project),
        path: document.path().map(|p| p.to_path_buf()),
        note,
        kept: kept.map(Arc::new),
        look: surroundings.look(color, glyphs),
        units: flags.units,
        // The loop says the real size before it draws.
        size: (80, 24),
    });
    session.run(&mut app, Arc::new(FileHost::new(document, home)))
}

/// What to say of a file in an older format.
fn migrated(document: &Document) -> Option<String> {
    document.migrated_from().map(|version| {
        format!("the file has the older format {version}; saving brings it up to date")
    })
}

impl From<ColorFlag> for ColorChoice {
    fn from(flag: ColorFlag) -> Self {
        match flag {
            ColorFlag::Auto => ColorChoice::Auto,
            ColorFlag::Sixteen => ColorChoice::Basic16,
            ColorFlag::None => ColorChoice::None,
        }
    }
}

impl From<GlyphFlag> for Glyphs {
    fn from(flag: GlyphFlag) -> Self {
        match flag {
            GlyphFlag::Braille => Glyphs::Braille,
            GlyphFlag::Block => Glyphs::Block,
            GlyphFlag::Ascii => Glyphs::Ascii,
        }
    }
}
