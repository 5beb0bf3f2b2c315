//! `validate` and `mesh`.

use super::{file, good, json, refused, shown};
use serde_json::Value;

#[test]
fn validate_prints_the_papers_table_beside_ours() {
    let out = good(&["validate"]);
    for row in [
        "   1 0.25  2.50  0.60  0.00  0.00     22.8   22.81  +0.01  22.6  same",
        "   5 0.25  3.50  0.80  0.55  1.15     0.64   0.640 +0.000  0.65  by construction",
        "alpha_F = F_a*/F_l*",
        "27.1 kN and 0.635 m",
        "Table 1: 10 of 10, 6 by the equations and 4 by construction.",
    ] {
        assert!(out.contains(row), "{row:?} is missing:\n{out}");
    }
    assert_eq!(out.matches("by construction\n").count(), 4, "{out}");
    assert!(!out.contains("DIFFER"), "{out}");
    assert!(out.lines().all(|l| l.chars().count() <= 80), "{out}");
}

#[test]
fn validate_as_json() {
    let v = json(&["validate"]);
    assert_eq!(v["agrees"], true);
    let rows = v["table_1"].as_array().unwrap();
    assert_eq!(rows.len(), 5);
    for (index, row) in rows.iter().enumerate() {
        assert_eq!(row["test"], index + 1);
        for quantity in ["F_kN", "delta_m"] {
            let cell = &row[quantity];
            assert_eq!(cell["agrees"], true);
            assert_eq!(cell["by_construction"], index >= 3);
            let printed: f64 = cell["printed"].as_str().unwrap().parse().unwrap();
            let ours = cell["ours"].as_f64().unwrap();
            // Both are rounded to twelve digits.
            assert!((ours - printed - cell["difference"].as_f64().unwrap()).abs() < 1e-9);
            assert!(cell["dem"].is_string());
        }
    }
    assert_eq!(v["facts"].as_array().unwrap().len(), 7);
    assert_eq!(v["reference_point"]["F_kN"]["printed"], "27.1");
}

#[test]
fn the_mesh_list_names_every_mesh() {
    let out = good(&["mesh", "list"]);
    assert!(out.starts_with("id "), "{out}");
    let row = out.lines().find(|l| l.starts_with("dt-8x10-2.7")).unwrap();
    for word in ["73.3 kN", "0.600 m", "mean", "reference"] {
        assert!(row.contains(word), "{row}");
    }
    let list = json(&["mesh", "list"]);
    let rows = out.lines().filter(|line| line.contains(" kN")).count();
    assert_eq!(list.as_array().unwrap().len(), rows);
    assert_eq!(list[0], json(&["mesh", "show", "dt-8x10-2.7"]));
}

#[test]
fn a_mesh_of_which_the_strength_alone_is_known_says_what_is_missing() {
    let id = "astm-a975-8x10-2.7";
    let out = good(&["mesh", "list"]);
    let row = out.lines().find(|line| line.starts_with(id)).unwrap();
    assert!(row.contains("42.3 kN/m  min   ASTM A975 1997"), "{row}");
    let told = good(&["mesh", "show", id]);
    assert!(told.contains("(minimum)") && told.contains("MISSING"), "{told}");
    assert!(json(&["mesh", "show", id])["missing"].as_str().unwrap().contains("ISO 17746"));
    let e = refused(&["forecast", "--mesh", id]);
    assert!(e.contains("only the strength of the net is published") && e.contains("adopt"), "{e}");
    let (_directory, path) =
        file("p.ron", &format!("(version: 1, name: \"x\", meshes: [\"{id}\"], layouts: [])"));
    let e = refused(&["compare", shown(&path)]);
    assert!(e.contains("only the strength of the net is published"), "{e}");
}

#[test]
fn a_mesh_is_shown_with_its_sources() {
    let out = good(&["mesh", "show", "dt-8x10-2.7"]);
    for word in [
        "Double twist 8x10",
        "73.3 kN (mean)",
        "0.60 m",
        "ISO 17745",
        "Pol & Gabrieli (2021)",
        "opening 80 mm",
        "diameter 2.7 mm",
        "alpha_F 0.3970",
    ] {
        assert!(out.contains(word), "{word:?} is missing:\n{out}");
    }
    assert_eq!(out.matches("source  ").count(), 2, "one a record:\n{out}");
    let v = json(&["mesh", "show", "dt-8x10-2.7"]);
    assert_eq!(v["lab"]["F_kN"], 73.3);
    assert_eq!(v["lab"]["statistic"], "mean");
    assert_eq!(v["wire"]["opening_m"], 0.08);
    assert!(v["wire"]["single_strain_stress_MPa"].as_array().is_some_and(|c| c.len() == 4));
    assert_eq!(v["ratios"]["source"], Value::Null);
}
