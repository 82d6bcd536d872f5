use std::collections::BTreeMap;

/// The tags of a compound by name. Sorted, so that the same tree always gives the same bytes.
pub type Compound = BTreeMap<String, Tag>;

/// One value of an NBT tree.
#[derive(Clone, PartialEq, Debug)]
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
