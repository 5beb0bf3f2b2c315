//! The energy account of a run up to its first break: what the punch put in, and where it is.
//!
//! Kinetic energy is taken every two centimetres or 64 steps, and what damping took in between is the
//! part that it takes in a step, of the mean of two such energies, times the steps. All energies are
//! set against the work every decimetre, at the first break, and at the end of a run without one.

use super::stepper::Energies;

/// Punch travel between two looks at the kinetic energy, m.
const ACCOUNT: f64 = 0.02;
/// Steps between two looks at the kinetic energy at most, and the part of the velocities that damping takes by then:
/// a third of the energy.
const SAMPLE: (usize, f64) = (64, 0.192);
/// Accounts of all energies: punch travel between two, m.
const BALANCE: f64 = 0.1;
/// Largest energy out of nowhere of a net at rest before a run counts as diverged, over the work of
/// the punch: nearly all sound runs of random scenes stay below 0.005.
pub(super) const IMBALANCE: f64 = 0.02;

/// Energy, J, that may be missing whatever the work: of a slack net whose nodes hop about under a small block damping takes
/// most, and what that is is known to a tenth. A run that shakes has more within some steps.
const HOPPING: f64 = 5.0;

#[derive(Debug, Clone, Copy)]
pub(super) struct Account {
    /// Work of the punch, J.
    work: f64,
    /// Kinetic energy that changes of the inertia added, J.
    added: f64,
    /// Taken by damping, J; nothing where the solver's damping cannot be accounted.
    damped: Option<f64>,
    /// Kinetic energy when last taken, J, and the steps since.
    kinetic: f64,
    since: usize,
    /// Steps after which it is taken again at the latest.
    sample: usize,
    /// Punch travel since then, and since all energies were taken, m.
    travelled: f64,
    balanced: f64,
    /// Kinetic energy over the work when last taken.
    over_work: f64,
}

impl Account {
    /// The account of a net at rest, whose velocities lose the part `damping` in a step.
    pub(super) fn new(damping: f64) -> Account {
        let (most, lost) = SAMPLE;
        let sample = (lost / damping.max(lost / most as f64)).round() as usize;
        Account {
            work: 0.0,
            added: 0.0,
            damped: Some(0.0),
            kinetic: 0.0,
            since: 0,
            sample: sample.max(1),
            travelled: 0.0,
            balanced: 0.0,
            over_work: 0.0,
        }
    }

    /// Enters the work of a mean force (N) over so many steps of `travel` (m).
    pub(super) fn push(&mut self, force: f64, travel: f64, steps: usize) {
        self.work += force * travel * steps as f64;
    }

    /// Counts steps of `travel` (m); tells whether the kinetic energy is to be taken.
    pub(super) fn due(&mut self, steps: usize, travel: f64) -> bool {
        self.since += steps;
        self.travelled += travel * steps as f64;
        if self.travelled < ACCOUNT && self.since < self.sample {
            return false;
        }
        self.balanced += self.travelled;
        self.travelled = 0.0;
        true
    }

    /// Takes the kinetic energy, J, and what damping took since the last time, of which it takes the part
    /// `loss` in a step.
    pub(super) fn sample(&mut self, kinetic: f64, loss: Option<f64>) {
        let mean = 0.5 * (kinetic + self.kinetic);
        let taken = loss.map(|loss| loss * mean * self.since as f64);
        self.damped = self.damped.zip(taken).map(|(damped, taken)| damped + taken);
        self.kinetic = kinetic;
        self.since = 0;
        self.over_work = kinetic / self.work.max(1.0);
    }

    /// Enters kinetic energy that a change of the inertia adds, J, or takes.
    pub(super) fn add(&mut self, kinetic: f64) {
        self.added += kinetic;
    }

    /// Whether all energies are to be taken now.
    pub(super) fn balance_due(&mut self) -> bool {
        let due = self.balanced > BALANCE;
        if due {
            self.balanced = 0.0;
        }
        due
    }

    /// Whether the net moves more than can be: motion cannot hold more than the punch and the changes of the
    /// inertia have put in; a tenth of a joule is far below any test.
    pub(super) fn ran_away(&self) -> bool {
        !self.kinetic.is_finite() || self.kinetic > self.work + self.added.max(0.0) + 0.1
    }

