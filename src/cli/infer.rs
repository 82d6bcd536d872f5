use super::failure::Failure;

#[derive(clap::Args)]
pub struct Args {}

pub fn execute(_: &Args) -> Result<(), Failure> {
    Ok(())
}
