//! The closed-form forecast of Pol & Gabrieli (2021): from the laboratory punch test of a mesh to the
//! force-deflection curve of an anchored panel, in three steps.
//!
//! 1. [`laboratory`] (Eqs. 1-2) brings a test to the standard panel, [`ratios`] (alpha_F,
//!    alpha_delta) to the field reference F_a*, delta_a*.
//! 2. [`field`] (Eqs. A.1-A.2) takes the layout into account, [`eccentricity`] (Fig. A1) the punch's
//!    offset: F_a, delta_a.
//! 3. [`master`] (Eq. 3) gives the curve, rescaled by both.
//!
//! That is the published method; [`derived`] takes the same steps with relations made of simulations.
//!
//! [`design`] answers what engineers ask of the curve; [`warning`] says what to distrust;
//! [`fingerprint`] tells inputs apart; [`published`] holds what the paper prints against ours.
//! The room reads no file and no clock; the same inputs give the same bits.

pub(crate) mod derived;
pub mod design;
pub(crate) mod eccentricity;
pub mod field;
pub(crate) mod fingerprint;
pub mod laboratory;
pub mod master;
mod outside;
pub mod published;
pub(crate) mod ratios;
pub(crate) mod warning;

use crate::curve::{Curve, Point};
use crate::layout::{self, Blocks, BranchRule, Layout, MethodChoice};
use crate::mesh::wire::WireData;
use crate::mesh::{self, MeshType, STANDARD_PANEL};
use crate::method::DerivedMethod;
use crate::problem::Problem;
use eccentricity::Eccentricity;
use field::Branch;
use master::Master;
use ratios::Ratios;
use std::ops::RangeInclusive;
use warning::{Outside, PublishedRange, Warning};

/// Forces at which punch tests of rockfall meshes break, N: wider than the tests that were published,
/// to find a record in a wrong unit.
const PLAUSIBLE_FORCE: RangeInclusive<f64> = 10.0e3..=500.0e3;
/// Their deflections, m.
const PLAUSIBLE_DEFLECTION: RangeInclusive<f64> = 0.1..=1.5;

/// Points of a forecast curve, both ends included.
pub const CURVE_POINTS: usize = 201;

/// A force with its deflection: the characteristic values of a test or a panel, and the curve up to them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Values {
    /// Force, N.
    pub force: f64,
    /// Deflection, m.
    pub deflection: f64,
    /// The normalised curve.
    pub(crate) master: Master,
}

impl Values {
    /// With the published curve.
    pub fn new(force: f64, deflection: f64) -> Values {
        Values { force, deflection, master: master::PUBLISHED }
    }

    /// Force at a deflection (m), N, on the rescaled master curve; meaningful from 0 to the failure.
    pub fn force_at(&self, deflection: f64) -> f64 {
        self.force * self.master.force(deflection / self.deflection)
    }

    /// Deflection at a force (N), m: the exact inverse of [`Values::force_at`]; nothing beyond failure.
    pub fn deflection_at(&self, force: f64) -> Option<f64> {
        // The failure force itself is on the curve, rounding of a quotient included.
        let y = force / self.force;
        (0.0..=1.0 + 1e-12)
            .contains(&y)
            .then(|| self.deflection * self.master.deflection(y.min(1.0)))
    }

    /// Tangent stiffness at a deflection (m), N/m.
    pub fn tangent_at(&self, deflection: f64) -> f64 {
        self.force / self.deflection * self.master.slope(deflection / self.deflection)
    }

    /// Secant stiffness from 0 to a deflection (m, above 0), N/m.
    pub fn secant_at(&self, deflection: f64) -> f64 {
        self.force_at(deflection) / deflection
    }

    /// Energy absorbed from 0 to a deflection (m), J.
    pub fn energy_to(&self, deflection: f64) -> f64 {
        self.force * self.deflection * self.master.area(deflection / self.deflection)
    }

    /// The curve from 0 to the failure deflection, both ends included.
    pub fn curve(&self, points: usize) -> Curve {
        rescaled(*self, points)
    }
}

/// What a test or a panel carries: its force at failure, and the deflection there where the
/// laboratory's is known. With both there is a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strength {
    /// Force, N.
    pub force: f64,
    /// Deflection, m; missing where the laboratory record has none.
    pub deflection: Option<f64>,
}

impl Strength {
    /// Both, where both are known.
    pub fn both(self) -> Option<Values> {
        let force = self.force;
        self.deflection.map(|deflection| Values::new(force, deflection))
    }
}

impl From<Values> for Strength {
    fn from(Values { force, deflection, .. }: Values) -> Strength {
        Strength { force, deflection: Some(deflection) }
    }
}

