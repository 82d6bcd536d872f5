//! Lowering, raising and the equality of graphs.

use super::{checked, graph, graph_of};
use proptest::prelude::*;
use vox::grammar::ast::*;
use vox::grammar::{check, parse};
use vox::graph::{Arg, Builder, Expr as GraphExpr, Op as GraphOp, Size as GraphSize, lower, raise};

proptest! {
    #[test]
    fn raising_and_lowering_are_inverse(grammar in checked::grammars()) {
        let graph = graph_of(grammar);
        let raised = raise(&graph);
        prop_assert!(graph_of(raised.clone()) == graph, "{}", raised);
    }

    #[test]
    fn joining_equal_operations_changes_nothing(grammar in checked::grammars()) {
        let graph = graph_of(grammar);
        let unified = graph.unified();
        prop_assert!(unified == graph);
        prop_assert!(unified.unified().len() == unified.len() && unified.len() <= graph.len());
        let raised = raise(&unified);
        prop_assert!(graph_of(raised.clone()) == graph, "{}", raised);
    }

    #[test]
    fn raised_grammars_survive_their_text(grammar in checked::grammars()) {
        let raised = raise(&graph_of(grammar));
        prop_assert_eq!(parse(&raised.to_string()).unwrap(), raised);
    }

    #[test]
    fn names_of_rules_do_not_matter(grammar in checked::grammars().prop_map(unasked)) {
        let renamed = relabelled(&grammar, &|label| format!("other_{label}"));
        prop_assume!(check(renamed.clone()).is_ok());
        prop_assert!(graph_of(renamed) == graph_of(grammar));
    }

    #[test]
    fn writing_a_rule_twice_does_not_matter(grammar in checked::grammars().prop_map(unasked)) {
        let mut doubled = relabelled(&grammar, &|label| format!("twin_{label}"));
        doubled.rules.splice(0..0, grammar.rules.clone());
        // The first rules call into the twins, which call themselves.
        let own = grammar.rules[0].label.name.clone();
        let first = doubled.rules.iter_mut().take_while(|rule| rule.label.name == own);
        first.for_each(|rule| relabel(&mut rule.successor, &|label| format!("twin_{label}")));
        prop_assume!(check(doubled.clone()).is_ok());
        prop_assert!(graph_of(doubled) == graph_of(grammar));
    }

    #[test]
    fn a_condition_matters(grammar in checked::grammars()) {
        let mut changed = grammar.clone();
        changed.rules[0].condition = Some(Expr::number(12345.0));
        prop_assume!(check(changed.clone()).is_ok());
        prop_assert!(graph_of(changed) != graph_of(grammar));
    }

    #[test]
    fn a_weight_matters_beside_another(grammar in checked::grammars()) {
        let mut two = grammar;
        two.rules.insert(0, two.rules[0].clone());
        let mut changed = two.clone();
        changed.rules[0].weight = Some(Expr::number(12345.0));
        prop_assume!(check(changed.clone()).is_ok() && check(two.clone()).is_ok());
        prop_assert!(graph_of(changed) != graph_of(two));
    }

    #[test]
    fn a_size_matters(grammar in checked::grammars()) {
        let with_size = |size: f64| {
            let mut changed = grammar.clone();
            let size = Size { kind: SizeKind::Absolute, value: Expr::number(size) };
            let part = Item::Part { size, body: changed.rules[0].successor.clone() };
            let axis = Expr::name("x");
            changed.rules[0].successor = Successor::new(Op::Split { axis, snap: None, items: vec![part.clone(), part] });
            graph_of(changed)
        };
        prop_assert!(with_size(12345.0) != with_size(12346.0));
        prop_assert!(with_size(12345.0) == with_size(12345.0));
    }
}

/// Without conditions that ask for a label: there its name matters.
fn unasked(mut grammar: Grammar) -> Grammar {
    for rule in &mut grammar.rules {
        let condition = rule.condition.as_ref().map(|condition| &condition.kind);
        if matches!(condition, Some(ExprKind::Occlusion { .. } | ExprKind::Visible(_))) {
            rule.condition = None;
        }
    }
    grammar
}

