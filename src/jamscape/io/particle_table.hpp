// The table of particles of a packing in CSV (packing_csv.hpp says what stands in it).
#pragma once

#include <string>
#include <vector>

#include "jamscape/io/csv.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// A packing without contacts and walls, and the row in which each of its grains stands.
struct ReadParticles {
  Packing packing;
  std::vector<std::size_t> row;
};

/// Whether the columns are those of particles.
bool holds_particles(const CsvFile& csv);

/// Appends to the notes what was assumed.
ReadParticles read_particles(const CsvFile& csv, std::vector<std::string>& notes);

Table particle_table(const Packing& packing);
CsvMetadata particle_metadata(const Packing& packing);

}  // namespace jam
