//! Styled snapshots of every screen: the main ones at four sizes and in three looks, see
//! [`PICTURES`], the others at 80x24.
//!
//! These find regressions only: what the numbers on them should be is tested elsewhere. After a wanted
//! change run `INSTA_UPDATE=always cargo test --test screens` and look at the difference.

use crate::harness::*;
use meshcast::app::look::Look;

fn check(name: &str, script: &str, size: (u16, u16), look: Look) {
    let mut app = start(road_cut(), size, look);
    press(&mut app, script);
    insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!(name, styled(&app));
    });
}

#[test]
fn main_screen_at_every_size_and_in_every_look() {
    for (name, size, look) in PICTURES {
        check(&format!("main_{name}"), "<Tab><Tab>", size, look);
    }
}

#[test]
fn main_screen_with_everything_on_it() {
    // Overlays, design values, an eccentric layout with warnings, units in millimetres.
    let script =
        "o<Tab>o<Tab>o<PgUp><PgUp><PgUp><Down><Down><Down><Down><Down>12<Enter><Down>0.5<Enter>t";
    for (word, look) in [("color", COLOR), ("mono", MONO), ("ascii", ASCII)] {
        check(&format!("busy_80x24_{word}"), script, (80, 24), look);
    }
}

#[test]
fn the_main_screens_in_feet_and_kips() {
    let script =
        ":units ft,kip<Enter><Down><Down><Down><Down><Down>2.7<Enter><Down><Down>1.6<Enter>";
    check("feet_80x24", script, (80, 24), MONO);
    check("feet_120x40", script, (120, 40), MONO);
    check("feet_details", &format!("{script}i"), (80, 24), MONO);
    check("feet_compare", &format!("{script}v"), (80, 24), MONO);
    check("tonnes_sweep", &format!("{script}:units m t<Enter>w"), (80, 24), MONO);
}

#[test]
fn other_screens() {
    for (name, script) in [
        ("help", "?"),
        ("help_scrolled", "?  "),
        ("details", "<PgUp>i"),
        ("mesh_picker", "m"),
        ("typing_a_value", "<Down>2.7"),
        ("refused_value", "<Down>2,750<Enter>"),
        ("refused_range", "12m<Enter>"),
        ("command_line", ":units mm"),
        ("refused_command", ":nonsense<Enter>"),
        ("renaming", "r"),
        ("note", "nseen in spring"),
        ("confirm_quit", "<Right>q"),
        ("punch_on_plate", "<PgUp><Down><Down><Down>1.75<Enter><Down>1.75<Enter>"),
        ("not_enough", "<Down><Down><Down><Down><Down>40<Enter>"),
        ("extrapolated", "<Down>6<Enter>"),
        ("near_branch_change", "<Down><Down>0.3<Enter>"),
    ] {
        check(name, script, (80, 24), MONO);
    }
}

#[test]
fn too_small_a_terminal_says_so_and_quits() {
    for size in [(39, 12), (40, 11), (10, 3), (1, 1)] {
        let mut app = start(road_cut(), size, COLOR);
        let shown = text(&app);
        assert_eq!(shown.lines().filter(|l| !l.is_empty()).count(), 1, "{shown}");
        assert!(shown.starts_with(&"too small: q quits"[..usize::from(size.0).min(18)]), "{shown}");
        let effects = press(&mut app, "q");
        assert!(matches!(effects[..], [meshcast::app::message::Command::Quit]));
    }
}
