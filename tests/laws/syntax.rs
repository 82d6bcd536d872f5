//! Any syntax tree that the printer can be given, and what printing and parsing owe one another.

use proptest::collection::vec;
use proptest::option::of;
use proptest::prelude::*;
use vox::grammar::ast::*;
use vox::grammar::parse;
use vox::space::{Axis, Up};

proptest! {
    #[test]
    fn what_is_printed_parses_to_the_same_tree(grammar in grammars()) {
        let text = grammar.to_string();
        let again = parse(&text);
        prop_assert_eq!(again.as_ref().map_err(|found| super::messages(found)), Ok(&grammar), "{}", text);
    }

    #[test]
    fn the_printers_layout_is_its_own(grammar in grammars()) {
        let text = grammar.to_string();
        prop_assert_eq!(parse(&text).unwrap().to_string(), text);
    }

    #[test]
    fn no_printed_line_ends_in_a_space(grammar in grammars()) {
        let text = grammar.to_string();
        prop_assert!(text.lines().all(|line| line.trim_end() == line), "{}", text);
        prop_assert!(text.ends_with('\n') && !text.ends_with("\n\n"));
    }
}

/// The words that mean something where a name stands.
const WORDS: [&str; 40] = [
    "I",
    "nil",
    "split",
    "repeat",
    "repeatN",
    "T",
    "S",
    "R",
    "comp",
    "size",
    "scope",
    "up",
    "and",
    "or",
    "not",
    "rand",
    "snap",
    "setback",
    "offset",
    "shapeL",
    "shapeU",
    "shapeT",
    "shapeH",
    "shapeO",
    "shapeRound",
    "local",
    "same",
    "style",
    "pick",
    "mix",
    "gradient",
    "occ",
    "visible",
    "attr",
    "import",
    "priority",
    "if",
    "when",
    "as",
    "all",
];

pub fn grammars() -> impl Strategy<Value = Grammar> {
    let up = prop_oneof![Just(Up::Y), Just(Up::Z)];
    let version = prop::option::of(0..5000i32);
    let head = (comments(), up, version, vec(start_size(), 0..3), vec(constant(), 0..4));
    let names = (vec(import(), 0..2), vec(style(), 0..2));
    (head, names, vec(rule(), 1..6)).prop_map(|(head, (imports, styles), rules)| {
        let (preamble, up, data_version, sizes, constants) = head;
        Grammar { preamble, up, data_version, imports, sizes, constants, styles, rules, ..Grammar::default() }
    })
}

fn import() -> impl Strategy<Value = Import> {
    (comments(), text(), of(ident())).prop_map(|(comments, file, prefix)| Import {
        comments,
        behind: None,
        file,
        prefix,
        span: Default::default(),
    })
}

fn style() -> impl Strategy<Value = Style> {
    (comments(), ident(), vec((ident(), argument()), 0..3)).prop_map(|(comments, name, values)| Style {
        comments,
        behind: None,
        name,
        values,
    })
}

/// What may stand in quotes.
fn text() -> impl Strategy<Value = String> {
    "[ !#-~ä]{0,12}"
}

fn comments() -> impl Strategy<Value = Vec<String>> {
    let line = "[ -~äß→]{0,30}".prop_map(|line| line.trim_end().to_owned());
    prop_oneof![3 => Just(Vec::new()), 1 => vec(line, 1..3)]
}

fn start_size() -> impl Strategy<Value = StartSize> {
    (comments(), [expr(), expr(), expr()], of(expr())).prop_map(|(comments, size, weight)| StartSize {
        comments,
        behind: None,
        size,
        weight,
        span: Default::default(),
    })
}

fn constant() -> impl Strategy<Value = Constant> {
    (comments(), ident(), argument(), of(attribute())).prop_map(|(comments, name, value, attribute)| {
        Constant { comments, behind: None, name, value, attribute }
    })
}

