use super::Compound;
use std::cmp::Ordering;

/// One value of an NBT tree. Tags are equal when their bytes are: a NaN is itself, and -0.0 is not 0.0.
#[derive(Clone, Debug)]
pub enum Tag {
    Byte(i8),
    Short(i16),
    Int(i32),
    Long(i64),
    Float(f32),
    Double(f64),
    String(String),
    ByteArray(Vec<i8>),
    IntArray(Vec<i32>),
    LongArray(Vec<i64>),
    List(Vec<Tag>),
    Compound(Compound),
}

/// The type numbers of the binary form.
pub(super) mod id {
    pub const END: u8 = 0;
    pub const BYTE: u8 = 1;
    pub const SHORT: u8 = 2;
    pub const INT: u8 = 3;
    pub const LONG: u8 = 4;
    pub const FLOAT: u8 = 5;
    pub const DOUBLE: u8 = 6;
    pub const BYTE_ARRAY: u8 = 7;
    pub const STRING: u8 = 8;
    pub const LIST: u8 = 9;
    pub const COMPOUND: u8 = 10;
    pub const INT_ARRAY: u8 = 11;
    pub const LONG_ARRAY: u8 = 12;
}

impl Tag {
    pub(super) fn id(&self) -> u8 {
        match self {
            Tag::Byte(_) => id::BYTE,
            Tag::Short(_) => id::SHORT,
            Tag::Int(_) => id::INT,
            Tag::Long(_) => id::LONG,
            Tag::Float(_) => id::FLOAT,
            Tag::Double(_) => id::DOUBLE,
            Tag::ByteArray(_) => id::BYTE_ARRAY,
            Tag::String(_) => id::STRING,
            Tag::List(_) => id::LIST,
            Tag::Compound(_) => id::COMPOUND,
            Tag::IntArray(_) => id::INT_ARRAY,
            Tag::LongArray(_) => id::LONG_ARRAY,
        }
    }

    /// What kind of value this is, in the words of messages: `a Short`.
    pub fn kind(&self) -> &'static str {
        match self {
            Tag::Byte(_) => "a Byte",
            Tag::Short(_) => "a Short",
            Tag::Int(_) => "an Int",
            Tag::Long(_) => "a Long",
            Tag::Float(_) => "a Float",
            Tag::Double(_) => "a Double",
            Tag::String(_) => "a String",
            Tag::ByteArray(_) => "a Byte Array",
            Tag::IntArray(_) => "an Int Array",
            Tag::LongArray(_) => "a Long Array",
            Tag::List(_) => "a List",
            Tag::Compound(_) => "a Compound",
        }
    }
}

impl Ord for Tag {
    fn cmp(&self, other: &Tag) -> Ordering {
        match (self, other) {
            (Tag::Byte(a), Tag::Byte(b)) => a.cmp(b),
            (Tag::Short(a), Tag::Short(b)) => a.cmp(b),
            (Tag::Int(a), Tag::Int(b)) => a.cmp(b),
            (Tag::Long(a), Tag::Long(b)) => a.cmp(b),
            (Tag::Float(a), Tag::Float(b)) => a.total_cmp(b),
            (Tag::Double(a), Tag::Double(b)) => a.total_cmp(b),
            (Tag::ByteArray(a), Tag::ByteArray(b)) => a.cmp(b),
            (Tag::String(a), Tag::String(b)) => a.cmp(b),
            (Tag::List(a), Tag::List(b)) => a.cmp(b),
            (Tag::Compound(a), Tag::Compound(b)) => a.cmp(b),
            (Tag::IntArray(a), Tag::IntArray(b)) => a.cmp(b),
            (Tag::LongArray(a), Tag::LongArray(b)) => a.cmp(b),
            _ => self.id().cmp(&other.id()),
        }
    }
}

impl PartialOrd for Tag {
    fn partial_cmp(&self, other: &Tag) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Eq for Tag {}

impl PartialEq for Tag {
    fn eq(&self, other: &Tag) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
