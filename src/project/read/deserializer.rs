//! What each kind of value may be.

use super::access::{Items, Variant};
use super::{At, Wrong};
use crate::problem::Problem;
use crate::project::text::{NodeKind, Shape, scalar};
use crate::project::words;
use serde::de::{Deserializer, Unexpected, Visitor};
use serde::forward_to_deserialize_any;

/// The one struct that may have a text in its place.
const STRUCT_OR_TEXT: &str = "MeshType";

/// Kinds of values that are read alike.
macro_rules! read_as {
    ($($method:ident: $how:ident),* $(,)?) => {$(
        fn $method<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
            self.$how(visitor)
        }
    )*};
}

impl<'t> At<'_, 't> {
    /// A number that can be reckoned with, if this is one.
    fn number(self) -> Result<Option<f64>, Wrong> {
        match self.node.kind {
            NodeKind::Number(v) if v.is_finite() => Ok(Some(v)),
            NodeKind::Number(v) => {
                let said =
                    if v.is_nan() { "this is not a number" } else { "the number is infinite" };
                let allowed = words::range(self.path.name());
                let problem = Problem::new("", said).allowed(allowed);
                Err(self.note(problem.advice("write an ordinary number")))
            }
            _ => Ok(None),
        }
    }

    fn float<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        // Of another base or type it is none, as RON has it; only quantities take those.
        let text = self.node.span.slice(self.reader.text);
        let typed =
            text.strip_suffix("f64").unwrap_or(text).contains(['f', 'i', 'u', 'x', 'o', 'b']);
        match self.number()?.filter(|_| !typed) {
            Some(v) => self.settle(visitor.visit_f64(v)),
            None => Err(self.note_due("a number")),
        }
    }

    fn whole<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        let number = matches!(self.node.kind, NodeKind::Number(_));
        // From its text: a floating point number holds no more than 53 bits of it.
        match scalar::whole(self.node.span.slice(self.reader.text)).filter(|_| number) {
            Some(v) => self.settle(visitor.visit_u64(v)),
            None => Err(self.note_due("a whole number, not below 0,")),
        }
    }

    fn text<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match &self.node.kind {
            NodeKind::Text(text) => self.settle(visitor.visit_borrowed_str(text)),
            _ => Err(self.note_due("a text in double quotes")),
        }
    }

    /// So many values in round brackets.
    fn tuple<V: Visitor<'t>>(self, name: &str, len: usize, visitor: V) -> Result<V::Value, Wrong> {
        let group = self.node.group().filter(|g| g.shape == Shape::Tuple);
        if let Some(group) = group.filter(|g| g.entries.len() == len) {
            self.check_name(group, name);
            return self.settle(visitor.visit_seq(Items::new(self, group)));
        }
        let problem = Problem::new("", words::tuple(name, len));
        // More numbers than there should be are mostly decimal commas.
        let many = group.is_some_and(|g| {
            let number = |kind: &NodeKind| matches!(kind, NodeKind::Number(_));
            g.entries.len() > len && g.entries.iter().all(|e| number(&e.value.kind))
        });
        Err(self.note(problem.advice(if many { words::DECIMAL_COMMA } else { "" })))
    }
}

impl<'t> Deserializer<'t> for At<'_, 't> {
    type Error = Wrong;

    /// For what may be of several kinds; the visitor says what it wants if it gets another.
    fn deserialize_any<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        if let Some(number) = self.number()? {
            return self.settle(visitor.visit_f64(number));
        }
        let result = match &self.node.kind {
            NodeKind::Bool(v) => visitor.visit_bool(*v),
            NodeKind::Text(v) => visitor.visit_borrowed_str(v),
            NodeKind::Group(group) if group.shape == Shape::Struct => {
                return self.settle(visitor.visit_map(self.fields(STRUCT_OR_TEXT, None)?));
            }
            NodeKind::Group(group) if group.shape == Shape::List => {
                visitor.visit_seq(Items::new(self, group))
            }
            _ => Err(serde::de::Error::invalid_type(Unexpected::Other("this"), &visitor)),
        };
        self.settle(result)
    }

    fn deserialize_bool<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        // In quotes it is read as well, as all words are.
        let value = match &self.node.kind {
            NodeKind::Bool(v) => Some(*v),
            NodeKind::Text(word) => word.parse().ok(),
            _ => None,
        };
        match value {
            Some(v) => self.settle(visitor.visit_bool(v)),
            None => Err(self.note(words::unknown_word("true or false"))),
        }
    }

    read_as! {
        deserialize_f32: float, deserialize_f64: float,
        deserialize_u8: whole, deserialize_u16: whole, deserialize_u32: whole, deserialize_u64: whole,
        deserialize_str: text, deserialize_string: text,
    }

    /// `Some` may be left out. One is taken off and no more, as RON has it.
    fn deserialize_option<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        if self.node.is_none() {
            return self.settle(visitor.visit_none());
        }
        let node = self.node.inside_some().unwrap_or(self.node);
        self.settle(visitor.visit_some(At { node, ..self }))
    }

    fn deserialize_newtype_struct<V: Visitor<'t>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        self.settle(visitor.visit_newtype_struct(self))
    }

    fn deserialize_seq<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.node.group().filter(|g| g.shape == Shape::List) {
            Some(group) => self.settle(visitor.visit_seq(Items::new(self, group))),
            None => Err(self.note_due("a list in square brackets")),
        }
    }

    fn deserialize_tuple<V: Visitor<'t>>(self, len: usize, visitor: V) -> Result<V::Value, Wrong> {
        self.tuple("", len, visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'t>>(
        self,
        name: &'static str,
        len: usize,
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        self.tuple(name, len, visitor)
    }

    fn deserialize_struct<V: Visitor<'t>>(
        self,
        name: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        self.settle(visitor.visit_map(self.fields(name, Some(fields))?))
    }

    /// A word, bare or in quotes, or a word before a value in round brackets.
    fn deserialize_enum<V: Visitor<'t>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        let word = match &self.node.kind {
            NodeKind::Word(word) | NodeKind::Text(word) => word.as_str(),
            NodeKind::Group(group) => group.name.as_deref().unwrap_or_default(),
            _ => "",
        };
        if !variants.contains(&word) {
            return Err(self.note(words::unknown_word(words::one_of(variants))));
        }
        self.settle(visitor.visit_enum(Variant { at: self, word }))
    }

    fn deserialize_ignored_any<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Wrong> {
        self.settle(visitor.visit_unit())
    }

    forward_to_deserialize_any! {
        <V: Visitor<'t>>
        i8 i16 i32 i64 i128 u128 char bytes byte_buf unit unit_struct map identifier
    }
}
