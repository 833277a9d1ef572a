// Which edges a threshold keeps.
#pragma once

namespace jam {

enum class Level {
  at_least,  ///< weight >= threshold (S1)
  above,     ///< weight > threshold (S2)
};

}  // namespace jam
