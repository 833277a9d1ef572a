// Measures of files: stored runs, packings and networks made elsewhere.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jamscape/base/table.hpp"
#include "jamscape/observe/options.hpp"

namespace jam::app {

struct FileRequest {
  std::vector<std::string> files, measures;
  std::vector<std::string> set;  ///< keys of the options that were given, for what ignores them
  MeasureOptions options;
  std::optional<double> frame;
  bool walls = false;   ///< of a network: walls are vertices
  bool anyway = false;  ///< however much memory it takes
};

struct FileResult {
  Table table;
  std::vector<std::string> notes;  ///< what was assumed, ignored or left out, for the person who asked
  bool damaged = false;            ///< some runs could not be read, and are named in the notes
};

FileResult measure_files(const FileRequest& request);

}  // namespace jam::app
