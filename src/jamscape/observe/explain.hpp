// The registry of measures as text: for `jamscape explain` and the generated reference.
#pragma once

#include <string>

#include "jamscape/observe/measure.hpp"

namespace jam {

/// A few lines of plain text: title, formula, source, and every column with unit and sentence.
std::string explain(const Measure& measure);

/// The measure with this name, or the one that gives a column of this name; throws a usage error for neither.
std::string explain_measure(std::string_view name_or_column);

/// One page of Markdown: every measure with its columns as a table.
std::string measures_reference();

}  // namespace jam
