#include "jamscape/io/contact_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "jamscape/base/error.hpp"
#include "jamscape/io/field_columns.hpp"
#include "jamscape/io/leading_lines.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/packing_check.hpp"
#include "jamscape/io/shape_list.hpp"
#include "jamscape/io/vector_columns.hpp"
#include "jamscape/packing/cell.hpp"
#include "jamscape/packing/fields.hpp"
#include "jamscape/packing/wall_roles.hpp"

namespace jam {
namespace {

constexpr std::int64_t most_walls = 65536;

constexpr const char* role_names[] = {"side", "floor", "lid"};  // in the order of WallRole

const KnownKeys contact_keys{
    .here = {"wall", "roles", "step", "time", "stage", "vertices"},
    .once = {},
    .consequential = {"wall", "dimension", "periodic", "tilt", "shape"},
    .elsewhere = {"dimension", "lo", "hi", "periodic", "tilt", "packing_fraction", "packing_fraction_plain", "shape"},
    .other_table = "table of particles"};

const VectorNames force_names{{{"fx", "f_x", "force_x"}, {"fy", "f_y", "force_y"}, {"fz", "f_z", "force_z"}}};
const VectorNames tangential_names{{{"ftx", "ft_x"}, {"fty", "ft_y"}, {"ftz", "ft_z"}}};
const VectorNames normal_names{{{"nx", "n_x", "normal_x"}, {"ny", "n_y", "normal_y"}, {"nz", "n_z", "normal_z"}}};
const VectorNames point_names{
    {{"x", "cx", "point_x", "contact_x"}, {"y", "cy", "point_y", "contact_y"}, {"z", "cz", "point_z", "contact_z"}}};
const VectorNames image_names{{{"sx", "image_x"}, {"sy", "image_y"}, {"sz", "image_z"}}};

struct Contact {
  std::int64_t i = 0, j = 0;  ///< i < j for grains, j = -1 - w for walls
  std::uint16_t part_i = 0, part_j = 0;
  std::array<std::int8_t, 3> image{};
  double overlap = 0, normal_force = 0;
  Vec3 normal{}, tangential_force{}, point{};
  std::uint8_t sliding = 0;
  bool flipped = false;  ///< given as j, i
  std::size_t row = 0;

  auto key() const { return std::tie(i, j, part_i, part_j); }
  Vec3 force() const { return tangential_force - normal_force * normal; }
};

/// The same contact seen from its other grain.
void flip(Contact& c, const Domain& domain) {
  std::swap(c.i, c.j);
  std::swap(c.part_i, c.part_j);
  for (auto& s : c.image) s = static_cast<std::int8_t>(-s);
  for (int k = 0; k < 3; ++k) {
    if (c.normal[k] != 0) c.normal[k] = -c.normal[k];
    if (c.tangential_force[k] != 0) c.tangential_force[k] = -c.tangential_force[k];
  }
  c.point = c.point + image_shift(domain, c.image);
  c.flipped = true;
}

class Reader {
 public:
  Reader(const CsvFile& csv, Packing& packing, std::vector<std::string>& notes)
      : csv_(csv),
        lines_(csv, contact_keys, notes),
        packing_(packing),
        notes_(notes),
        dimension_(packing.dimension),
        id1_column_(need_column(csv, {"id1", "i", "particle1", "from"}, "the first grain of a contact")),
        id2_column_(need_column(csv, {"id2", "j", "particle2", "to"}, "the second grain, or -1 - w for wall w")),
        id1_(csv.integers(id1_column_)),
        id2_(csv.integers(id2_column_)),
        force_(read_vectors(csv, force_names, dimension_)),
        tangential_(read_vectors(csv, tangential_names, dimension_)),
        normal_(read_vectors(csv, normal_names, dimension_)),
        point_(read_vectors(csv, point_names, dimension_)),
        image_(read_vectors(csv, image_names, dimension_)),
        overlap_(optional_numbers({"overlap", "delta", "penetration"})),
        sideways_(optional_numbers({"ft", "f_t", "tangential_force", "force_tangential"})),
        part1_(small_numbers({"part1", "part_i"}, 65535)),
        part2_(small_numbers({"part2", "part_j"}, 65535)),
        sliding_(small_numbers({"sliding", "slip"}, 255)) {
    packing.knows.sliding = find_column(csv, {"sliding", "slip"}).has_value();
    packing.knows.tangential_forces = tangential_ || force_ || (sideways_ && dimension_ == 2);
    const ColumnNames names{"fn", "f_n", "normal_force", "force_normal", "force"};
    if (find_column(csv, names) || !force_)
      normal_force_ = read_finite(csv, need_column(csv, names, "the normal force"));
    if (dimension_ == 2)
      for (const VectorNames* vectors : {&force_names, &tangential_names, &normal_names})
        refuse_out_of_plane(csv, (*vectors)[2]);
  }

