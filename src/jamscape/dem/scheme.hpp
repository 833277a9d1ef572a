// The integration schemes (theory sec. 2.5).
#pragma once

namespace jam {

/// Velocity Verlet with forces at the half-step velocity, or the 5-value Gear predictor-corrector.
enum class Scheme { verlet, gear5 };

}  // namespace jam
