#include "jamscape/io/frame_column.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "jamscape/base/error.hpp"
#include "jamscape/io/column_names.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/vector_columns.hpp"

namespace jam {
namespace {

const ColumnNames frame_names{"frame", "frame_id", "timestep", "step", "snapshot", "time"};

std::string listed(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(values.size(), 5); ++k)
    text += (k == 0 ? "" : ", ") + to_text(values[k]);
  return values.size() > 5 ? fmt::format("{}, ... ({} in all)", text, values.size()) : text;
}

}  // namespace

bool tells_frames(const CsvFile& csv) { return find_column(csv, frame_names).has_value(); }

FrameRows one_frame(CsvFile csv, std::optional<double> wanted) {
  const auto column = find_column(csv, frame_names);
  if (!column && wanted)
    throw data_error("no column tells frames apart", csv.file(), "leave out --frame, or name a column 'frame'");
  if (!column || csv.rows() == 0) return {std::move(csv), wanted};
  const std::vector<double> values = read_finite(csv, *column);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (values[row] == wanted.value_or(values[0])) rows.push_back(row);
  if (rows.empty())
    throw data_error(fmt::format("there is no frame {} in column '{}'", to_text(*wanted), csv.columns()[*column]),
                     csv.file(), "there are: " + listed(values));
  if (rows.size() < values.size() && !wanted) {
    const auto other = static_cast<std::size_t>(
        std::find_if(values.begin(), values.end(), [&](double value) { return !(value == values[0]); }) -
        values.begin());
    throw data_error(
        fmt::format("the table holds several frames: {} in column '{}'", listed(values), csv.columns()[*column]),
        csv.place(other, *column), fmt::format("--frame {} takes the rows of one", to_text(values[0])));
  }
  const double frame = values[rows.front()];
  if (rows.size() == values.size()) return {std::move(csv), frame};
  return {csv.with_rows(rows), frame};
}

}  // namespace jam