    /// Work of the punch, with what changes of the inertia added, that is found in no energy, over that
    /// work; nothing where damping is not accounted.
    pub(super) fn imbalance(&self, e: &Energies) -> Option<f64> {
        let found = e.bonds + e.kinetic + e.contact + self.damped?;
        Some((self.work + self.added - found) / self.work.max(1.0e-9))
    }

    /// Largest imbalance that is believed: what damping takes is summed up from kinetic energies some
    /// steps apart, so a net in motion may have a part of that energy more.
    pub(super) fn unexplained(&self) -> f64 {
        IMBALANCE + 0.5 * self.over_work
    }

    /// Whether an imbalance is more than that, and more than [`HOPPING`].
    pub(super) fn unbalanced(&self, imbalance: f64) -> bool {
        imbalance.abs() * self.work > self.unexplained() * self.work + HOPPING
    }

    /// Work of the punch so far, J.
    pub(super) fn work(&self) -> f64 {
        self.work
    }

    /// Kinetic energy over the work when last taken.
    pub(super) fn kinetic_over_work(&self) -> f64 {
        self.over_work
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 100 N over half a metre, with 2 J of motion at both looks.
    fn account(loss: Option<f64>) -> Account {
        let mut account = Account::new(0.0);
        for _ in 0..2 {
            account.push(100.0, 0.25 / 64.0, 64);
            assert!(account.due(64, 0.25 / 64.0));
            account.sample(2.0, loss);
        }
        account
    }

    #[test]
    fn what_is_missing_is_the_work_less_all_energies_worked_by_hand() {
        let mut a = account(Some(0.01));
        // Damping took 0.01 of (0 + 2)/2 J in 64 steps, then of 2 J in 64: 0.64 and 1.28 J.
        let energies = |bonds: f64| Energies { kinetic: 2.0, bonds, contact: 4.0 };
        let missing = a.imbalance(&energies(40.0)).unwrap();
        assert!((missing - (50.0 - 47.92) / 50.0).abs() < 1e-12, "{missing}");
        // Believed are 2 % and half of 2 J in 50 J, and five joules: 7 J.
        assert!(!a.unbalanced(missing));
        assert!(!a.unbalanced(a.imbalance(&energies(35.2)).unwrap()));
        assert!(a.unbalanced(a.imbalance(&energies(34.9)).unwrap()));
        assert!(a.unbalanced(a.imbalance(&energies(49.3)).unwrap()), "energy out of nowhere");
        assert!(!a.ran_away());
        assert!(a.balance_due() && !a.balance_due(), "half a metre, and nothing since");
        a.sample(50.2, Some(0.01));
        assert!(a.ran_away());
        // Three joules came with a change of the inertia.
        a.add(3.0);
        assert!(!a.ran_away());
        let with = a.imbalance(&energies(40.0)).unwrap();
        assert!((with - (53.0 - 46.0 - 1.92) / 50.0).abs() < 1e-12, "{with}");
        a.sample(53.2, Some(0.01));
        assert!(a.ran_away());
        a.sample(f64::NAN, Some(0.01));
        assert!(a.ran_away());
    }

    #[test]
    fn damping_that_is_not_accounted_leaves_no_balance() {
        let a = account(None);
        assert_eq!(a.imbalance(&Energies::default()), None);
        assert_eq!((a.work(), a.kinetic_over_work()), (50.0, 0.04));
    }

    #[test]
    fn the_kinetic_energy_is_taken_after_two_centimetres_or_a_third_lost() {
        let mut a = Account::new(0.0);
        assert!(!a.due(40, 4.0e-4) && a.due(20, 4.0e-4), "16 mm and 24 mm");
        let mut a = Account::new(0.0);
        assert!(!a.due(60, 1.0e-5) && a.due(4, 1.0e-5));
        // Twice the damping that takes a third of it in 64 steps.
        let mut a = Account::new(0.006);
        assert!(!a.due(31, 1.0e-5) && a.due(1, 1.0e-5));
    }
}
