//! Screens by styled snapshot, and edits by key script.

mod harness;

#[test]
fn look() {
    use harness::*;
    let which = std::env::var("LOOK").unwrap_or_default();
    let size: Vec<u16> = std::env::var("SIZE")
        .unwrap_or("80x24".into())
        .split('x')
        .map(|v| v.parse().unwrap())
        .collect();
    let look = match which.as_str() {
        "ascii" => ASCII,
        "mono" => MONO,
        _ => COLOR,
    };
    let mut app = start(road_cut(), (size[0], size[1]), look);
    press(&mut app, &std::env::var("KEYS").unwrap_or_default());
    println!("{}", text(&app));
}
