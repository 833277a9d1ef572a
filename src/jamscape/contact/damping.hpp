// Damping coefficients from the restitution a study asks for, for the law and the damping rule in use.
#pragma once

#include "jamscape/contact/law.hpp"
#include "jamscape/contact/options.hpp"

namespace jam {

/// gamma_n (1/time) that gives the linear law the restitution e in a head-on collision with reduced mass mbar.
///   unclipped   gamma_n = 2 w0 |ln e| / sqrt(pi^2 + ln^2 e),  w0 = sqrt(k_n / mbar)
///   clipped     the same collision ends when the force would turn attractive; solved for numerically
///   printed     force zero whenever |dashpot| > |spring|; the smallest gamma_n that reaches e, by integrating the
///   collision
/// Source: theory sec. 2.1-2.2. Throws a usage error when the rule cannot reach e (printed rule: e < .696).
double solve_damping(double k_n, double mbar, double restitution, DampingRule rule);

/// Restitution of the linear law for z = gamma_n / (2 w0) < 1.
double linear_restitution(double z, DampingRule rule);

/// The law between two grains, and between a grain and a wall, of mean mass `mass` (reduced mass mass/2 in the
/// damping).
PairLaw<> grain_law(const ContactOptions& options, double mass);
PairLaw<> wall_law(const ContactOptions& options, double mass);

}  // namespace jam
