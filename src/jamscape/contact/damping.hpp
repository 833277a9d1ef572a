// Damping coefficients from the restitution a study asks for, for the law and the damping rule in use.
#pragma once

#include "jamscape/contact/law.hpp"
#include "jamscape/contact/options.hpp"

namespace jam {

/// gamma_n that gives the restitution e in a head-on collision with reduced mass mbar at impact speed `speed` (only
/// the hertz law depends on it). Unit: 1/time (linear), per length^nu for the Hertz laws.
///   linear unclipped   2 w0 |ln e| / sqrt(pi^2 + ln^2 e),  w0 = sqrt(k_n / mbar)
///   linear clipped     from the closed form of linear_restitution()
///   ratio              sqrt(mbar) times that of the linear law: the same for all mbar
///   all others         by integrating the collision (collision.hpp)
/// Source: theory sec. 2.1-2.2. Throws a usage error when the rule cannot reach e (printed rule).
double solve_damping(NormalLaw law, DampingRule rule, double k_n, double mbar, double restitution, double speed);

/// Restitution of the linear law for z = gamma_n / (2 w0) < 1.
double linear_restitution(double z, DampingRule rule);

/// The law between two grains, and between a grain and a wall, of mean mass `mass`. The damping is solved for reduced
/// mass mass/2 (between grains) and `mass` (a wall with a restitution of its own).
PairLaw<> grain_law(const ContactOptions& options, double mass);
PairLaw<> wall_law(const ContactOptions& options, double mass);

}  // namespace jam
