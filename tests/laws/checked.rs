//! Grammars that pass the checks: every label has rules, every name a meaning, every call its arguments.

use proptest::collection::vec;
use proptest::option::of;
use proptest::prelude::*;
use proptest::sample;
use vox::grammar::ast::*;
use vox::grammar::{Code, Diagnostic, check};
use vox::space::{Axis, Up};

/// What the parameters of a label are for: its calls know what to hand over.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Type {
    Number,
    Axis,
    Thing,
}

const TYPES: [Type; 3] = [Type::Number, Type::Axis, Type::Thing];

/// The types of each label's parameters.
type Labels = Vec<Vec<Type>>;

/// What the names of one rule mean.
#[derive(Clone)]
struct Scope {
    labels: Labels,
    params: Vec<Type>,
    up: Up,
}

/// Grammars that pass, with rings of rules, parameters, conditions and every operation.
pub fn grammars() -> impl Strategy<Value = Grammar> {
    let types = vec((0..TYPES.len()).prop_map(|at| TYPES[at]), 0..3);
    let labels = vec(types, 1..5).prop_map(|mut labels| {
        labels[0].clear();
        labels
    });
    let up = prop_oneof![Just(Up::Y), Just(Up::Z)];
    (labels, up).prop_flat_map(grammar).prop_filter("can never go well", |grammar| {
        let found = check(grammar.clone()).map_or_else(|found| found, |_| Vec::new());
        found.iter().filter(|finding| finding.is_error()).all(is_unexpected)
    })
}

/// Whether an error is none of those that grammars of random words must have now and then.
fn is_unexpected(finding: &Diagnostic) -> bool {
    !matches!(finding.code, Code::NamesInARing | Code::Endless | Code::EndlessCondition | Code::NoWeight)
}

fn grammar((labels, up): (Labels, Up)) -> impl Strategy<Value = Grammar> {
    let rules: Vec<_> = (0..labels.len())
        .map(|at| {
            let scope = Scope { labels: labels.clone(), params: labels[at].clone(), up };
            vec(rule(at, scope), 1..3)
        })
        .collect();
    let sizes = vec(start_size(), 0..3);
    (constants(), sizes, rules).prop_map(move |(constants, sizes, rules)| Grammar {
        up,
        sizes,
        constants,
        styles: vec![Style {
            comments: Vec::new(),
            behind: None,
            name: Ident::new("other"),
            values: vec![(Ident::new("p0"), Expr::number(7.0))],
        }],
        rules: rules.concat(),
        ..Grammar::default()
    })
}

fn start_size() -> impl Strategy<Value = StartSize> {
    ([1..9u32, 1..9, 1..9], of(1..4u32)).prop_map(|(size, weight)| StartSize {
        comments: Vec::new(),
        behind: None,
        size: size.map(|length| Expr::number(length.into())),
        weight: weight.map(|weight| Expr::number(weight.into())),
        span: Default::default(),
    })
}

/// One constant of each type, under names that a printer might want for itself.
fn constants() -> impl Strategy<Value = Vec<Constant>> {
    let named = |name: &'static str, value: BoxedStrategy<Expr>| {
        value.prop_map(move |value| Constant {
            comments: Vec::new(),
            behind: None,
            name: Ident::new(name),
            value,
            attribute: None,
        })
    };
    let number = (0..9u32).prop_map(|number| Expr::number(number.into())).boxed();
    // A constant named after a primitive says what that is made of.
    let thing = proptest::sample::select(vec!["stone", "glass"]).prop_map(Expr::name).boxed();
    (named("p0", number), named("rect", thing)).prop_map(|(number, thing)| vec![number, thing])
}

fn label(at: usize) -> Ident {
    Ident::new(format!("label_{at}"))
}

fn param(at: usize) -> String {
    format!("q{at}")
}

fn rule(at: usize, scope: Scope) -> impl Strategy<Value = Rule> {
    let params: Vec<Ident> = (0..scope.params.len()).map(|at| Ident::new(param(at))).collect();
    (of(condition(&scope)), successor(scope.clone()), of(number(&scope)), 1..3u32).prop_map(
        move |(condition, successor, weight, priority)| Rule {
            priority,
            comments: Vec::new(),
            behind: None,
            label: label(at),
            params: params.clone(),
            condition,
            successor,
            weight,
        },
    )
}

