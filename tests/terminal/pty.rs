//! A pseudo-terminal with a program in it, and an emulator that shows what the program draws.
//!
//! ```ignore
//! let mut pty = Launch::meshcast().arg("road-cut.ron").size(80, 24).start();
//! pty.wait_for("bench 2");
//! pty.send("\x1b[B");
//! pty.send("q");
//! assert!(pty.wait_exit().success());
//! ```

use portable_pty::{Child, CommandBuilder, ExitStatus, MasterPty, PtySize, native_pty_system};
use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
use rustix::process::{Pid, Signal, kill_process};
use rustix::termios::{LocalModes, tcgetattr};
use std::ffi::OsString;
use std::fs::File;
use std::io::{ErrorKind, Read, Write};
use std::num::NonZeroU16;
use std::os::fd::BorrowedFd;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Longest wait for anything; generous, because other tests share the machine.
pub(crate) const PATIENCE: Duration = Duration::from_secs(20);
/// A terminal is quiet when it got nothing for this long.
const QUIET: Duration = Duration::from_millis(400);
/// Time between two looks.
const LOOK: Duration = Duration::from_millis(5);

/// A program about to be started. Its environment holds nothing but `PATH`, a UTF-8 xterm, a home
/// directory of its own, and what is added here.
pub(crate) struct Launch {
    program: PathBuf,
    args: Vec<OsString>,
    env: Vec<(OsString, OsString)>,
    size: (u16, u16),
    home: tempfile::TempDir,
    seen: bool,
}

impl Launch {
    /// The built `meshcast`, which does not begin with the tour.
    pub(crate) fn meshcast() -> Launch {
        Launch::new_user().arg("--no-tour")
    }

    /// The built `meshcast` as one who never ran it finds it.
    pub(crate) fn new_user() -> Launch {
        Launch::program(env!("CARGO_BIN_EXE_meshcast"))
    }

    /// Any program.
    pub(crate) fn program(program: impl AsRef<Path>) -> Launch {
        let home = tempfile::tempdir().unwrap();
        let launch = Launch {
            program: program.as_ref().to_path_buf(),
            args: Vec::new(),
            env: Vec::new(),
            size: (80, 24),
            home,
            seen: true,
        };
        let home = launch.home().into_os_string();
        launch
            .env("PATH", std::env::var_os("PATH").unwrap_or_default())
            .env("TERM", "xterm-256color")
            .env("LANG", "C.UTF-8")
            .env("HOME", home)
    }

    /// Without an emulator: what is sent is kept, and any size will do.
    pub(crate) fn unseen(mut self) -> Launch {
        self.seen = false;
        self
    }

    /// A shell script in place of the program, with the same environment.
    pub(crate) fn wrapped_in_shell(mut self, script: &str) -> Launch {
        self.program = PathBuf::from("/bin/sh");
        self.args = vec!["-c".into(), script.into()];
        self
    }

    /// The home directory, there until the program has ended.
    pub(crate) fn home(&self) -> PathBuf {
        self.home.path().to_path_buf()
    }

    /// One more argument.
    pub(crate) fn arg(mut self, arg: impl Into<OsString>) -> Launch {
        self.args.push(arg.into());
        self
    }

    /// An environment variable.
    pub(crate) fn env(mut self, name: impl Into<OsString>, value: impl Into<OsString>) -> Launch {
        let name = name.into();
        self.env.retain(|(known, _)| *known != name);
        self.env.push((name, value.into()));
        self
    }

    /// Takes an environment variable away.
    pub(crate) fn without(mut self, name: &str) -> Launch {
        self.env.retain(|(known, _)| known != name);
        self
    }

    /// Columns and rows.
    pub(crate) fn size(mut self, width: u16, height: u16) -> Launch {
        self.size = (width, height);
        self
    }

    /// Starts the program as leader of a session of its own, on a new terminal.
    pub(crate) fn start(self) -> Pty {
        let Launch { program, args, env, size, home, seen } = self;
        let pair = native_pty_system().openpty(pty_size(size)).unwrap();
        let mut command = CommandBuilder::new(program);
        command.args(args);
        command.cwd(home.path());
        command.env_clear();
        for (name, value) in env {
            command.env(name, value);
        }
        let child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let file = own_end(pair.master.as_ref());
        let state = Arc::new(Mutex::new(State {
            emulator: vt100::Parser::new(nonzero(size.1), nonzero(size.0), 0),
            bytes: Vec::new(),
            last: Instant::now(),
            seen,
        }));
        let control = Arc::new(Control::default());
        let reader = thread::spawn({
            let (state, control) = (Arc::clone(&state), Arc::clone(&control));
            let file = file.try_clone().unwrap();
            move || listen(file, &state, &control)
        });
        Pty {
            child,
            line: Some((pair.master, file)),
            state,
            control,
            reader: Some(reader),
            _home: home,
        }
    }
}

