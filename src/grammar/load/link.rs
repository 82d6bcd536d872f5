//! Files that import one another become one grammar.

use super::constants::in_order;
use super::rename::{Naming, Renaming};
use super::space::{Sort, Space, named_imports, spaces};
use super::{Module, beside, place};
use crate::grammar::ast::{Constant, Rule};
use crate::grammar::{Code, Diagnostic, Grammar};
use std::collections::{BTreeMap, BTreeSet};

/// The whole grammar, and the names that could not be read. What it says of sizes and axes is said by the root.
pub fn link(mut modules: Vec<Module>, errors: &mut Vec<Diagnostic>) -> (Grammar, BTreeSet<String>) {
    if modules.len() == 1 {
        let Module { parsed, .. } = modules.remove(0);
        return (parsed.grammar, parsed.broken);
    }
    axes(&modules, errors);
    let (spaces, of_module) = spaces(&modules, errors);
    let root = &modules[0].parsed.grammar;
    let mut whole = Grammar { preamble: root.preamble.clone(), up: root.up, ..Grammar::default() };
    whole.data_version = modules.iter().find_map(|module| module.parsed.grammar.data_version);
    let mut constants = Vec::new();
    let mut broken = BTreeSet::new();
    for (number, space) in spaces.iter().enumerate() {
        for member in &space.members {
            let file =
                File { modules: &modules, spaces: &spaces, of_module: &of_module, number, module: *member };
            file.add(&mut whole, &mut constants);
            broken
                .extend(modules[*member].parsed.broken.iter().map(|name| format!("{}{name}", space.prefix)));
        }
    }
    whole.constants = in_order(constants, &whole.styles);
    (whole, broken)
}

/// Files that turn their scopes differently do not go together.
fn axes(modules: &[Module], errors: &mut Vec<Diagnostic>) {
    for module in modules {
        for (number, imported) in module.imports.iter().enumerate().filter_map(|(at, of)| Some((at, (*of)?)))
        {
            let [here, there] = [module, &modules[imported]].map(|module| module.parsed.grammar.up);
            if here != there {
                let message = format!("here {} is up, in the imported file {}", here.axis(), there.axis());
                let hint = format!("write `up {}` in one of them", here.axis());
                errors.push(Diagnostic::new(Code::ImportsClash, place(module, number), message).hint(hint));
            }
        }
    }
}

/// A file as a member of a space.
struct File<'m> {
    modules: &'m [Module],
    spaces: &'m [Space],
    of_module: &'m BTreeMap<usize, usize>,
    /// The space.
    number: usize,
    module: usize,
}

impl File<'_> {
    fn space(&self) -> &Space {
        &self.spaces[self.number]
    }

    /// Adds what this file defines and no file above it hides.
    fn add(&self, whole: &mut Grammar, constants: &mut Vec<(usize, Constant)>) {
        let own = &self.modules[self.module].parsed.grammar;
        let plain = Renaming { naming: self, params: Vec::new() };
        for rule in own.rules.iter().filter(|rule| self.stands(Sort::Label, &rule.label.name)) {
            let rule = self.rule(rule);
            if self.module != 0 || self.number != 0 {
                whole.imported.insert(rule.label.name.clone());
            }
            whole.rules.push(rule);
        }
        for constant in own.constants.iter().filter(|it| self.stands(Sort::Constant, &it.name.name)) {
            let mut constant = constant.clone();
            plain.constant(&mut constant);
            constants.push((self.module, constant));
        }
        for style in own.styles.iter().filter(|style| self.stands(Sort::Style, &style.name.name)) {
            let mut style = style.clone();
            plain.style(&mut style);
            whole.styles.push(style);
        }
        if self.module == 0 && self.number == 0 {
            whole.sizes = own.sizes.clone();
            whole.sizes.iter_mut().for_each(|start| plain.start_size(start));
        }
    }

    fn rule(&self, rule: &Rule) -> Rule {
        let params = rule.params.iter().map(|param| param.name.clone()).collect();
        let mut rule = rule.clone();
        Renaming { naming: self, params }.rule(&mut rule);
        rule
    }

    /// Whether a definition of this file is the one that its space has.
    fn stands(&self, sort: Sort, name: &str) -> bool {
        self.space().table.get(&(sort, name.to_owned())) == Some(&self.module)
    }
}

impl Naming for File<'_> {
    fn defined(&self, sort: Sort, name: &str) -> Option<String> {
        let (space, name) = match name.split_once('.') {
            None => (self.space(), name),
            Some((prefix, name)) => {
                let mut imports = named_imports(&self.modules[self.module]);
                let (_, module) = imports.find(|(known, _)| *known == prefix)?;
                (&self.spaces[*self.of_module.get(&module)?], name)
            }
        };
        let is_known = space.table.contains_key(&(sort, name.to_owned()));
        is_known.then(|| format!("{}{name}", space.prefix))
    }

    fn missing(&self, label: &str) -> String {
        format!("{}{label}", self.space().prefix)
    }

    fn is_captured(&self, name: &str) -> bool {
        self.number != 0 && self.spaces[0].table.contains_key(&(Sort::Constant, name.to_owned()))
    }

    fn file(&self, file: &str) -> String {
        beside(&self.modules[self.module].path, file).to_string_lossy().into_owned()
    }
}
