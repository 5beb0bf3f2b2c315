//! The commands of the `:` line, as the help lists them.

/// A command of the command line: its form and what it does, for the help.
pub struct CommandHelp {
    /// The form, as typed after the colon.
    pub form: &'static str,
    /// What it does.
    pub help: &'static str,
}

/// The commands, in the order of the help; `app::command` carries them out, and a test holds the two
/// together.
pub const COMMANDS: &[CommandHelp] = &[
    CommandHelp { form: "w", help: "save" },
    CommandHelp { form: "w PATH", help: "save to another file and go on with that one" },
    CommandHelp { form: "w!", help: "save over a file that changed on disk" },
    CommandHelp { form: "own", help: "take the file over from the session that holds it" },
    CommandHelp { form: "reload", help: "read the file anew, as another program left it" },
    CommandHelp { form: "wq", help: "save and quit (also :x)" },
    CommandHelp { form: "q", help: "quit; asks when edits are unsaved" },
    CommandHelp { form: "q!", help: "quit without saving" },
    CommandHelp { form: "N", help: "select layout number N" },
    CommandHelp { form: "name TEXT", help: "name of the project" },
    CommandHelp { form: "site TEXT", help: "site of the project" },
    CommandHelp {
        form: "client TEXT",
        help: "head of the report; so with author, checker, revision, date",
    },
    CommandHelp {
        form: "basis mean|characteristic",
        help: "which value of a capacity verdicts go by, as B",
    },
    CommandHelp { form: "mesh ID", help: "mesh of this layout" },
    CommandHelp { form: "grid square|rectangular|staggered", help: "grid of anchors, as P" },
    CommandHelp { form: "twists down|across", help: "how the net hangs, as T" },
    CommandHelp { form: "shape dome|sphere|flat", help: "shape of the block in the check" },
    CommandHelp {
        form: "units m|mm|ft|in|kN|kip|t",
        help: "units shown, one or two: units ft,kip",
    },
    CommandHelp { form: "glyphs braille|block|ascii", help: "signs that charts are drawn with" },
    CommandHelp { form: "color 16|none", help: "colours" },
    CommandHelp { form: "export", help: "choose what to write to a file" },
    CommandHelp {
        form: "export KIND PATH",
        help: "write report, markdown, chart, charts, plan, curves or table; export! replaces a file",
    },
    CommandHelp { form: "check / check all", help: "check this layout, or all" },
    CommandHelp {
        form: "campaign [RUNS] [BLOCKS] FOLDER",
        help: "runs of random layouts with this mesh and the method from them; the same goes on",
    },
    CommandHelp {
        form: "method FILE|off",
        help: "a method that a campaign or derive wrote, for this project; off: none",
    },
    CommandHelp { form: "fidelity auto|quick|standard|fine", help: "how exactly checks compute" },
    CommandHelp {
        form: "runs N|auto",
        help: "runs of a check; auto: until the mean is known to 1 %",
    },
    CommandHelp { form: "live on|off", help: "a quick check after each edit" },
    CommandHelp { form: "undo / redo", help: "the same as u and U" },
    CommandHelp { form: "help", help: "this help" },
    CommandHelp { form: "open", help: "list of recent and near projects, as O (also :e)" },
    CommandHelp { form: "open PATH", help: "open another project" },
    CommandHelp { form: "tour", help: "the tour of the first run" },
    CommandHelp { form: "set", help: "the settings, kept for all projects" },
    CommandHelp {
        form: "set fidelity auto|quick|standard|fine",
        help: "one of them at once; so with set units, glyphs, color, runs, live",
    },
];
