use super::report;
use crate::io::{ReadError, WriteError};
use std::fmt::Display;
use std::process::ExitCode;

/// Why a command ends without having done all it was asked for.
#[derive(Debug)]
pub enum Failure {
    /// One sentence, and what to do about it.
    Message { text: String, hint: Option<String> },
    /// All has been told already.
    Told,
    /// Whoever reads the output has stopped reading, as `head` does.
    Pipe,
}

impl Failure {
    pub fn new(text: impl Display) -> Failure {
        Failure::Message { text: text.to_string(), hint: None }
    }

    /// A failure with a file, named first.
    pub fn of_file(name: &str, problem: impl Display) -> Failure {
        Failure::new(format!("{name}: {problem}"))
    }

    pub fn hint(self, hint: impl Into<String>) -> Failure {
        match self {
            Failure::Message { text, .. } => Failure::Message { text, hint: Some(hint.into()) },
            told => told,
        }
    }

    pub fn read(name: &str, error: &ReadError) -> Failure {
        Failure::of_file(name, plain(error))
    }

    pub fn write(name: &str, error: &WriteError) -> Failure {
        Failure::of_file(name, error)
    }

    /// Tells the user, and gives the exit code.
    pub fn report(self) -> ExitCode {
        match self {
            Failure::Message { text, hint } => {
                report::error(&text, hint.as_deref());
                ExitCode::FAILURE
            }
            Failure::Told => ExitCode::FAILURE,
            Failure::Pipe => ExitCode::SUCCESS,
        }
    }
}

/// The words for an error of reading.
pub fn plain(error: &ReadError) -> String {
    match error {
        ReadError::File(error) => io_text(error),
        error => error.to_string(),
    }
}

/// The words for an error of the operating system, without its number.
pub fn io_text(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        std::io::ErrorKind::IsADirectory => "this is a folder, not a file".to_owned(),
        std::io::ErrorKind::NotADirectory | std::io::ErrorKind::AlreadyExists => {
            "a part of this path is a file, not a folder".to_owned()
        }
        _ => {
            let text = error.to_string();
            text.split(" (os error").next().unwrap_or_default().to_owned()
        }
    }
}
