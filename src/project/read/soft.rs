//! Fields whose faults do not hide those of their neighbours.
//!
//! A struct that serde derives gives up at the first field that cannot be read. One whose fields are
//! soft reads on: the fault is noted at its place by the reader, and whoever takes the value out of
//! the field learns that there is none.

use serde::de::{Deserialize, Deserializer, Visitor};
use std::fmt;
use std::marker::PhantomData;

/// What became of a field.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Soft<T> {
    /// It is left out, or `None` stands there.
    Absent,
    /// What stands there cannot be read.
    Refused,
    Value(T),
}

/// There is no value because of a fault that was noted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Refused;

impl<T> Soft<T> {
    /// The value, or nothing where the field is left out.
    pub(crate) fn get(self) -> Result<Option<T>, Refused> {
        match self {
            Soft::Absent => Ok(None),
            Soft::Refused => Err(Refused),
            Soft::Value(value) => Ok(Some(value)),
        }
    }

    /// The value of a field that cannot be left out.
    pub(crate) fn needed(self) -> Result<T, Refused> {
        self.get()?.ok_or(Refused)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Soft<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reading<T>(PhantomData<T>);

        impl<'de, T: Deserialize<'de>> Visitor<'de> for Reading<T> {
            type Value = Soft<T>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a value")
            }
            fn visit_none<E>(self) -> Result<Self::Value, E> {
                Ok(Soft::Absent)
            }
            fn visit_some<D: Deserializer<'de>>(self, d: D) -> Result<Self::Value, D::Error> {
                Ok(T::deserialize(d).map_or(Soft::Refused, Soft::Value))
            }
        }

        deserializer.deserialize_option(Reading(PhantomData))
    }
}
