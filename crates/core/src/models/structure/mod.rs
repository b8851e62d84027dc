//! The five-mass machine of Panda et al. 2019, with its errata mended (`study/errata_2019.rs`).
//!
//! ```text
//! variant A                                        M z'' + C z' + K z = b P(t)
//!   ground -k1- 1 -k2- 2 -k3- 3  (tooth, -P)       K = sum of k_i d_i d_i^T over the springs of
//!               |                                  the tree, d_i its elongation; C likewise
//!               +-k5- 5 -k4- 4   (work, +P)
//! variant B: 4 and 5 change places (the table is the outer node)
//! ```
//!
//! 1 base console, 2 spindle, 3 tooth, 4 slides, 5 table. P parts tooth and work; u = z_work - z_3
//! is what the surface sees, and G_rel = u / P.

pub mod engagement;
pub mod frf;
pub mod literal;
pub mod modes;
pub mod parameters;
pub mod pulses;
pub mod reduction;

use nalgebra::SMatrix;
use nalgebra::SVector;

use super::tip_modes::TipModes;
use parameters::{Elements, Parameters};

/// Complex numbers; their four operations give the same bits everywhere.
pub type Complex = nalgebra::Complex<f64>;
/// A real 5 x 5 matrix, nodes in the order of the table.
pub type Matrix5 = SMatrix<f64, 5, 5>;

crate::choice! {
    /// Topology variant: how slides and table hang on the base.
    pub enum Variant {
        /// The table carries the slides and the force acts on the slides: rows 4 and 5 of eq. 2 as printed.
        Equations = "A", "A, by the equations";
        /// The slides carry the table and the force acts on the table: by the names of the nodes.
        Names = "B", "B, by the nodes' names";
    }
}

crate::choice! {
    /// Where Ra with machine dynamics comes from when the machine is coupled to the cut.
    pub enum RoughnessFrom {
        /// From the marks that the vibrating teeth leave: Ra = K5(F) plus what the vibration adds to the profile.
        Vibration = "vibration", "Vibration of the machine";
        /// From the random dynamic component of the force, as in 2007: Ra = K6(F_dyn).
        Random = "random", "Random force, as in 2007";
    }
}

crate::settings! {
    /// The machine: five masses (2019), or measured modes in their place.
    pub struct MachineSettings {
        /// Which of slides and table is the outer one; their relative frequency responses differ by 3 %.
        variant: Variant = Variant::Equations, [], "", setup, "Variant";
        /// Parameters: from the rules of Table 1, its digits with two exponents corrected, or as printed.
        parameters: Parameters = Parameters::Rules, [], "", setup, "Parameters";
        /// Quality factor Q of the spindle: its printed damper shows 5, the table prints 17.
        spindle_quality: f64 = parameters::SPINDLE_QUALITY, [1.0, 100.0], "", setup, "Spindle quality";
        /// Specific cutting force K_s of the regenerative force, per depth of cut and chip thickness: 6.1e6 N/m at the 2 mm of the papers.
        specific_cutting_force_n_mm2: f64 = 3050.0, [100.0, 20000.0], "N/mm2", setup, "Specific cutting force";
        /// Directional factor: fraction of a displacement between tooth and work that changes the chip thickness; chosen.
        directional_factor: f64 = 0.5, [0.0, 1.0], "", setup, "Directional factor";
        /// Whether the machine vibrates in the running cut, chatter included; wants the parameters D or T.
        coupled: bool = false, [], "", setup, "Machine in the cut";
        /// Where Ra with machine dynamics comes from in a coupled run.
        roughness_from: RoughnessFrom = RoughnessFrom::Vibration, [], "", setup, "Ra with dynamics from";
        /// Structure at the tool's tip as measured modes, in the place of the five masses; the running cut has those across the feed.
        tip_modes: TipModes = TipModes::default(), [], "", setup, "Modes at the tool's tip";
        /// Radial over tangential force K_r in the stability chart of measured modes, whose K_t is the specific cutting force; chosen.
        radial_ratio: f64 = 0.3, [0.0, 2.0], "", setup, "Radial force ratio";
        /// Whether the teeth cut against the feed (down-milling) in the stability chart of measured modes.
        down_milling: bool = false, [], "", setup, "Down-milling";
    }
}

impl MachineSettings {
    /// K_s gamma: what a displacement between tooth and work changes the force by, in N/m for each
    /// millimetre of axial depth.
    #[must_use]
    pub fn regeneration_n_m_mm(&self) -> f64 {
        // N/mm^2 x mm = N/mm per mm of depth; 1000 N/m are one N/mm.
        1000.0 * self.specific_cutting_force_n_mm2 * self.directional_factor
    }
}

/// The machine: a tree of five masses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveMass {
    /// Masses, springs, dampers.
    pub elements: Elements,
    /// Where slides and table stand.
    pub variant: Variant,
}

impl FiveMass {
    /// The machine that the settings describe.
    #[must_use]
    pub fn new(settings: &MachineSettings) -> Self {
        let elements = Elements::new(settings.parameters, settings.spindle_quality);
        Self { elements, variant: settings.variant }
    }

    /// Indices of the inner node of the work branch, on the base, and of the outer one, which
    /// takes the force.
    #[must_use]
    pub fn branch(&self) -> (usize, usize) {
        match self.variant {
            Variant::Equations => (4, 3),
            Variant::Names => (3, 4),
        }
    }

