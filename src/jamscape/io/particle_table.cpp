#include "jamscape/io/particle_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "jamscape/base/error.hpp"
#include "jamscape/io/cluster_columns.hpp"
#include "jamscape/io/leading_lines.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/packing_check.hpp"
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
const ColumnNames radius_names{"radius", "r"}, diameter_names{"diameter", "d"}, mass_names{"mass", "m"};
const ColumnNames id_names{"id", "particle", "particle_id", "grain"};

KnownKeys particle_keys() {
  KnownKeys keys{
      .here = {"dimension", "step", "time", "stage", "packing_fraction", "packing_fraction_plain", "lo", "hi",
               "periodic"},
      .once = {},
      .consequential = {"dimension", "packing_fraction", "packing_fraction_plain", "periodic", "shape", "wall"},
      .elsewhere = {"wall"},
      .other_table = "table of contacts"};
  for (const auto& [name, member] : run_layout::energies) keys.here.emplace_back(name);
  keys.once = keys.here;
  keys.here.emplace_back("shape");
  return keys;
}

int dimension_of(const CsvFile& csv, const LeadingLines& lines, std::vector<std::string>& notes) {
  const auto z = find_column(csv, position_names[2]);
  if (const auto given = lines.numbers("dimension", 1)) {
    if ((*given)[0] != 2 && (*given)[0] != 3)
      throw data_error(fmt::format("the dimension is {}, not 2 or 3", to_text((*given)[0])),
                       lines.find("dimension")->place);
    const int dimension = static_cast<int>((*given)[0]);
    if (dimension == 2 && z) {
      const auto values = read_finite(csv, *z);
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      if (!values.empty() && *low != *high)
        notes.push_back(fmt::format("the line '# dimension: 2' is believed: z, from {} to {}, is left out",
                                    to_text(*low), to_text(*high)));
    }
    return dimension;
  }
  if (!z) return 2;
  const auto values = read_finite(csv, *z);
  if (values.empty()) return 3;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto size = find_column(csv, radius_names) ? find_column(csv, radius_names) : find_column(csv, diameter_names);
  const auto sizes = size ? read_finite(csv, *size) : std::vector<double>{0};
  // A layer that rounding has bent stays a layer; heights that differ for good make a packing in space.
  if (*high - *low > 1e-6 * *std::min_element(sizes.begin(), sizes.end())) return 3;
  if (*low != 0 || *high != 0)
    notes.push_back(
        fmt::format("all grains lie at z = {}: taken as discs in a plane; spheres need the line "
                    "'# dimension: 3'",
                    to_text(*low)));
  return 2;
}

std::vector<double> read_radius(const CsvFile& csv) {
  const auto diameter = find_column(csv, diameter_names);
  const std::size_t column =
      diameter && !find_column(csv, radius_names) ? *diameter : need_column(csv, radius_names, "the size of a grain");
  std::vector<double> values = read_finite(csv, column);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (values[row] <= 0)
      throw data_error(fmt::format("'{}' in column '{}' is no size", csv.field(row, column), csv.columns()[column]),
                       csv.place(row, column), "sizes are above 0");
    if (diameter && column == *diameter) values[row] /= 2;
  }
  return values;
}

double power(double x, int dimension) { return dimension == 2 ? x * x : x * x * x; }

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

/// Area (volume in space) of a grain; overlap of a cluster's arms counts once.
double room(const Packing& p, std::size_t n) {
  const Grains& g = p.grains;
  if (p.shapes.empty())
    return (p.dimension == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3) * power(g.radius[n], p.dimension);
  const ClusterShape& shape = p.shapes[static_cast<std::size_t>(g.shape[n])];
  return (p.dimension == 2 ? shape.area : shape.volume) * power(g.scale[n], p.dimension);
}

