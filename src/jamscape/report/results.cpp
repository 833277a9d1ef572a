#include "jamscape/report/results.hpp"

#include <toml++/toml.h>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/schema.hpp"
#include "jamscape/io/csv.hpp"

namespace jam {

std::optional<Table> Results::table(std::string_view name) const {
  const std::filesystem::path file = folder / name;
  if (!std::filesystem::exists(file)) return std::nullopt;
  return read_csv(file);
}

int Results::system(std::string_view name) const {
  for (std::size_t k = 0; k < study.systems.size(); ++k)
    if (study.systems[k].name == name) return static_cast<int>(k);
  return -1;
}

Results open_results(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "study.toml";
  if (!std::filesystem::exists(file))
    throw data_error("there is no study in this folder", folder.string(),
                     "name the folder that `jamscape run` printed");
  const std::string text = read_text(file);
  Results results{folder, ResultPlaces(folder), read_study_text(text, file.string()), {}, {}, {}, {}, {}};
  const toml::table document = toml::parse(text, file.string());
  results.version = document["program"]["version"].value_or(std::string());
  results.commit = document["program"]["commit"].value_or(std::string());
  results.relaxations.resize(results.study.systems.size());
  results.states.resize(results.study.systems.size());
  results.marks.resize(results.study.systems.size());
  if (const auto frames = results.table("tables/frames.csv")) {
    results.relaxations = count_relaxations(results.study, *frames);
    results.states = frames_of_curves(results.study, *frames);
    results.marks = count_marks(results.study, *frames);
  }
  return results;
}

std::vector<std::string> text_column(const Table& table, std::string_view name) {
  if (!table.has(name)) return std::vector<std::string>(table.rows());
  const Column& column = table.column(name);
  if (const auto* text = std::get_if<std::vector<std::string>>(&column.values)) return *text;
  std::vector<std::string> out;
  for (const double value : table.numbers(name)) {
    std::string number = print_number(value);
    if (number.ends_with(".0")) number.resize(number.size() - 2);
    out.push_back(std::move(number));
  }
  return out;
}

}  // namespace jam
