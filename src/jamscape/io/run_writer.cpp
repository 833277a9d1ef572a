#include "jamscape/io/run_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "jamscape/base/error.hpp"
#include "jamscape/io/run_layout.hpp"
#include "jamscape/io/shape_list.hpp"
#include "jamscape/packing/fields.hpp"

namespace jam {
namespace {

using hdf5::Group;
using hdf5::Shape;

constexpr hsize_t chunk_bytes = 65536;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// How many numbers a value is stored as, where it is no single one.
hsize_t width_of(FieldShape shape, int dimension) {
  return shape == FieldShape::scalar ? 0 : static_cast<hsize_t>(components(shape, dimension).count);
}

/// The stored components of values, one value after another.
template <class T>
struct Flat {
  std::vector<Number<T>> copy;  // empty where the values lie in memory as they are stored
  std::span<const Number<T>> values;
};

/// The components that are not stored must be zero, or they would be lost.
template <class T>
Flat<T> flat(const std::vector<T>& values, FieldShape shape, int dimension, const std::string& name) {
  constexpr int all = component_count<T>();
  const Components stored = components(shape, dimension);
  static_assert(sizeof(T) == all * sizeof(Number<T>));
  if (stored.count == all) return {{}, {reinterpret_cast<const Number<T>*>(values.data()), values.size() * all}};
  Flat<T> out;
  out.copy.reserve(values.size() * static_cast<std::size_t>(stored.count));
  for (std::size_t n = 0; n < values.size(); ++n)
    for (int k = 0; k < all; ++k) {
      const auto value = component(values[n], k);
      if (k >= stored.first && k < stored.first + stored.count)
        out.copy.push_back(value);
      else if (value != 0)
        throw data_error(fmt::format("the {} of entry {} of a two-dimensional packing has component {} = {}", name, n,
                                     "xyz"[k], value));
    }
  out.values = out.copy;
  return out;
}

/// What stands in an array of numbers for a member that is none.
template <class T>
constexpr auto stored_value(const T& value) {
  if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>)
    return static_cast<std::uint8_t>(value);
  else
    return value;
}

/// One member of many records, as it is stored.
template <class Record, class T>
void write_column(Group& group, const Field<Record, T>& f, const std::string& name,
                  const std::vector<const Record*>& records) {
  if constexpr (std::is_same_v<T, std::string>) {
    std::vector<std::string> texts;
    for (const Record* r : records) texts.push_back(r->*f.member);
    group.write_strings(name, texts);
  } else {
    std::vector<decltype(stored_value(T{}))> values;
    for (const Record* r : records) values.push_back(stored_value(r->*f.member));
    if constexpr (std::is_same_v<T, Vec3>) {
      const Flat<Vec3> numbers = flat(values, f.shape, 3, f.name);
      group.write(name, numbers.values, {values.size(), 3});
    } else {
      group.write(name, values);
    }
  }
}

template <class Record>
std::vector<const Record*> pointers(const std::vector<Record>& records) {
  std::vector<const Record*> out;
  for (const Record& r : records) out.push_back(&r);
  return out;
}

}  // namespace

RunWriter::RunWriter(Group root, std::size_t frames) : root_(std::move(root)), planned_(frames) {
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
  group.attribute("layout_version", std::vector<std::int32_t>{layout_});
  return group;
}

