//! How fast the built program answers in its terminal, measured from outside: from a key press to the
//! forecast's redraw and to the quick check's, frames a second while a check runs, and how soon a check
//! ends when it is told to.
//!
//! `cargo bench --bench terminal`; with `MESHCAST_BENCH_BESIDE` another build of the program is measured beside it,
//! key by key in turn.

use portable_pty::{CommandBuilder, PtySize, native_pty_system};
use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// Key presses that are measured.
const KEYS: usize = 40;
/// Names another build of the program.
const BESIDE: &str = "MESHCAST_BENCH_BESIDE";
/// Longest wait for anything.
const PATIENCE: Duration = Duration::from_secs(30);

/// What came out, each piece with its time.
type Pieces = Arc<Mutex<Vec<(Instant, Vec<u8>)>>>;

struct Terminal {
    writer: Box<dyn Write + Send>,
    pieces: Pieces,
    emulator: vt100::Parser,
    /// Pieces the emulator has taken.
    taken: usize,
    child: Box<dyn portable_pty::Child + Send + Sync>,
    _master: Box<dyn portable_pty::MasterPty + Send>,
    _home: tempfile::TempDir,
}

impl Terminal {
    /// The program on a copy of the reference panel at 80x24, past its first screen.
    fn open(program: &str) -> Terminal {
        let home = tempfile::tempdir().expect("a temporary folder");
        let project = home.path().join("panel.ron");
        // An older build reads the older format, which this one does too.
        let text = include_str!("../../projects/reference-panel.ron");
        std::fs::write(&project, text.replace("version: 2", "version: 1"))
            .expect("the temporary folder takes a file");
        let panel = PtySize { rows: 24, cols: 80, pixel_width: 0, pixel_height: 0 };
        let pair = native_pty_system().openpty(panel).expect("a pseudo-terminal");
        let mut command = CommandBuilder::new(program);
        command.arg("--no-tour");
        command.arg(&project);
        command.env_clear();
        command.env("TERM", "xterm-256color");
        command.env("LANG", "C.UTF-8");
        command.env("HOME", home.path());
        let child = pair.slave.spawn_command(command).expect("the program starts");
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().expect("a reader");
        let writer = pair.master.take_writer().expect("a writer");
        let pieces = Pieces::default();
        let theirs = Arc::clone(&pieces);
        thread::spawn(move || {
            let mut chunk = [0; 65536];
            while let Ok(count) = reader.read(&mut chunk) {
                if count == 0 {
                    break;
                }
                let piece = (Instant::now(), chunk[..count].to_vec());
                theirs.lock().expect("no panic holds it").push(piece);
            }
        });
        let mut terminal = Terminal {
            writer,
            pieces,
            emulator: vt100::Parser::new(size(24), size(80), 0),
            taken: 0,
            child,
            _master: pair.master,
            _home: home,
        };
        terminal.when("the first screen", |screen| screen.contains("answer"));
        terminal.settle();
        terminal
    }

    fn send(&mut self, keys: &str) -> Instant {
        let at = Instant::now();
        self.writer.write_all(keys.as_bytes()).expect("the program reads");
        self.writer.flush().expect("the program reads");
        at
    }

    /// Feeds what has come to the emulator, piece by piece, and tells when `wanted` first held of the
    /// screen; waits for it.
    fn when(&mut self, what: &str, wanted: impl Fn(&str) -> bool) -> Instant {
        let start = Instant::now();
        loop {
            let new: Vec<(Instant, Vec<u8>)> = {
                let pieces = self.pieces.lock().expect("no panic holds it");
                pieces[self.taken..].to_vec()
            };
            for (at, bytes) in new {
                self.emulator.process(&bytes);
                self.taken += 1;
                if wanted(&self.emulator.screen().contents()) {
                    return at;
                }
            }
            let screen = self.emulator.screen().contents();
            assert!(start.elapsed() < PATIENCE, "waited for {what}:\n{screen}");
            thread::sleep(Duration::from_micros(200));
        }
    }

    /// Waits until nothing has come for a while.
    fn settle(&mut self) {
        loop {
            let before = self.pieces.lock().expect("no panic holds it").len();
            thread::sleep(Duration::from_millis(300));
            let pieces = self.pieces.lock().expect("no panic holds it");
            if pieces.len() == before {
                for (_, bytes) in &pieces[self.taken..] {
                    self.emulator.process(bytes);
                }
                self.taken = pieces.len();
                return;
            }
        }
    }

