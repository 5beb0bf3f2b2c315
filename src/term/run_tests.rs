//! The loop with a stage, a program and a host that only take notes.

use super::super::cells::Charset;
use super::super::events::{self, Mail};
use super::*;
use crate::app::key::{Code, Key};
use crate::app::look::Look;
use crate::app::message::{OpenFailure, OpenedProject, SaveFailure, Saved};
use crate::project::Project;
use ratatui::buffer::Buffer;
use ratatui::layout::Position;
use ratatui::style::Style;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// What happened, in order.
type Notes = Arc<Mutex<Vec<String>>>;

fn note(notes: &Notes, text: impl Into<String>) {
    notes.lock().unwrap().push(text.into());
}

struct NotedStage {
    notes: Notes,
    broken: bool,
    can_stop: bool,
    size: (u16, u16),
}

impl Stage for NotedStage {
    fn size(&self) -> (u16, u16) {
        self.size
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        if self.broken {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        let copied = bytes.starts_with(b"\x1b]52");
        note(&self.notes, if copied { "copied" } else { "frame" });
        Ok(())
    }

    fn take(&mut self) -> io::Result<()> {
        note(&self.notes, "take");
        Ok(())
    }

    fn suspend(&mut self, group: bool) -> bool {
        note(&self.notes, if group { "suspend all" } else { "suspend" });
        self.can_stop
    }
}

struct NotedHost {
    notes: Notes,
    full: bool,
    /// A save waits for a word from here, as for a disk that does not answer.
    gate: Option<Mutex<Receiver<()>>>,
    /// So does the recovery file.
    recovery_gate: Option<Mutex<Receiver<()>>>,
}

impl NotedHost {
    fn new(notes: &Notes, full: bool) -> NotedHost {
        NotedHost { notes: Arc::clone(notes), full, gate: None, recovery_gate: None }
    }
}

impl Host for NotedHost {
    fn save(
        &self,
        project: &Arc<Project>,
        path: Option<&Path>,
        overwrite: bool,
    ) -> Result<Saved, SaveFailure> {
        note(&self.notes, format!("save {} {path:?} {overwrite}", project.name));
        if let Some(gate) = &self.gate {
            gate.lock().unwrap().recv_timeout(PATIENCE).unwrap();
        }
        Ok(Saved { project: Arc::clone(project), path: PathBuf::new(), note: None })
    }

    fn recover(&self, project: &Project) -> Result<PathBuf, String> {
        note(&self.notes, format!("recover {}", project.name));
        if let Some(gate) = &self.recovery_gate {
            gate.lock().unwrap().recv_timeout(PATIENCE).unwrap();
            note(&self.notes, "recovered");
        }
        if self.full { Err("no room".to_owned()) } else { Ok(PathBuf::new()) }
    }

    fn forget_recovery(&self) -> Result<(), String> {
        note(&self.notes, "forget");
        Ok(())
    }

    fn open(&self, path: &Path) -> Result<OpenedProject, OpenFailure> {
        note(&self.notes, format!("open {}", path.display()));
        let project = Arc::new(Project::starter("other"));
        Ok(OpenedProject {
            project,
            path: path.to_path_buf(),
            note: None,
            kept: None,
            holder: None,
        })
    }
}

/// Notes messages; keys ask for effects.
struct NotedProgram {
    notes: Notes,
    count: u32,
    dirty: bool,
    unsaved: Option<Arc<Project>>,
}

impl Program for NotedProgram {
    fn update(&mut self, message: Message) -> Vec<Command> {
        match message {
            Message::Key(Key { code: Code::Char(c), .. }) => {
                match c {
                    '+' => {
                        self.count += 1;
                        self.dirty = true;
                    }
                    'e' => self.unsaved = Some(Arc::new(Project::starter("edited"))),
                    'u' => self.unsaved = None,
                    's' => {
                        let project = Arc::clone(self.unsaved.as_ref().unwrap());
                        return vec![Command::Save { project, path: None, overwrite: true }];
                    }
                    'z' => return vec![Command::Suspend],
                    'r' => return vec![Command::Redraw],
                    'y' => return vec![Command::Copy { text: "22.8 kN".to_owned() }],
                    'o' => return vec![Command::OpenProject { path: "other.ron".into() }],
                    'q' => return vec![Command::Quit],
                    _ => {}
                }
                note(&self.notes, format!("key {c}"));
            }
            Message::Saved(result) => {
                let saved = result.unwrap().project;
                self.unsaved.take_if(|unsaved| Arc::ptr_eq(unsaved, &saved));
                note(&self.notes, "saved");
            }
            Message::Trouble(text) => note(&self.notes, format!("trouble: {text}")),
            Message::HangUp => {
                note(&self.notes, "hang-up");
                return vec![Command::Redraw, Command::Suspend];
            }
            Message::Resumed => note(&self.notes, "resumed"),
            Message::Resize { width, height } => {
                note(&self.notes, format!("size {width}x{height}"));
            }
            Message::Opened(_) => {
                self.unsaved = None;
                note(&self.notes, "opened");
                return vec![Command::TakeOver];
            }
            _ => {}
        }
        Vec::new()
    }