  void read() {
    if (!packing_.shapes.empty() && !(overlap_ && normal_ && point_))
      throw data_error("overlap, normal or point of the contacts is not given, and clusters need them", csv_.file(),
                       "add the columns overlap, nx, ny, nz and x, y, z");
    read_walls();
    check_box();
    std::vector<Contact> contacts;
    for (std::size_t row = 0; row < csv_.rows(); ++row) contacts.push_back(contact(row));
    std::sort(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
      return std::tuple_cat(a.key(), std::tie(a.flipped, a.row)) < std::tuple_cat(b.key(), std::tie(b.flipped, b.row));
    });
    std::vector<std::size_t> row;
    for (const Contact& c : merged(contacts)) {
      store(c);
      row.push_back(c.row);
    }
    add_notes();
    check_contacts(
        packing_,
        {overlap_.has_value(), normal_.has_value(), point_.has_value(), !normal_force_, tangential_.has_value()},
        {{}, [&](std::size_t m) { return csv_.place(row[m], id1_column_); }, {}}, notes_);
    finish_walls();
    read_roles();
    if (const std::string problem = cluster_problem(packing_); !problem.empty()) throw data_error(problem, csv_.file());
  }

 private:
  std::optional<std::vector<double>> optional_numbers(const ColumnNames& names) {
    const auto column = find_column(csv_, names);
    if (!column) return {};
    return read_finite(csv_, *column);
  }

  std::vector<std::int64_t> small_numbers(const ColumnNames& names, std::int64_t most) {
    const auto column = find_column(csv_, names);
    if (!column) return std::vector<std::int64_t>(csv_.rows(), 0);
    auto values = csv_.integers(*column);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (values[row] < 0 || values[row] > most)
        throw data_error(
            fmt::format("{} in column '{}' is not from 0 to {}", values[row], csv_.columns()[*column], most),
            csv_.place(row, *column));
    return values;
  }

  void read_walls() {
    for (const CsvRemark* line : lines_.all("wall")) {
      const std::string& text = line->value;
      const auto round = parse_numbers(text, 10), v = round ? round : parse_numbers(text, 9);
      if (!v)
        throw data_error(fmt::format("the line '# wall: {}' should hold nine numbers", text), line->place,
                         "a point of the plane, its normal into the domain, its velocity; a cylinder has its axis in "
                         "place of the normal, and its radius last");
      Wall wall;
      if (round) {
        wall.kind = WallKind::cylinder;
        wall.radius = (*round)[9];
      }
      wall.position = {(*v)[0], (*v)[1], (*v)[2]};
      wall.normal = {(*v)[3], (*v)[4], (*v)[5]};
      wall.velocity = {(*v)[6], (*v)[7], (*v)[8]};
      const double length = norm(wall.normal);
      if (!(length > 0)) throw data_error("the normal of a wall has no length", line->place);
      if (std::abs(length - 1) > 1e-12) wall.normal = (1 / length) * wall.normal;
      packing_.walls.push_back(wall);
    }
    given_walls_ = packing_.walls.size();
  }

