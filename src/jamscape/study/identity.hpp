// What makes two simulations the same. A task is named by what determines its numbers and nothing else:
//
//   physics text   every option of the system that is not at its default, as "key = value" lines; stages by number;
//                  without the names of stages and systems and without the frames wanted (taking a frame changes no
//                  bit)
//   physics key    hash of that text; it names the system in the random numbers, so that renaming or adding systems
//                  leaves the numbers of all others as they are
//   task hash      hash of physics text, seed, realisation and physics revision; the name of the folder
//
// An option added later with a default that means "as before" leaves all old hashes valid. Changing the default of an
// option, or what it does, needs a new physics_revision (protocol/simulate.hpp).
#pragma once

#include <cstdint>
#include <string>

#include "jamscape/protocol/options.hpp"
#include "jamscape/protocol/simulate.hpp"

namespace jam {

std::string physics_text(const SystemOptions& system);

/// 16 hexadecimal digits.
std::string physics_key(const SystemOptions& system);

TaskKey task_key(const SystemOptions& system, std::uint64_t seed, std::uint64_t realisation);

/// 16 hexadecimal digits.
std::string task_hash(const SystemOptions& system, std::uint64_t seed, std::uint64_t realisation);

}  // namespace jam