    fn draw(&self, buffer: &mut Buffer) -> Option<Position> {
        buffer.set_string(0, 0, self.count.to_string(), Style::new());
        None
    }

    fn take_dirty(&mut self) -> bool {
        std::mem::take(&mut self.dirty)
    }

    fn unsaved(&self) -> Option<Arc<Project>> {
        self.unsaved.clone()
    }

    fn look(&self) -> Look {
        Look::default()
    }
}

/// How the loop is set up; the defaults are those of a healthy world.
struct Setting {
    broken: bool,
    can_stop: bool,
    full: bool,
    autosave: Option<Duration>,
}

const HEALTHY: Setting = Setting { broken: false, can_stop: true, full: false, autosave: None };

/// Runs the loop on what `send` puts into the channel; all of it is there before the loop starts, unless
/// `send` leaves a thread behind. Files are written on the spot.
fn run(setting: Setting, send: impl FnOnce(Mail)) -> (Ending, Vec<String>) {
    let notes = Notes::default();
    let host = NotedHost::new(&notes, setting.full);
    let host: Arc<dyn Host> = Arc::new(host);
    let (mail, events) = events::open();
    send(mail);
    let filing = Filing::on_the_spot(Arc::clone(&host));
    let rescue = Arc::new(Rescue::new(Arc::clone(&host)));
    let keeping = Keeping::on_the_spot(Arc::clone(&host), Arc::clone(&rescue));
    let ending = run_with(setting, (host, rescue), (filing, keeping), events, &notes);
    let notes = notes.lock().unwrap().clone();
    (ending, notes)
}

fn run_with(
    setting: Setting,
    (host, rescue): (Arc<dyn Host>, Arc<Rescue>),
    (filing, keeping): (Filing, Keeping),
    events: Receiver<Event>,
    notes: &Notes,
) -> Ending {
    let mut program =
        NotedProgram { notes: Arc::clone(notes), count: 0, dirty: true, unsaved: None };
    let (ending, _) = Loop {
        workshop: Workshop::none(),
        filing,
        keeping,
        program: &mut program,
        stage: NotedStage {
            notes: Arc::clone(notes),
            broken: setting.broken,
            can_stop: setting.can_stop,
            size: (20, 4),
        },
        rescue,
        host,
        events,
        painter: Painter::new(Charset::Utf8),
        clipboard: setting.can_stop,
        autosave: setting.autosave,
        size: (0, 0),
        unkept_since: None,
        kept_at: None,
        away: false,
        redraw: true,
        ending: None,
    }
    .run();
    ending
}

/// Far beyond what any step here takes; only reached where something hangs.
const PATIENCE: Duration = Duration::from_secs(20);

/// Waits until something is noted, or in vain for long.
fn hear(notes: &Notes, word: &str) {
    let start = Instant::now();
    while !notes.lock().unwrap().iter().any(|noted| noted == word) && start.elapsed() < PATIENCE / 2
    {
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn without_frames(notes: &Notes) -> Vec<String> {
    notes.lock().unwrap().iter().filter(|noted| *noted != "frame").cloned().collect()
}

/// Runs the loop with a host whose saves wait: once `word` is noted of the keys typed, the save goes on,
/// and the program ends when it was answered.
fn run_with_a_slow_disk(keys: &'static str, word: &'static str) -> Vec<String> {
    let notes = Notes::default();
    let (open_gate, gate) = std::sync::mpsc::channel();
    let gate = Some(Mutex::new(gate));
    let host: Arc<dyn Host> = Arc::new(NotedHost { gate, ..NotedHost::new(&notes, false) });
    let (mail, events) = events::open();
    let filing = Filing::open(Arc::clone(&host), mail.clone());
    let rescue = Arc::new(Rescue::new(Arc::clone(&host)));
    let keeping = Keeping::on_the_spot(Arc::clone(&host), Arc::clone(&rescue));
    let watched = Arc::clone(&notes);
    std::thread::spawn(move || {
        type_keys(&mail, keys);
        hear(&watched, word);
        let _ = open_gate.send(());
        hear(&watched, "saved");
        type_keys(&mail, "q");
    });
    run_with(HEALTHY, (host, rescue), (filing, keeping), events, &notes);
    without_frames(&notes)
}

/// Runs the loop with a host whose recovery file waits for its disk: `first` is typed, and `then` once the
/// file is being written; when `word` is noted of that the disk answers, and the program ends.
fn run_with_a_slow_recovery(
    first: &'static str,
    then: &'static str,
    word: &'static str,
) -> Vec<String> {
    let notes = Notes::default();
    let (open_gate, gate) = std::sync::mpsc::channel();
    let recovery_gate = Some(Mutex::new(gate));
    let host: Arc<dyn Host> =
        Arc::new(NotedHost { recovery_gate, ..NotedHost::new(&notes, false) });
    let (mail, events) = events::open();
    let filing = Filing::on_the_spot(Arc::clone(&host));
    let rescue = Arc::new(Rescue::new(Arc::clone(&host)));
    let keeping = Keeping::open(Arc::clone(&host), Arc::clone(&rescue), mail.clone());
    let watched = Arc::clone(&notes);
    std::thread::spawn(move || {
        type_keys(&mail, first);
        hear(&watched, "recover edited");
        type_keys(&mail, then);
        hear(&watched, word);
        let _ = open_gate.send(());
        hear(&watched, "recovered");
        type_keys(&mail, "q");
    });
    let setting = Setting { autosave: Some(Duration::from_millis(5)), ..HEALTHY };
    run_with(setting, (host, rescue), (filing, keeping), events, &notes);
    without_frames(&notes)
}

fn type_keys(mail: &Mail, keys: &str) {
    for c in keys.chars() {
        mail.send(Message::Key(Key::char(c)));
    }
}

fn keys(text: &'static str) -> impl FnOnce(Mail) {
    move |mail| type_keys(&mail, text)
}

#[test]
fn queued_keys_make_one_frame() {
    let (ending, notes) = run(HEALTHY, |mail| {
        type_keys(&mail, "+++");
        std::thread::spawn(move || {
            std::thread::sleep(Duration::from_millis(50));
            type_keys(&mail, "nq");
        });
    });
    assert_eq!(ending, Ending::Quit);
    assert_eq!(notes, ["size 20x4", "frame", "key +", "key +", "key +", "frame", "key n"]);
}

#[test]
fn what_comes_after_quit_is_not_looked_at() {
    assert_eq!(run(HEALTHY, keys("q+++")).1, ["size 20x4", "frame"]);
}

#[test]
fn a_save_is_answered_and_its_effects_carried_out() {
    let (_, notes) = run(HEALTHY, keys("esq"));
    assert_eq!(notes, ["size 20x4", "frame", "key e", "save edited None true", "saved", "forget"]);
}

#[test]
fn keys_are_answered_while_a_save_waits_for_its_disk() {
    let notes = run_with_a_slow_disk("es+", "key +");
    let wanted = ["size 20x4", "key e", "save edited None true", "key +", "saved", "forget"];
    // Which of the two threads is the first does not matter.
    let mut notes = notes;
    if notes[2] == "key +" {
        notes.swap(2, 3);
    }
    assert_eq!(notes, wanted);
}

#[test]
fn edits_made_while_a_save_runs_stay_unsaved_and_are_kept_again() {
    let notes = run_with_a_slow_disk("es+e+n", "key n");
    let end = notes.iter().position(|noted| noted == "saved").unwrap();
    assert_eq!(notes[end..], ["saved", "recover edited"]);
}

#[test]
fn a_hang_up_keeps_what_is_unsaved_whatever_the_program_does() {
    let (ending, notes) = run(HEALTHY, |mail| {
        type_keys(&mail, "e");
        mail.send(Message::HangUp);
        type_keys(&mail, "+");
    });
    assert_eq!(ending, Ending::HungUp);
    assert_eq!(notes, ["size 20x4", "frame", "key e", "hang-up", "recover edited"]);
}

#[test]
fn a_write_that_fails_and_a_channel_that_closes_are_hang_ups() {
    let (ending, notes) = run(Setting { broken: true, ..HEALTHY }, keys(""));
    assert_eq!((ending, notes), (Ending::HungUp, vec!["size 20x4".into(), "hang-up".into()]));
    let (ending, notes) = run(HEALTHY, drop);
    assert_eq!(ending, Ending::HungUp);
    assert_eq!(notes, ["size 20x4", "frame", "hang-up"]);
}

#[test]
fn stopped_it_draws_nothing_until_it_is_continued() {
    let (_, notes) = run(HEALTHY, |mail| {
        type_keys(&mail, "z+");
        std::thread::spawn(move || {
            std::thread::sleep(Duration::from_millis(50));
            mail.event(Event::Continue);
            std::thread::sleep(Duration::from_millis(50));
            type_keys(&mail, "q");
        });
    });
    let wanted = ["size 20x4", "frame", "suspend all", "key +", "take", "resumed", "frame"];
    assert_eq!(notes, wanted);
}

#[test]
fn told_to_stop_it_stops_alone_and_where_it_cannot_it_goes_on() {
    let (_, notes) = run(Setting { can_stop: false, ..HEALTHY }, |mail| {
        mail.event(Event::Stop);
        type_keys(&mail, "+");
        std::thread::spawn(move || {
            std::thread::sleep(Duration::from_millis(50));
            type_keys(&mail, "q");
        });
    });
    assert_eq!(notes, ["size 20x4", "frame", "suspend", "key +", "frame"]);
}

#[test]
fn only_a_new_size_counts_as_one() {
    let (_, notes) = run(HEALTHY, |mail| {
        mail.send(Message::Resize { width: 20, height: 4 });
        mail.send(Message::Resize { width: 30, height: 4 });
        type_keys(&mail, "q");
    });
    assert_eq!(notes, ["size 20x4", "frame", "size 30x4"]);
}

#[test]
fn edits_are_kept_once_and_forgotten_when_they_are_gone() {
    let setting = Setting { autosave: Some(Duration::from_millis(5)), ..HEALTHY };
    let (_, notes) = run(setting, |mail| {
        type_keys(&mail, "e");
        std::thread::spawn(move || {
            std::thread::sleep(Duration::from_millis(150));
            type_keys(&mail, "uq");
        });
    });
    assert_eq!(notes, ["size 20x4", "frame", "key e", "recover edited", "key u", "forget"]);
}

#[test]
fn edits_are_kept_in_the_middle_of_a_flood_of_keys() {
    let setting = Setting { autosave: Some(Duration::ZERO), ..HEALTHY };
    let (_, notes) = run(setting, |mail| {
        type_keys(&mail, "e");
        type_keys(&mail, &"+".repeat(2_000));
        type_keys(&mail, "q");
    });
    let kept = notes.iter().position(|noted| noted == "recover edited").unwrap();
    let after = notes[kept..].iter().filter(|noted| *noted == "key +").count();
    assert!(after > 1_000, "{after} keys came after they were kept");
}

#[test]
fn keys_are_answered_while_the_recovery_file_waits_for_its_disk() {
    let notes = run_with_a_slow_recovery("e", "+", "key +");
    assert_eq!(notes, ["size 20x4", "key e", "recover edited", "key +", "recovered"]);
}

#[test]
fn a_recovery_file_of_edits_that_went_while_it_was_written_goes_too() {
    let notes = run_with_a_slow_recovery("e", "u", "key u");
    assert_eq!(notes[..5], ["size 20x4", "key e", "recover edited", "key u", "recovered"]);
    // Once or twice, for the loop may hear of the file before it ends.
    assert!(notes.len() > 5 && notes[5..].iter().all(|noted| noted == "forget"), "{notes:?}");
}

#[test]
fn edits_that_cannot_be_kept_are_told_once() {
    let setting = Setting { autosave: Some(Duration::from_millis(5)), full: true, ..HEALTHY };
    let (_, notes) = run(setting, |mail| {
        type_keys(&mail, "e");
        std::thread::spawn(move || {
            std::thread::sleep(Duration::from_millis(150));
            type_keys(&mail, "q");
        });
    });
    let told = "trouble: unsaved edits could not be kept in the recovery file: no room";
    assert_eq!(notes, ["size 20x4", "frame", "key e", "recover edited", told]);
}

#[test]
fn after_opening_another_project_its_recovery_file_stays() {
    // `e` edits, `o` opens another project, whose answer lets the edits go.
    let setting = Setting { autosave: Some(Duration::from_millis(5)), ..HEALTHY };
    let (_, notes) = run(setting, |mail| {
        type_keys(&mail, "e");
        std::thread::spawn(move || {
            std::thread::sleep(Duration::from_millis(150));
            type_keys(&mail, "oq");
        });
    });
    let wanted = ["size 20x4", "frame", "key e", "recover edited", "open other.ron", "opened"];
    assert_eq!(notes, wanted);
}

#[test]
fn a_copy_is_sent_at_once_and_draws_nothing() {
    let (_, notes) = run(HEALTHY, keys("yq"));
    assert_eq!(notes, ["size 20x4", "frame", "copied"]);
    // A terminal that would show the bytes gets none.
    let (_, notes) = run(Setting { can_stop: false, ..HEALTHY }, keys("yq"));
    assert_eq!(notes, ["size 20x4", "frame", "trouble: this kind of terminal has no clipboard"]);
}