fn relabelled(grammar: &Grammar, name: &dyn Fn(&str) -> String) -> Grammar {
    let mut renamed = grammar.clone();
    for rule in &mut renamed.rules {
        rule.label = Ident::new(name(&rule.label.name));
        relabel(&mut rule.successor, name);
    }
    renamed
}

fn relabel(successor: &mut Successor, name: &dyn Fn(&str) -> String) {
    match &mut successor.op {
        Op::Nil | Op::Primitive { .. } | Op::Snap { .. } => {}
        Op::Call { label, .. } => *label = Ident::new(name(&label.name)),
        Op::All(ops) => ops.iter_mut().for_each(|op| relabel(op, name)),
        Op::Split { items, .. } => items.iter_mut().for_each(|item| relabel_item(item, name)),
        Op::Repeat { body, .. } | Op::RepeatN { body, .. } | Op::Within { body, .. } => relabel(body, name),
        Op::Carve { parts, .. } => parts.iter_mut().for_each(|(_, body)| relabel(body, name)),
    }
}

fn relabel_item(item: &mut Item, name: &dyn Fn(&str) -> String) {
    match item {
        Item::Part { body, .. } => relabel(body, name),
        Item::Group { items, .. } => items.iter_mut().for_each(|item| relabel_item(item, name)),
    }
}

#[test]
fn rings_of_rules_are_equal_by_what_they_derive() {
    let one = graph("a : scope.sx > 1 --> split(x){ 1 : I(stone) | ~1 : a }\na --> I(stone)");
    let two = graph(
        "a : scope.sx > 1 --> split(x){ 1 : I(stone) | ~1 : b }\na --> I(stone)\n\
         b : scope.sx > 1 --> split(x){ 1 : I(stone) | ~1 : a }\nb --> I(stone)",
    );
    let other = graph(
        "a : scope.sx > 1 --> split(x){ 1 : I(stone) | ~1 : b }\na --> I(stone)\n\
         b : scope.sx > 1 --> split(x){ 1 : I(dirt) | ~1 : a }\nb --> I(stone)",
    );
    assert!(one == two);
    assert!(one != other);
}

#[test]
fn a_built_graph_with_numbers_below_zero_comes_back() {
    let mut builder = Builder::default();
    let stone = builder.primitive(GraphExpr::name("stone"));
    let delta = [-1.0, 0.0, 2.5].map(|length| GraphSize::absolute(GraphExpr::number(length)));
    let root = builder.node(GraphOp::Translate(delta), vec![(Arg::None, stone)]);
    let (graph, _) = builder.finish(root);
    let checked = vox::grammar::check(raise(&graph)).unwrap();
    assert!(lower(&checked, None).unwrap() == graph);
}

#[test]
fn a_rule_with_parameters_starts_nothing() {
    let checked = vox::grammar::check(parse("a(n) --> repeatN(x, n){ nil }").unwrap()).unwrap();
    let told = lower(&checked, None).unwrap_err().to_string();
    assert!(told.contains("`a` takes parameters (n)"), "{told}");
}

#[test]
fn nested_rhythms_come_back() {
    for items in
        ["{ { ~1 : a }* }*", "{ { ~1 : a }* | 1 : a }*", "{ 1 : a | { ~1 : a }* }*", "{ { { ~1 : a }* }* }*"]
    {
        let graph = graph(&format!("s --> split(x){{ {items} }}\na --> I(stone)"));
        let raised = raise(&graph);
        assert!(graph_of(raised.clone()) == graph, "{items}: {raised}");
    }
}

#[test]
fn parameters_do_not_hide_constants() {
    let graph = graph("m = glass\na --> b(stone)\nb(m) --> split(x){ ~1 : I(m) | ~1 : c }\nc --> I(m)");
    let raised = raise(&graph);
    assert!(graph_of(raised.clone()) == graph, "{raised}");
}
