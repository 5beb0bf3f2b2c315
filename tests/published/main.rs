//! The paper's printed values against the forecast, and every equation at values worked by hand.

mod equations;

use meshcast::forecast::forecast;
use meshcast::forecast::published::{published, validate};
use meshcast::layout::BranchRule;
use meshcast::mesh::catalogue;
use meshcast::units::to_kn;

#[test]
fn table_1_comes_out_digit_for_digit() {
    let tests = &published().tests;
    assert_eq!(tests.iter().map(|t| t.test).collect::<Vec<_>>(), [1, 2, 3, 4, 5]);
    for test in tests {
        let result =
            forecast(&test.layout(), &catalogue::reference(), BranchRule::Published).unwrap();
        let values = result.field.unwrap().end().unwrap();
        let force = format!("{:.1}", to_kn(values.force));
        let deflection = format!("{:.2}", values.deflection);
        let printed = (test.forecast.force.text(), test.forecast.deflection.text());
        assert_eq!((force.as_str(), deflection.as_str()), printed, "test {}", test.test);
    }
}

/// The asset is the only place of the paper's values, so a slip in it would go unseen: the sum of each
/// column of Table 1, added by hand from the paper, must hold.
#[test]
fn the_asset_holds_the_papers_table() {
    let tests = &published().tests;
    let sum = |value: fn(&meshcast::forecast::published::PublishedTest) -> f64| -> String {
        format!("{:.2}", tests.iter().map(value).sum::<f64>())
    };
    assert_eq!(sum(|t| t.plate), "1.62");
    assert_eq!(sum(|t| t.spacing), "15.50");
    assert_eq!(sum(|t| t.punch), "4.05");
    assert_eq!((sum(|t| t.ex), sum(|t| t.ey)), ("2.55".into(), "1.35".into()));
    assert_eq!(sum(|t| t.dem.force.value()), "116.70");
    assert_eq!(sum(|t| t.dem.deflection.value()), "2.99");
    assert_eq!(sum(|t| t.forecast.force.value()), "119.20");
    assert_eq!(sum(|t| t.forecast.deflection.value()), "2.98");
}

#[test]
fn every_other_printed_number_comes_out_and_the_oddity_is_as_disclosed() {
    let validation = validate();
    for (fact, compared) in &validation.facts {
        assert!(compared.agrees(), "{}: {}", fact.words, compared.ours);
    }
    assert!(validation.reference_force.agrees() && validation.reference_deflection.agrees());
    assert!(validation.agrees());
}
