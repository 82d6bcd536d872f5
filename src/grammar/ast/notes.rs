/// The comments beside an operation inside a rule.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Notes {
    /// On lines of their own above it.
    pub above: Vec<String>,
    /// Behind the bracket that opens its parts.
    pub open: Option<String>,
    /// On lines of their own below its last part.
    pub last: Vec<String>,
    /// Behind it on its last line.
    pub behind: Option<String>,
}
