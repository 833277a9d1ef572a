// The collision time tau_c, which is the unit of time, and the stiffness of a material.
//
//   elastic head-on collision   mbar x'' = -k_n x^(1+beta),  x'(0) = v        beta = 0 linear, 1/2 Hertz
//   its duration                tau_c = zeta (1 + beta/2)^(1/(2+beta)) (mbar/k_n)^(1/(2+beta)) v^(-beta/(2+beta))
//                               zeta  = sqrt(pi) Gamma(1/(2+beta)) / ((1 + beta/2) Gamma((4+beta)/(4+2 beta)))
//   stiffness of a material     k_n = 2 Y d^(1-beta) / (3 (1 - sigma^2))      Y Young's modulus, sigma Poisson's ratio
//
// Any consistent units; k_n is in mass/(length^beta time^2). k_n is twice the textbook Hertz value of equal spheres, as
// the paper has it. Source: S2 Eqs. 1, 4, 5; theory sec. 2.2.
#pragma once

#include "jamscape/contact/options.hpp"

namespace jam {

/// Force of the overlap: x^(1+beta).
constexpr double hardening_exponent(NormalLaw law) { return hertzian(law) ? 0.5 : 0; }

/// zeta(0) = pi, zeta(1/2) = 2.943275.
double collision_prefactor(double beta);

/// tau_c of two grains of reduced mass mbar that meet at `speed` (which does not matter where beta = 0).
double collision_time(double mbar, double k_n, double speed, double beta);

/// k_n of grains of mean diameter d.
double material_stiffness(double young, double poisson, double diameter, double beta);

}  // namespace jam
