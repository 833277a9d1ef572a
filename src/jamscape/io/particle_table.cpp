#include "jamscape/io/particle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "jamscape/base/error.hpp"
#include "jamscape/io/cluster_columns.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/run_layout.hpp"
#include "jamscape/io/vector_columns.hpp"

namespace jam {
namespace {

const VectorNames position_names{
    {{"x", "pos_x", "position_x"}, {"y", "pos_y", "position_y"}, {"z", "pos_z", "position_z"}}};
const VectorNames velocity_names{
    {{"vx", "v_x", "velocity_x"}, {"vy", "v_y", "velocity_y"}, {"vz", "v_z", "velocity_z"}}};
const VectorNames spin_names{{{"spin_x", "wx", "omegax", "omega_x"},
                              {"spin_y", "wy", "omegay", "omega_y"},
                              {"spin_z", "wz", "omegaz", "omega_z"}}};
const VectorNames angle_names{{{"angle_x"}, {"angle_y"}, {"angle_z"}}};

/// Entries of the leading lines, by key.
class Metadata {
 public:
  explicit Metadata(const CsvFile& csv) : csv_(csv) {}

  const std::string* text(std::string_view key) const {
    for (const auto& [name, value] : csv_.metadata())
      if (name == key) return &value;
    return nullptr;
  }
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count) const {
    const std::string* value = text(key);
    if (!value) return {};
    const auto found = parse_numbers(*value, count);
    if (!found)
      throw data_error(
          fmt::format("the line '# {}: {}' should hold {} number{}", key, *value, count, count == 1 ? "" : "s"),
          csv_.file());
    return found;
  }
  double number(std::string_view key, double otherwise) const {
    const auto found = numbers(key, 1);
    return found ? (*found)[0] : otherwise;
  }

 private:
  const CsvFile& csv_;
};

int dimension_of(const CsvFile& csv, const Metadata& metadata) {
  if (const auto given = metadata.numbers("dimension", 1)) {
    if ((*given)[0] != 2 && (*given)[0] != 3)
      throw data_error(fmt::format("the dimension is {}, not 2 or 3", to_text((*given)[0])), csv.file());
    return static_cast<int>((*given)[0]);
  }
  const auto z = find_column(csv, position_names[2]);
  if (!z) return 2;
  const auto values = read_finite(csv, *z);
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; }) ? 2 : 3;
}

std::vector<double> read_radius(const CsvFile& csv) {
  const auto diameter = find_column(csv, {"diameter", "d"});
  const std::size_t column = diameter && !find_column(csv, {"radius", "r"})
                                 ? *diameter
                                 : need_column(csv, {"radius", "r"}, "the size of a grain");
  std::vector<double> values = read_finite(csv, column);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (values[row] <= 0)
      throw data_error(fmt::format("'{}' in column '{}' is no size", csv.field(row, column), csv.columns()[column]),
                       csv.place(row, column), "sizes are above 0");
    if (diameter && column == *diameter) values[row] /= 2;
  }
  return values;
}

/// Rotations: in 2D the one component out of the plane, under its plain name too.
std::vector<Vec3> read_rotation(const CsvFile& csv, ColumnNames plain, const VectorNames& names, int dimension) {
  if (dimension == 3) {
    auto all = read_vectors(csv, names, 3);
    return all ? *all : std::vector<Vec3>(csv.rows(), Vec3{});
  }
  plain.insert(plain.end(), names[2].begin(), names[2].end());
  std::vector<Vec3> out(csv.rows(), Vec3{});
  if (const auto column = find_column(csv, plain)) {
    const auto values = read_finite(csv, *column);
    for (std::size_t row = 0; row < out.size(); ++row) out[row][2] = values[row];
  }
  return out;
}

std::vector<std::int32_t> read_species(const CsvFile& csv) {
  std::vector<std::int32_t> species(csv.rows(), 0);
  const auto column = find_column(csv, {"species", "type", "material"});
  if (!column) return species;
  const auto values = csv.integers(*column);
  for (std::size_t row = 0; row < species.size(); ++row) {
    species[row] = static_cast<std::int32_t>(values[row]);
    if (species[row] != values[row])
      throw data_error(fmt::format("the species {} is out of range", values[row]), csv.place(row, *column));
  }
  return species;
}

double power(double x, int dimension) { return dimension == 2 ? x * x : x * x * x; }

std::vector<double> read_mass(const CsvFile& csv, const std::vector<double>& radius, int dimension,
                              std::vector<std::string>& notes) {
  if (const auto column = find_column(csv, {"mass", "m"})) return read_finite(csv, *column);
  notes.push_back("no masses are given: taken for one material, mass 1 at the mean radius");
  const double mean = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
  std::vector<double> mass;
  for (double r : radius) mass.push_back(power(r / mean, dimension));
  return mass;
}

/// `rows` in the order of their ids.
std::vector<std::size_t> order_by_id(const CsvFile& csv, std::size_t column, const std::vector<std::int64_t>& id) {
  std::vector<std::size_t> order(id.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::tie(id[a], a) < std::tie(id[b], b); });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (id[order[k]] == id[order[k - 1]])
      throw data_error(fmt::format("grain {} was given before, at {}", id[order[k]], csv.place(order[k - 1], column)),
                       csv.place(order[k], column), "give each grain one row and an id of its own");
  return order;
}

template <class T>
std::vector<T> ordered(const std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> out;
  out.reserve(values.size());
  for (std::size_t row : order) out.push_back(values[row]);
  return out;
}

