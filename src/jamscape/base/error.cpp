#include "jamscape/base/error.hpp"

#include "jamscape/base/printable.hpp"

namespace jam {
namespace {

std::string join(const std::string& problem, const std::string& place, const std::string& suggestion) {
  std::string text = place.empty() ? problem : place + ": " + problem;
  if (!suggestion.empty()) text += "\n  try: " + suggestion;
  return text;
}

}  // namespace

Error::Error(ExitCode code, std::string problem, std::string place, std::string suggestion)
    : std::runtime_error(printable(join(problem, place, suggestion))),
      code_(code),
      problem_(std::move(problem)),
      place_(std::move(place)),
      suggestion_(std::move(suggestion)) {}

Error usage_error(std::string problem, std::string place, std::string suggestion) {
  return {ExitCode::usage, std::move(problem), std::move(place), std::move(suggestion)};
}

Error data_error(std::string problem, std::string place, std::string suggestion) {
  return {ExitCode::data, std::move(problem), std::move(place), std::move(suggestion)};
}

}  // namespace jam
