#include "jamscape/io/cluster_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/shape_list.hpp"
#include "jamscape/io/vector_columns.hpp"

namespace jam {
namespace {

constexpr const char* columns[] = {"qw", "qx", "qy", "qz"};
constexpr double Quaternion::*parts[] = {&Quaternion::w, &Quaternion::x, &Quaternion::y, &Quaternion::z};
constexpr double ClusterShape::*measures[] = {&ClusterShape::volume, &ClusterShape::surface, &ClusterShape::area,
                                              &ClusterShape::length, &ClusterShape::circumradius};
constexpr std::size_t per_shape = 8, per_arm = 8;

std::string line(const ClusterShape& shape) {
  std::string text;
  const auto put = [&text](double value) {
    if (!text.empty()) text += ' ';
    text += to_text(value);
  };
  for (const auto member : measures) put(shape.*member);
  for (int k = 0; k < 3; ++k) put(shape.inertia[k]);
  for (const Arm& arm : shape.arms) {
    for (int k = 0; k < 3; ++k) put(arm.centre[k]);
    for (int k = 0; k < 3; ++k) put(arm.direction[k]);
    put(arm.half_length);
    put(arm.radius);
  }
  return text + ", " + shape.name;
}

ClusterShape read_line(const std::string& text, const std::string& file) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view head = std::string_view(text).substr(0, comma);
  const auto blanks = static_cast<std::size_t>(std::count(head.begin(), head.end(), ' '));
  const auto numbers = parse_numbers(head, blanks + 1);
  if (!numbers || numbers->size() <= per_shape || (numbers->size() - per_shape) % per_arm != 0)
    throw data_error(fmt::format("the line '# shape: {}' does not hold eight numbers and eight for each arm", text),
                     file,
                     "volume surface area length circumradius, three of inertia; arms: centre, direction, half length, "
                     "radius; then a comma and the name");
  ClusterShape shape;
  const std::vector<double>& n = *numbers;
  for (std::size_t k = 0; k < std::size(measures); ++k) shape.*measures[k] = n[k];
  shape.inertia = {n[5], n[6], n[7]};
  for (std::size_t a = per_shape; a < n.size(); a += per_arm)
    shape.arms.push_back({{n[a], n[a + 1], n[a + 2]}, {n[a + 3], n[a + 4], n[a + 5]}, n[a + 6], n[a + 7]});
  const std::size_t name = text.find_first_not_of(' ', comma + 1);
  if (comma < text.size() && name != std::string::npos) shape.name = text.substr(name);
  return shape;
}

}  // namespace

CsvMetadata shape_lines(const Packing& packing) {
  CsvMetadata lines;
  for (const ClusterShape& shape : packing.shapes) lines.emplace_back("shape", line(shape));
  return lines;
}

void read_clusters(const CsvFile& csv, const LeadingLines& lines, const std::vector<std::size_t>& order,
                   Packing& packing) {
  for (const CsvRemark* remark : lines.all("shape")) packing.shapes.push_back(read_line(remark->value, remark->place));
  if (packing.shapes.empty()) return;
  Grains& g = packing.grains;
  const auto shape = csv.integers(need_column(csv, {"shape"}, "which shape a grain has, counted from 0"));
  const auto scale = read_finite(csv, need_column(csv, {"scale"}, "the size factor of a grain"));
  g.orientation.resize(order.size());
  for (std::size_t k = 0; k < std::size(columns); ++k) {
    const auto values = read_finite(csv, need_column(csv, {columns[k]}, "the orientation of a grain"));
    for (std::size_t n = 0; n < order.size(); ++n) g.orientation[n].*parts[k] = values[order[n]];
  }
  for (const std::size_t row : order) {
    g.shape.push_back(static_cast<std::int32_t>(std::clamp<std::int64_t>(shape[row], -1, INT32_MAX)));
    g.scale.push_back(scale[row]);
  }
  if (const std::string problem = cluster_problem(packing); !problem.empty()) throw data_error(problem, csv.file());
}

}  // namespace jam