void read_grains(const CsvFile& csv, Packing& packing, std::vector<std::string>& notes) {
  const int dimension = packing.dimension;
  const std::size_t column = need_column(csv, {"id", "particle", "particle_id", "grain"}, "the name of a grain");
  need_column(csv, position_names[0], "where a grain is");
  const auto id = csv.integers(column);
  const auto order = order_by_id(csv, column, id);
  const auto radius = read_radius(csv);
  const auto velocity = read_vectors(csv, velocity_names, dimension);
  Grains& g = packing.grains;
  g.id = ordered(id, order);
  g.species = ordered(read_species(csv), order);
  g.radius = ordered(radius, order);
  g.mass = ordered(read_mass(csv, radius, dimension, notes), order);
  g.position = ordered(*read_vectors(csv, position_names, dimension), order);
  g.velocity = velocity ? ordered(*velocity, order) : std::vector<Vec3>(id.size(), Vec3{});
  g.spin = ordered(read_rotation(csv, {"spin", "omega"}, spin_names, dimension), order);
  g.angle = ordered(read_rotation(csv, {"angle"}, angle_names, dimension), order);
  read_clusters(csv, order, packing);
}

Domain read_domain(const CsvFile& csv, const Metadata& metadata, const Packing& packing,
                   std::vector<std::string>& notes) {
  Domain domain;
  const auto lo = metadata.numbers("lo", 3), hi = metadata.numbers("hi", 3), periodic = metadata.numbers("periodic", 3);
  if (lo.has_value() != hi.has_value() || (periodic && !lo))
    throw data_error("the box is given in part", csv.file(),
                     "give '# lo: x y z' and '# hi: x y z', with periodic or without");
  for (int k = 0; k < (lo ? 3 : packing.dimension); ++k) {
    const auto d = static_cast<std::size_t>(k);
    if (lo) {
      domain.lo[k] = (*lo)[d];
      domain.hi[k] = (*hi)[d];
      domain.periodic[d] = periodic && (*periodic)[d] != 0;
      continue;
    }
    const Grains& g = packing.grains;
    for (std::size_t n = 0; n < g.size(); ++n) {
      const double low = g.position[n][k] - g.radius[n], high = g.position[n][k] + g.radius[n];
      domain.lo[k] = n == 0 ? low : std::min(domain.lo[k], low);
      domain.hi[k] = n == 0 ? high : std::max(domain.hi[k], high);
    }
  }
  if (!lo) notes.push_back("no box is given: taken as the smallest one around the grains, not periodic");
  return domain;
}

double plain_fraction(const Packing& packing) {
  double grains = 0, box = 1;
  const double unit = packing.dimension == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
  for (double r : packing.grains.radius) grains += unit * power(r, packing.dimension);
  for (int k = 0; k < packing.dimension; ++k) box *= packing.domain.hi[k] - packing.domain.lo[k];
  return box > 0 ? grains / box : 0;
}

}  // namespace

Packing read_particles(const CsvFile& csv, std::vector<std::string>& notes) {
  const Metadata metadata(csv);
  Packing packing;
  packing.dimension = dimension_of(csv, metadata);
  read_grains(csv, packing, notes);
  packing.domain = read_domain(csv, metadata, packing, notes);
  if (const std::string* stage = metadata.text("stage")) packing.stage = *stage;
  if (const std::string* step = metadata.text("step")) {
    const auto value = parse_integer(*step);
    if (!value) throw data_error(fmt::format("the step '{}' is no integer", *step), csv.file());
    packing.step = *value;
  }
  packing.time = metadata.number("time", 0);
  packing.packing_fraction_plain = metadata.number("packing_fraction_plain", plain_fraction(packing));
  packing.packing_fraction = metadata.number("packing_fraction", packing.packing_fraction_plain);
  for (const auto& [name, member] : run_layout::energies) packing.energy.*member = metadata.number(name, 0);
  return packing;
}

Table particle_table(const Packing& packing) {
  const Grains& g = packing.grains;
  const int dimension = packing.dimension;
  Table table;
  table.add("id", g.id);
  table.add("species", std::vector<std::int64_t>(g.species.begin(), g.species.end()));
  add_vectors(table, {"x", "y", "z"}, g.position, dimension);
  table.add("radius", g.radius);
  table.add("mass", g.mass);
  add_vectors(table, {"vx", "vy", "vz"}, g.velocity, dimension);
  if (dimension == 3) {
    add_vectors(table, {"spin_x", "spin_y", "spin_z"}, g.spin, 3);
    add_vectors(table, {"angle_x", "angle_y", "angle_z"}, g.angle, 3);
    add_cluster_columns(table, packing);
    return table;
  }
  std::vector<double> spin, angle;
  for (std::size_t n = 0; n < g.size(); ++n) {
    spin.push_back(g.spin[n][2]);
    angle.push_back(g.angle[n][2]);
  }
  table.add("spin", spin);
  table.add("angle", angle);
  add_cluster_columns(table, packing);
  return table;
}

CsvMetadata particle_metadata(const Packing& p) {
  const auto& periodic = p.domain.periodic;
  CsvMetadata metadata{{"dimension", fmt::format("{}", p.dimension)},
                       {"step", fmt::format("{}", p.step)},
                       {"time", to_text(p.time)},
                       {"stage", p.stage},
                       {"packing_fraction", to_text(p.packing_fraction)},
                       {"packing_fraction_plain", to_text(p.packing_fraction_plain)},
                       {"lo", to_text(p.domain.lo)},
                       {"hi", to_text(p.domain.hi)},
                       {"periodic", fmt::format("{:d} {:d} {:d}", periodic[0], periodic[1], periodic[2])}};
  for (const auto& [name, member] : run_layout::energies) metadata.emplace_back(name, to_text(p.energy.*member));
  const CsvMetadata shapes = shape_lines(p);
  metadata.insert(metadata.end(), shapes.begin(), shapes.end());
  return metadata;
}

}  // namespace jam