std::vector<double> mass_of_one_material(const Packing& p) {
  const Grains& g = p.grains;
  std::vector<double> mass;
  if (p.shapes.empty()) {
    const double mean = std::accumulate(g.radius.begin(), g.radius.end(), 0.0) / static_cast<double>(g.size());
    for (const double r : g.radius) mass.push_back(power(r / mean, p.dimension));
    return mass;
  }
  double total = 0;
  for (std::size_t n = 0; n < g.size(); ++n) total += room(p, n);
  for (std::size_t n = 0; n < g.size(); ++n) mass.push_back(room(p, n) * static_cast<double>(g.size()) / total);
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

/// The row of each grain.
std::vector<std::size_t> read_grains(const CsvFile& csv, const LeadingLines& lines, Packing& packing,
                                     std::vector<std::string>& notes) {
  const int dimension = packing.dimension;
  const std::size_t column = need_column(csv, id_names, "the name of a grain");
  need_column(csv, position_names[0], "where a grain is");
  const auto id = csv.integers(column);
  auto order = order_by_id(csv, column, id);
  const auto radius = read_radius(csv);
  const auto velocity = read_vectors(csv, velocity_names, dimension);
  Grains& g = packing.grains;
  g.id = ordered(id, order);
  g.species = ordered(read_species(csv), order);
  g.radius = ordered(radius, order);
  g.position = ordered(*read_vectors(csv, position_names, dimension), order);
  g.velocity = velocity ? ordered(*velocity, order) : std::vector<Vec3>(id.size(), Vec3{});
  g.spin = ordered(read_rotation(csv, {"spin", "omega"}, spin_names, dimension), order);
  g.angle = ordered(read_rotation(csv, {"angle"}, angle_names, dimension), order);
  if (dimension == 2 && velocity) refuse_out_of_plane(csv, velocity_names[2]);
  read_clusters(csv, lines, order, packing);
  if (const auto mass = find_column(csv, mass_names)) {
    g.mass = ordered(read_finite(csv, *mass), order);
  } else {
    g.mass = mass_of_one_material(packing);
    notes.push_back(packing.shapes.empty() ? "no masses are given: taken for one material, mass 1 at the mean radius"
                                           : "no masses are given: taken for one material, 1 in the mean");
  }
  return order;
}

/// Three numbers, or two in the plane.
std::optional<Vec3> corner(const LeadingLines& lines, const char* key, int dimension) {
  const CsvRemark* line = lines.find(key);
  if (line == nullptr) return {};
  auto values = dimension == 2 ? parse_numbers(line->value, 2) : std::nullopt;
  if (!values) values = lines.numbers(key, 3);
  values->resize(3, 0);
  return Vec3{(*values)[0], (*values)[1], (*values)[2]};
}

Domain read_domain(const LeadingLines& lines, const Packing& packing, std::vector<std::string>& notes) {
  Domain domain;
  const auto lo = corner(lines, "lo", packing.dimension), hi = corner(lines, "hi", packing.dimension),
             periodic = corner(lines, "periodic", packing.dimension);
  if (lo.has_value() != hi.has_value() || (periodic && !lo))
    throw data_error("the box is given in part",
                     (lo   ? lines.find("lo")
                      : hi ? lines.find("hi")
                           : lines.find("periodic"))
                         ->place,
                     "give '# lo: x y z' and '# hi: x y z', with periodic or without");
  for (int k = 0; periodic && k < 3; ++k)
    if ((*periodic)[k] != 0 && (*periodic)[k] != 1)
      throw data_error(fmt::format("'{}' is neither 0 nor 1", to_text((*periodic)[k])), lines.find("periodic")->place,
                       "1 where the box repeats, 0 where it does not: '# periodic: 1 1 0'");
  for (int k = 0; k < (lo ? 3 : packing.dimension); ++k) {
    const auto d = static_cast<std::size_t>(k);
    if (lo) {
      domain.lo[k] = (*lo)[k];
      domain.hi[k] = (*hi)[k];
      domain.periodic[d] = periodic && (*periodic)[k] != 0;
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
  for (std::size_t n = 0; n < packing.grains.size(); ++n) grains += room(packing, n);
  for (int k = 0; k < packing.dimension; ++k) box *= packing.domain.hi[k] - packing.domain.lo[k];
  return box > 0 ? grains / box : 0;
}

}  // namespace

ReadParticles read_particles(const CsvFile& csv, std::vector<std::string>& notes) {
  const LeadingLines lines(csv, particle_keys(), notes);
  ReadParticles read;
  Packing& packing = read.packing;
  packing.dimension = dimension_of(csv, lines, notes);
  read.row = read_grains(csv, lines, packing, notes);
  packing.domain = read_domain(lines, packing, notes);
  if (const CsvRemark* stage = lines.find("stage")) packing.stage = stage->value;
  if (const CsvRemark* step = lines.find("step")) {
    const auto value = parse_integer(step->value);
    if (!value) throw data_error(fmt::format("the step '{}' is no integer", step->value), step->place);
    packing.step = *value;
  }
  packing.time = lines.number("time", 0);
  packing.packing_fraction_plain = lines.number("packing_fraction_plain", plain_fraction(packing));
  packing.packing_fraction = lines.number("packing_fraction", packing.packing_fraction_plain);
  for (const auto& [name, member] : run_layout::energies) packing.energy.*member = lines.number(name, 0);
  const auto place_of = [&](const ColumnNames& names) {
    return [&csv, &read, column = find_column(csv, names).value_or(0)](std::size_t n) {
      return csv.place(read.row[n], column);
    };
  };
  const CsvRemark* lo = lines.find("lo");
  check_grains(packing, {place_of(id_names), {}, lo ? lo->place : csv.place_of_header()});
  if (const auto unread = csv.unread(); !unread.empty())
    notes.push_back(fmt::format("columns of particles that nothing reads: {}", fmt::join(unread, ", ")));
  return read;
}

bool holds_particles(const CsvFile& csv) {
  return find_column(csv, position_names[0]) && (find_column(csv, radius_names) || find_column(csv, diameter_names));
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