fn successor(scope: Scope) -> BoxedStrategy<Successor> {
    let shape = prop_oneof![Just("rect"), Just("gable"), Just("window2")];
    let primitive = prop_oneof![
        thing(&scope).prop_map(|name| (name, None)),
        (shape, thing(&scope)).prop_map(|(shape, material)| (Expr::name(shape), Some(material))),
    ];
    let leaf = prop_oneof![
        1 => Just(Op::Nil),
        3 => (primitive, of(number(&scope))).prop_map(|((name, material), pitch)| {
            // Only shapes have options.
            let pitch = pitch.filter(|_| material.is_some());
            let options = pitch.into_iter().map(|pitch| (Ident::new("pitch"), pitch)).collect();
            Op::Primitive { name, material, options }
        }),
        1 => axis(&scope).prop_map(|axis| Op::Snap { axis, label: None }),
        3 => call(&scope),
    ];
    let branch = move |inner: BoxedStrategy<Successor>| {
        let body = || inner.clone().prop_map(Box::new);
        let (axis, number) = (|| axis(&scope), || number(&scope));
        let up = Expr::name(scope.up.to_string());
        prop_oneof![
            (axis(), snap(), items(number(), inner.clone())).prop_map(|(axis, snap, items)| Op::Split {
                axis,
                snap,
                items
            }),
            (axis(), number(), snap(), body()).prop_map(|(axis, size, snap, body)| Op::Repeat {
                axis,
                size,
                snap,
                body
            }),
            (axis(), number(), body()).prop_map(|(axis, count, body)| Op::RepeatN { axis, count, body }),
            (change(&scope, up), body()).prop_map(|(change, body)| Op::Within { change, body }),
            vec(inner.clone(), 2..4).prop_map(Op::All),
            (sample::subsequence(Face::NAMES.to_vec(), 1..4), of(number()), vec(inner.clone(), 4)).prop_map(
                |(faces, thickness, bodies)| {
                    let selectors = faces.into_iter().map(|(_, face)| Selector::On(vec![face]));
                    let parts = selectors.zip(bodies).collect();
                    Op::Carve { how: Carving::Faces, args: thickness.into_iter().collect(), parts }
                }
            ),
        ]
        .prop_map(Successor::new)
    };
    leaf.prop_map(Successor::new).prop_recursive(3, 12, 3, branch).boxed()
}

fn change(scope: &Scope, up: Expr) -> impl Strategy<Value = Change> + use<> {
    let sizes = || [0, 1, 2].map(|_| fixed(number(scope)));
    prop_oneof![
        sizes().prop_map(Change::Translate),
        sizes().prop_map(Change::Resize),
        number(scope).prop_map(move |angle| Change::Rotate { axis: up.clone(), angle }),
        Just(Change::Local),
        number(scope).prop_map(Change::Same),
        Just(Change::Style(Ident::new("other"))),
    ]
}

fn snap() -> impl Strategy<Value = Option<Snap>> {
    of(of(Just("planes".to_owned())).prop_map(|label| Snap { label }))
}

/// A condition, which may ask about other shapes.
fn condition(scope: &Scope) -> impl Strategy<Value = Expr> + use<> {
    let label = label(0).name;
    let against = sample::select(vec![Against::All, Against::NoParent, Against::Label(label.clone())]);
    let occlusion = (against, of(number(scope).prop_map(Box::new)))
        .prop_map(|(against, distance)| ExprKind::Occlusion { against, distance });
    let visible = Just(ExprKind::Visible(label));
    prop_oneof![3 => number(scope), 1 => prop_oneof![occlusion, visible].prop_map(Expr::new)]
}

fn call(scope: &Scope) -> impl Strategy<Value = Op> + use<> {
    let scope = scope.clone();
    (0..scope.labels.len()).prop_flat_map(move |at| {
        let args: Vec<_> = scope.labels[at].iter().map(|of| of_type(*of, &scope)).collect();
        args.prop_map(move |args| Op::Call { label: label(at), args })
    })
}

