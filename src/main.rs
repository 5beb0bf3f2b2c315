//! The `meshcast` binary: hands the command line to the `cli` room and returns its exit code.

fn main() -> std::process::ExitCode {
    meshcast::cli::run(std::env::args_os())
}
