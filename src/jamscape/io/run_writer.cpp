#include "jamscape/io/run_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "jamscape/base/error.hpp"
#include "jamscape/io/run_layout.hpp"
#include "jamscape/io/shape_list.hpp"

namespace jam {
namespace {

using hdf5::Group;
using hdf5::Shape;
using run_layout::Components;

constexpr hsize_t chunk_bytes = 65536;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

double component(const Vec3& v, int k) { return v[k]; }
std::int8_t component(const std::array<std::int8_t, 3>& v, int k) { return v[static_cast<std::size_t>(k)]; }

/// The stored components of vectors, one after another. The others must be zero, or they would be lost.
template <class V>
auto flat(const std::vector<V>& vectors, Components stored, const char* name) {
  std::vector<decltype(component(V{}, 0))> out;
  out.reserve(vectors.size() * static_cast<std::size_t>(stored.count));
  for (std::size_t n = 0; n < vectors.size(); ++n)
    for (int k = 0; k < 3; ++k) {
      const auto value = component(vectors[n], k);
      if (k >= stored.first && k < stored.first + stored.count)
        out.push_back(value);
      else if (value != 0)
        throw data_error(fmt::format("the {} of entry {} of a two-dimensional packing has component {} = {}", name, n,
                                     "xyz"[k], value));
    }
  return out;
}

void put(std::vector<double>& out, const Vec3& v, int components = 3) {
  for (int k = 0; k < components; ++k) out.push_back(v[k]);
}

}  // namespace

RunWriter::RunWriter(Group root, std::size_t frames) : root_(std::move(root)), planned_(frames) {
  root_.attribute("layout_version", std::vector<std::int32_t>{run_layout::version});
  root_.attribute(run_layout::sealed, std::vector<std::int32_t>{1});
  Group h5md = make(root_, "h5md");
  h5md.attribute("version", std::vector<std::int32_t>{1, 1});
  frames_ = make(root_, "frames");
  particles_ = make(root_, "particles");
  all_ = make(particles_, "all");
  contacts_ = make(root_, "contacts");
  walls_ = make(root_, "walls");
}

Group RunWriter::make(Group& parent, const char* name) const {
  Group group = parent.create_group(name);
  group.attribute("layout_version", std::vector<std::int32_t>{run_layout::version});
  return group;
}

void RunWriter::append(const Packing& packing) {
  if (count_ == planned_) throw data_error("more frames than were announced", all_.file());
  if (packing.dimension != 2 && packing.dimension != 3)
    throw data_error(fmt::format("a packing of {} dimensions cannot be stored", packing.dimension), all_.file());
  if (count_ == 0) {
    first_.dimension = packing.dimension;
    first_.domain = packing.domain;
    first_.grains = packing.grains;
    first_.shapes = packing.shapes;
  } else if (packing.dimension != first_.dimension) {
    throw data_error("frames of two and of three dimensions cannot stand in one file", all_.file());
  } else if (packing.shapes != first_.shapes) {
    throw data_error("frames of clusters of other shapes cannot stand in one file", all_.file());
  }
  if (const std::string problem = cluster_problem(packing); !problem.empty())
    throw data_error("the packing cannot be stored: " + problem, all_.file());
  append_grains(packing);
  append_contacts(packing.contacts);
  append_walls(packing.walls);
  append_domain(packing.domain);
  steps_.push_back(packing.step);
  times_.push_back(packing.time);
  stages_.push_back(packing.stage);
  relaxations_.push_back(packing.relaxation);
  fraction_.push_back(packing.packing_fraction);
  fraction_plain_.push_back(packing.packing_fraction_plain);
  energy_.push_back(packing.energy);
  ++count_;
}

void RunWriter::append_grains(const Packing& packing) {
  const Grains& g = packing.grains;
  const Components plane = run_layout::in_plane(first_.dimension), turn = run_layout::rotation(first_.dimension);
  const auto vectors = [&](const char* name, const std::vector<Vec3>& values, Components stored) {
    append_grain_row(name, count_, flat(values, stored, name), static_cast<hsize_t>(stored.count));
  };
  vectors("position", g.position, plane);
  vectors("velocity", g.velocity, plane);
  vectors("angular_velocity", g.spin, turn);
  vectors("angle", g.angle, turn);
  append_property("id", &Grains::id, g);
  append_property("species", &Grains::species, g);
  append_property("radius", &Grains::radius, g);
  append_property("mass", &Grains::mass, g);
  if (!first_.shapes.empty()) {
    append_property("shape", &Grains::shape, g);
    append_property("scale", &Grains::scale, g);
    std::vector<double> turned;
    for (const Quaternion& q : g.orientation) turned.insert(turned.end(), {q.w, q.x, q.y, q.z});
    append_grain_row("orientation", count_, turned, 4);
  }
  grains_.push_back(static_cast<std::int64_t>(g.size()));
}

/// A lasting property becomes a time-dependent one at the first frame in which it differs.
template <class T>
void RunWriter::append_property(const char* name, const std::vector<T> Grains::*member, const Grains& now) {
  if (!elements_.contains(name)) {
    if (same_bits(first_.grains.*member, now.*member)) return;
    for (std::size_t k = 0; k < count_; ++k) append_grain_row(name, k, first_.grains.*member, 0);
  }
  append_grain_row(name, count_, now.*member, 0);
}

template <class T>
void RunWriter::append_grain_row(const char* name, std::size_t frame, const std::vector<T>& values, hsize_t width) {
  const hsize_t n = values.size() / std::max<hsize_t>(width, 1);
  const auto shape = [&](hsize_t rows, hsize_t columns) {
    return width == 0 ? Shape{rows, columns} : Shape{rows, columns, width};
  };
  auto found = open_.find(name);
  if (found == open_.end()) {
    Group& element = elements_.emplace(name, make(all_, name)).first->second;
    if (planned_ == 1) return element.write("value", values, shape(1, n));
    const hsize_t bytes = std::max<hsize_t>(width, 1) * sizeof(T);
    const hsize_t columns = std::clamp<hsize_t>(n, 1, chunk_bytes / bytes);
    const hsize_t rows = std::clamp<hsize_t>(chunk_bytes / (columns * bytes), 1, planned_);
    found = open_
                .emplace(name, element.create<T>("value", shape(0, n), shape(planned_, hdf5::unlimited),
                                                 shape(rows, columns)))
                .first;
  }
  hdf5::Dataset& data = found->second;
  data.resize(shape(frame + 1, std::max(n, data.shape()[1])));
  data.template write<T>(width == 0 ? Shape{frame, 0} : Shape{frame, 0, 0}, shape(1, n), values);
}

template <class T>
void RunWriter::append_rows(Group& group, const std::string& name, const std::vector<T>& values, hsize_t width) {
  const hsize_t n = values.size() / std::max<hsize_t>(width, 1);
  const auto shape = [&](hsize_t rows) { return width == 0 ? Shape{rows} : Shape{rows, width}; };
  if (planned_ == 1) return group.write(name, values, shape(n));
  const std::string key = (&group == &walls_ ? "walls/" : "contacts/") + name;
  auto found = open_.find(key);
  if (found == open_.end()) {
    const hsize_t rows = chunk_bytes / (std::max<hsize_t>(width, 1) * sizeof(T));
    found = open_.emplace(key, group.create<T>(name, shape(0), shape(hdf5::unlimited), shape(rows))).first;
  }
  hdf5::Dataset& data = found->second;
  const hsize_t before = data.shape()[0];
  data.resize(shape(before + n));
  data.template write<T>(width == 0 ? Shape{before} : Shape{before, 0}, shape(n), values);
}

void RunWriter::append_contacts(const Contacts& c) {
  const Components plane = run_layout::in_plane(first_.dimension);
  const auto width = static_cast<hsize_t>(plane.count);
  append_rows(contacts_, "i", c.i);
  append_rows(contacts_, "j", c.j);
  append_rows(contacts_, "part_i", c.part_i);
  append_rows(contacts_, "part_j", c.part_j);
  append_rows(contacts_, "image", flat(c.image, plane, "periodic image"), width);
  append_rows(contacts_, "overlap", c.overlap);
  append_rows(contacts_, "fn", c.normal_force);
  append_rows(contacts_, "normal", flat(c.normal, plane, "contact normal"), width);
  append_rows(contacts_, "ft", flat(c.tangential_force, plane, "tangential force"), width);
  append_rows(contacts_, "point", flat(c.point, plane, "contact point"), width);
  append_rows(contacts_, "slip", c.sliding);
  contact_offset_.push_back(contact_offset_.back() + c.size());
}

void RunWriter::append_walls(const std::vector<Wall>& walls) {
  std::vector<std::uint8_t> kind;
  std::vector<double> position, normal, velocity, force, bead_radius, radius, bead;
  for (const Wall& wall : walls) {
    kind.push_back(static_cast<std::uint8_t>(wall.kind));
    put(position, wall.position);
    put(normal, wall.normal);
    put(velocity, wall.velocity);
    put(force, wall.force);
    bead_radius.push_back(wall.bead_radius);
    radius.push_back(wall.radius);
    for (const Vec3& centre : wall.beads) put(bead, centre);
    bead_offset_.push_back(bead_offset_.back() + wall.beads.size());
  }
  append_rows(walls_, "kind", kind);
  append_rows(walls_, "position", position, 3);
  append_rows(walls_, "normal", normal, 3);
  append_rows(walls_, "velocity", velocity, 3);
  append_rows(walls_, "force", force, 3);
  append_rows(walls_, "bead_radius", bead_radius);
  append_rows(walls_, "cylinder_radius", radius);
  append_rows(walls_, "bead", bead, 3);
  wall_offset_.push_back(wall_offset_.back() + walls.size());
}

void RunWriter::append_domain(const Domain& domain) {
  put(edges_, domain.hi - domain.lo, first_.dimension);
  put(lower_, domain.lo);
  put(upper_, domain.hi);
  for (bool p : domain.periodic) periodic_.push_back(p);
}

void RunWriter::link_times(Group& group) {
  group.link("step", frames_, "step");
  group.link("time", frames_, "time");
}

template <class T>
void RunWriter::finish_element(Group& parent, const char* name, const std::vector<T>& values, hsize_t width) {
  Group element = make(parent, name);
  element.write("value", values, width == 0 ? Shape{count_} : Shape{count_, width});
  link_times(element);
}

template <class T>
void RunWriter::finish_property(const char* name, const std::vector<T> Grains::*member) {
  if (!elements_.contains(name)) all_.write(name, first_.grains.*member);
}

void RunWriter::finish_box() {
  Group box = make(all_, "box");
  box.attribute("dimension", std::vector<std::int32_t>{first_.dimension});
  std::vector<std::string> boundary;
  for (std::size_t k = 0; k < static_cast<std::size_t>(first_.dimension); ++k)
    boundary.push_back(first_.domain.periodic[k] ? "periodic" : "none");
  box.attribute_for_others("boundary", boundary);
  finish_element(box, "edges", edges_, static_cast<hsize_t>(first_.dimension));
  box.write("lower", lower_, {count_, 3});
  box.write("upper", upper_, {count_, 3});
  box.write("periodic", periodic_, {count_, 3});
}

void RunWriter::finish(const Provenance& provenance) {
  if (count_ == 0) {  // the tables are there, with no rows
    append_contacts({});
    append_walls({});
    contact_offset_.pop_back();
    wall_offset_.pop_back();
  }
  open_.clear();
  frames_.write("step", steps_);
  frames_.write("time", times_);
  frames_.write_strings("stage", stages_);
  if (std::any_of(relaxations_.begin(), relaxations_.end(), [](const std::string& r) { return !r.empty(); }))
    frames_.write_strings("relaxation", relaxations_);

  for (auto& [name, element] : elements_) link_times(element);
  finish_property("id", &Grains::id);
  finish_property("species", &Grains::species);
  finish_property("radius", &Grains::radius);
  finish_property("mass", &Grains::mass);
  if (!first_.shapes.empty()) {
    finish_property("shape", &Grains::shape);
    finish_property("scale", &Grains::scale);
    Group shapes = make(root_, "shapes");
    write_shapes(shapes, first_.shapes);
  }
  finish_element(all_, "count", grains_);
  finish_box();

  contacts_.write("offset", contact_offset_);
  link_times(contacts_);
  walls_.write("offset", wall_offset_);
  walls_.write("bead_offset", bead_offset_);
  link_times(walls_);

  Group observables = make(root_, "observables");
  finish_element(observables, "packing_fraction", fraction_);
  finish_element(observables, "packing_fraction_plain", fraction_plain_);
  for (const auto& [name, member] : run_layout::energies) {
    std::vector<double> values;
    for (const EnergyLedger& ledger : energy_) values.push_back(ledger.*member);
    finish_element(observables, name, values);
  }

  Group parameters = make(root_, "parameters");
  parameters.attribute("program", std::string("jamscape"));
  parameters.attribute("version", provenance.version);
  for (const auto& [name, value] : provenance.further) parameters.attribute(name, value);
  parameters.write_string("config", provenance.study);

  Group h5md = root_.group("h5md");
  Group author = make(h5md, "author"), creator = make(h5md, "creator");
  author.attribute_for_others("name", {"jamscape"});
  creator.attribute_for_others("name", {"jamscape"});
  creator.attribute_for_others("version", {provenance.version.empty() ? "unknown" : provenance.version});
}

}  // namespace jam
