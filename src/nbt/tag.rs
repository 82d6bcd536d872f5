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
