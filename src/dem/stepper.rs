//! What run control needs of a solver, whichever it is.

/// Means over a block of steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepBlock {
    /// Mean punch displacement at which the forces were taken, m.
    pub deflection: f64,
    /// Mean force on the punch, N; of several blocks per block.
    pub punch: f64,
    /// Mean force on the fixed nodes along z, N; of several blocks per block.
    pub support: f64,
}

/// Energies of the net, J; of several blocks per block.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energies {
    /// Of the fictitious masses.
    pub kinetic: f64,
    /// Absorbed by the bonds so far, elastic, plastic and by rupture.
    pub bonds: f64,
    pub contact: f64,
}

/// A solver that can be driven: it owns the net's state and moves the punch as told.
pub trait Stepper {
    /// Takes `steps` steps with the punch moving `travel` metres in each.
    fn advance(&mut self, steps: usize, travel: f64) -> StepBlock;
    /// Punch displacement now, m.
    fn deflection(&self) -> f64;
    /// Numbers of the bonds that have broken and were not in `known` yet are added to it, rising.
    /// Tells how many.
    fn broken(&self, known: &mut Vec<usize>) -> usize;
    /// Mean force of each anchor in the last block of steps, N, row by row: what its nodes pull it by along x
    /// and y, and out of the plane. Nothing where there are no plates.
    fn anchors(&self) -> Vec<[f64; 3]>;
    /// Kinetic energy, J, of several blocks per block; a not-finite value tells that the state is no longer finite.
    fn kinetic(&self) -> f64;
    /// All energies, J.
    fn energies(&self) -> Energies;
    /// Largest strain over the strain at rupture among the bonds that hold, 0 to 1.
    fn utilisation(&self) -> f64;
    /// Largest change of strain in a step among the double twists that hold, over the strain at
    /// rupture: what an unstable step shows first.
    fn shaking(&self) -> f64;
    /// Fits the inertia out of the plane to the net as it stands; tells the kinetic energy that this adds, J.
    /// A solver whose inertia stays adds none.
    fn follow(&mut self) -> f64 {
        0.0
    }
    /// Part of its kinetic energy that damping takes in a step, or nothing where damping is not viscous.
    fn damping_loss(&self) -> Option<f64>;
    /// Positions of all nodes, bottom and top of each pair in turn, from the panel's corner, m.
    fn positions(&self) -> Vec<[f64; 3]>;
}
