//! The codes of all findings: each names one kind of slip for good, and `vox explain` tells more of it.

use super::Severity;

/// A longer word on one kind of finding.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Explanation {
    /// `E` for errors, `W` for warnings. 00: reading the text; 01: names; 02: kinds and numbers of things; 03: what
    /// can never go well; 05: what only a run shows.
    pub id: &'static str,
    /// What is wrong, in a few words.
    pub title: &'static str,
    pub text: &'static str,
    /// A whole grammar that is told of with this code; a short one for all but one code.
    pub wrong: &'static str,
    /// The same without the slip.
    pub right: &'static str,
}

macro_rules! codes {
    ($($code:ident $id:literal $title:literal $text:literal wrong $wrong:literal right $right:literal)*) => {
        /// What kind of slip a finding is about.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $(#[doc = $title] $code,)*
        }

        impl Code {
            /// In the order of their ids, errors first.
            pub const ALL: &[Code] = &[$(Code::$code),*];
        }

        const EXPLANATIONS: &[Explanation] = &[$(
            Explanation { id: $id, title: $title, text: $text, wrong: $wrong, right: $right },
        )*];
    };
}

impl Code {
    pub fn explanation(self) -> &'static Explanation {
        &EXPLANATIONS[self as usize]
    }

    /// `E0101`: how reports and `vox explain` name it.
    pub fn id(self) -> &'static str {
        self.explanation().id
    }

    pub fn of_id(id: &str) -> Option<Code> {
        Code::ALL.iter().copied().find(|code| code.id().eq_ignore_ascii_case(id))
    }

    pub fn severity(self) -> Severity {
        if self.id().starts_with('E') { Severity::Error } else { Severity::Warning }
    }
}