    fn bytes(&self) -> usize {
        self.pieces.lock().expect("no panic holds it").iter().map(|p| p.1.len()).sum()
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A number of rows or columns.
fn size(count: u16) -> NonZeroU16 {
    NonZeroU16::new(count).expect("not zero")
}

/// Median, and the value that 19 of 20 stay below, ms.
fn figures(mut times: Vec<Duration>) -> (f64, f64) {
    times.sort();
    let ms = |part: f64| {
        let last = times.len().saturating_sub(1);
        1.0e3 * times[(part * last as f64).round() as usize].as_secs_f64()
    };
    (ms(0.5), ms(0.95))
}

fn row(what: &str, (median, high): (f64, f64)) {
    println!("{what:<58} {median:>8.1} {high:>8.1}");
}

/// The key of a step there, and of the one back.
fn step(k: usize) -> &'static str {
    if k.is_multiple_of(2) { "\x1b[C" } else { "\x1b[D" }
}

/// Keys without live mode.
fn plain(terminal: &mut Terminal) {
    let (mut forecast, mut sent) = (Vec::new(), 0);
    for k in 0..KEYS {
        let before = terminal.bytes();
        let at = terminal.send(step(k));
        forecast.push(terminal.when("a redraw", |_| true) - at);
        terminal.settle();
        sent += terminal.bytes() - before;
    }
    row("key to the forecast's redraw, ms", figures(forecast));
    println!("{:<58} {:>8}", "bytes a key, mean", sent / KEYS);
}

/// What keys in live mode took.
#[derive(Default)]
struct Live {
    redraw: Vec<Duration>,
    quick: Vec<Duration>,
    whole: Vec<Duration>,
    sent: usize,
}

impl Live {
    fn key(&mut self, terminal: &mut Terminal, k: usize) {
        let before = terminal.bytes();
        let at = terminal.send(step(k));
        self.redraw.push(terminal.when("a redraw", |screen| screen.contains("stale")) - at);
        let fresh = |screen: &str| screen.contains("live ") && !screen.contains("stale");
        self.quick.push(terminal.when("the quick check", fresh) - at);
        let all = |screen: &str| fresh(screen) && screen.contains("; 4 runs");
        self.whole.push(terminal.when("all four runs", all) - at);
        terminal.settle();
        self.sent += terminal.bytes() - before;
    }

    fn tell(self, whose: &str) -> f64 {
        let whole = figures(self.whole);
        row(&format!("{whose}: key to the forecast's redraw, ms"), figures(self.redraw));
        row(&format!("{whose}: key to the quick check's first curve, ms"), figures(self.quick));
        row(&format!("{whose}: key to the band of four runs, ms"), whole);
        println!("{:<58} {:>8}", format!("{whose}: bytes a key, mean"), self.sent / KEYS);
        whole.0
    }
}

/// Keys in live mode, in turn with those of another build where there is one.
fn live(terminal: &mut Terminal, other: Option<&str>) {
    let mut beside = other.map(Terminal::open);
    for one in [Some(&mut *terminal), beside.as_mut()].into_iter().flatten() {
        one.send("l");
        one.when("a live check", |screen| screen.contains("live ") && screen.contains("4 runs"));
        one.settle();
    }
    let (mut own, mut theirs) = (Live::default(), Live::default());
    for k in 0..KEYS {
        own.key(terminal, k);
        if let Some(other) = &mut beside {
            theirs.key(other, k);
        }
    }
    let own = own.tell("live");
    if beside.is_some() {
        let theirs = theirs.tell("live, the build beside it");
        println!("{:<58} {:>8.2}", "live: band of the build beside it over this one", theirs / own);
    }
    terminal.send("l");
    terminal.settle();
}

/// Frames while a long check runs, and how soon it ends.
fn long_check(terminal: &mut Terminal) {
    terminal.send(":runs 64\r:fidelity fine\r");
    terminal.settle();
    let (mut ends, mut rates) = (Vec::new(), Vec::new());
    for _ in 0..5 {
        let first = terminal.pieces.lock().expect("no panic holds it").len();
        terminal.send("c");
        terminal.when("progress", |screen| screen.contains("checking"));
        thread::sleep(Duration::from_secs(3));
        let frames = terminal.pieces.lock().expect("no panic holds it").len() - first;
        rates.push(frames as f64 / 3.0);
        let at = terminal.send("\x07");
        let ended = terminal.when("the end", |screen| !screen.contains("checking"));
        ends.push(ended.saturating_duration_since(at));
        terminal.settle();
    }
    row("Ctrl+G to the end of a fine check, ms", figures(ends));
    let most = rates.iter().copied().fold(0.0, f64::max);
    println!("{:<58} {most:>8.1}", "frames a second while a check runs, most");
}

fn main() {
    let mut terminal = Terminal::open(env!("CARGO_BIN_EXE_meshcast"));
    let beside = std::env::var(BESIDE).ok();
    println!("{:<58} {:>8} {:>8}", "", "median", "95 %");
    plain(&mut terminal);
    live(&mut terminal, beside.as_deref());
    long_check(&mut terminal);
}