  /// One word a wall; without the line the lid is guessed.
  void read_roles() {
    const CsvRemark* line = lines_.find("roles");
    if (line == nullptr) return guess_roles(packing_);
    std::vector<WallRole> roles;
    for (std::string_view text = trimmed(line->value); !text.empty();) {
      const auto end = std::min(text.size(), text.find_first_of(" \t"));
      const auto* role = std::find(std::begin(role_names), std::end(role_names), text.substr(0, end));
      if (role == std::end(role_names))
        throw data_error(fmt::format("'{}' is no role of a wall", text.substr(0, end)), line->place,
                         fmt::format("one of {}", fmt::join(role_names, ", ")));
      roles.push_back(static_cast<WallRole>(role - std::begin(role_names)));
      text = trimmed(text.substr(end));
    }
    if (roles.size() != packing_.walls.size())
      throw data_error(
          fmt::format("the line '# roles' names {} walls, but there are {}", roles.size(), packing_.walls.size()),
          line->place, "one word for each wall, in the order of the lines '# wall'");
    for (std::size_t w = 0; w < roles.size(); ++w) packing_.walls[w].role = roles[w];
  }

  /// Without image columns the nearest copy is taken, which is only sure in a box of some size.
  void check_box() const {
    if (image_ || packing_.grains.size() == 0) return;
    const auto& periodic = packing_.domain.periodic;
    if (!packing_.domain.upright() && std::find(periodic.begin(), periodic.end(), true) != periodic.end())
      throw data_error(
          "which copy of a grain is touched in a tilted periodic cell is not given", csv_.file(),
          "give the columns sx, sy (and sz): the copy is shifted by sx times edge x of the cell, and so on");
    const double most = *std::max_element(packing_.grains.radius.begin(), packing_.grains.radius.end());
    for (int k = 0; k < dimension_; ++k)
      if (packing_.domain.periodic[static_cast<std::size_t>(k)] &&
          packing_.domain.hi[k] - packing_.domain.lo[k] < 4 * most)
        throw data_error(
            fmt::format("the periodic box is narrower than two grains along {}, so the copy of a grain that "
                        "is touched cannot be told",
                        "xyz"[k]),
            csv_.file(), "give the columns sx, sy (and sz)");
  }

  std::optional<std::int64_t> grain(std::int64_t id) const {
    const auto& ids = packing_.grains.id;
    const auto found = std::lower_bound(ids.begin(), ids.end(), id);
    if (found == ids.end() || *found != id) return {};
    return found - ids.begin();
  }

  [[noreturn]] void unknown(std::size_t row, std::size_t column, std::int64_t id) const {
    throw data_error(fmt::format("there is no grain {} in the table of particles", id), csv_.place(row, column),
                     id < 0 ? fmt::format("wall w is -1 - w, and stands in '{}'", csv_.columns()[id2_column_])
                            : "check that both tables are of the same frame");
  }

