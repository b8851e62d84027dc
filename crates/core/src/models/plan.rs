//! Settings of the off-line optimisation (`study/plan`), beside the models it works with, since a
//! scenario holds them and `run` knows no study: what is sought, under which force, with
//! which swarm. The cut itself comes from `plant`, `workpiece`, `target` and `belief`.

use super::neural_force::NeuralKind;

crate::choice! {
    /// Where the largest force that the plan allows comes from.
    pub enum ForceLimit {
        /// The reference force of the target Ra, by the controller's model K1 or M1: the plan and
        /// the controller want the same force.
        TargetRa = "target_ra", "from target Ra";
        /// The value of `plan.force_max_n`.
        Fixed = "fixed", "fixed value";
    }
}

crate::choice! {
    /// The section of the workpiece's depth profile that the plan is made for.
    pub enum PlannedSection {
        /// The deepest one: the force stays allowed everywhere, the safe choice.
        Heaviest = "heaviest", "heaviest";
        /// The shallowest one that is cut at all: fast there, too much force elsewhere.
        Lightest = "lightest", "lightest";
    }
}

crate::settings! {
    /// The off-line optimisation of feed and speed by particle swarm (2013 section 2.1).
    pub struct PlanSettings {
        /// Where the largest allowed force comes from.
        force_limit: ForceLimit = ForceLimit::TargetRa, [], "", setup, "Force limit";
        /// The largest allowed force where it is a fixed value; 665 N is the 2005 paper's.
        force_max_n: f64 = 665.0, [10.0, 10000.0], "N", setup, "Largest force";
        /// The section of the depth profile that the plan is made for.
        section: PlannedSection = PlannedSection::Heaviest, [], "", setup, "Planned section";
        /// The network whose force surface is searched.
        network: NeuralKind = NeuralKind::Improved, [], "", setup, "Network";
        /// Whether cutting speed and feed per tooth are searched, or only the feed per tooth.
        free_speed: bool = true, [], "", setup, "Search the speed too";
        /// Cutting speed where it is not searched.
        cutting_speed_m_min: f64 = 80.0, [40.0, 150.0], "m/min", setup, "Cutting speed";
        /// Weight of the force, relative to its limit: the paper's objective is the largest force
        /// that is still allowed, so a heavier one takes the cut nearer to the limit. A tenth of it goes to the
        /// removal rate, to break ties.
        weight_force: f64 = 1.0, [0.0, 1.0], "", setup, "Weight of a large force";
        /// Weight of the metal removal rate, relative to the reference cut (80 m/min, 0.08 mm).
        weight_removal_rate: f64 = 0.0, [0.0, 1.0], "", setup, "Weight of a large removal rate";
        /// Weight of a short production time (the cut with its share of tool changes), relative to
        /// the reference cut.
        weight_time: f64 = 0.0, [0.0, 1.0], "", setup, "Weight of a short time";
        /// Weight of a low cost, relative to the reference cut.
        weight_cost: f64 = 0.0, [0.0, 1.0], "", setup, "Weight of a low cost";
        /// Cost of machine and operator, C_m (chosen).
        machine_cost_per_min: f64 = 1.0, [0.0, 1000.0], "1/min", setup, "Machine cost";
        /// Cost of a tool life: one set of cutting edges, C_t (chosen).
        tool_cost: f64 = 20.0, [0.0, 10000.0], "", setup, "Tool cost";
        /// Time to change a worn tool, t_ch (chosen).
        tool_change_min: f64 = 2.0, [0.0, 1000.0], "min", setup, "Tool change";
        /// Particles of the swarm.
        particles: u32 = 30, [2.0, 500.0], "", setup, "Particles";
        /// Most iterations of the swarm.
        iterations: u32 = 100, [1.0, 1000.0], "", setup, "Iterations";
        /// Iterations without a gain of one part in ten thousand after which the swarm stops, once
        /// its particles have gathered.
        stop_after: u32 = 12, [1.0, 1000.0], "", setup, "Stop after";
        /// Seed of the swarm's random numbers.
        seed: u32 = 1, [0.0, 4_294_967_295.0], "", setup, "Swarm seed";
    }
}
