//! What stands under a name in a result that programs read: SI with kN, without the noise of conversion.

use crate::units::{to_kn, without_noise};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::borrow::Cow;

/// A value of a JSON object, or of a cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    /// Nothing: `null`, an empty cell.
    None,
    /// A finite number in the unit that its name says.
    Number(f64),
    /// A finite number that is no conversion and stays as it is to the last bit.
    Exact(f64),
    /// How many.
    Count(u64),
    /// Yes or no.
    Flag(bool),
    Text(Cow<'static, str>),
    /// Stable identifiers.
    Codes(Vec<&'static str>),
    /// Numbers of one unit.
    Numbers(Vec<f64>),
    /// Several values, in JSON only.
    List(Vec<Value>),
    /// Named values, in JSON only.
    Object(Object),
}

/// A force, N, in kN.
pub(crate) fn kn(force: f64) -> Value {
    Value::Number(to_kn(force))
}

/// Two numbers that are no conversions.
pub(crate) fn exact(pair: [f64; 2]) -> Value {
    pair.map(Value::Exact).into_iter().collect()
}

/// The word that files have for a value without parts.
pub(crate) fn word(value: impl Serialize) -> Value {
    match serde_json::to_value(value) {
        Ok(serde_json::Value::String(word)) => word.into(),
        _ => Value::None,
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Value {
        Value::Number(number)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Value {
        Value::Count(count as u64)
    }
}

impl From<bool> for Value {
    fn from(flag: bool) -> Value {
        Value::Flag(flag)
    }
}

impl From<&'static str> for Value {
    fn from(text: &'static str) -> Value {
        Value::Text(Cow::Borrowed(text))
    }
}

impl From<String> for Value {
    fn from(text: String) -> Value {
        Value::Text(Cow::Owned(text))
    }
}

impl From<Object> for Value {
    fn from(object: Object) -> Value {
        Value::Object(object)
    }
}

impl<T: Into<Value>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Value {
        value.map_or(Value::None, Into::into)
    }
}

impl FromIterator<Value> for Value {
    fn from_iter<I: IntoIterator<Item = Value>>(values: I) -> Value {
        Value::List(values.into_iter().collect())
    }
}

impl FromIterator<Object> for Value {
    fn from_iter<I: IntoIterator<Item = Object>>(objects: I) -> Value {
        objects.into_iter().map(Value::Object).collect()
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::None => s.serialize_none(),
            Value::Number(number) => s.serialize_f64(without_noise(*number)),
            Value::Exact(number) => s.serialize_f64(*number),
            Value::Count(count) => s.serialize_u64(*count),
            Value::Flag(flag) => s.serialize_bool(*flag),
            Value::Text(text) => s.serialize_str(text),
            Value::Codes(codes) => s.collect_seq(codes),
            Value::Numbers(numbers) => s.collect_seq(numbers.iter().map(|v| without_noise(*v))),
            Value::List(values) => s.collect_seq(values),
            Value::Object(object) => object.serialize(s),
        }
    }
}

impl Value {
    /// The value as a cell of a table, codes with a separator between them.
    pub(crate) fn cell(&self, between: &str) -> String {
        match self {
            Value::None | Value::List(_) | Value::Object(_) => String::new(),
            Value::Number(number) => without_noise(*number).to_string(),
            Value::Exact(number) => number.to_string(),
            Value::Count(count) => count.to_string(),
            Value::Flag(flag) => flag.to_string(),
            Value::Text(text) => neutral(text),
            Value::Codes(codes) => codes.join(between),
            Value::Numbers(numbers) => {
                let all: Vec<String> = numbers.iter().map(|v| Value::Number(*v).cell("")).collect();
                all.join(between)
            }
        }
    }
}

/// A text as a spreadsheet takes it for a text: one that begins like a formula gets an apostrophe.
fn neutral(text: &str) -> String {
    let formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    if formula { format!("'{text}") } else { text.to_string() }
}

/// A column of a result: its name with the unit, and what stands in it.
pub(crate) type NamedColumn<R> = (&'static str, fn(&R) -> Value);

/// Named values in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Object(Vec<(&'static str, Value)>);

impl Object {
    /// Nothing yet.
    pub(crate) fn new() -> Object {
        Object::default()
    }

    /// With a value behind those that are there.
    pub(crate) fn with(mut self, name: &'static str, value: impl Into<Value>) -> Object {
        self.0.push((name, value.into()));
        self
    }

    /// With a value that has no place in the object where it is missing.
    pub(crate) fn maybe(self, name: &'static str, value: Option<impl Into<Value>>) -> Object {
        match value {
            Some(value) => self.with(name, value),
            None => self,
        }
    }

    /// With some columns of a row.
    pub(crate) fn columns<R>(self, columns: &[NamedColumn<R>], row: &R) -> Object {
        columns.iter().fold(self, |object, (name, get)| object.with(name, get(row)))
    }

    /// With the values of another object behind those that are there.
    pub(crate) fn and(mut self, other: Object) -> Object {
        self.0.extend(other.0);
        self
    }
}

impl Serialize for Object {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        let mut map = s.serialize_map(Some(self.0.len()))?;
        for (name, value) in &self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_their_order_and_numbers_lose_their_noise() {
        let inner = Object::new().with("band", Value::Numbers(vec![0.1 + 0.2, 2.0]));
        let object = Object::new()
            .with("z", 0.1 + 0.2)
            .with("a", None::<f64>)
            .maybe("left_out", None::<f64>)
            .with("codes", Value::Codes(vec!["x", "y"]))
            .with("n", 3_usize)
            .with("inner", inner);
        assert_eq!(
            serde_json::to_string(&object).unwrap(),
            r#"{"z":0.3,"a":null,"codes":["x","y"],"n":3,"inner":{"band":[0.3,2.0]}}"#
        );
        let cells = [kn(21_400.0), Value::None, Value::Codes(vec!["x", "y"]), true.into()];
        assert_eq!(cells.map(|v| v.cell(";")), ["21.4", "", "x;y", "true"]);
    }
}