fn items(number: BoxedStrategy<Expr>, body: BoxedStrategy<Successor>) -> impl Strategy<Value = Vec<Item>> {
    let kind = prop_oneof![Just(SizeKind::Absolute), Just(SizeKind::Floating), Just(SizeKind::Relative)];
    let part =
        (kind, number, body).prop_map(|(kind, value, body)| Item::Part { size: Size { kind, value }, body });
    let item = part.prop_recursive(2, 6, 3, |inner| {
        vec(inner, 1..4).prop_map(|items| Item::Group { items, span: Default::default() })
    });
    vec(item, 1..4)
}

/// A length for `T` and `S`, where nothing floats.
fn fixed(number: BoxedStrategy<Expr>) -> impl Strategy<Value = Size> {
    let kind = prop_oneof![Just(SizeKind::Absolute), Just(SizeKind::Relative)];
    (kind, number).prop_map(|(kind, value)| Size { kind, value })
}

fn of_type(of: Type, scope: &Scope) -> BoxedStrategy<Expr> {
    match of {
        Type::Number => number(scope),
        Type::Axis => axis(scope),
        Type::Thing => thing(scope),
    }
}

fn params_of(of: Type, scope: &Scope) -> Vec<Expr> {
    let typed = scope.params.iter().enumerate().filter(move |(_, known)| **known == of);
    typed.map(|(at, _)| Expr::name(param(at))).collect()
}

fn axis(scope: &Scope) -> BoxedStrategy<Expr> {
    let mut known = params_of(Type::Axis, scope);
    known.extend(Axis::ALL.map(|axis| Expr::name(axis.to_string())));
    proptest::sample::select(known).boxed()
}

fn thing(scope: &Scope) -> BoxedStrategy<Expr> {
    let mut known = params_of(Type::Thing, scope);
    known.extend(["stone", "glass", "rect", "gable", "window2"].map(Expr::name));
    for state in ["oak_stairs[facing=east]", "rect[facing=north]"] {
        known.push(Expr::new(ExprKind::Block(state.to_owned())));
    }
    let plain = proptest::sample::select(known);
    let mix = vec((number(scope), plain.clone()), 1..3).prop_map(ExprKind::Mix);
    let gradient = (axis(scope).prop_map(Box::new), vec(plain.clone(), 1..3))
        .prop_map(|(axis, blocks)| ExprKind::Gradient(axis, blocks));
    let pick = vec((number(scope), plain.clone()), 1..3).prop_map(ExprKind::Pick);
    prop_oneof![6 => plain, 1 => prop_oneof![mix, gradient, pick].prop_map(Expr::new)].boxed()
}

fn number(scope: &Scope) -> BoxedStrategy<Expr> {
    let mut known = params_of(Type::Number, scope);
    known.extend(Axis::ALL.map(|axis| Expr::new(ExprKind::ScopeSize(axis))));
    known.extend(["p0", "pi", "true"].map(Expr::name));
    known.extend((0..6).map(|number| Expr::number(f64::from(number) / 2.0)));
    let leaf = proptest::sample::select(known);
    let branch = |inner: BoxedStrategy<Expr>| {
        let boxed = || inner.clone().prop_map(Box::new);
        let unary = prop_oneof![Just(UnaryOp::Negate), Just(UnaryOp::Not)];
        prop_oneof![
            (unary, boxed()).prop_map(|(op, operand)| ExprKind::Unary(op, operand)),
            (0..BinaryOp::ALL.len(), boxed(), boxed()).prop_map(|(op, left, right)| ExprKind::Binary(
                BinaryOp::ALL[op],
                left,
                right
            )),
            (0..Function::ALL.len(), vec(inner.clone(), 3)).prop_map(|(function, mut args)| {
                let function = Function::ALL[function];
                while function.takes(args.len()).is_err() {
                    args.pop();
                }
                ExprKind::Call(function, args)
            }),
        ]
        .prop_map(Expr::new)
    };
    leaf.prop_recursive(2, 6, 3, branch).boxed()
}
