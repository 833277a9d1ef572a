// The table of particles of a packing in CSV (packing_csv.hpp says what stands in it).
#pragma once

#include <string>
#include <vector>

#include "jamscape/io/csv.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// A packing without contacts and walls; appends to the notes what was assumed.
Packing read_particles(const CsvFile& csv, std::vector<std::string>& notes);

Table particle_table(const Packing& packing);
CsvMetadata particle_metadata(const Packing& packing);

}  // namespace jam
