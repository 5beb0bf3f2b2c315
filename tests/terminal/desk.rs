//! The built program around the work: the first run, settings, opening, copying.

use crate::pty::Launch;
use std::fs;

const PROJECT: &str =
    "(version: 1, name: \"North\", layouts: [(name: \"NAME\", d: 0.25, L: 2.5, D: 0.6)])";

#[test]
fn the_tour_comes_once() {
    let launch = Launch::new_user();
    let kept = tempfile::tempdir().unwrap();
    let data = kept.path().join("data");
    let mut pty = launch.env("MESHCAST_DATA_DIR", &data).start();
    pty.wait_for("1 of ");
    pty.send("\r");
    pty.wait_for("2 of ");
    pty.send("q");
    pty.wait_for("? shows the keys");
    pty.send("q");
    assert!(pty.wait_exit().success());
    assert!(fs::read_to_string(data.join("settings.ron")).unwrap().contains("tour: seen"));
    let mut again = Launch::new_user().env("MESHCAST_DATA_DIR", &data).start();
    again.wait_for("road-cut.ron");
    again.settle();
    assert!(!again.dump().contains("1 of "), "{}", again.dump());
    again.send("q");
    assert!(again.wait_exit().success());
}

#[test]
fn a_setting_is_kept_in_the_config_folder_and_a_flag_stands_above_it() {
    let launch = Launch::meshcast();
    let home = launch.home();
    let mut pty = launch.start();
    pty.wait_for("22.8 kN");
    pty.send(":set units mm\r");
    pty.wait_for("250 mm");
    let file = home.join(".config/meshcast/settings.ron");
    // It is written behind the screen.
    pty.wait_until("the setting in its file", |_| {
        fs::read_to_string(&file).is_ok_and(|text| text.contains("units: mm"))
    });
    let mut again = Launch::meshcast().arg("--units").arg("m").env("HOME", &home).start();
    again.wait_for("0.25 m");
    again.send("q");
    assert!(again.wait_exit().success());
    fs::write(&file, "(\n    fidelity: fast,\n)\n").unwrap();
    let mut broken = Launch::meshcast().env("HOME", &home).start();
    broken.wait_for("! settings.ron line 2, fidelity: fast is none of auto, quick");
    broken.send("q");
    assert!(broken.wait_exit().success());
    assert!(fs::read_to_string(&file).unwrap().contains("fast"));
    pty.send("q");
    assert!(pty.wait_exit().success());
}

#[test]
fn another_project_is_found_and_opened_and_a_broken_one_is_not() {
    let launch = Launch::meshcast();
    let home = launch.home();
    fs::create_dir(home.join("sites")).unwrap();
    for (file, name) in [("one.ron", "first bench"), ("sites/two.ron", "second bench")] {
        fs::write(home.join(file), PROJECT.replace("NAME", name)).unwrap();
    }
    fs::write(home.join("sites/bad.ron"), PROJECT.replace("2.5", "2,5")).unwrap();
    let mut pty = launch.arg("one.ron").start();
    pty.wait_for("first bench");
    pty.send("Obad");
    pty.wait_for("bad.ron");
    pty.send("\r");
    pty.wait_for("bad.ron cannot be opened");
    pty.wait_for("line 1");
    pty.send("\x15two");
    pty.wait_for("two.ron");
    pty.send("\r");
    pty.wait_for("second bench");
    // Edits of the one now open go beside it.
    pty.send("0.31\r");
    pty.wait_for("two.ron *");
    pty.send("\x13");
    pty.wait_for("saved");
    assert!(fs::read_to_string(home.join("sites/two.ron")).unwrap().contains("d: 0.31"));
    pty.send("O");
    pty.wait_for("recent");
    pty.send("\r");
    pty.wait_for("first bench");
    pty.send("q");
    assert!(pty.wait_exit().success());
}

#[test]
fn a_copy_leaves_the_screen_alone() {
    let mut pty = Launch::meshcast().start();
    pty.wait_for("22.8 kN");
    pty.settle();
    pty.send("y");
    pty.wait_for("copied, if the terminal");
    pty.send("\t");
    pty.settle();
    let shown = pty.dump();
    pty.send("\x0c");
    pty.settle();
    assert_eq!(pty.dump(), shown);
    let bytes = String::from_utf8(pty.received()).unwrap();
    assert_eq!(bytes.matches("\x1b]52;c;").count(), 1);
    pty.send("q");
    assert!(pty.wait_exit().success());
}

#[test]
fn a_methods_file_is_named_in_the_session_and_stands_in_the_saved_file() {
    let launch = Launch::meshcast();
    let home = launch.home();
    fs::create_dir_all(home.join("site/runs")).unwrap();
    fs::write(home.join("site/one.ron"), PROJECT.replace("NAME", "first bench")).unwrap();
    let method = include_str!("../../assets/methods/dt-8x10-2.7-repeated.ron");
    fs::write(home.join("site/runs/m.ron"), method).unwrap();
    fs::write(home.join("no.ron"), PROJECT).unwrap();
    let mut pty = launch.arg("site/one.ron").start();
    pty.wait_for("first bench");
    // Typed from the working directory, as all paths are; no file and no method are refused in words.
    pty.send(":method away.ron\r");
    pty.wait_for("away.ron: there is no such file");
    pty.send(":method no.ron\r");
    pty.wait_for("no.ron: it is no method");
    pty.send(":method site/runs/m.ron\r");
    pty.wait_for("blocks go by runs/m.ron");
    pty.send("\x13");
    pty.wait_for("saved");
    let saved = fs::read_to_string(home.join("site/one.ron")).unwrap();
    assert!(saved.contains("method_files: [\"runs/m.ron\"]"), "{saved}");
    pty.send("u\x13");
    pty.wait_until("the file without it", |_| {
        fs::read_to_string(home.join("site/one.ron"))
            .is_ok_and(|text| !text.contains("method_files"))
    });
    pty.send("q");
    assert!(pty.wait_exit().success());
}