fn attribute() -> impl Strategy<Value = Attribute> {
    (of([expr(), expr()]), of(text()), of(text())).prop_map(|(range, group, about)| Attribute {
        range,
        group,
        about,
    })
}

fn rule() -> impl Strategy<Value = Rule> {
    (comments(), ident(), vec(ident(), 0..3), of(expr()), successor(), of(expr()), 1..4u32).prop_map(
        |(comments, label, params, condition, successor, weight, priority)| Rule {
            priority,
            comments,
            behind: None,
            label,
            params,
            condition,
            successor,
            weight,
        },
    )
}

fn ident() -> impl Strategy<Value = Ident> {
    name().prop_map(Ident::new)
}

fn name() -> impl Strategy<Value = String> {
    "[a-zA-Z_äß][a-zA-Z0-9_äß]{0,8}".prop_filter("a word of the language", |name| !WORDS.contains(&&**name))
}

fn successor() -> impl Strategy<Value = Successor> {
    let leaf = prop_oneof![
        Just(Op::Nil),
        (argument(), of(argument()), vec((ident(), argument()), 0..3))
            .prop_map(|(name, material, options)| Op::Primitive { name, material, options }),
        (expr(), of(ident())).prop_map(|(axis, label)| Op::Snap { axis, label }),
        (ident(), vec(argument(), 0..3)).prop_map(|(label, args)| Op::Call { label, args }),
    ];
    leaf.prop_map(Successor::new).prop_recursive(4, 24, 4, |inner| {
        let body = || inner.clone().prop_map(Box::new);
        prop_oneof![
            (expr(), of(snap()), items(inner.clone())).prop_map(|(axis, snap, items)| Op::Split {
                axis,
                snap,
                items
            }),
            (expr(), expr(), of(snap()), body()).prop_map(|(axis, size, snap, body)| Op::Repeat {
                axis,
                size,
                snap,
                body
            }),
            (expr(), expr(), body()).prop_map(|(axis, count, body)| Op::RepeatN { axis, count, body }),
            (change(), body()).prop_map(|(change, body)| Op::Within { change, body }),
            vec(inner.clone(), 2..4).prop_map(Op::All),
            carving().prop_flat_map(move |how| {
                let args = vec(expr(), how.takes().0);
                let parts = vec((selector(how), inner.clone()), 1..4);
                (args, parts).prop_map(move |(args, parts)| Op::Carve { how, args, parts })
            }),
        ]
        .prop_map(Successor::new)
    })
}

/// The items of a split: parts, and rhythm groups up to two deep.
fn items(body: impl Strategy<Value = Successor> + Clone + 'static) -> impl Strategy<Value = Vec<Item>> {
    let part = (size(), body).prop_map(|(size, body)| Item::Part { size, body });
    let item = part.prop_recursive(2, 6, 3, |inner| {
        vec(inner, 1..4).prop_map(|items| Item::Group { items, span: Default::default() })
    });
    vec(item, 1..4)
}

fn size() -> impl Strategy<Value = Size> {
    let kind = prop_oneof![Just(SizeKind::Absolute), Just(SizeKind::Floating), Just(SizeKind::Relative)];
    (kind, expr()).prop_map(|(kind, value)| Size { kind, value })
}

fn change() -> impl Strategy<Value = Change> {
    let sizes = || [size(), size(), size()];
    prop_oneof![
        sizes().prop_map(Change::Translate),
        sizes().prop_map(Change::Resize),
        (expr(), expr()).prop_map(|(axis, angle)| Change::Rotate { axis, angle }),
        Just(Change::Local),
        argument().prop_map(Change::Same),
        ident().prop_map(Change::Style),
    ]
}

fn snap() -> impl Strategy<Value = Snap> {
    of(name()).prop_map(|label| Snap { label })
}

fn carving() -> impl Strategy<Value = Carving> {
    (0..Carving::NAMES.len()).prop_map(|at| Carving::NAMES[at].1)
}

