//! What is told of work behind the screen.

use crate::curve::Point;
use crate::mesh::MeshType;
use crate::problem::Problem;
use crate::study::checks::CheckAnswer;
use crate::study::result::make::Made;
use std::sync::Arc;

/// News of an order.
#[derive(Debug, Clone)]
pub struct News {
    /// Number of the order.
    pub number: u64,
    /// What is new.
    pub what: What,
}

/// What is new of an order.
#[derive(Debug, Clone)]
pub enum What {
    /// It has come so far.
    Progress(Progress),
    /// A check's result so far, or the whole of it.
    Made {
        /// The layout, by its uid.
        uid: u64,
        /// The result.
        made: Arc<Made>,
        /// Whether more runs of it are to come.
        more: bool,
        /// Whether nobody asked for it.
        live: bool,
    },
    /// A case of a campaign is done.
    Case {
        /// Its place among the campaign's cases.
        index: usize,
        /// How many there are.
        total: usize,
        /// Its check, or why there is none.
        answer: Arc<CheckAnswer>,
    },
    /// Work of several steps has come so far.
    Step(StepProgress),
    /// Work of several steps has ended: what to say of it, or why it failed. [`What::Ended`] follows.
    Told(Result<String, String>),
    /// A mesh is adopted. [`What::Ended`] follows.
    Adopted {
        /// The layout that it is for, by its uid.
        uid: u64,
        /// What was identified, with its laws and method.
        mesh: Arc<MeshType>,
        /// What is to be known of it.
        remarks: Vec<String>,
    },
    /// What was typed in a form cannot be used; fields are named by flags. [`What::Ended`] follows.
    FormRefused(Vec<Problem>),
    /// A layout cannot be checked.
    Refused {
        /// The layout, by its uid.
        uid: u64,
        /// Why.
        problems: Vec<Problem>,
    },
    /// Nothing more comes.
    Ended {
        /// Whether it was ended early.
        cancelled: bool,
    },
    /// It ended by a fault of the program.
    Failed,
}

/// How far an order has come.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Progress {
    /// The layout it is at, by its uid; 0 for a campaign.
    pub uid: u64,
    /// Which of how many layouts or cases, from 0.
    pub part: usize,
    /// How many layouts or cases there are.
    pub parts: usize,
    /// Runs of it that are done.
    pub done: usize,
    /// Runs of it to be made as far as is known.
    pub planned: usize,
    /// How much of all is done, 0 to 1.
    pub fraction: f64,
    /// Time left, s.
    pub left: f64,
    /// The curves of this layout's runs as far as they have come.
    pub curves: Vec<Vec<Point>>,
}

/// How far work of several steps has come.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StepProgress {
    /// The step in words: `132 of 384 runs`.
    pub text: String,
    /// How much of it is done, 0 to 1.
    pub fraction: f64,
    /// Time left, s; unknown where missing.
    pub left: Option<f64>,
}
