//! The interactive program: `meshcast [PROJECT.ron]`.

use super::output::Fault;
use super::{StartFlags, UiFlags, flags, headless_help, output};
use crate::app::settings::SettingItem;
use crate::app::{self, App};
use crate::project::home::{FirstProject, Home};
use crate::project::{self, LoadError, Opened};
use crate::term::capabilities::Surroundings;
use crate::term::{
    Beginning, Ending, FileHost, Session, SessionOptions, TermError, can_be_shown, preferences,
};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

/// Opens a project in the terminal: the one named, or the last one. Without a terminal on standard
/// input and output, prints the help of the headless commands to standard error: exit code 2.
pub(crate) fn interactive(path: Option<PathBuf>, ui: UiFlags, start: StartFlags) -> ExitCode {
    if !(io::stdin().is_terminal() && io::stdout().is_terminal()) {
        output::say(
            "error",
            "the interactive program needs a terminal; without one, use a command",
        );
        let _ = write!(io::stderr(), "\n{}", headless_help());
        return ExitCode::from(output::BAD_INPUT);
    }
    open(path, flags::settings(&ui, &start))
}

/// Opens the project and hands the terminal over.
fn open(path: Option<PathBuf>, flags: Vec<(SettingItem, String)>) -> ExitCode {
    let home = Home::find();
    let start = match path {
        Some(path) => project::load(&path).map(|opened| FirstProject { opened, note: None }),
        None => home.start_project().and_then(shown_or_sample),
    };
    let FirstProject { opened, note } = match start {
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

/// A project that is opened unasked must not make the start impossible: if it brings out a fault of the
/// program, the sample takes its place.
fn shown_or_sample(first: FirstProject) -> Result<FirstProject, LoadError> {
    match first.opened.document.path() {
        Some(path) if !can_be_shown(&first.opened.project) => FirstProject::sample(&format!(
            "The last project, {}, brings out a fault of the program",
            path.display()
        )),
        _ => Ok(first),
    }
}

fn run(
    opened: Opened,
    note: Option<String>,
    flags: Vec<(SettingItem, String)>,
    home: Home,
) -> Result<Ending, TermError> {
    let Opened { document, project } = opened;
    let surroundings = Surroundings::of_process();
    let (preferences, bad_settings) = preferences(&home, &surroundings, flags);
    let settings = preferences.effective();
    let charset = surroundings.charset(settings.glyphs);
    let session = Session::open(SessionOptions {
        charset,
        clipboard: surroundings.clipboard(),
        ..SessionOptions::default()
    })?;
    if let Some(path) = document.path() {
        // Not being able to remember the file is no reason not to open it.
        let _ = home.remember(path);
    }
    let path = document.path().map(Path::to_path_buf);
    // A catalogue that cannot be read is no reason not to start; `meshcast mesh list` says why.
    let own = home.own_meshes().unwrap_or_default();
    let (host, Beginning { kept, holder, note: of_file }) = FileHost::new(document, home);
    let notes: Vec<String> = [bad_settings, note, of_file].into_iter().flatten().collect();
    let note = (!notes.is_empty()).then(|| notes.join("; "));
    let mut app = App::new(app::Start {
        project: Arc::new(project),
        path,
        note,
        kept,
        holder,
        look: preferences.look(&settings),
        units: settings.chosen_units(),
        // The loop says the real size before it draws.
        size: (80, 24),
        preferences,
    });
    app.offer(own);
    session.run(&mut app, Arc::new(host))
}
