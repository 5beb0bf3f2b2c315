//! The paper's printed values against the forecast: Table 1, digit for digit.

use meshcast::forecast::forecast;
use meshcast::layout::{BranchRule, Layout};
use meshcast::mesh::catalogue;

/// Table 1 of Pol & Gabrieli (2021): d, L, D, ex, ey (m), F_a (kN, one decimal), delta_a (m, two).
const TABLE_1: [([f64; 5], &str, &str); 5] = [
    ([0.25, 2.5, 0.60, 0.00, 0.00], "22.8", "0.55"),
    ([0.32, 2.5, 0.20, 0.00, 0.00], "13.0", "0.49"),
    ([0.40, 3.0, 1.25, 0.00, 0.00], "31.0", "0.62"),
    ([0.40, 4.0, 1.20, 2.00, 0.20], "37.1", "0.68"),
    ([0.25, 3.5, 0.80, 0.55, 1.15], "15.3", "0.64"),
];

#[test]
fn table_1_comes_out_digit_for_digit() {
    for ([plate, spacing, punch, ex, ey], force, deflection) in TABLE_1 {
        let layout = Layout { plate, spacing, punch, ex, ey };
        let result = forecast(&layout, &catalogue::reference(), BranchRule::Published).unwrap();
        let field = result.field.unwrap();
        assert_eq!(format!("{:.1}", field.values.force / 1000.0), force, "{layout:?}");
        assert_eq!(format!("{:.2}", field.values.deflection), deflection, "{layout:?}");
    }
}
