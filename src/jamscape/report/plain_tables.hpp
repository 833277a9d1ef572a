// The main numbers of a report as plain HTML tables, for readers whose browser or server lets no script run.
#pragma once

#include <string>
#include <string_view>

#include "jamscape/report/results.hpp"

namespace jam {

/// Of all realisations (ensemble/transitions.csv), and of every frame the means of a few quantities.
std::string plain_tables(const Results& results);

/// Text as HTML.
std::string escaped(std::string_view text);

}  // namespace jam
