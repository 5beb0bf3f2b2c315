//! The `:method` command: a method's file that the project names, so that its layouts go by it.

use super::App;
use super::message::Command;
use crate::project::schema::MethodFile;
use std::path::{Path, PathBuf};

impl App {
    /// Names a method's file, names none any more, or says which are named: `method [FILE|off]`.
    ///
    /// # Errors
    /// Why nothing can be named.
    pub(super) fn method_command(&mut self, text: &str) -> Result<Vec<Command>, String> {
        match text {
            "" => {
                let files: Vec<&str> =
                    self.project().method_files.iter().map(|f| f.file.as_str()).collect();
                let said = match files.is_empty() {
                    true => "no method's file is named; method FILE names one".into(),
                    false => format!("methods: {}", files.join(", ")),
                };
                self.inform(said);
                Ok(Vec::new())
            }
            "off" => {
                let said = self.editor.drop_methods();
                self.inform(said);
                Ok(Vec::new())
            }
            _ if self.opening_holds() => Ok(Vec::new()),
            _ => {
                let of =
                    self.path().ok_or("save the project first: it names files from its folder")?;
                Ok(vec![Command::ReadMethod { path: PathBuf::from(text), of: of.to_path_buf() }])
            }
        }
    }

    /// A method's file was read for the project in the file `of`, or not.
    pub(super) fn method_read(&mut self, of: &Path, result: Result<MethodFile, String>) {
        // Another project may have been opened, or this one saved elsewhere: its name would be a wrong one.
        if self.path() != Some(of) {
            return;
        }
        match result.and_then(|named| self.editor.name_method(named)) {
            Ok(said) => self.inform(said),
            Err(why) => self.complain(why),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Start;
    use super::super::key::{Code, Key};
    use super::super::message::Message;
    use super::*;
    use crate::layout::{Blocks, MethodChoice};
    use crate::mesh::adopted::KeptMethod;
    use crate::mesh::catalogue;
    use crate::method::{DerivedMethod, canned};
    use crate::project::schema::Project;

    fn app(path: Option<&str>) -> App {
        let mut project = Project::starter("p");
        project.layouts[0].layout.method = MethodChoice::Derived;
        project.layouts[0].layout.blocks = Blocks::Repeated;
        App::new(Start { path: path.map(PathBuf::from), ..Start::of(project) })
    }

    fn typed(app: &mut App, text: &str) -> Vec<Command> {
        let keys = text.chars().map(Key::char).chain([Key::plain(Code::Enter)]);
        keys.flat_map(|key| app.update(Message::Key(key))).collect()
    }

    /// A method of the reference mesh with this alpha_F.
    fn method(alpha: f64, wires: Option<&str>) -> Option<KeptMethod> {
        let mesh = catalogue::reference();
        let own = mesh.wire.as_ref().unwrap().print().to_string();
        let mut method = DerivedMethod {
            mesh: mesh.id.clone(),
            wires: wires.map_or(own, str::to_string),
            ..canned::method()
        };
        method.alpha.force = alpha;
        Some(KeptMethod::keep(method))
    }

    /// The answer to a file that was read.
    fn read(app: &mut App, file: &str, method: Option<KeptMethod>) {
        let result = Ok(MethodFile { file: file.into(), method });
        app.update(Message::MethodRead { of: PathBuf::from("/site/p.ron"), result });
    }

    fn said(app: &App) -> String {
        app.screen.status().map_or(String::new(), |status| status.text.clone())
    }

    fn force(app: &App) -> f64 {
        app.result().forecast().unwrap().field.unwrap().values.force
    }

    #[test]
    fn a_methods_file_is_named_by_a_command_and_undone() {
        let mut app = app(Some("/site/p.ron"));
        let before = force(&app);
        let asked = typed(&mut app, ":method runs/m.ron");
        let [Command::ReadMethod { path, of }] = &asked[..] else { panic!("{asked:?}") };
        assert_eq!(
            (path.as_path(), of.as_path()),
            (Path::new("runs/m.ron"), Path::new("/site/p.ron"))
        );
        assert!(!app.edited());
        read(&mut app, "runs/m.ron", method(0.4, None));
        assert_eq!(said(&app), "derived forecasts of repeated blocks go by runs/m.ron");
        // The canned relations are 1 at the reference panel: 0.4 of 73.3 kN.
        assert!((force(&app) / 29_320.0 - 1.0).abs() < 0.01, "{}", force(&app));
        assert!(app.edited() && force(&app) != before);
        typed(&mut app, ":method");
        assert_eq!(said(&app), "methods: runs/m.ron");
        // Another one of the same blocks takes its place.
        read(&mut app, "other.ron", method(0.2, None));
        assert!(said(&app).ends_with("other.ron in place of runs/m.ron"), "{}", said(&app));
        assert!((force(&app) / 14_660.0 - 1.0).abs() < 0.01, "{}", force(&app));
        app.update(Message::Key(Key::char('u')));
        assert_eq!(said(&app), "undone: method's file (1 more)");
        assert_eq!(app.project().method_files[0].file, "runs/m.ron");
        typed(&mut app, ":method off");
        assert_eq!((force(&app), app.project().method_files.len()), (before, 0));
        app.update(Message::Key(Key::char('u')));
        app.update(Message::Key(Key::char('u')));
        assert!(!app.edited() && force(&app) == before);
    }

    #[test]
    fn what_cannot_be_named_is_refused_in_words_and_nothing_changes() {
        let mut nowhere = app(None);
        assert!(typed(&mut nowhere, ":method m.ron").is_empty());
        let entry = nowhere.screen.entry().and_then(|entry| entry.error.clone());
        assert!(entry.unwrap().starts_with("save the project first"));
        let mut app = app(Some("/site/p.ron"));
        read(&mut app, "m.ron", method(0.4, Some("1")));
        assert!(
            said(&app).starts_with("m.ron: its simulations are of another net"),
            "{}",
            said(&app)
        );
        let of = PathBuf::from("/site/p.ron");
        app.update(Message::MethodRead { of, result: Err("there is no such file".into()) });
        assert_eq!(said(&app), "there is no such file");
        // Read for a project that is not open any more.
        let result = Ok(MethodFile { file: "m.ron".into(), method: method(0.4, None) });
        app.update(Message::MethodRead { of: PathBuf::from("/site/q.ron"), result });
        assert!(!app.edited());
        read(&mut app, "m.ron", method(0.4, None));
        read(&mut app, "m.ron", method(0.3, None));
        assert_eq!(said(&app), "m.ron is named already; it has changed since, :reload reads it");
        typed(&mut app, ":method off");
        typed(&mut app, ":method");
        assert!(said(&app).starts_with("no method's file is named"));
    }
}
