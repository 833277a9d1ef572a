// The table of contacts of a packing in CSV (packing_csv.hpp says what stands in it).
#pragma once

#include <string>
#include <vector>

#include "jamscape/io/csv.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// Adds contacts and walls to a packing that has its grains; appends to the notes what was assumed.
void read_contacts(const CsvFile& csv, Packing& packing, std::vector<std::string>& notes);

Table contact_table(const Packing& packing);
CsvMetadata contact_metadata(const Packing& packing);

}  // namespace jam