/// The forecast of one layout with one mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Forecast {
    /// The geometry it was made from, m.
    pub layout: Layout,
    /// The branch rule it follows.
    pub rule: BranchRule,
    /// Standard laboratory values F_l*, delta_l*.
    pub laboratory: Strength,
    /// Field reference values F_a*, delta_a* (step 1).
    pub reference: Strength,
    /// The ratios that led from one to the other.
    pub ratios: Ratios,
    /// Factors of the eccentricity, with their uncertainty.
    pub eccentricity: Eccentricity,
    /// The panel's values and curve, or why there are none.
    pub field: Result<Field, NoField>,
    /// What to distrust.
    pub warnings: Vec<Warning>,
}

/// Why a layout that makes sense has no field value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoField {
    /// The punch overlaps an anchor plate, which is outside the method.
    PunchOnPlate,
    /// The block is smaller than the opening of the mesh.
    PassesThrough,
    /// The anchors stand on no square grid, for which there is no published relation.
    Grid,
    /// Mirrored blocks would overlap; the published relations know nothing of that.
    Overlap,
}

impl NoField {
    /// Stable identifier for programs, that of the forecast's warning.
    pub(crate) fn code(self) -> &'static str {
        match self {
            NoField::PunchOnPlate => "punch_on_plate",
            NoField::PassesThrough => "passes_through",
            NoField::Grid => "grid_without_relation",
            NoField::Overlap => "blocks_overlap",
        }
    }

    /// A word or two for a narrow column.
    pub(crate) fn short(self) -> &'static str {
        match self {
            NoField::PunchOnPlate => "on plate",
            NoField::PassesThrough => "through",
            NoField::Grid => "grid",
            NoField::Overlap => "overlap",
        }
    }

    /// Why, in a few words.
    pub(crate) fn reason(self) -> &'static str {
        match self {
            NoField::PunchOnPlate => "the block is on a plate",
            NoField::PassesThrough => "the block is smaller than the mesh opening",
            NoField::Grid => "no relation for this grid, and no check",
            NoField::Overlap => "mirrored blocks overlap",
        }
    }

    /// That there is no value, and why; without a final stop.
    pub(crate) fn sentence(self) -> &'static str {
        match self {
            NoField::PunchOnPlate => {
                "no field value: the block is on an anchor plate, outside the method"
            }
            NoField::PassesThrough => {
                "no field value: the block is smaller than the opening of the mesh and passes through"
            }
            NoField::Grid => {
                "no field value: no relation is published for rectangular or staggered grids; the check answers"
            }
            NoField::Overlap => {
                "no field value: mirrored blocks of neighbouring cells would overlap"
            }
        }
    }
}

/// The forecast of the anchored panel: its values at failure, and with them its whole curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field {
    /// F_a, delta_a, eccentricity included.
    pub values: Strength,
    /// By the size of the punch against the plate: `SmallPunch` where D <= d.
    pub regime: Branch,
    /// The branch of A.1-A.2 that was used.
    pub branch: Branch,
    /// The same values by the other branch, where the layout is near the branch change.
    pub other_branch: Option<Strength>,
    /// The derived method that gave them; nothing is the published one.
    pub(crate) method: Option<&'static DerivedMethod>,
    /// What the published method says, where it is another.
    pub(crate) published: Option<Strength>,
    /// Coefficient of variation of F_a about the forecast: alignment and slack.
    pub(crate) variation: f64,
}

impl Forecast {
    /// F_a over F_l*, if there is a field value.
    pub(crate) fn force_over_lab(&self) -> Option<f64> {
        self.field.ok().map(|f| f.values.force / self.laboratory.force)
    }

    /// delta_a over delta_l*, if there is a field value.
    pub(crate) fn deflection_over_lab(&self) -> Option<f64> {
        Some(self.field.ok()?.values.deflection? / self.laboratory.deflection?)
    }

    /// Whether any size is outside its published range, so that the numbers are extrapolated.
    pub(crate) fn extrapolated(&self) -> bool {
        warning::extrapolated(&self.warnings)
    }
}

impl Field {
    /// The point of failure, on which the curve hangs; missing where the laboratory's deflection is.
    pub fn end(&self) -> Option<Values> {
        let master = self.method.map_or(master::PUBLISHED, |method| {
            let [a, b, c] = method.master.cubic;
            Master { a, b, c }
        });
        self.values.both().map(|values| Values { master, ..values })
    }

