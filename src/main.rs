fn main() -> std::process::ExitCode {
    vox::cli::main()
}
