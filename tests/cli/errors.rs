//! What is refused, and what is said then.

use super::{PROJECT, file, refused, run, shown};

/// Everything in `words` is said.
fn says(arguments: &[&str], words: &[&str]) {
    let said = refused(arguments);
    for word in words {
        assert!(said.contains(word), "{arguments:?}: {word:?} is missing in {said}");
    }
}

#[test]
fn a_wrong_value_is_said_with_flag_value_unit_range_and_advice() {
    says(&["forecast", "-d", "2,7"], &["'2,7'", "-d", "write the decimal point as a point: 2.7"]);
    says(&["forecast", "-L", "3 kN"], &["'3 kN'", "-L", "\"kN\"", "use m, cm, mm, ft or in"]);
    says(&["forecast", "-D", "wide"], &["'wide'", "-D", "is not a number", "250mm"]);
    says(&["forecast", "--ex", "NaN"], &["'NaN'", "--ex", "-L/2 to L/2"]);
    says(&["forecast", "-L", "1e999"], &["1e999", "not a finite number", "below 100 m"]);
    says(&["forecast", "-d", ""], &["-d", "a number is needed"]);
    says(&["forecast", "--force", "25 mm"], &["--force", "use kN, N, MN, t, kip or lbf"]);
    says(&["forecast", "--gamma-load", "1.5 m"], &["--gamma-load", "no unit"]);
    // A flag that swallowed the next one says so by quoting it.
    says(&["forecast", "--ex", "--format"], &["'--format'", "--ex"]);
}

#[test]
fn a_value_out_of_range_is_said_by_its_flag() {
    says(&["forecast", "-d", "-0.1"], &["-d = -0.1 m", "above 0", "below the spacing L = 3.0 m"]);
    says(&["forecast", "-D", "3"], &["-D = 3.0 m", "too large", "below the spacing L = 3.0 m"]);
    says(&["forecast", "-L", "0"], &["-L = 0.0 m", "above 0, below 100.0 m"]);
    says(&["forecast", "-L", "-3"], &["-L = -3.0 m"]);
    says(&["forecast", "--gamma-load", "9"], &["--gamma-load = 9.0", "0.5 to 5"]);
    says(&["forecast", "--force", "-1"], &["--force = -1.0 kN", "above 0"]);
    says(&["forecast", "--deflection", "0"], &["--deflection = 0.0 m", "above 0"]);
    // What the user did not give is named as a default, with what to do.
    says(
        &["forecast", "-L", "0.5"],
        &["-D = 1.0 m (its default)", "below the spacing L = 0.5 m", "give -D as well"],
    );
}

#[test]
fn words_that_are_not_known_are_said_with_those_that_are() {
    says(&["forecast", "--branch", "lower"], &["lower", "published, conservative"]);
    says(&["forecast", "--format", "xml"], &["xml", "text, json, csv"]);
    says(&["forecast", "--mesh", "dt-8x10-2.2"], &["--mesh", "did you mean \"dt-8x10-2.7\"?"]);
    says(&["mesh", "show", "nothing"], &["\"nothing\"", "\"dt-8x10-2.7\""]);
    says(&["--glyphs", "dots", "forecast"], &["braille, block, ascii"]);
    says(&["--color", "256", "forecast"], &["auto, 16, none"]);
    says(&["--units", "cm", "forecast"], &["no unit cm", "m, mm, ft or in", "kN, kip or t"]);

    says(&["forecast", "--layout", "a"], &["PROJECT.ron"]);
    says(&["forecast", "--what"], &["--what"]);
}

#[test]
fn an_unknown_layout_is_said_with_the_names() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    says(
        &["forecast", shown(&path), "--layout", "bench2"],
        &["--layout = \"bench2\"", "\"portal, east\", \"corner\"", "did you mean \"bench 2\"?"],
    );
}

#[test]
fn a_layout_that_a_flag_makes_senseless_is_named() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    says(
        &["forecast", shown(&path), "-L", "1 m"],
        &["layout \"portal, east\".D = 1.2 m", "below the spacing L = 1.0 m"],
    );
}

#[test]
fn a_bad_file_is_said_with_its_place() {
    let (_keep, path) = file("bad.ron", &PROJECT.replace("L: 2.5", "L: 2,5"));
    says(&["forecast", shown(&path)], &["bad.ron", "line 5"]);
    let (_keep, path) = file("bad.ron", &PROJECT.replace("d: 0.25", "plate: 0.25"));
    says(&["forecast", shown(&path)], &["line 5", "plate"]);
    let (keep, _) = file("bad.ron", "");
    says(&["forecast", shown(&keep.path().join("bad.ron"))], &["the file is empty"]);
    says(&["forecast", shown(&keep.path().join("none.ron"))], &["there is no such file"]);
    says(&["forecast", shown(keep.path())], &["directory"]);
}

#[test]
fn a_mistyped_command_is_recognised() {
    says(&["forcast"], &["did you mean the command: meshcast forecast"]);
    says(&["valdate"], &["meshcast validate"]);
    says(&["road.ron", "forecast"], &["belongs behind it"]);
}

#[test]
fn new_never_overwrites() {
    let (keep, path) = file("there.ron", "mine");
    says(&["new", shown(&path)], &["there.ron", "exists already"]);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
    says(&["new", shown(&keep.path().join("no/such/road.ron"))], &["directory does not exist"]);
}

#[test]
fn help_and_version_go_to_standard_output() {
    for arguments in [&["--help"][..], &["-V"], &["forecast", "--help"], &["help", "mesh"]] {
        let got = run(arguments);
        assert_eq!((got.code, got.err.as_str()), (0, ""), "{arguments:?}");
        assert!(!got.out.is_empty());
    }
}
