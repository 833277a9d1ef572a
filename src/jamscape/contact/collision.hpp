// A head-on collision of two grains, integrated: what restitution a dashpot gives, and which dashpot gives a
// restitution.
#pragma once

#include "jamscape/contact/options.hpp"

namespace jam {

/// Restitution for the scaled damping g, in x'' + g x^nu x' + x^delta = 0 from x = 0, x' = 1 (theory sec. 2.2), where
///   g = gamma_n X^(nu + 1) / v0,   X = (mbar v0^2 / k_n)^(1/(1 + delta)).
/// `clipped`: the force is never attractive; `printed`: zero whenever the dashpot exceeds the spring, on approach too.
/// Accurate to about 1e-6.
double collision_restitution(NormalLaw law, DampingRule rule, double g);

/// The smallest g >= 0 with restitution e. Throws a usage error when the rule cannot reach e.
double collision_damping(NormalLaw law, DampingRule rule, double e);

}  // namespace jam
