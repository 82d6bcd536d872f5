//! Spaces of names: a file and those that it imports without `as` share one, in which each name has one definition.

use super::{Module, place};
use crate::grammar::{Code, Diagnostic, Grammar};
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

/// What a name is the name of: labels, constants and styles may share one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Sort {
    Label,
    Constant,
    Style,
}

/// Which module defines each name.
pub type Table = BTreeMap<(Sort, String), usize>;

#[derive(Debug)]
pub struct Space {
    /// What its names begin with in the whole grammar; that of the root is empty.
    pub prefix: String,
    /// The file and those that it imports without `as`, each before those that only it imports.
    pub members: Vec<usize>,
    pub table: Table,
}

/// All spaces, that of the root first, and the space of each module that has one.
pub fn spaces(modules: &[Module], errors: &mut Vec<Diagnostic>) -> (Vec<Space>, BTreeMap<usize, usize>) {
    let mut definitions = Definitions { modules, errors, told: BTreeSet::new() };
    let mut spaces = Vec::new();
    let mut of_module = BTreeMap::from([(0, 0)]);
    let mut open = vec![(0, String::new())];
    let mut taken = BTreeSet::new();
    while spaces.len() < open.len() {
        let (first, prefix) = open[spaces.len()].clone();
        let members = members(modules, first);
        for (name, module) in members.iter().flat_map(|member| named_imports(&modules[*member])) {
            if let Entry::Vacant(vacant) = of_module.entry(module) {
                vacant.insert(open.len());
                open.push((module, free(format!("{prefix}{name}"), &mut taken)));
            }
        }
        spaces.push(Space { prefix, members, table: definitions.of(first, &mut BTreeMap::new()) });
    }
    (spaces, of_module)
}

/// A prefix that no other space has.
fn free(name: String, taken: &mut BTreeSet<String>) -> String {
    let numbered = (2..).map(|number| format!("{name}{number}."));
    let prefix = std::iter::once(format!("{name}.")).chain(numbered).find(|prefix| !taken.contains(prefix));
    let prefix = prefix.unwrap_or_default();
    taken.insert(prefix.clone());
    prefix
}

/// A module and all that it imports without a prefix.
fn members(modules: &[Module], first: usize) -> Vec<usize> {
    let mut members = vec![first];
    let mut at = 0;
    while at < members.len() {
        for (_, module) in plain_imports(&modules[members[at]]) {
            if !members.contains(&module) {
                members.push(module);
            }
        }
        at += 1;
    }
    members
}

/// The modules that are imported without a prefix, with the numbers of their imports.
fn plain_imports(module: &Module) -> impl Iterator<Item = (usize, usize)> + use<'_> {
    let imports = module.parsed.grammar.imports.iter().zip(&module.imports).enumerate();
    imports.filter(|(_, (import, _))| import.prefix.is_none()).filter_map(|(at, (_, of))| Some((at, (*of)?)))
}

/// The modules that are imported with a prefix.
pub fn named_imports(module: &Module) -> impl Iterator<Item = (&str, usize)> {
    let imports = module.parsed.grammar.imports.iter().zip(&module.imports);
    imports.filter_map(|(import, of)| Some((import.prefix.as_ref()?.name.as_str(), (*of)?)))
}

/// Finds out which module defines a name, and tells of names that two imports define.
struct Definitions<'m> {
    modules: &'m [Module],
    errors: &'m mut Vec<Diagnostic>,
    /// Conflicts that were told, by the module and the number of its import.
    told: BTreeSet<(usize, usize)>,
}

impl Definitions<'_> {
    /// The definitions that a module has or imports. Its own hide those that it imports. Those of one space are kept
    /// in `known`; a module that is open already is in a ring, and adds nothing to itself.
    fn of(&mut self, module: usize, known: &mut BTreeMap<usize, Table>) -> Table {
        if let Some(table) = known.get(&module) {
            return table.clone();
        }
        known.insert(module, Table::new());
        let modules = self.modules;
        let own: BTreeSet<(Sort, &str)> = defined(&modules[module].parsed.grammar).collect();
        let mut table = Table::new();
        for (number, imported) in plain_imports(&modules[module]) {
            for ((sort, name), by) in self.of(imported, known) {
                match table.get(&(sort, name.clone())) {
                    _ if own.contains(&(sort, name.as_str())) => {}
                    Some(other) if *other != by => self.conflict(module, number, &name, [*other, by]),
                    _ => {
                        table.insert((sort, name), by);
                    }
                }
            }
        }
        table.extend(own.into_iter().map(|(sort, name)| ((sort, name.to_owned()), module)));
        known.insert(module, table.clone());
        table
    }

    fn conflict(&mut self, module: usize, number: usize, name: &str, by: [usize; 2]) {
        if self.told.insert((module, number)) {
            let files = by.map(|module| self.modules[module].path.display().to_string());
            let message = format!("`{name}` is defined by `{}` and by `{}`", files[0], files[1]);
            let place = place(&self.modules[module], number);
            let error = Diagnostic::new(Code::ImportsClash, place, message).label("again here");
            let hint =
                format!("give one import a name, as in `import ... as walls`, or define `{name}` here");
            self.errors.push(error.hint(hint));
        }
    }
}

/// The names that a file defines.
fn defined(grammar: &Grammar) -> impl Iterator<Item = (Sort, &str)> {
    let labels = grammar.rules.iter().map(|rule| (Sort::Label, rule.label.name.as_str()));
    let constants = grammar.constants.iter().map(|constant| (Sort::Constant, constant.name.name.as_str()));
    let styles = grammar.styles.iter().map(|style| (Sort::Style, style.name.name.as_str()));
    labels.chain(constants).chain(styles)
}
