//! A village from a handful of cottages, as a user would make it on the command line:
//! learn a grammar from `schematics/`, draw its op graph, grow new cottages and lay them out on one sheet.
//! Everything lands in `out/`. Each command is printed before it runs.

use std::process::ExitCode;

const COMMANDS: [&str; 4] = [
    "infer schematics/cottage-*.schem -o out/village.grammar --dot out/village.dot",
    "check out/village.grammar",
    "run out/village.grammar -n 12 -o out/house-{number}.schem",
    "render out/house-*.schem -o out/sheet.png",
];

fn main() -> ExitCode {
    if let Err(error) = std::env::set_current_dir(env!("CARGO_MANIFEST_DIR")) {
        eprintln!("{}: {error}", env!("CARGO_MANIFEST_DIR"));
        return ExitCode::FAILURE;
    }
    for command in COMMANDS {
        println!("$ vox {command}");
        let code = vox::cli::run_from(std::iter::once("vox").chain(command.split(' ')));
        if code != ExitCode::SUCCESS {
            return code;
        }
    }
    println!(
        "out/village.grammar holds the rules, out/village.dot their graph, out/sheet.png the new houses"
    );
    ExitCode::SUCCESS
}
