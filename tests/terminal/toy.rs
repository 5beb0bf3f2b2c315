//! A small program on the real loop, run by the other tests: this test binary starts itself again, in a
//! pseudo-terminal, and takes the part of the program.

use crate::pty::Launch;
use meshcast::app::key::{Code, Key};
use meshcast::app::look::{ColorChoice, Look};
use meshcast::app::message::{Command, Message, SaveFailure, Saved};
use meshcast::project::Project;
use meshcast::term::capabilities::Surroundings;
use meshcast::term::{Ending, Host, Mail, Program, Session, SessionOptions};
use ratatui::buffer::Buffer;
use ratatui::layout::Position;
use ratatui::style::Style;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Names the recovery file and turns the test below into the program.
const RECOVERY: &str = "TOY_RECOVERY";
/// Milliseconds until edits are kept by themselves.
const AUTOSAVE: &str = "TOY_AUTOSAVE";

/// The toy, ready to be started. Keys: `+` counts and makes an edit, `n` does nothing, `d` asks for a
/// drawing in which nothing changed, `r` for a whole one, `s` saves, `p` fails, `w` fails in a worker,
/// `m` mails from a worker, Ctrl+Z stops, `q` quits.
pub(crate) fn toy() -> Launch {
    let launch = Launch::program(std::env::current_exe().unwrap());
    let recovery = recovery_file(&launch);
    launch
        .arg("--exact")
        .arg("toy::child")
        .arg("--ignored")
        .arg("--nocapture")
        .env(RECOVERY, recovery)
}

/// The toy, keeping its edits by itself after a short time.
pub(crate) fn toy_with_autosave() -> Launch {
    toy().env(AUTOSAVE, "100")
}

/// Where the toy keeps unsaved edits.
pub(crate) fn recovery_file(launch: &Launch) -> PathBuf {
    launch.home().join("recovery")
}

#[test]
#[ignore = "the program that the other tests start"]
fn child() {
    let Some(recovery) = std::env::var_os(RECOVERY) else { return };
    let autosave = std::env::var(AUTOSAVE).ok().and_then(|ms| ms.parse().ok());
    let surroundings = Surroundings::of_process();
    let options = SessionOptions {
        charset: surroundings.charset(None),
        autosave: autosave.map(Duration::from_millis),
        ..SessionOptions::default()
    };
    let session = Session::open(options).unwrap();
    let mut toy = Toy {
        look: surroundings.look(ColorChoice::Auto, None),
        mail: session.mail(),
        size: (0, 0),
        count: 0,
        said: String::new(),
        unsaved: None,
        dirty: true,
    };
    let ending = session.run(&mut toy, Arc::new(Files { recovery: recovery.into() })).unwrap();
    // The terminal may be gone, and `println!` would call that a fault.
    let _ = writeln!(std::io::stdout(), "the toy has ended: {ending:?}");
    std::process::exit(match ending {
        Ending::Quit => 0,
        Ending::HungUp => 3,
    });
}

struct Toy {
    look: Look,
    mail: Mail,
    size: (u16, u16),
    count: u32,
    said: String,
    unsaved: Option<Arc<Project>>,
    dirty: bool,
}

impl Program for Toy {
    fn update(&mut self, message: Message) -> Vec<Command> {
        match message {
            Message::Key(key) => return self.key(key),
            Message::Paste(text) => self.say(&format!("pasted {text}")),
            Message::Resize { width, height } => {
                self.size = (width, height);
                self.dirty = true;
            }
            Message::Saved(Ok(saved)) => {
                self.unsaved = None;
                self.say(&format!("saved {}", saved.project.name));
            }
            Message::Saved(Err(failure)) => self.say(&failure.message),
            Message::Trouble(trouble) => self.say(&trouble),
            Message::Resumed => self.say("back again"),
            _ => {}
        }
        Vec::new()
    }

    fn draw(&self, buffer: &mut Buffer) -> Option<Position> {
        let (width, height) = self.size;
        let style = Style::new().light_cyan().bold();
        buffer.set_string(0, 0, format!("toy {width}x{height} ⣿ count {}", self.count), style);
        if height > 1 {
            buffer.set_string(0, 1, &self.said, Style::new());
        }
        for y in 2..height {
            buffer.set_string(0, y, format!("row {y} ").repeat(20), Style::new());
        }
        if height > 2 {
            buffer.set_string(width.saturating_sub(3), height - 1, "end", Style::new().reversed());
        }
        None
    }

    fn take_dirty(&mut self) -> bool {
        std::mem::take(&mut self.dirty)
    }

    fn unsaved(&self) -> Option<Arc<Project>> {
        self.unsaved.clone()
    }

    fn look(&self) -> Look {
        self.look
    }
}

impl Toy {
    fn say(&mut self, text: &str) {
        text.clone_into(&mut self.said);
        self.dirty = true;
    }

    fn key(&mut self, key: Key) -> Vec<Command> {
        if key == Key::ctrl('z') {
            return vec![Command::Suspend];
        }
        if key != Key::plain(key.code) {
            self.say(&format!("key {key}"));
            return Vec::new();
        }
        match key.code {
            Code::Char('+') => {
                self.count += 1;
                let name = format!("edit {}", self.count);
                self.unsaved = Some(Arc::new(Project::starter(name)));
                self.dirty = true;
            }
            Code::Char('d') => self.dirty = true,
            Code::Char('n') => {}
            Code::Char('r') => return vec![Command::Redraw],
            Code::Char('s') => {
                let project =
                    self.unsaved.clone().unwrap_or_else(|| Project::starter("toy").into());
                return vec![Command::Save { project, path: None, overwrite: false }];
            }
            Code::Char('p') => panic!("the toy broke"),
            Code::Char('w') => {
                std::thread::spawn(|| panic!("the worker broke"));
            }
            Code::Char('o') => {
                std::thread::spawn(|| println!("{}", deep(1)));
            }
            Code::Char('O') => println!("{}", deep(1)),
            Code::Char('a') => {
                std::thread::spawn(|| std::process::abort());
            }
            Code::Char('m') => {
                let mail = self.mail.clone();
                std::thread::spawn(move || mail.send(Message::Trouble("a letter".to_owned())));
            }
            Code::Char('q') => return vec![Command::Quit],
            _ => self.say(&format!("key {key}")),
        }
        Vec::new()
    }
}

/// Calls itself until the stack is used up.
fn deep(level: u64) -> u64 {
    let room = std::hint::black_box([level; 64]);
    if level == 0 { 0 } else { deep(level + 1) + room[63] }
}

struct Files {
    recovery: PathBuf,
}

impl Host for Files {
    fn save(
        &self,
        project: &Arc<Project>,
        _path: Option<&Path>,
        _overwrite: bool,
    ) -> Result<Saved, SaveFailure> {
        Ok(Saved { project: Arc::clone(project), path: PathBuf::from("toy"), note: None })
    }

    fn recover(&self, project: &Project) -> Result<PathBuf, String> {
        fs::write(&self.recovery, &project.name).map_err(|error| error.to_string())?;
        Ok(self.recovery.clone())
    }

    fn forget_recovery(&self) -> Result<(), String> {
        match fs::remove_file(&self.recovery) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(error.to_string()),
            _ => Ok(()),
        }
    }
}