    /// Between which 90 % of the simulated curves lie, rescaled: lower and upper. Nothing for the published
    /// method, whose envelope is a picture.
    pub(crate) fn envelope(&self) -> Option<[Curve; 2]> {
        let (points, end) = (&self.method?.master.envelope, self.end()?);
        let last = points.len().max(2) - 1;
        Some([0, 2].map(|side| Curve {
            deflection:
                (0..points.len()).map(|i| end.deflection * i as f64 / last as f64).collect(),
            force: points.iter().map(|p| end.force * p[side]).collect(),
            failure: None,
        }))
    }
}

/// Eq. 3 rescaled to a failure point, at equal steps of deflection, both ends included.
///
/// For the laboratory values this is a drawing aid: only their end point was published.
pub fn rescaled(values: Values, points: usize) -> Curve {
    let last = points.max(2) - 1;
    let mut curve = Curve {
        deflection: Vec::with_capacity(last + 1),
        force: Vec::with_capacity(last + 1),
        failure: Some(Point { deflection: values.deflection, force: values.force }),
    };
    for i in 0..last {
        let x = i as f64 / last as f64;
        curve.deflection.push(values.deflection * x);
        curve.force.push(values.force * values.master.force(x));
    }
    curve.deflection.push(values.deflection);
    curve.force.push(values.force);
    curve
}

/// Forecasts a layout with a mesh.
///
/// # Errors
/// Every field of the layout or the mesh that makes no sense; what is only outside the published
/// ranges is a warning of the result.
pub fn forecast(
    layout: &Layout,
    mesh: &MeshType,
    rule: BranchRule,
) -> Result<Forecast, Vec<Problem>> {
    layout.check()?;
    // All that is wrong with the mesh, and never nothing.
    let laboratory = laboratory::standard_values(&mesh.laboratory)
        .map_err(|problem| mesh.check().err().unwrap_or_else(|| vec![problem]))?;
    let by_runs = (layout.method == MethodChoice::Derived)
        .then(|| derived::derived(layout, mesh, laboratory));
    let ratios = by_runs.map_or_else(|| ratios::of_mesh(mesh), |by_runs| by_runs.ratios);
    let reference = ratios::field_reference(laboratory, &ratios);
    let eccentricity = by_runs
        .map_or_else(|| eccentricity::published().at(layout), |by_runs| by_runs.eccentricity);
    let mut warnings = Vec::new();
    mesh_warnings(mesh, &ratios, &mut warnings);
    range_warnings(layout, &mut warnings);

    let opening = mesh.wire.as_ref().map(|wire| wire.net.opening);
    let field = if layout.punch_on_plate() {
        warnings.push(Warning::PunchOnPlate {
            distance: layout.distance_to_plate(),
            radius: layout.punch / 2.0,
        });
        Err(NoField::PunchOnPlate)
    } else if let Some(opening) = opening.filter(|opening| layout.punch < *opening) {
        warnings.push(Warning::PassesThrough { block: layout.punch, opening });
        Err(NoField::PassesThrough)
    } else if !layout.is_square() {
        warnings.push(Warning::GridWithoutRelation { stagger: layout.grid.stagger });
        Err(NoField::Grid)
    } else if let Some(by_runs) = by_runs {
        if by_runs.field == Err(NoField::Overlap) {
            warnings.push(Warning::BlocksOverlap);
        } else if by_runs.borrowed {
            warnings.push(Warning::BorrowedMap);
        }
        let by_paper = || {
            let reference = ratios::field_reference(laboratory, &ratios::of_mesh(mesh));
            let offset = eccentricity::published().at(layout);
            field_values(layout, reference, &offset, rule).values
        };
        by_runs.field.map(|field| Field { published: Some(by_paper()), ..field })
    } else {
        Ok(field_values(layout, reference, &eccentricity, rule))
    };
    if let Ok(field) = &field {
        if layout.blocks == Blocks::Single && !by_runs.is_some_and(|by_runs| by_runs.of_one) {
            warnings.push(Warning::OneBlock);
        }
        if mesh.id == mesh::REFERENCE_ID {
            outside::tell(layout, field, &mut warnings);
        }
        field_warnings(layout, field, reference, &eccentricity, &mut warnings);
        if field.method.is_some_and(|method| method.mesh == mesh::REFERENCE_ID) && other_wires(mesh)
        {
            warnings.push(Warning::OtherWires);
        }
        if layout.facing_left_out() {
            let worst = Layout { blocks: Blocks::Worst, ..*layout };
            let worst = derived::derived(&worst, mesh, laboratory).field;
            let told = worst.map(|f| Warning::FacingLeftOut { worst: f.values.force });
            warnings.extend(told);
        }
    }
    Ok(Forecast {
        layout: *layout,
        rule,
        laboratory,
        reference,
        ratios,
        eccentricity,
        field,
        warnings,
    })
}