  Contact contact(std::size_t row) {
    Contact c;
    c.row = row;
    const auto i = grain(id1_[row]), j = grain(id2_[row]);
    if (!i) unknown(row, id1_column_, id1_[row]);
    const bool wall = !j && id2_[row] < 0 && id2_[row] >= -most_walls;
    if (!j && !wall) unknown(row, id2_column_, id2_[row]);
    if (j == i)
      throw data_error(fmt::format("grain {} touches itself", id1_[row]), csv_.place(row, id2_column_),
                       "remove the row; where a grain touches its own copy, the periodic box is too narrow to measure");
    c.i = *i;
    c.j = wall ? id2_[row] : *j;
    c.part_i = static_cast<std::uint16_t>(part1_[row]);
    c.part_j = static_cast<std::uint16_t>(part2_[row]);
    c.sliding = static_cast<std::uint8_t>(sliding_[row]);
    if (wall && static_cast<std::size_t>(-c.j) > packing_.walls.size())
      packing_.walls.resize(static_cast<std::size_t>(-c.j));
    if (!wall) set_image(c, row);
    const Vec3 centre = packing_.grains.position[static_cast<std::size_t>(c.i)];
    const double radius = packing_.grains.radius[static_cast<std::size_t>(c.i)];
    const Vec3 apart = wall ? Vec3{} : other(c) - centre;
    c.normal = normal_of(c, row, centre, apart);
    if (overlap_)
      c.overlap = (*overlap_)[row];
    else if (!wall)
      c.overlap = radius + packing_.grains.radius[static_cast<std::size_t>(c.j)] - norm(apart);
    else if (point_)
      c.overlap = 2 * (radius - norm((*point_)[row] - centre));
    c.point = point_ ? (*point_)[row] : centre + (radius - c.overlap / 2) * c.normal;
    set_force(c, row);
    if (!wall && c.i > c.j) flip(c, packing_.domain);
    return c;
  }

  Vec3 other(const Contact& c) const {
    return packing_.grains.position[static_cast<std::size_t>(c.j)] + image_shift(packing_.domain, c.image);
  }

  void set_image(Contact& c, std::size_t row) const {
    const auto& x = packing_.grains.position;
    for (int k = 0; k < dimension_; ++k) {
      double s = 0;
      if (image_) {
        s = (*image_)[row][k];
      } else if (packing_.domain.periodic[static_cast<std::size_t>(k)]) {
        const double apart = x[static_cast<std::size_t>(c.j)][k] - x[static_cast<std::size_t>(c.i)][k];
        s = -std::round(apart / (packing_.domain.hi[k] - packing_.domain.lo[k]));
      }
      if (s != std::round(s) || std::abs(s) > 127)
        throw data_error(fmt::format("{} is no periodic image", to_text(s)), csv_.place(row, id2_column_));
      c.image[static_cast<std::size_t>(k)] = static_cast<std::int8_t>(s);
    }
  }

  Vec3 normal_of(const Contact& c, std::size_t row, const Vec3& centre, const Vec3& apart) const {
    Vec3 n{};
    if (normal_)
      n = (*normal_)[row];
    else if (c.j >= 0)
      n = apart;
    else if (point_)
      n = (*point_)[row] - centre;
    else if (static_cast<std::size_t>(-c.j) <= given_walls_)
      n = Vec3{} - packing_.walls[static_cast<std::size_t>(-1 - c.j)].normal;
    else
      throw data_error("the direction of a contact with a wall is not given", csv_.place(row, id2_column_),
                       "add the columns nx, ny or x, y, or leave out the rows of walls");
    const double length = norm(n);
    if (!(length > 0)) throw data_error("the normal of a contact has no length", csv_.place(row, id1_column_));
    return std::abs(length - 1) < 1e-12 ? n : (1 / length) * n;
  }

  void set_force(Contact& c, std::size_t row) {
    if (force_ && normal_force_) {
      const double given = (*normal_force_)[row], along = -dot((*force_)[row], c.normal);
      along_ += std::abs(given - along);
      turned_ += std::abs(given + along);
      if (std::abs(given - along) > off_) off_ = std::abs(given - along), off_row_ = row;
    }
    c.normal_force = normal_force_ ? (*normal_force_)[row] : -dot((*force_)[row], c.normal);
    if (tangential_)
      c.tangential_force = (*tangential_)[row];
    else if (force_)
      c.tangential_force = (*force_)[row] - dot((*force_)[row], c.normal) * c.normal;
    else if (sideways_ && dimension_ == 2)
      c.tangential_force = (*sideways_)[row] * Vec3{-c.normal[1], c.normal[0], 0};
  }

