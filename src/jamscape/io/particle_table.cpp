#include "jamscape/io/particle_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "jamscape/base/error.hpp"
#include "jamscape/io/cluster_columns.hpp"
#include "jamscape/io/field_columns.hpp"
#include "jamscape/io/leading_lines.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/packing_check.hpp"
#include "jamscape/io/vector_columns.hpp"
#include "jamscape/packing/cell.hpp"
#include "jamscape/packing/fields.hpp"

namespace jam {
namespace {

template <class T>
constexpr const FieldText& text_of(T Grains::*member) {
  const FieldText* found = nullptr;
  for_each_field(grain_fields, [&](const auto& f) {
    if constexpr (std::is_same_v<decltype(f.member), T Grains::*>)
      if (f.member == member) found = &f;
  });
  return *found;
}

ColumnNames position_names(std::size_t axis) { return column_names(text_of(&Grains::position), 3)[axis]; }
const ColumnNames radius_names = column_names(text_of(&Grains::radius), 2)[0], diameter_names{"diameter", "d"},
                  mass_names = column_names(text_of(&Grains::mass), 2)[0],
                  id_names = column_names(text_of(&Grains::id), 2)[0];

KnownKeys particle_keys() {
  KnownKeys keys{
      .here = {"dimension", "step", "time", "stage", "packing_fraction", "packing_fraction_plain", "lo", "hi",
               "periodic", "tilt"},
      .once = {},
      .consequential = {"dimension", "packing_fraction", "packing_fraction_plain", "periodic", "tilt", "shape", "wall"},
      .elsewhere = {"wall"},
      .other_table = "table of contacts"};
  for_each_field(energy_fields, [&](const auto& f) { keys.here.emplace_back(f.in_file()); });
  keys.once = keys.here;
  keys.here.emplace_back("shape");
  return keys;
}

int dimension_of(const CsvFile& csv, const LeadingLines& lines, std::vector<std::string>& notes) {
  const auto z = find_column(csv, position_names(2));
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
  need_column(csv, position_names(0), "where a grain is");
  const auto id = csv.integers(column);
  auto order = order_by_id(csv, column, id);
  const auto radius = read_radius(csv);
  Grains& g = packing.grains;
  g.id = ordered(id, order);
  g.radius = ordered(radius, order);
  for_each_field(grain_fields, [&]<class T>(const Field<Grains, std::vector<T>>& f) {
    const std::string_view name = f.name;
    if (name == "id" || name == "radius" || name == "mass" || f.presence == Presence::clusters) return;
    const auto values = read_field<T>(csv, f, dimension);
    if (values && dimension == 2 && f.shape == FieldShape::vector && name != "position")
      refuse_out_of_plane(csv, column_names(f, 3)[2]);
    g.*f.member = values ? ordered(*values, order) : std::vector<T>(id.size(), T{});
    if (f.known != nullptr) packing.knows.*f.known = values.has_value();
  });
  read_clusters(csv, lines, order, packing);
  if (const auto mass = find_column(csv, mass_names)) {
    g.mass = ordered(read_finite(csv, *mass), order);
  } else {
    g.mass = mass_of_one_material(packing);
    packing.knows.masses = false;
    notes.push_back(packing.shapes.empty() ? "no masses are given: taken for one material, mass 1 at the mean radius"
                                           : "no masses are given: taken for one material, 1 in the mean");
  }
  return order;
}

/// Three numbers, or two in the plane.
std::optional<Vec3> corner(const LeadingLines& lines, const char* key, int dimension) {
  const CsvRemark* line = lines.find(key);
  if (line == nullptr) return {};
  auto values = parse_numbers(line->value, 3);
  if (!values) values = lines.numbers(key, static_cast<std::size_t>(dimension));
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
                     packing.dimension == 2 ? "give '# lo: x y' and '# hi: x y', with periodic or without"
                                            : "give '# lo: x y z' and '# hi: x y z', with periodic or without");
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
  if (const CsvRemark* line = lines.find("tilt")) {
    const auto tilt = lines.numbers("tilt", 9);
    for (std::size_t n = 0; n < 9; ++n) domain.tilt[n / 3][static_cast<int>(n % 3)] = (*tilt)[n];
    for (int k = 0; k < 3; ++k)
      if (domain.tilt[static_cast<std::size_t>(k)][k] != 0)
        throw data_error(fmt::format("edge {} of the cell is given twice along {}", "xyz"[k], "xyz"[k]), line->place,
                         "hi - lo has it; of a box sheared along x: '# tilt: 0 0 0 yx 0 0 0 0 0'");
    if (!lo)
      throw data_error("a tilted cell is given in part", line->place, "give '# lo: x y z' and '# hi: x y z' too");
  }
  if (!lo) notes.push_back("no box is given: taken as the smallest one around the grains, not periodic");
  return domain;
}

double plain_fraction(const Packing& packing) {
  double grains = 0;
  for (std::size_t n = 0; n < packing.grains.size(); ++n) grains += room(packing, n);
  const double box = cell_volume(packing.domain, packing.dimension);
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
  int energies = 0, known = 0;
  for_each_field(energy_fields, [&](const auto& f) {
    packing.energy.*f.member = lines.number(f.in_file(), 0);
    ++energies;
    known += lines.find(f.in_file()) != nullptr;
  });
  packing.knows.energies = known == energies;
  if (known > 0 && known < energies)
    notes.push_back(fmt::format("{} of {} energies are given: the ledger is not known", known, energies));
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
  return find_column(csv, position_names(0)) && (find_column(csv, radius_names) || find_column(csv, diameter_names));
}

Table particle_table(const Packing& packing) {
  Table table;
  for_each_field(grain_fields, [&](const auto& f) {
    if (f.presence == Presence::clusters && packing.shapes.empty()) return;
    if (f.known == nullptr || packing.knows.*f.known) add_field(table, packing.grains.*f.member, f, packing.dimension);
  });
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
  if (!p.domain.upright()) {
    const auto& t = p.domain.tilt;
    metadata.emplace_back("tilt", to_text(t[0]) + ' ' + to_text(t[1]) + ' ' + to_text(t[2]));
  }
  for_each_field(energy_fields, [&](const auto& f) {
    if (p.knows.energies) metadata.emplace_back(f.in_file(), to_text(p.energy.*f.member));
  });
  const CsvMetadata shapes = shape_lines(p);
  metadata.insert(metadata.end(), shapes.begin(), shapes.end());
  return metadata;
}

}  // namespace jam