    /// The node that each node hangs on; the base stands on the ground.
    fn parent(&self, node: usize) -> Option<usize> {
        let (inner, outer) = self.branch();
        match node {
            0 => None,
            2 => Some(1),
            _ if node == outer => Some(inner),
            _ => Some(0),
        }
    }

    fn tree(&self, values: [f64; 5]) -> Matrix5 {
        let mut matrix = Matrix5::zeros();
        for (node, value) in values.into_iter().enumerate() {
            matrix[(node, node)] += value;
            if let Some(parent) = self.parent(node) {
                matrix[(parent, parent)] += value;
                matrix[(parent, node)] -= value;
                matrix[(node, parent)] -= value;
            }
        }
        matrix
    }

    /// The mass matrix M, kg (2019, eq. 1).
    #[must_use]
    pub fn mass(&self) -> Matrix5 {
        Matrix5::from_diagonal(&SVector::from(self.elements.mass_kg))
    }

    /// The stiffness matrix K, N/m (2019, eq. 1, errata mended).
    #[must_use]
    pub fn stiffness(&self) -> Matrix5 {
        self.tree(self.elements.stiffness_n_m)
    }

    /// The damping matrix C, N s/m (2019, eq. 1, errata mended).
    #[must_use]
    pub fn damping(&self) -> Matrix5 {
        self.tree(self.elements.damping_n_s_m)
    }

    /// The load vector b: -1 on the tooth, +1 on the work's outer node (2019, eq. 1).
    #[must_use]
    pub fn load(&self) -> SVector<f64, 5> {
        let mut load = SVector::zeros();
        load[2] = -1.0;
        load[self.branch().1] = 1.0;
        load
    }

    /// The machine with a worn tooth: spring and damper of node 3 in N/m and N s/m.
    #[must_use]
    pub fn with_tooth(mut self, stiffness_n_m: f64, damping_n_s_m: f64) -> Self {
        self.elements.stiffness_n_m[2] = stiffness_n_m;
        self.elements.damping_n_s_m[2] = damping_n_s_m;
        self
    }

    /// Static compliances in closed form, m/N; equal in both variants.
    #[must_use]
    pub fn static_compliance(&self) -> StaticCompliance {
        let [one, two, three, four, five] = self.elements.stiffness_n_m.map(|k| 1.0 / k);
        StaticCompliance {
            h33_m_n: one + two + three,
            hww_m_n: one + four + five,
            h3w_m_n: one,
            grel_m_n: two + three + four + five,
        }
    }
}

/// Displacements per newton at rest, m/N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticCompliance {
    /// Tooth under a force on the tooth.
    pub h33_m_n: f64,
    /// Work under a force on the work.
    pub hww_m_n: f64,
    /// Tooth under a force on the work: the base alone.
    pub h3w_m_n: f64,
    /// Between tooth and work under the pair of forces; the base cancels.
    pub grel_m_n: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn machine(variant: Variant) -> FiveMass {
        FiveMass::new(&MachineSettings { variant, ..MachineSettings::default() })
    }

    #[test]
    fn matrices_are_those_of_the_reference() {
        let k = machine(Variant::Equations).stiffness();
        let c = machine(Variant::Equations).damping();
        let near = |x: f64, y: f64| assert!((x / y - 1.0).abs() < 1e-11, "{x} {y}");
        near(k[(0, 0)], 9_862_920_704.99);
        near(k[(1, 1)], 211_113_996.413);
        near(k[(4, 4)], 1_859_635_598.66);
        near(k[(0, 4)], -1_233_700_550.14);
        near(c[(0, 0)], 2_093_603.421_04);
        near(c[(1, 1)], 2_350.691_676_5);
        near(c[(3, 4)], -145_644.235_42);
        near(c[(4, 4)], 407_443.623_22);
        assert_eq!((k[(0, 3)], k[(0, 2)], k[(2, 3)]), (0.0, 0.0, 0.0));
        let b = machine(Variant::Names).stiffness();
        assert_eq!((b[(0, 4)], b[(3, 4)]), (0.0, k[(0, 4)]));
        for matrix in [k, c, b] {
            assert_eq!(matrix, matrix.transpose());
        }
    }

    #[test]
    fn the_stiffness_has_the_springs_product_as_determinant() {
        for variant in Variant::ALL {
            let machine = machine(*variant);
            let product: f64 = machine.elements.stiffness_n_m.iter().product();
            let determinant = machine.stiffness().determinant();
            assert!((determinant / product - 1.0).abs() < 1e-9, "{determinant:e} {product:e}");
        }
    }

    #[test]
    fn static_compliances_meet_the_reference_and_the_matrix() {
        for variant in Variant::ALL {
            let machine = machine(*variant);
            let closed = machine.static_compliance();
            let reference = [
                (closed.h33_m_n, 1.281_842_002_155_3e-7),
                (closed.hww_m_n, 2.524_173_806_895_5e-9),
                (closed.h3w_m_n, 1.159_944_861_389_1e-10),
                (closed.grel_m_n, 1.304_763_850_501_5e-7),
            ];
            for (value, expected) in reference {
                assert!((value / expected - 1.0).abs() < 1e-12, "{value:e} {expected:e}");
            }
            let load = machine.load();
            let solved = machine.stiffness().lu().solve(&load).unwrap().dot(&load);
            assert!((solved / closed.grel_m_n - 1.0).abs() < 1e-12);
        }
    }
}