/// What has come out of the terminal.
struct State {
    emulator: vt100::Parser,
    bytes: Vec<u8>,
    last: Instant,
    seen: bool,
}

/// Orders to the thread that reads.
#[derive(Default)]
struct Control {
    end: AtomicBool,
    deaf: AtomicBool,
}

/// A running program in its terminal; killed when dropped.
pub(crate) struct Pty {
    child: Box<dyn Child + Send + Sync>,
    line: Option<(Box<dyn MasterPty + Send>, File)>,
    state: Arc<Mutex<State>>,
    control: Arc<Control>,
    reader: Option<JoinHandle<()>>,
    _home: tempfile::TempDir,
}

impl Pty {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap()
    }

    fn file(&self) -> &File {
        &self.line.as_ref().expect("the terminal has hung up").1
    }

    /// Types, escape sequences included: `"\x1b[A"` is the arrow up, `"\x13"` is Ctrl+S.
    pub(crate) fn send(&self, keys: &str) {
        self.send_bytes(keys.as_bytes());
    }

    /// Sends bytes, whatever they are.
    pub(crate) fn send_bytes(&self, bytes: &[u8]) {
        let mut rest = bytes;
        let start = Instant::now();
        while !rest.is_empty() {
            rest = self.offer(rest).unwrap_or_else(|error| panic!("cannot type: {error}"));
            assert!(start.elapsed() < PATIENCE, "the program reads nothing");
        }
    }

    /// Sends bytes as long as the program runs; whether it has taken them all.
    pub(crate) fn try_send(&mut self, bytes: &[u8]) -> bool {
        let mut rest = bytes;
        let start = Instant::now();
        while !rest.is_empty() {
            match self.offer(rest) {
                Ok(left) => rest = left,
                Err(_) => return false,
            }
            if !rest.is_empty() && self.ends_within(LOOK) {
                return false;
            }
            assert!(start.elapsed() < PATIENCE, "the program reads nothing");
        }
        true
    }

    /// Offers bytes to the terminal once; what it did not take.
    fn offer<'a>(&self, bytes: &'a [u8]) -> std::io::Result<&'a [u8]> {
        match self.file().write(bytes) {
            Ok(taken) => Ok(&bytes[taken..]),
            Err(error) if error.kind() == ErrorKind::WouldBlock => {
                thread::sleep(LOOK);
                Ok(bytes)
            }
            Err(error) => Err(error),
        }
    }

    /// The screen as text, a line each row.
    pub(crate) fn dump(&self) -> String {
        self.state().emulator.screen().contents()
    }

    /// Waits until the screen contains a text.
    pub(crate) fn wait_for(&self, text: &str) {
        self.wait_until(&format!("{text:?} on the screen"), |screen| {
            screen.contents().contains(text)
        });
    }

    /// Waits until bytes were received.
    pub(crate) fn wait_for_bytes(&self, bytes: &[u8]) {
        let start = Instant::now();
        while !self.state().bytes.windows(bytes.len()).any(|window| window == bytes) {
            assert!(start.elapsed() < PATIENCE, "waited for {}", bytes.escape_ascii());
            thread::sleep(LOOK);
        }
    }

    /// Waits until the screen is as wanted.
    pub(crate) fn wait_until(&self, what: &str, wanted: impl Fn(&vt100::Screen) -> bool) {
        let start = Instant::now();
        while !wanted(self.state().emulator.screen()) {
            assert!(start.elapsed() < PATIENCE, "waited for {what}; the screen:\n{}", self.dump());
            thread::sleep(LOOK);
        }
    }

    /// Looks at the screen.
    pub(crate) fn screen<T>(&self, look: impl FnOnce(&vt100::Screen) -> T) -> T {
        look(self.state().emulator.screen())
    }

    /// All bytes received so far.
    pub(crate) fn received(&self) -> Vec<u8> {
        self.state().bytes.clone()
    }

    /// Waits until the terminal is quiet; bytes received until then.
    pub(crate) fn settle(&self) -> usize {
        let start = Instant::now();
        loop {
            {
                let state = self.state();
                if state.last.elapsed() >= QUIET {
                    return state.bytes.len();
                }
            }
            assert!(start.elapsed() < PATIENCE, "the program never stops sending");
            thread::sleep(LOOK);
        }
    }

    /// Bytes sent in answer to some keys.
    pub(crate) fn cost_of(&self, keys: &str) -> usize {
        let before = self.settle();
        self.send(keys);
        thread::sleep(QUIET);
        self.settle() - before
    }

    /// Writes to the screen behind the program's back.
    pub(crate) fn spoil(&self, bytes: &str) {
        self.state().emulator.process(bytes.as_bytes());
    }

    /// Changes the size of the terminal.
    pub(crate) fn resize(&self, width: u16, height: u16) {
        if self.state().seen {
            self.state().emulator.screen_mut().set_size(nonzero(height), nonzero(width));
        }
        let (master, _) = self.line.as_ref().expect("the terminal has hung up");
        master.resize(pty_size((width, height))).unwrap();
    }

    /// The number of the program's process.
    pub(crate) fn id(&self) -> u32 {
        self.child.process_id().expect("it has been waited for")
    }

    /// Sends the program a signal.
    pub(crate) fn signal(&self, signal: Signal) {
        kill_process(Pid::from_raw(self.id() as i32).unwrap(), signal).unwrap();
    }

    /// Sends the program a signal, if it is still there.
    pub(crate) fn try_signal(&self, signal: Signal) {
        if let Some(id) = self.child.process_id() {
            let _ = kill_process(Pid::from_raw(id as i32).unwrap(), signal);
        }
    }

    /// Stops reading what the program sends, like a line that is stuck.
    pub(crate) fn go_deaf(&self) {
        self.control.deaf.store(true, Ordering::SeqCst);
    }

    /// Closes the line, as when SSH drops.
    pub(crate) fn hang_up(&mut self) {
        self.control.end.store(true, Ordering::SeqCst);
        if let Some(reader) = self.reader.take() {
            reader.join().unwrap();
        }
        self.line = None;
    }

    /// Whether line editing and echo are on, as a shell leaves them.
    pub(crate) fn is_cooked(&self) -> bool {
        let modes = tcgetattr(self.file()).unwrap().local_modes;
        modes.contains(LocalModes::ICANON | LocalModes::ECHO | LocalModes::ISIG)
    }

    /// Asserts that the terminal is as a shell wants it.
    pub(crate) fn assert_restored(&self) {
        assert!(self.is_cooked(), "line editing and echo are off");
        self.wait_until("the main screen and a cursor", |screen| {
            !screen.alternate_screen() && !screen.hide_cursor() && !screen.bracketed_paste()
        });
        self.screen(|screen| {
            assert!(!screen.bold() && !screen.inverse() && !screen.underline());
            assert_eq!(screen.fgcolor(), vt100::Color::Default);
            assert_eq!(screen.bgcolor(), vt100::Color::Default);
            assert_eq!(screen.mouse_protocol_mode(), vt100::MouseProtocolMode::None);
        });
    }

    /// Waits for the program to end.
    pub(crate) fn wait_exit(&mut self) -> ExitStatus {
        let start = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status;
            }
            assert!(start.elapsed() < PATIENCE, "still running; the screen:\n{}", self.dump());
            thread::sleep(LOOK);
        }
    }

    /// Whether the program has ended within a time.
    pub(crate) fn ends_within(&mut self, time: Duration) -> bool {
        let start = Instant::now();
        while start.elapsed() < time {
            if self.child.try_wait().unwrap().is_some() {
                return true;
            }
            thread::sleep(LOOK);
        }
        false
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        self.control.end.store(true, Ordering::SeqCst);
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Reads until told to end, without ever waiting inside a read: an open read would keep the line open.
fn listen(mut file: File, state: &Mutex<State>, control: &Control) {
    let mut chunk = [0; 4096];
    while !control.end.load(Ordering::SeqCst) {
        if control.deaf.load(Ordering::SeqCst) {
            thread::sleep(LOOK);
            continue;
        }
        match file.read(&mut chunk) {
            Ok(count) if count > 0 => {
                let mut state = state.lock().unwrap();
                if state.seen {
                    state.emulator.process(&chunk[..count]);
                }
                state.bytes.extend_from_slice(&chunk[..count]);
                state.last = Instant::now();
            }
            // The program's end closed, for now or for good.
            _ => thread::sleep(LOOK),
        }
    }
}

/// Our end of the line as a file that never waits.
fn own_end(master: &dyn MasterPty) -> File {
    let raw = master.as_raw_fd().unwrap();
    // SAFETY: the descriptor belongs to `master`, which outlives this borrow.
    let borrowed = unsafe { BorrowedFd::borrow_raw(raw) };
    let file = File::from(borrowed.try_clone_to_owned().unwrap());
    let flags = fcntl_getfl(&file).unwrap();
    fcntl_setfl(&file, flags | OFlags::NONBLOCK).unwrap();
    file
}

fn pty_size((width, height): (u16, u16)) -> PtySize {
    PtySize { rows: height, cols: width, pixel_width: 0, pixel_height: 0 }
}

fn nonzero(n: u16) -> NonZeroU16 {
    NonZeroU16::new(n).unwrap()
}
