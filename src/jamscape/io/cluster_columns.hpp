// Clusters in the table of particles (packing_csv.hpp): shapes as leading lines, bodies as columns.
#pragma once

#include <vector>

#include "jamscape/io/csv.hpp"
#include "jamscape/io/leading_lines.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// A line `# shape: volume surface area length circumradius ix iy iz [arms], name` each, an arm being the numbers cx cy
/// cz ux uy uz half_length radius.
CsvMetadata shape_lines(const Packing& packing);

/// Fills shapes and the arrays of clusters, rows in the order given; leaves a packing without shapes alone. Throws a
/// data error for lines and columns that do not fit.
void read_clusters(const CsvFile& csv, const LeadingLines& lines, const std::vector<std::size_t>& order,
                   Packing& packing);

}  // namespace jam
