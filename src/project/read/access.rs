//! The parts of a value: fields of a struct, items of a list, the variant of an enum.

use super::{At, Path, Wrong};
use crate::problem::Problem;
use crate::project::text::{Entry, Group, NodeKind, line_column};
use crate::project::words;
use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, IntoDeserializer, MapAccess, SeqAccess,
    VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;
use std::collections::HashMap;
use std::slice::Iter;

/// The fields of a struct, in the order in which they stand.
pub(crate) struct Fields<'r, 't> {
    at: At<'r, 't>,
    /// Name of the struct.
    holder: &'r str,
    /// Names that may stand there; nothing where only the visitor knows.
    known: Option<&'r [&'r str]>,
    entries: Iter<'t, Entry>,
    /// Names so far, and where they stand.
    seen: HashMap<&'t str, usize>,
    /// The field whose name was given out and whose value was not yet.
    open: Option<(&'t str, &'t Entry)>,
}

impl<'r, 't> Fields<'r, 't> {
    pub(super) fn new(
        at: At<'r, 't>,
        group: &'t Group,
        holder: &'r str,
        known: Option<&'r [&'r str]>,
    ) -> Self {
        let entries = group.entries.iter();
        Fields { at, holder, known, entries, seen: HashMap::new(), open: None }
    }

    /// The next field that may stand here and stands here for the first time; all others are noted.
    pub(crate) fn next_field(&mut self) -> Option<(&'t str, &'t Entry)> {
        loop {
            let entry = self.entries.next().filter(|_| !self.at.reader.has_enough())?;
            let Some((key, span)) = &entry.key else { continue };
            if self.known.is_some_and(|known| !known.contains(&key.as_str())) {
                self.note_unknown(key, span.start);
            } else if let Some(first) = self.seen.get(key.as_str()) {
                let (line, _) = line_column(self.at.reader.text, *first);
                let problem = words::repeated_field(key)
                    .value(words::shorten(entry.value.span.slice(self.at.reader.text)))
                    .advice(format!("it also stands in line {line}; keep one"));
                self.at.note_at(span.start, problem);
            } else {
                self.seen.insert(key, span.start);
                return Some((key, entry));
            }
        }
    }

    fn note_unknown(&self, key: &str, at: usize) {
        if !self.at.reader.unknown_pass {
            let known = self.known.unwrap_or_default();
            self.at.note_at(at, words::unknown_field(self.holder, key, key, known));
        }
    }

    /// Notes a problem with a field's value.
    pub(crate) fn note(&self, (name, entry): (&str, &'t Entry), problem: Problem) {
        let path = Path::Field(self.at.path, name);
        At { node: entry.value.unwrapped(), path: &path, ..self.at }.note(problem);
    }
}

impl<'t> MapAccess<'t> for Fields<'_, 't> {
    type Error = Wrong;

    fn next_key_seed<K: DeserializeSeed<'t>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Wrong> {
        self.open = self.next_field();
        let Some((name, entry)) = self.open else { return Ok(None) };
        let at = entry.span().start;
        seed.deserialize(Name { name, at, holder: self.at }).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'t>>(&mut self, seed: V) -> Result<V::Value, Wrong> {
        let Some((name, entry)) = self.open.take() else { return Err(Wrong::Noted) };
        let path = Path::Field(self.at.path, name);
        seed.deserialize(At { node: &entry.value, path: &path, ..self.at })
    }
}

/// The name of a field.
struct Name<'r, 't> {
    name: &'t str,
    at: usize,
    holder: At<'r, 't>,
}

impl<'t> Deserializer<'t> for Name<'_, 't> {
    type Error = Wrong;

    fn deserialize_any<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        visitor.visit_borrowed_str(self.name).map_err(|wrong: Wrong| match wrong {
            Wrong::Noted => Wrong::Noted,
            Wrong::Said(problem) => self.holder.note_at(self.at, *problem),
        })
    }

    forward_to_deserialize_any! {
        <V: Visitor<'t>>
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

/// The items of a list, or of a group without names.
pub(super) struct Items<'r, 't> {
    at: At<'r, 't>,
    entries: std::iter::Enumerate<Iter<'t, Entry>>,
}

impl<'r, 't> Items<'r, 't> {
    pub(super) fn new(at: At<'r, 't>, group: &'t Group) -> Self {
        Items { at, entries: group.entries.iter().enumerate() }
    }
}

impl<'t> SeqAccess<'t> for Items<'_, 't> {
    type Error = Wrong;

    fn next_element_seed<T: DeserializeSeed<'t>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Wrong> {
        let next = self.entries.next().filter(|_| !self.at.reader.has_enough());
        let Some((index, entry)) = next else { return Ok(None) };
        let path = Path::Item(self.at.path, index);
        seed.deserialize(At { node: &entry.value, path: &path, ..self.at }).map(Some)
    }
}

/// A word that stands for one of several things, perhaps with a value behind it.
pub(super) struct Variant<'r, 't> {
    pub(super) at: At<'r, 't>,
    pub(super) word: &'t str,
}

impl<'t> EnumAccess<'t> for Variant<'_, 't> {
    type Error = Wrong;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'t>>(self, seed: V) -> Result<(V::Value, Self), Wrong> {
        let word: StrDeserializer<Wrong> = self.word.into_deserializer();
        let variant = self.at.settle(seed.deserialize(word))?;
        Ok((variant, self))
    }
}

impl<'t> VariantAccess<'t> for Variant<'_, 't> {
    type Error = Wrong;

    fn unit_variant(self) -> Result<(), Wrong> {
        match &self.at.node.kind {
            NodeKind::Group(_) => {
                let said = format!("{} stands alone, without brackets", self.word);
                Err(self.at.note(Problem::new("", said)))
            }
            _ => Ok(()),
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'t>>(self, seed: T) -> Result<T::Value, Wrong> {
        match self.at.node.items() {
            Some([entry]) => seed.deserialize(At { node: &entry.value, ..self.at }),
            _ => {
                let said = format!("{} takes one value in round brackets", self.word);
                Err(self.at.note(Problem::new("", said)))
            }
        }
    }

    // No file of the program has a variant of one of these kinds.
    fn tuple_variant<V: Visitor<'t>>(self, _: usize, _: V) -> Result<V::Value, Wrong> {
        Err(self.at.note_due("another word"))
    }

    fn struct_variant<V: Visitor<'t>>(
        self,
        _: &'static [&'static str],
        _: V,
    ) -> Result<V::Value, Wrong> {
        Err(self.at.note_due("another word"))
    }
}
