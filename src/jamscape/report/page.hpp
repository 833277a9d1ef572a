// One HTML file that holds its style, its program and its data, and may load nothing else.
#pragma once

#include <string>
#include <vector>

#include "jamscape/report/json.hpp"

namespace jam {

struct Block {
  std::string name;  ///< the page finds it under the id "data-<name>"
  Json data;
};

struct Page {
  std::string title;
  std::vector<Block> blocks;
  std::string plain = {};  ///< HTML that stands where the script does not run
};

std::string print_page(const Page& page);

}  // namespace jam