void RunWriter::append(const Packing& packing) {
  if (heads_.size() == planned_) throw data_error("more frames than were announced", all_.file());
  if (packing.dimension != 2 && packing.dimension != 3)
    throw data_error(fmt::format("a packing of {} dimensions cannot be stored", packing.dimension), all_.file());
  if (heads_.empty()) {
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
  append_grains(packing.grains);
  append_contacts(packing.contacts);
  append_walls(packing.walls);
  Packing& head = heads_.emplace_back();
  for_each_field(frame_fields, [&](const auto& f) { head.*f.member = packing.*f.member; });
  head.domain = packing.domain;
  head.energy = packing.energy;
  head.knows = packing.knows;
}

void RunWriter::append_grains(const Grains& g) {
  for_each_field(grain_fields, [&](const auto& f) {
    if (f.presence == Presence::clusters && first_.shapes.empty()) return;
    append_property(f, g);
  });
  grains_.push_back(static_cast<std::int64_t>(g.size()));
}

/// A lasting property becomes a time-dependent one at the first frame in which it differs.
template <class T>
void RunWriter::append_property(const Field<Grains, std::vector<T>>& f, const Grains& now) {
  const auto append = [&](std::size_t frame, const Grains& g) {
    append_grain_row<Number<T>>(f.in_file(), frame,
                                flat(g.*f.member, f.shape, first_.dimension, std::string("grain ") + f.name).values,
                                width_of(f.shape, first_.dimension));
  };
  const std::size_t count = heads_.size();
  if (f.kept == Kept::once && !elements_.contains(f.in_file())) {
    if (same_bits(first_.grains.*f.member, now.*f.member)) return;
    for (std::size_t k = 0; k < count; ++k) append(k, first_.grains);
  }
  append(count, now);
}

template <class T>
void RunWriter::append_grain_row(const char* name, std::size_t frame, std::span<const T> values, hsize_t width) {
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
void RunWriter::append_rows(Group& group, const std::string& name, std::span<const T> values, hsize_t width) {
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
  for_each_field(contact_fields, [&](const auto& f) {
    const auto rows = flat(c.*f.member, f.shape, first_.dimension, std::string("contact ") + f.name);
    append_rows(contacts_, f.in_file(), rows.values, width_of(f.shape, first_.dimension));
  });
  contact_offset_.push_back(contact_offset_.back() + c.size());
}

void RunWriter::append_walls(const std::vector<Wall>& walls) {
  for_each_field(wall_fields, [&]<class T>(const Field<Wall, T>& f) {
    const auto append = [&]<class V>(const std::vector<V>& values) {
      append_rows(walls_, f.in_file(), flat(values, f.shape, 3, f.name).values, width_of(f.shape, 3));
    };
    if constexpr (std::is_same_v<T, std::vector<Vec3>>) {
      std::vector<Vec3> all;
      for (const Wall& wall : walls) all.insert(all.end(), (wall.*f.member).begin(), (wall.*f.member).end());
      append(all);
    } else {
      std::vector<decltype(stored_value(T{}))> values;
      for (const Wall& wall : walls) values.push_back(stored_value(wall.*f.member));
      append(values);
    }
  });
  for (const Wall& wall : walls) bead_offset_.push_back(bead_offset_.back() + wall.beads.size());
  wall_offset_.push_back(wall_offset_.back() + walls.size());
}

void RunWriter::link_times(Group& group) {
  group.link("step", frames_, "step");
  group.link("time", frames_, "time");
}

template <class T>
void RunWriter::finish_element(Group& parent, const char* name, const std::vector<T>& values, const Shape& shape) {
  Group element = make(parent, name);
  element.write("value", values, shape);
  link_times(element);
}

/// The cell. A layout of its own, which programs of before refuse, where one is tilted.
void RunWriter::finish_box() {
  const std::size_t frames = heads_.size();
  const auto dimension = static_cast<std::size_t>(first_.dimension);
  const bool tilted = std::any_of(heads_.begin(), heads_.end(), [](const Packing& p) { return !p.domain.upright(); });
  layout_ = tilted ? run_layout::version : run_layout::upright_version;
  Group box = make(all_, "box");
  box.attribute("dimension", std::vector<std::int32_t>{first_.dimension});
  std::vector<std::string> boundary;
  for (std::size_t k = 0; k < dimension; ++k) boundary.push_back(first_.domain.periodic[k] ? "periodic" : "none");
  box.attribute_for_others("boundary", boundary);
  std::vector<double> edges;
  for (const Packing& p : heads_)
    for (std::size_t k = 0; k < dimension; ++k)
      for (std::size_t a = 0; a < dimension; ++a)
        if (tilted || a == k) edges.push_back(p.domain.edge(static_cast<int>(k))[static_cast<int>(a)]);
  finish_element(box, "edges", edges, tilted ? Shape{frames, dimension, dimension} : Shape{frames, dimension});
  for_each_field(domain_fields, [&]<class T>(const Field<Domain, T>& f) {
    if constexpr (std::is_same_v<T, Vec3>) {
      std::vector<double> rows;
      for (const Packing& p : heads_)
        for (int k = 0; k < 3; ++k) rows.push_back((p.domain.*f.member)[k]);
      box.write(f.in_file(), rows, {frames, 3});
    } else if constexpr (std::is_same_v<T, std::array<Vec3, 3>>) {
      std::vector<double> rows;
      for (const Packing& p : heads_)
        for (const Vec3& row : p.domain.*f.member) rows.insert(rows.end(), row.c, row.c + 3);
      if (tilted) box.write(f.in_file(), rows, {frames, 3, 3});
    } else {
      std::vector<std::uint8_t> rows;
      for (const Packing& p : heads_)
        for (const bool flag : p.domain.*f.member) rows.push_back(flag);
      box.write(f.in_file(), rows, {frames, 3});
    }
  });
}

/// Only what some frame does not know.
void RunWriter::finish_knowledge() {
  const auto knows_all = [](const Packing& p) { return p.knows == Knowledge{}; };
  if (std::all_of(heads_.begin(), heads_.end(), knows_all)) return;
  Group group = make(root_, "knows");
  for_each_field(knowledge_fields, [&](const auto& f) {
    std::vector<std::uint8_t> known;
    for (const Packing& p : heads_) known.push_back(p.knows.*f.member);
    group.write(f.in_file(), known);
  });
}

void RunWriter::finish(const Provenance& provenance) {
  if (heads_.empty()) {  // the tables are there, with no rows
    append_contacts({});
    append_walls({});
    contact_offset_.pop_back();
    wall_offset_.pop_back();
  }
  open_.clear();
  Group observables = make(root_, "observables");
  for_each_field(frame_fields, [&]<class T>(const Field<Packing, T>& f) {
    const std::string name = f.in_file(), prefix = "observables/";
    if constexpr (std::is_same_v<T, std::string>) {
      if (f.later && std::all_of(heads_.begin(), heads_.end(), [&](const Packing& p) { return (p.*f.member).empty(); }))
        return;
    }
    if (!name.starts_with(prefix)) return write_column(frames_, f, name, pointers(heads_));
    Group element = make(observables, name.c_str() + prefix.size());
    write_column(element, f, "value", pointers(heads_));
  });
  for (const std::string& name : observables.names()) {
    Group element = observables.group(name);
    link_times(element);
  }
  for_each_field(energy_fields, [&](const auto& f) {
    std::vector<double> values;
    for (const Packing& p : heads_) values.push_back(p.energy.*f.member);
    finish_element(observables, f.in_file(), values, {heads_.size()});
  });

  for (auto& [name, element] : elements_) link_times(element);
  for_each_field(grain_fields, [&](const auto& f) {
    if (f.kept != Kept::once || elements_.contains(f.in_file())) return;
    if (f.presence == Presence::clusters && first_.shapes.empty()) return;
    const auto rows = flat(first_.grains.*f.member, f.shape, first_.dimension, f.name);
    const hsize_t width = width_of(f.shape, first_.dimension);
    all_.write(f.in_file(), rows.values, width == 0 ? Shape{} : Shape{rows.values.size() / width, width});
  });
  if (!first_.shapes.empty()) {
    Group shapes = make(root_, "shapes");
    write_shapes(shapes, first_.shapes);
  }
  finish_element(all_, "count", grains_, {heads_.size()});
  finish_box();
  finish_knowledge();

  contacts_.write("offset", contact_offset_);
  link_times(contacts_);
  walls_.write("offset", wall_offset_);
  walls_.write("bead_offset", bead_offset_);
  link_times(walls_);

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
  root_.attribute("layout_version", std::vector<std::int32_t>{layout_});
}

}  // namespace jam