fn selector(how: Carving) -> impl Strategy<Value = Selector> {
    let face = (0..Face::NAMES.len()).prop_map(|at| Face::NAMES[at].1);
    let named = (0..Selector::NAMES.len()).prop_map(|at| Selector::NAMES[at].1.clone());
    prop_oneof![vec(face, 1..4).prop_map(Selector::On), (0..12u32).prop_map(Selector::Index), named]
        .prop_filter("parts of that name are carved", move |selector| selector.suits(how))
}

/// An expression where a block with a namespace may stand as well.
fn argument() -> impl Strategy<Value = Expr> {
    let block = "[a-z]{1,5}:[a-z_]{1,5}(/[a-z]{1,3})?(\\[[a-z]{1,4}=[a-z0-9]{1,4}\\])?";
    prop_oneof![4 => expr(), 1 => block.prop_map(|text| Expr::new(ExprKind::Block(text)))]
}

pub fn expr() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![
        number().prop_map(Expr::number),
        name().prop_map(Expr::name),
        "[a-z_]{1,8}\\[[a-z]{1,4}=[a-z0-9]{1,4}(,[a-z]{1,4}=[a-z]{1,4})?\\]"
            .prop_map(|text| Expr::new(ExprKind::Block(text))),
        "[ !#-~ä]{0,12}".prop_map(|name| Expr::new(ExprKind::File(name))),
        (0..3usize).prop_map(|axis| Expr::new(ExprKind::ScopeSize(Axis::ALL[axis]))),
        prop_oneof![Just(Share::Index), Just(Share::Total)]
            .prop_map(|share| Expr::new(ExprKind::Share(share))),
        name().prop_map(|label| Expr::new(ExprKind::Visible(label))),
    ];
    leaf.prop_recursive(4, 16, 3, |inner| {
        let boxed = || inner.clone().prop_map(Box::new);
        let unary = prop_oneof![Just(UnaryOp::Negate), Just(UnaryOp::Not)];
        prop_oneof![
            (unary, boxed()).prop_map(|(op, operand)| ExprKind::Unary(op, operand)),
            ((0..BinaryOp::ALL.len()), boxed(), boxed()).prop_map(|(op, left, right)| ExprKind::Binary(
                BinaryOp::ALL[op],
                left,
                right
            )),
            call(inner.clone()),
            (against(), of(boxed()))
                .prop_map(|(against, distance)| ExprKind::Occlusion { against, distance }),
            vec((inner.clone(), inner.clone()), 1..3).prop_map(ExprKind::Pick),
            vec((inner.clone(), inner.clone()), 1..3).prop_map(ExprKind::Mix),
            (boxed(), vec(inner.clone(), 1..3)).prop_map(|(axis, blocks)| ExprKind::Gradient(axis, blocks)),
            (boxed(), boxed()).prop_map(|(key, value)| ExprKind::Same(key, value)),
        ]
        .prop_map(Expr::new)
    })
}

fn against() -> impl Strategy<Value = Against> {
    let word = prop_oneof![Just("all"), Just("active"), Just("noparent")].prop_map(str::to_owned);
    prop_oneof![word, name()].prop_map(|name| Against::of_name(&name))
}

fn call(arg: impl Strategy<Value = Expr>) -> impl Strategy<Value = ExprKind> {
    ((0..Function::ALL.len()), vec(arg, 3)).prop_map(|(function, mut args)| {
        let function = Function::ALL[function];
        while function.takes(args.len()).is_err() {
            args.pop();
        }
        ExprKind::Call(function, args)
    })
}

/// Numbers of any size that a text can state; a sign is an operator.
fn number() -> impl Strategy<Value = f64> {
    let any = any::<f64>().prop_map(f64::abs).prop_filter("finite", |number| number.is_finite());
    prop_oneof![2 => (0..100u32).prop_map(f64::from), 2 => 0.0..10.0f64, 1 => any]
}