codes! {
    UnknownCharacter "E0001" "a character has no meaning here"
    "Only letters, digits and the signs of the language stand outside of comments and quoted names.
A comment begins with `#` or `//`; parts are separated by `|`, arguments by `,`."
    wrong "house --> split(x){ ~1 : I(stone) ; ~1 : nil }"
    right "house --> split(x){ ~1 : I(stone) | ~1 : nil }"

    OpenText "E0002" "a quoted name is not closed"
    "The name of a file stands between two double quotes on one line."
    wrong "house --> I(\"door.schem)"
    right "house --> I(\"door.schem\")"

    Unexpected "E0003" "something else is expected here"
    "The text cannot be read on from this place. Most often a bracket, a bar or a comma is missing just before
it: the arrow of the report points at the first word that does not fit."
    wrong "house --> split(x){ ~1 : I(stone) ~2 : I(dirt) }"
    right "house --> split(x){ ~1 : I(stone) | ~2 : I(dirt) }"

    NoArrow "E0004" "a rule has no arrow"
    "A rule reads `label --> operation`, a constant `name = value`. The arrow has two dashes."
    wrong "house -> I(stone)"
    right "house --> I(stone)"

    LeftOver "E0005" "something stands behind the end of an item"
    "A rule or a constant ends with its line, unless one of its brackets is open. A condition stands before the
arrow, not behind the operation."
    wrong "house --> I(stone) if scope.sx > 3"
    right "house : scope.sx > 3 --> I(stone)
house : scope.sx <= 3 --> nil"

    NestedTooDeeply "E0006" "operations or expressions are nested too deeply"
    "Operations and brackets stand in one another up to 200 deep, and an expression has up to 200 operators. More is
most often a slip of a program that writes grammars; give the inner parts rules or constants of their own."
    wrong "n = ----------------------------------------------------------------------------------------------------\
------------------------------------------------------------------------------------------------------------1
house --> repeatN(x, n){ I(stone) }"
    right "n = 1
house --> repeatN(x, n){ I(stone) }"

    NumberTooLarge "E0007" "a number is too large"
    "Numbers are kept with about 16 digits and up to about 300 zeros. No building needs one near that."
    wrong "house --> split(x){ 1000000000000000000000000000000000000000000000000000000000000000000000000000000000\
0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000\
0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000\
0000000000000000000000000000000000000000000000000000 : nil }"
    right "house --> split(x){ ~1 : nil }"

    OpenProperties "E0008" "the properties of a block are not closed"
    "The properties of a block state stand between `[` and `]`, right behind its name."
    wrong "house --> I(oak_stairs[facing=east)"
    right "house --> I(oak_stairs[facing=east])"

    NoRules "E0009" "a grammar has no rule"
    "A run starts from the first rule of the file. Without one there is nothing to do."
    wrong "floor = 4"
    right "house --> I(stone)"

    BadPart "E0010" "a part of a split is not complete"
    "Every part of a split reads `size : operation`. A size is a number of blocks (`3`), a share of what is left
(`~1`) or a fraction of the scope (`'0.5`)."
    wrong "house --> split(x){ wall | ~1 : wall }
wall --> I(stone)"
    right "house --> split(x){ 1 : wall | ~1 : wall }
wall --> I(stone)"

    UnknownOperation "E0011" "there is no operation of that name"
    "A word with braces behind it is one of the operations: split, repeat, repeatN, T, S, R, comp, setback, offset,
the footprints shapeL, shapeU, shapeT, shapeH, shapeO and shapeRound, local, same and style. A label stands alone."
    wrong "house --> spilt(x){ ~1 : nil }"
    right "house --> split(x){ ~1 : nil }"

    UnknownComponent "E0012" "a scope has no components of that kind"
    "`comp` takes a scope apart into its faces, `comp(f)`, its edges, `comp(e)`, or its vertices, `comp(v)`."
    wrong "house --> comp(w){ side : I(stone) }"
    right "house --> comp(f){ side : I(stone) }"

    UnknownPart "E0013" "there is no part of that name"
    "Each operation that carves a scope has names for its parts. Faces: front, back, left, right, top, bottom, side,
all, and north, east, south, west of the world. Edges and vertices lie on several: `top.front`, `top.front.left`.
Offsets have `border` and `inside`, footprints `shape` and `remainder`. `inside` is what is left."
    wrong "house --> comp(f){ roof : I(stone) }"
    right "house --> comp(f){ top : I(stone) }"

    CarvingArguments "E0014" "a carving has too many or too few arguments"
    "`comp` may take a thickness, `setback` and `offset` take a depth, and footprints take the widths of their wings:
`shapeL(front, left)`, `shapeU(back, left, right)`, `shapeT(back, stem)`, `shapeH(left, bar, right)`, `shapeO(ring)`."
    wrong "house --> shapeL(3){ shape : I(stone) }"
    right "house --> shapeL(3, 4){ shape : I(stone) }"

    FunctionArguments "E0015" "a function has too many or too few arguments"
    "`min` and `max` take two numbers or more; `abs`, `floor`, `ceil` and `round` one; `rand`, `randint` and `gauss`
two; `triangular` three. `rand` alone is a number from 0 to 1."
    wrong "house --> repeatN(x, randint(3)){ I(stone) }"
    right "house --> repeatN(x, randint(1, 3)){ I(stone) }"

    UnknownField "E0016" "a scope or a split has no such field"
    "A scope has its lengths: `scope.sx`, `scope.sy` and `scope.sz`, in blocks. The part of a split or a repeat has its
number, `split.index`, from 0, and `split.total`."
    wrong "house : scope.height > 3 --> nil
house --> I(stone)"
    right "house : scope.sy > 3 --> nil
house --> I(stone)"

    UnknownNote "E0017" "an attribute has no such note"
    "Behind its value, an attribute may have `range(1, 9)`, `group(\"Massing\")` and `about(\"the number of storeys\")`."
    wrong "attr floors = 4 between(1, 9)
house --> repeatN(y, floors){ I(stone) }"
    right "attr floors = 4 range(1, 9)
house --> repeatN(y, floors){ I(stone) }"

    BadUp "E0018" "only y or z can be up"
    "With `up y`, which needs no line, y is up as in the game. With `up z`, z is up and y runs away from the front."
    wrong "up x
house --> I(stone)"
    right "up z
house --> I(stone)"

    BadDataVersion "E0019" "a data version is no whole number"
    "`data_version 3465` says that the block states are those of 1.20.1. Every version of the game has such a number."
    wrong "data_version 1.20
house --> I(stone)"
    right "data_version 3465
house --> I(stone)"

    BadPriority "E0020" "a priority is no whole number from 1"
    "`priority 2` on a line of its own gives the rules below it that priority. A label's rules of priority 1 come first;
those of priority 2 are for where the conditions of all of them fail."
    wrong "house : scope.sx > 3 --> I(stone)
priority 0
house --> nil"
    right "house : scope.sx > 3 --> I(stone)
priority 2
house --> nil"

    NoImport "E0021" "a file cannot be imported"
    "The file that an import names is not there, or is no text. Files are looked for beside the file that imports them."
    wrong "import \"wals.grammar\"
house --> wall
# --- walls.grammar
wall --> I(stone)"
    right "import \"walls.grammar\"
house --> wall
# --- walls.grammar
wall --> I(stone)"

    UnknownLabel "E0101" "there is no rule for a label"
    "A word on the right of an arrow that is no operation is a label: it needs a rule with that label on the left. What
is to be placed as it is stands in `I(...)`."
    wrong "house --> split(x){ ~1 : wal | ~1 : wall }
wall --> I(stone)"
    right "house --> split(x){ ~1 : wall | ~1 : wall }
wall --> I(stone)"

    UnknownName "E0102" "a name is no parameter and no constant"
    "A name in a number means a parameter of the rule that it stands in, or else a constant of the file. Parameters of the
rule that calls this one are not seen: hand them over."
    wrong "house --> wall(3)
wall(n) --> repeatN(x, n){ bay }
bay --> repeatN(y, n){ I(stone) }"
    right "house --> wall(3)
wall(n) --> repeatN(x, n){ bay(n) }
bay(n) --> repeatN(y, n){ I(stone) }"

    UnknownBlock "E0103" "there is no block or primitive of that name"
    "`I(...)` takes a block of the game, a primitive such as `gable`, a constant, a parameter or a file in quotes. Blocks of
mods carry their namespace: `create:brass_casing`. A constant gives a word of your own a meaning: `plaster = calcite`."
    wrong "house --> I(stome)"
    right "house --> I(stone)"

    UnknownStyle "E0104" "there is no style of that name"
    "`style(name){ operation }` needs a `style name { constant = value }` on a line of its own."
    wrong "wall = oak_planks
style spruce { wall = spruce_planks }
house --> style(sprcue){ I(wall) }"
    right "wall = oak_planks
style spruce { wall = spruce_planks }
house --> style(spruce){ I(wall) }"

    UnknownConstant "E0105" "a style gives a value to no constant"
    "A style gives other values to constants of the file; it cannot define new ones."
    wrong "wall = oak_planks
style spruce { walls = spruce_planks }
house --> style(spruce){ I(wall) }"
    right "wall = oak_planks
style spruce { wall = spruce_planks }
house --> style(spruce){ I(wall) }"

    Reserved "E0106" "a word of the language is given a meaning"
    "The words of the language cannot be labels, constants or parameters."
    wrong "pi = 3
house --> repeatN(x, pi){ I(stone) }"
    right "bays = 3
house --> repeatN(x, bays){ I(stone) }"

    ConstantTwice "E0107" "a constant is defined twice"
    "A constant has one value in a run. To have several to choose from, write `pick{ ... }`, or give a style another one."
    wrong "wall = stone
wall = andesite
house --> I(wall)"
    right "wall = pick{ 1 : stone | 1 : andesite }
house --> I(wall)"

    ParameterTwice "E0108" "a parameter stands twice"
    "Each parameter of a rule has a name of its own."
    wrong "house --> wall(1, 2)
wall(n, n) --> repeatN(x, n){ I(stone) }"
    right "house --> wall(1, 2)
wall(n, m) --> repeatN(x, n + m){ I(stone) }"

    StyleTwice "E0109" "a style is defined twice"
    "A style has one block of values. Join the two."
    wrong "wall = oak_planks
post = oak_log
style spruce { wall = spruce_planks }
style spruce { post = spruce_log }
house --> style(spruce){ split(x){ 1 : I(post) | ~1 : I(wall) } }"
    right "wall = oak_planks
post = oak_log
style spruce { wall = spruce_planks, post = spruce_log }
house --> style(spruce){ split(x){ 1 : I(post) | ~1 : I(wall) } }"

    PartTwice "E0110" "a part stands twice"
    "Each part of a carved scope goes to one operation. Two operations side by side share a scope."
    wrong "house --> comp(f){ side : I(stone) | side : I(glass) }"
    right "house --> comp(f){ side : I(stone) | top : I(glass) }"

    ConstantTooEarly "E0111" "a constant uses one below it"
    "Constants are drawn in the order of the file: each may use those above it, and not itself."
    wrong "height = storeys * 4
storeys = 2
house --> split(y){ height : I(stone) | ~1 : nil }"
    right "storeys = 2
height = storeys * 4
house --> split(y){ height : I(stone) | ~1 : nil }"

    ConstantAsksScope "E0112" "a constant asks about a scope"
    "Constants are drawn once, before there is a scope. Lengths, places in a split and questions about other shapes belong
into rules."
    wrong "half = scope.sx / 2
house --> split(x){ half : I(stone) | ~1 : nil }"
    right "house --> split(x){ scope.sx / 2 : I(stone) | ~1 : nil }"

    BadBlockState "E0113" "a block state cannot be read"
    "A block state reads `name[key=value,key=value]`, with small letters."
    wrong "house --> I(oak_log[axis])"
    right "house --> I(oak_log[axis=x])"

    UnknownOption "E0114" "a primitive has no such option"
    "Roofs and solids take `pitch` (blocks up for each block in), `overhang` (blocks that the eaves reach out), `thickness`
(blocks of a shell, 0 for a solid one) and `wall` (the block of the gable ends)."
    wrong "house --> I(gable, oak, overhand = 1)"
    right "house --> I(gable, oak, overhang = 1)"

    OptionTwice "E0115" "an option stands twice"
    "Each option of a primitive has one value."
    wrong "house --> I(gable, oak, pitch = 1, pitch = 2)"
    right "house --> I(gable, oak, pitch = 2)"

    ImportsClash "E0116" "imported files do not go together"
    "Two imported files give one name a meaning, or turn their axes differently. Import one of them under a name of its own,
or define the name in the file that imports both: its own definitions come first."
    wrong "import \"oak.grammar\"
import \"stone.grammar\"
house --> wall
# --- oak.grammar
wall --> I(oak_planks)
# --- stone.grammar
wall --> I(stone)"
    right "import \"oak.grammar\"
import \"stone.grammar\" as stone
house --> split(y){ 1 : stone.wall | ~1 : wall }
# --- oak.grammar
wall --> I(oak_planks)
# --- stone.grammar
wall --> I(stone)"

    WrongType "E0201" "a value is of the wrong kind"
    "There are numbers, axes and things to place. A size, a count, an angle or a weight is a number; `split`, `repeat` and
`R` take an axis: x, y or z; `I` takes a block or a primitive."
    wrong "house --> split(3){ ~1 : I(stone) }"
    right "house --> split(x){ ~1 : I(stone) }"

    WrongArity "E0202" "a label is called with too many or too few arguments"
    "A call hands over one value for each parameter of the label's rules."
    wrong "house --> wall
wall(n) --> repeatN(x, n){ I(stone) }"
    right "house --> wall(3)
wall(n) --> repeatN(x, n){ I(stone) }"

    ParametersDiffer "E0203" "the rules of a label take different parameters"
    "Any rule of a label may be drawn for a call of it, so all of them take as many parameters."
    wrong "house --> wall(3)
wall(n) --> repeatN(x, n){ I(stone) }
wall --> I(dirt)"
    right "house --> wall(3)
wall(n) --> repeatN(x, n){ I(stone) }
wall(n) --> I(dirt)"

    NoMaterial "E0204" "a block is to be made of another"
    "Only shapes such as `cuboid`, `gable` or `door` are made of something: a block is what it is."
    wrong "house --> I(stone, oak_planks)"
    right "house --> I(cuboid, oak_planks)"

    FloatsAlone "E0205" "a floating size stands outside of a split"
    "A floating size is a share of what the other parts of a split leave. `T` and `S` have no other parts: write blocks or a
fraction of the scope."
    wrong "house --> S(~1, 2, 3){ I(stone) }"
    right "house --> S('0.5, 2, 3){ I(stone) }"

    FlatTurn "E0206" "a scope is turned about a level axis"
    "Blocks of the game only turn about the vertical, so scopes do as well: the axis of `R` is y, or z with `up z`."
    wrong "house --> R(x, 90){ I(oak_stairs) }"
    right "house --> R(y, 90){ I(oak_stairs) }"

    NamesInARing "E0301" "labels only lead back to themselves"
    "A label whose only rule is another label is a second name for it. Names in a ring name nothing."
    wrong "house --> hut
hut --> house"
    right "house --> hut
hut --> I(oak_planks)"

    Endless "E0302" "rules call one another without an end"
    "Every rule of these labels calls the next one in the same scope, so nothing ever ends it: no part becomes smaller, and
there is no rule that stops. Call the label in a part of the scope, or give it a rule that ends, with a condition or by
chance."
    wrong "tower --> storey T(0, 4, 0){ tower }
storey --> S('1, 4, '1){ I(bricks) }"
    right "tower --> split(y){ 4 : storey | ~1 : tower }
storey --> I(bricks)"

    EndlessCondition "E0303" "the condition of a ring of rules cannot change"
    "Once this rule is taken, it calls its own label with all that its condition asks for as it was: the condition holds
again, and again. Hand over another value, such as `n - 1`, or call it in a part of the scope."
    wrong "house --> tower(3)
tower(n) : n > 0 --> I(bricks) T(0, 1, 0){ tower(n) }
tower(n) : n <= 0 --> nil"
    right "house --> tower(3)
tower(n) : n > 0 --> I(bricks) T(0, 1, 0){ tower(n - 1) }
tower(n) : n <= 0 --> nil"

    NoWeight "E0304" "weights leave nothing to choose"
    "One of several is drawn in proportion to its weight: weights are zero or more, and not all of them zero. To switch a
rule off, give it the weight 0 and leave another one above zero."
    wrong "house --> I(stone) : 0
house --> I(bricks) : 0"
    right "house --> I(stone) : 0
house --> I(bricks) : 1"

    OutOfRange "E0305" "the value of an attribute lies outside of its range"
    "What an attribute is unless a run sets it must be a value that a run may set. The same holds for what a style gives it."
    wrong "attr floors = 12 range(1, 9)
house --> repeatN(y, floors){ I(stone) }"
    right "attr floors = 4 range(1, 9)
house --> repeatN(y, floors){ I(stone) }"

    EmptyRange "E0306" "a range holds no value"
    "`range(low, high)` names the least value first."
    wrong "attr floors = 4 range(9, 1)
house --> repeatN(y, floors){ I(stone) }"
    right "attr floors = 4 range(1, 9)
house --> repeatN(y, floors){ I(stone) }"

    NoStartSize "E0501" "the size of the start scope is not known"
    "A run needs the size of its plot: from the grammar, `size(9, 7, 9)`, or from the command line, `--size 9x7x9`."
    wrong "house --> I(stone)"
    right "size(9, 7, 9)
house --> I(stone)"

    BadStartSize "E0502" "the start scope is too large or too small"
    "Each length of the start scope is one block or more, and its volume is bounded, so that a slip does not fill the memory."
    wrong "size(100000, 100000, 100000)
house --> I(stone)"
    right "size(100, 100, 100)
house --> I(stone)"

    Overrun "E0503" "sizes need more blocks than the scope has"
    "The parts of a split fill its scope exactly. Make the scope larger or one of the sizes floating, choose another rule for
small scopes with a condition, or cut off what is too much with `--overrun clip`."
    wrong "size(5, 3, 1)
wall --> split(x){ 3 : I(stone) | 4 : I(glass) }"
    right "size(5, 3, 1)
wall --> split(x){ 3 : I(stone) | ~4 : I(glass) }"

    Underrun "E0504" "sizes leave a part of the scope free"
    "The parts of a split fill its scope exactly. Make one of the sizes floating (`~1`), or add a part with `nil`."
    wrong "size(3, 3, 1)
wall --> split(y){ 1 : I(stone) }"
    right "size(3, 3, 1)
wall --> split(y){ 1 : I(stone) | ~1 : nil }"

    NegativeSize "E0505" "a size is less than zero"
    "Sizes are zero or more; a part of no size is skipped. `max(0, ...)` keeps a difference from falling below zero."
    wrong "size(3, 3, 1)
wall --> split(y){ scope.sx - 5 : I(stone) | ~1 : nil }"
    right "size(3, 3, 1)
wall --> split(y){ max(0, scope.sx - 5) : I(stone) | ~1 : nil }"

    NoRuleApplies "E0506" "no rule of a label applies"
    "All rules of the label have conditions, and every one of them fails in this scope. Add a rule for the case, or one
without a condition at a later priority."
    wrong "size(3, 3, 1)
wall : scope.sx > 3 --> I(stone)"
    right "size(3, 3, 1)
wall : scope.sx > 3 --> I(stone)
wall : scope.sx <= 3 --> I(glass)"

    BadWeight "E0507" "weights leave nothing to draw from"
    "Of the rules whose conditions hold, one is drawn in proportion to its weight. Weights are zero or more, and not all of
them are zero at once."
    wrong "size(3, 3, 1)
wall --> I(stone) : scope.sx - 4
wall --> I(glass)"
    right "size(3, 3, 1)
wall --> I(stone) : max(1, scope.sx - 4)
wall --> I(glass)"

    NoValue "E0508" "an expression has no value"
    "A division by zero has no value, and neither has a number without bound."
    wrong "size(5, 3, 1)
wall --> repeatN(x, 3 / (scope.sx - 5)){ I(stone) }"
    right "size(5, 3, 1)
wall --> repeatN(x, 3 / max(1, scope.sx - 5)){ I(stone) }"

    BadStep "E0509" "a repeat of nothing"
    "The size of a repeat is more than zero, its count is zero or more."
    wrong "size(5, 3, 1)
wall --> repeat(x, scope.sx - 5){ I(stone) }"
    right "size(5, 3, 1)
wall --> repeat(x, max(1, scope.sx - 5)){ I(stone) }"

    BadAngle "E0510" "an angle is not a multiple of a quarter turn"
    "Scopes are boxes of blocks and stay so. Angles are in degrees (90, 180, 270) or in radians (pi/2, pi, 3*pi/2)."
    wrong "size(3, 3, 3)
house --> R(y, 45){ I(oak_stairs) }"
    right "size(3, 3, 3)
house --> R(y, 90){ I(oak_stairs) }"

    ThinRhythm "E0511" "the parts of a rhythm group are too thin"
    "A group in braces with a star is repeated as often as it fits. Parts that sum to almost nothing would fit without end."
    wrong "size(5, 3, 1)
wall --> split(x){ { 0 : I(stone) }* | ~1 : nil }"
    right "size(5, 3, 1)
wall --> split(x){ { 1 : I(stone) }* | ~1 : nil }"

    LeavesPlot "E0512" "something is placed outside of the start scope"
    "The start scope is all the room that a building has. Keep `T` and `S` inside of it, or cut off what leaves it with
`--overrun clip`."
    wrong "size(3, 3, 3)
house --> T(1, 0, 0){ I(stone) }"
    right "size(3, 3, 3)
house --> T(1, 0, 0){ S(2, 3, 3){ I(stone) } }"

    CallsTooDeep "E0513" "rules call one another too deep"
    "A chain of operations, each derived from the one before, has reached the limit: most likely it has no end. Let a
condition end it, or let the scope become smaller with each step."
    wrong "size(3, 3, 3)
house --> tower(1)
tower(n) : n > 0 --> tower(n + 1)
tower(n) : n <= 0 --> I(stone)"
    right "size(3, 3, 3)
house --> tower(3)
tower(n) : n > 0 --> tower(n - 1)
tower(n) : n <= 0 --> I(stone)"

    TooManySteps "E0514" "a derivation takes too many steps"
    "The number of operations of a run is bounded, so that a slip ends in an error. `--max-steps` raises the bound."
    wrong "size(3, 3, 3)
house --> repeatN(x, 1000000000){ I(stone) }"
    right "size(3, 3, 3)
house --> repeatN(x, 3){ I(stone) }"

    TooManyScopes "E0515" "a repeat opens too many scopes at once"
    "Each scope that waits takes memory, so their number is bounded. Split the scope into a few parts first, and repeat inside
of them."
    wrong "size(5000000, 1, 1)
line --> repeat(x, 1){ I(stone) }"
    right "size(500, 1, 1)
line --> repeat(x, 1){ I(stone) }"

    NoFile "E0516" "a file that the grammar places was not loaded"
    "A name in quotes is a schematic file, which is looked for beside the grammar."
    wrong "size(3, 3, 3)
house --> I(\"no_such_door.schem\")"
    right "size(3, 3, 3)
house --> I(door, oak)"

    PaletteFull "E0517" "a building has too many different blocks"
    "A grid numbers its block states with 16 bits: it holds 65536 different ones, more than the game has. Only a grammar with
as many names of blocks of mods can need more."
    wrong "" right ""

    StartTakesParameters "W0101" "the first rule takes parameters"
    "A run starts from the first rule of the file, and nothing hands it arguments. Put a rule in front that calls it."
    wrong "wall(n) --> repeatN(x, n){ I(stone) }"
    right "house --> wall(3)
wall(n) --> repeatN(x, n){ I(stone) }"

    Unreachable "W0102" "a label cannot be reached"
    "No chain of calls leads from the first rule to this label, so its rules never run."
    wrong "house --> I(stone)
roof --> I(gable, oak)"
    right "house --> split(y){ ~1 : I(stone) | ~1 : roof }
roof --> I(gable, oak)"

    UnknownProperty "W0103" "a block has no such property, or not that value of it"
    "The state is written as it stands, for mods may know it; the game drops what it does not know."
    wrong "house --> I(oak_stairs[facing=up])"
    right "house --> I(oak_stairs[facing=east])"

    UnusedConstant "W0104" "a constant is never used"
    "Nothing in the file names this constant: is a name mistyped where it was meant?"
    wrong "trim = oak_log
house --> I(oak_planks)"
    right "trim = oak_log
house --> split(x){ 1 : I(trim) | ~1 : I(oak_planks) }"

    UnusedAttribute "W0105" "an attribute is never used"
    "Nothing in the file names this attribute, so whatever a run sets it to, the buildings stay the same."
    wrong "attr floors = 4 range(1, 9)
house --> repeatN(y, 4){ I(stone) }"
    right "attr floors = 4 range(1, 9)
house --> repeatN(y, floors){ I(stone) }"

    EmptyStyle "W0106" "a style changes nothing"
    "None of the constants to which this style gives a value is used, or it gives none."
    wrong "wall = oak_planks
style spruce { }
house --> style(spruce){ I(wall) }"
    right "wall = oak_planks
style spruce { wall = spruce_planks }
house --> style(spruce){ I(wall) }"

    UnusedParameter "W0107" "a parameter is never used"
    "None of the rules of this label reads the parameter: calls hand over a value for nothing."
    wrong "house --> wall(3, 4)
wall(n, m) --> repeatN(x, n){ I(stone) }"
    right "house --> wall(3, 4)
wall(n, m) --> repeatN(x, n){ repeatN(y, m){ I(stone) } }"

    SnapUnmarked "W0108" "a split heeds planes that nothing marks"
    "`split(axis, snap(label))` and `repeat(axis, size, snap(label))` move their boundaries onto planes that `snap(axis, label)`
has marked. No operation marks planes of this label."
    wrong "house --> split(x){ ~1 : tower | ~2 : hall }
tower --> snap(y, ledge) I(stone)
hall --> split(y, snap(ledges)){ ~1 : I(bricks) | ~1 : I(glass) }"
    right "house --> split(x){ ~1 : tower | ~2 : hall }
tower --> snap(y, ledge) I(stone)
hall --> split(y, snap(ledge)){ ~1 : I(bricks) | ~1 : I(glass) }"

    SnapUnheeded "W0109" "nothing heeds the planes that are marked"
    "`snap(axis, label)` marks planes; no split and no repeat of the file heeds them."
    wrong "house --> snap(y, ledge) split(y){ ~1 : I(bricks) | ~1 : I(glass) }"
    right "house --> snap(y, ledge) split(y, snap(ledge)){ ~1 : I(bricks) | ~1 : I(glass) }"

    NeverFits "W0301" "sizes can never fit their scope"
    "However the grammar runs from its own start sizes, the parts of this split need more blocks than its scope has. A run that
comes here ends in an error, unless it cuts off what is too much with `--overrun clip`."
    wrong "house --> split(x){ 3 : bay | ~1 : nil }
bay --> split(x){ 2 : I(stone) | 2 : I(glass) }"
    right "house --> split(x){ 4 : bay | ~1 : nil }
bay --> split(x){ 2 : I(stone) | 2 : I(glass) }"

    NeverFills "W0302" "sizes can never fill their scope"
    "However the grammar runs from its own start sizes, the parts of this split leave some of its scope free, and none floats.
A run that comes here ends in an error, unless it leaves the rest free with `--overrun clip`."
    wrong "house --> split(x){ 5 : bay | ~1 : nil }
bay --> split(x){ 2 : I(stone) | 2 : I(glass) }"
    right "house --> split(x){ 5 : bay | ~1 : nil }
bay --> split(x){ 2 : I(stone) | ~2 : I(glass) }"

    Gap "W0303" "the conditions of a label leave a gap"
    "All rules of this label have conditions, and there is a case that none of them covers: a run that meets it ends in an
error. Move a bound, add a rule for the case, or add one without a condition at a later priority."
    wrong "bays : scope.sx > 3 --> repeat(x, 2){ I(glass) }
bays : scope.sx < 3 --> I(stone)"
    right "bays : scope.sx >= 3 --> repeat(x, 2){ I(glass) }
bays : scope.sx < 3 --> I(stone)"

    NeverHolds "W0304" "a condition can never hold"
    "The parts of this condition contradict one another, so the rule is never taken."
    wrong "wall : scope.sx > 5 and scope.sx < 3 --> I(glass)
wall --> I(stone)"
    right "wall : scope.sx < 5 and scope.sx > 3 --> I(glass)
wall --> I(stone)"

    Shadowed "W0305" "a rule is never taken, for an earlier one always applies"
    "Rules of a later priority are for where none of the earlier ones applies. A rule without a condition always applies."
    wrong "wall --> I(stone)
priority 2
wall --> I(glass)"
    right "wall : scope.sx > 3 --> I(stone)
priority 2
wall --> I(glass)"

    NoRoomForDoor "W0501" "a door has no room"
    "A door is two blocks high and was left out of a scope of one."
    wrong "size(1, 1, 1)
house --> I(door, oak)"
    right "size(1, 2, 1)
house --> I(door, oak)"
}
