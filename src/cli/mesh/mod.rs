//! `meshcast mesh`: the mesh types of the catalogue.

pub(crate) mod list;
pub(crate) mod show;

use super::output::{CommandEnd, Format};
use clap::{Args, Subcommand};

/// Show the mesh types of the catalogue.
#[derive(Debug, Args)]
pub(crate) struct MeshArgs {
    #[command(subcommand)]
    command: MeshCommand,
}

#[derive(Debug, Subcommand)]
enum MeshCommand {
    /// One line a mesh: identifier, name, laboratory values.
    List {
        /// How the result is written.
        #[arg(long, value_enum, default_value_t)]
        format: Format,
    },
    /// Everything that is known of one mesh, with its sources.
    Show {
        /// Identifier of the mesh.
        #[arg(value_name = "ID")]
        id: String,
        /// How the result is written.
        #[arg(long, value_enum, default_value_t)]
        format: Format,
    },
}

/// Shows the list or one mesh.
pub(crate) fn run(args: &MeshArgs) -> CommandEnd {
    match &args.command {
        MeshCommand::List { format } => list::run(*format),
        MeshCommand::Show { id, format } => show::run(id, *format),
    }
}