  /// Contacts given from both sides become one.
  std::vector<Contact> merged(const std::vector<Contact>& contacts) {
    std::vector<Contact> out;
    double total = 0;
    for (const Contact& c : contacts) {
      if (out.empty() || out.back().key() != c.key()) {
        out.push_back(c);
        continue;
      }
      Contact& first = out.back();
      if (first.image != c.image) {  // refused by check_contacts
        out.push_back(c);
        continue;
      }
      if (first.flipped == c.flipped)
        throw data_error(fmt::format("the contact of {} and {} was given before, at {}", id1_[c.row], id2_[c.row],
                                     csv_.place(first.row, id1_column_)),
                         csv_.place(c.row, id1_column_),
                         "grains that touch in several places need the columns part1 and part2");
      mirrored_ += 1;
      worst_ = std::max(worst_, norm(first.force() - c.force()));
      first.normal_force = (first.normal_force + c.normal_force) / 2;
      first.overlap = (first.overlap + c.overlap) / 2;
      first.tangential_force = 0.5 * (first.tangential_force + c.tangential_force);
      first.point = 0.5 * (first.point + c.point);
      first.sliding = std::max(first.sliding, c.sliding);
      first.flipped = true;  // a third row is one too many, whichever side it is from
    }
    for (const Contact& c : out) total += norm(c.force());
    mean_ = out.empty() ? 0 : total / static_cast<double>(out.size());
    pairs_ = static_cast<std::size_t>(std::count_if(out.begin(), out.end(), [](const Contact& c) { return c.j >= 0; }));
    return out;
  }

  void store(const Contact& c) {
    Contacts& out = packing_.contacts;
    out.i.push_back(static_cast<std::uint32_t>(c.i));
    out.j.push_back(static_cast<std::int32_t>(c.j));
    out.part_i.push_back(c.part_i);
    out.part_j.push_back(c.part_j);
    out.image.push_back(c.image);
    out.overlap.push_back(c.overlap);
    out.normal_force.push_back(c.normal_force);
    out.normal.push_back(c.normal);
    out.tangential_force.push_back(c.tangential_force);
    out.point.push_back(c.point);
    out.sliding.push_back(c.sliding);
  }

  /// Forces from the contacts; place and normal too where no line gave them.
  void finish_walls() {
    const Contacts& c = packing_.contacts;
    std::vector<double> count(packing_.walls.size(), 0);
    for (std::size_t m = 0; m < c.size(); ++m) {
      if (c.j[m] >= 0) continue;
      const auto w = static_cast<std::size_t>(-1 - c.j[m]);
      Wall& wall = packing_.walls[w];
      wall.force += c.normal_force[m] * c.normal[m] - c.tangential_force[m];
      if (w < given_walls_) continue;
      wall.normal -= c.normal[m];
      wall.position += c.point[m];
      count[w] += 1;
    }
    for (std::size_t w = given_walls_; w < packing_.walls.size(); ++w) {
      Wall& wall = packing_.walls[w];
      if (count[w] > 0) wall.position = (1 / count[w]) * wall.position;
      if (const double length = norm(wall.normal); length > 0) wall.normal = (1 / length) * wall.normal;
    }
  }

  void add_notes() {
    if (mirrored_ > 0) {
      notes_.push_back(
          fmt::format("{} of {} contacts are given from both sides: their means are taken; the forces differ by "
                      "up to {:.3g} mean forces",
                      mirrored_, pairs_, mean_ > 0 ? worst_ / mean_ : 0.0));
    }
    if (sideways_ && !force_ && !tangential_ && dimension_ == 3)
      notes_.push_back("tangential forces are left out: in three dimensions they need the columns ftx, fty, ftz");
    if (packing_.walls.size() > given_walls_)
      notes_.push_back(fmt::format("{} walls are known by their contacts only", packing_.walls.size() - given_walls_));
    if (!overlap_ && !point_ && !packing_.walls.empty())
      notes_.push_back("overlaps with walls are not given: taken as 0");
    if (force_ && normal_force_) compare_forces();
    if (const auto unread = csv_.unread(); !unread.empty()) {
      const bool tangential = tangential_ || sideways_ || force_;
      const auto hint = std::find_if(unread.begin(), unread.end(), looks_tangential);
      notes_.push_back(fmt::format(
          "columns of contacts that nothing reads: {}{}", fmt::join(unread, ", "),
          tangential || hint == unread.end()
              ? ""
              : fmt::format(
                    "; if '{}' is a tangential force, name it ft (in the plane, left of the normal), or ftx, fty "
                    "(and ftz): without one, tangential forces are 0",
                    *hint)));
    }
  }

