//! Settings between their file and the program's state.

use super::capabilities::Surroundings;
use crate::app::look::ColorChoice;
use crate::app::settings::{Preferences, SettingItem, Settings};
use crate::project::home::Home;
use crate::project::settings::KnownSettings;

/// What the file of settings may hold.
fn known() -> Vec<KnownSettings> {
    fn takes<const N: usize>(word: &str) -> bool {
        SettingItem::ALL[N].takes(word)
    }
    const TAKES: [fn(&str) -> bool; SettingItem::ALL.len()] = [
        takes::<0>, takes::<1>, takes::<2>, takes::<3>, takes::<4>, takes::<5>, takes::<6>,
        takes::<7>,
    ];
    let each = SettingItem::ALL.into_iter().zip(TAKES);
    each.map(|(item, takes)| KnownSettings {
        name: item.name(),
        allowed: item.allowed(),
        about: item.about(),
        takes,
    })
    .collect()
}

/// The settings of a session: the file's with this run's flags over them. A file that cannot be read
/// leaves the defaults, with the reason; such a user is not new, so there is no tour.
pub(crate) fn preferences(
    home: &Home,
    surroundings: &Surroundings,
    flags: Vec<(SettingItem, String)>,
) -> (Preferences, Option<String>) {
    let mut kept = Settings::default();
    let (mut trouble, mut note) = (None, None);
    match home.settings(&known()) {
        Ok(words) => {
            for (name, word) in words.unwrap_or_default() {
                if let Some(item) = SettingItem::named(&name) {
                    // The file's words were checked when it was read.
                    let _ = kept.set(item, &word);
                }
            }
        }
        Err(error) => {
            kept.tour_seen = true;
            note = Some(format!("{}; defaults hold", error.in_one_line()));
            trouble = Some(error.to_string());
        }
    }
    let auto = surroundings.look(ColorChoice::default(), None);
    let file = home.settings_file();
    let mut preferences = Preferences { kept, flags, auto, file, trouble, tour: false };
    // Without a place to keep that it was seen, the tour would come at every start.
    preferences.tour = !preferences.effective().tour_seen
        && (preferences.file.is_some() || preferences.is_flag(SettingItem::Tour));
    (preferences, note)
}

/// Keeps a setting for the next start; the others are as the file has them, or else the session.
///
/// # Errors
/// Why that cannot be done.
pub(super) fn keep(
    home: &Home,
    changed: SettingItem,
    settings: &Settings,
) -> Result<Option<String>, String> {
    let words = settings.to_words();
    let words: Vec<(&str, String)> = words.into_iter().map(|(i, w)| (i.name(), w)).collect();
    match home.keep_setting(changed.name(), &words, &known()) {
        Ok(aside) => Ok(aside.map(|path| {
            format!("settings kept; the file that could not be read is now {}", path.display())
        })),
        Err(error) => Err(format!("settings hold now but could not be kept: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::exactness::Exactness;
    use std::fs;

    #[test]
    fn flags_stand_above_the_file_and_the_file_above_defaults() {
        let dir = tempfile::tempdir().unwrap();
        let home = Home::at(Some(dir.path().to_path_buf()));
        let settings = Settings { fidelity: Exactness::Fine, live: true, ..Settings::default() };
        assert_eq!(keep(&home, SettingItem::Live, &settings), Ok(None));
        let flags = vec![(SettingItem::Fidelity, "quick".to_string())];
        let (found, note) = preferences(&home, &Surroundings::default(), flags);
        assert_eq!(note, None);
        assert_eq!(found.kept, settings);
        assert_eq!(found.effective().fidelity, Exactness::Quick);
        assert!(found.effective().live);
        assert!(found.tour);
        assert!(!preferences(&Home::at(None), &Surroundings::default(), Vec::new()).0.tour);
    }

    #[test]
    fn a_file_keeps_the_fidelity_that_it_names_and_else_has_the_default() {
        let dir = tempfile::tempdir().unwrap();
        let home = Home::at(Some(dir.path().to_path_buf()));
        for (text, due) in [
            ("(tour: seen)", Exactness::Auto),
            ("(tour: seen, fidelity: standard)", Exactness::Standard),
        ] {
            fs::write(home.settings_file().unwrap(), text).unwrap();
            let (found, _) = preferences(&home, &Surroundings::default(), Vec::new());
            assert_eq!(found.effective().fidelity, due, "{text}");
        }
    }

    #[test]
    fn a_bad_file_leaves_defaults_and_is_not_lost() {
        let dir = tempfile::tempdir().unwrap();
        let home = Home::at(Some(dir.path().to_path_buf()));
        let file = home.settings_file().unwrap();
        fs::write(&file, "(\n    fidelity: fast,\n)\n").unwrap();
        let (found, note) = preferences(&home, &Surroundings::default(), Vec::new());
        let said = "settings.ron line 2, fidelity: fast is none of auto, quick, standard, fine; \
                    defaults hold";
        assert_eq!(note.as_deref(), Some(said));
        assert!(found.trouble.is_some_and(|t| t.contains("line 2, column 15")));
        assert!(!found.tour);
        assert!(fs::read_to_string(&file).unwrap().contains("fast"));
        let told = keep(&home, SettingItem::Live, &found.kept).unwrap().unwrap();
        assert!(told.contains("settings.ron.unread"), "{told}");
    }
}