/// Coefficient of variation of F_a about the published forecast for a punch diameter (m): alignment and slack,
/// assumed, because the paper gives none.
pub(crate) fn variation(punch: f64) -> f64 {
    /// Punch diameter from which on it scatters less, m.
    const LARGE_PUNCH: f64 = 0.4;
    if punch >= LARGE_PUNCH { 0.07 } else { 0.085 }
}

/// Whether a mesh has a net and wires, and others than the reference mesh; where they come from is none of it.
fn other_wires(mesh: &MeshType) -> bool {
    let reference = mesh::catalogue::reference();
    match (&mesh.wire, &reference.wire) {
        (Some(own), Some(due)) => {
            WireData { source: String::new(), ..own.clone() }
                != WireData { source: String::new(), ..due.clone() }
        }
        _ => false,
    }
}

fn field_values(layout: &Layout, reference: Strength, e: &Eccentricity, rule: BranchRule) -> Field {
    let by = |branch| {
        let centred = field::centred(layout, branch, reference);
        let deflection = centred.deflection.map(|delta| delta * e.deflection);
        Strength { force: centred.force * e.force, deflection }
    };
    let branch = Branch::by_rule(layout, rule);
    Field {
        values: by(branch),
        regime: Branch::published(layout),
        branch,
        other_branch: field::near_branch_change(layout).then(|| by(branch.other())),
        method: None,
        published: None,
        variation: variation(layout.punch),
    }
}

fn mesh_warnings(mesh: &MeshType, ratios: &Ratios, warnings: &mut Vec<Warning>) {
    if mesh.example {
        warnings.push(Warning::ExampleMesh);
    }
    if ratios.default && !mesh.reference {
        warnings.push(Warning::DefaultRatios);
    }
    let (force, deflection) = (mesh.laboratory.force, mesh.laboratory.deflection);
    if deflection.is_none() {
        warnings.push(Warning::StrengthOnly);
    }
    let plausible = deflection.is_none_or(|delta| PLAUSIBLE_DEFLECTION.contains(&delta));
    if !(PLAUSIBLE_FORCE.contains(&force) && plausible) {
        warnings.push(Warning::ImplausibleLaboratory { force, deflection });
    }
    let panel = mesh.laboratory.panel;
    if panel != STANDARD_PANEL {
        warnings.push(Warning::PanelConverted { panel });
        push_range(warning::PANEL, panel, warnings);
    }
}

fn range_warnings(layout: &Layout, warnings: &mut Vec<Warning>) {
    push_range(warning::PLATE, layout.plate, warnings);
    if layout.is_square() {
        push_range(warning::SPACING, layout.spacing, warnings);
    }
    push_range(warning::PUNCH, layout.punch, warnings);
    if !warning::PLATE.holds(layout.plate)
        && warning::PLATE.holds(layout.punch)
        && layout.punch < layout.plate
        && warning::PUNCH.holds(layout.plate)
    {
        warnings.push(Warning::Swapped);
    }
    let (ex, ey) = layout.folded();
    if (ex, ey) != (layout.ex, layout.ey) {
        warnings.push(Warning::EccentricityFolded { ex, ey });
    }
}

fn push_range(range: PublishedRange, value: f64, warnings: &mut Vec<Warning>) {
    if !range.holds(value) {
        warnings.push(Warning::Extrapolated { range, value, outside: Outside::Unknown });
    }
}

fn field_warnings(
    layout: &Layout,
    field: &Field,
    reference: Strength,
    e: &Eccentricity,
    warnings: &mut Vec<Warning>,
) {
    if let Some(other) = field.other_branch {
        warnings.push(Warning::NearBranchChange { used: field.values.force, other: other.force });
    }
    if !e.supported {
        warnings.push(Warning::EccentricityWithoutData);
    }
    if e.force_sd > 0.0 || e.deflection_sd > 0.0 {
        warnings.push(Warning::EccentricityUncertain {
            force: e.force_sd / e.force,
            deflection: e.deflection_sd / e.deflection,
        });
    }
    // Blocks of other cells change no forecast, nor does how the net hangs under a centred one.
    let point = layout::REFERENCE;
    let same = Layout { grid: point.grid, blocks: point.blocks, shape: point.shape, ..*layout };
    if same == point && field.method.is_none() {
        warnings.push(Warning::ReferencePoint {
            force: field.values.force,
            deflection: field.values.deflection,
            reference_force: reference.force,
            reference_deflection: reference.deflection,
        });
    }
}
