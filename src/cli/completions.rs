use super::failure::Failure;
use super::{Cli, output};
use clap::CommandFactory;
use clap_complete::Shell;

/// Print the completions for a shell
#[derive(clap::Args)]
#[command(after_help = "Example:\n  vox completions bash > ~/.local/share/bash-completion/completions/vox")]
pub struct Args {
    /// The shell to complete for
    shell: Shell,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "vox", &mut script);
    output::stdout(&script)
}