  static bool looks_tangential(const std::string& name) {
    const std::string text = lower_case(name);
    return text.starts_with("ft") || text.starts_with("f_t") || text.starts_with("fs") ||
           text.find("tan") != std::string::npos || text.find("shear") != std::string::npos ||
           text.find("friction") != std::string::npos;
  }

  /// Both the normal force and a vector are given: the first is believed, after a look at the second.
  void compare_forces() {
    if (off_ <= 1e-3 * mean_) return;
    if (turned_ < along_)
      throw data_error("fn and the force vector of the contacts have opposite signs", csv_.place(off_row_, id1_column_),
                       "fx, fy (and fz) are the force on id1, which is pushed away from id2 where fn is positive");
    notes_.push_back(
        fmt::format("fn differs from the part of fx, fy along the normal by up to {:.3g} mean forces: fn is "
                    "believed",
                    off_ / mean_));
  }

  const CsvFile& csv_;
  LeadingLines lines_;
  Packing& packing_;
  std::vector<std::string>& notes_;
  int dimension_;
  std::size_t id1_column_, id2_column_;
  std::vector<std::int64_t> id1_, id2_;
  std::optional<std::vector<Vec3>> force_, tangential_, normal_, point_, image_;
  std::optional<std::vector<double>> overlap_, sideways_, normal_force_;
  std::vector<std::int64_t> part1_, part2_, sliding_;
  std::size_t given_walls_ = 0, mirrored_ = 0, pairs_ = 0, off_row_ = 0;
  double worst_ = 0, mean_ = 0;
  double along_ = 0, turned_ = 0, off_ = 0;  ///< fn beside the vector: summed differences, with its sign and turned
};

}  // namespace

void read_contacts(const CsvFile& csv, Packing& packing, std::vector<std::string>& notes) {
  Reader(csv, packing, notes).read();
}

Table contact_table(const Packing& packing) {
  const Contacts& c = packing.contacts;
  std::vector<std::int64_t> id1, id2;
  for (std::size_t m = 0; m < c.size(); ++m) {
    id1.push_back(packing.grains.id[c.i[m]]);
    id2.push_back(c.j[m] < 0 ? c.j[m] : packing.grains.id[static_cast<std::size_t>(c.j[m])]);
  }
  Table table;
  table.add("id1", id1);
  table.add("id2", id2);
  for_each_field(contact_fields, [&](const auto& f) {
    const std::string_view name = f.name;
    if (name == "i" || name == "j") return;  // by the names of the grains
    if (f.known == nullptr || packing.knows.*f.known)
      add_field(table, packing.contacts.*f.member, f, packing.dimension);
  });
  return table;
}

CsvMetadata contact_metadata(const Packing& packing) {
  CsvMetadata metadata;
  for (const Wall& wall : packing.walls) {
    std::string text = fmt::format("{} {} {}", to_text(wall.position), to_text(wall.normal), to_text(wall.velocity));
    if (wall.kind == WallKind::cylinder) text += ' ' + to_text(wall.radius);
    metadata.emplace_back("wall", text);
  }
  std::vector<const char*> roles;
  for (const Wall& wall : packing.walls) roles.push_back(role_names[static_cast<std::size_t>(wall.role)]);
  if (!roles.empty()) metadata.emplace_back("roles", fmt::format("{}", fmt::join(roles, " ")));
  return metadata;
}

}  // namespace jam
