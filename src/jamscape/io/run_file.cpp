#include "jamscape/io/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/io/aside.hpp"
#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/run_layout.hpp"
#include "jamscape/io/run_writer.hpp"
#include "jamscape/io/seal.hpp"
#include "jamscape/io/shape_list.hpp"
#include "jamscape/packing/fields.hpp"
#include "jamscape/packing/wall_roles.hpp"

namespace jam {
namespace {

using hdf5::Group;
using hdf5::Shape;

constexpr const char* advice = "`jamscape run` with its folder of results simulates this run again";

[[noreturn]] void damaged(const Group& where, const std::string& what) {
  throw data_error("the file is damaged: " + what, where.file(), advice);
}

/// Not damage: the file is of a later version.
struct OtherVersion : Error {
  explicit OtherVersion(const Error& error) : Error(error) {}
};

Error does_not_fit_seal(const std::filesystem::path& path) {
  return data_error("the file is damaged or was changed: its content does not fit its seal", path.string(), advice);
}

hsize_t width_in_file(FieldShape shape, int dimension) {
  return shape == FieldShape::scalar ? 0 : static_cast<hsize_t>(components(shape, dimension).count);
}

/// Values from their stored components, one value after another.
template <class T>
std::vector<T> values_of(std::vector<Number<T>> numbers, FieldShape shape, int dimension) {
  if constexpr (std::is_arithmetic_v<T>) {
    return numbers;
  } else {
    const Components stored = components(shape, dimension);
    const auto width = static_cast<std::size_t>(stored.count);
    std::vector<T> out(numbers.size() / width);
    if (stored.count == component_count<T>() && !out.empty()) {
      static_assert(sizeof(T) == component_count<T>() * sizeof(Number<T>) && std::is_trivially_copyable_v<T>);
      std::memcpy(static_cast<void*>(out.data()), numbers.data(), out.size() * sizeof(T));
      return out;
    }
    for (std::size_t n = 0; n < out.size(); ++n) {
      T value{};
      for (int k = 0; k < component_count<T>(); ++k) component(value, k) = 0;
      for (int k = 0; k < stored.count; ++k)
        component(value, stored.first + k) = numbers[n * width + static_cast<std::size_t>(k)];
      out[n] = value;
    }
    return out;
  }
}

/// The number a member is stored as: its own type, or a byte for truth and names.
template <class T>
using Stored = std::conditional_t<std::is_enum_v<T> || std::is_same_v<T, bool>, std::uint8_t, T>;

/// Offsets of a flat table: one more than the entries they cut it into, rising from 0 to `rows`.
std::vector<std::uint64_t> read_offsets(const Group& group, const char* name, std::size_t entries, hsize_t rows) {
  auto offset = group.read<std::uint64_t>(name);
  if (offset.size() != entries + 1 || offset.front() != 0 || offset.back() != rows ||
      !std::is_sorted(offset.begin(), offset.end()))
    damaged(group, fmt::format("'{}' does not cut {} rows into {} parts", name, rows, entries));
  return offset;
}

template <class T>
std::vector<T> read_rows(const Group& group, const char* name, hsize_t first, hsize_t count, hsize_t width = 0) {
  return group.dataset(name).read<T>(width == 0 ? Shape{first} : Shape{first, 0},
                                     width == 0 ? Shape{count} : Shape{count, width});
}

}  // namespace

struct RunFile::State {
  hdf5::File file;
  Group root, all, contacts, walls;
  int dimension = 0;
  std::vector<std::int64_t> counts;
  std::vector<Packing> heads;  // of each frame what is one value a frame
  std::vector<std::int64_t> steps;
  std::vector<double> times, fraction;
  std::vector<std::string> stages, relaxations;
  std::vector<ClusterShape> shapes;
  bool roles = false;  // whether the walls say what they are for
  std::vector<std::uint64_t> contact_offset, wall_offset, bead_offset;

  explicit State(hdf5::File opened);
  template <class T>
  std::vector<T> per_frame(const Group& group, const char* name, std::size_t width = 1) const;
  void read_frames();
  void read_box(const Group& box);
  Grains grains(std::size_t k, Knowledge& knows) const;
  template <class T>
  std::vector<T> grain_values(const Field<Grains, std::vector<T>>& f, std::size_t k, hsize_t n) const;
  Contacts read_contacts(std::size_t k, std::size_t grains, std::size_t walls, Knowledge& knows) const;
  std::vector<Wall> read_walls(std::size_t k) const;
};

template <class T>
std::vector<T> RunFile::State::per_frame(const Group& group, const char* name, std::size_t width) const {
  auto values = group.read<T>(name);
  if (values.size() != heads.size() * width)
    damaged(group, fmt::format("'{}' has {} entries for {} frames", name, values.size(), heads.size()));
  return values;
}

RunFile::State::State(hdf5::File opened) : file(std::move(opened)), root(file.root()) {
  if (!root.has("frames") || !root.has("contacts") || !root.has("particles") || !root.has_attribute("layout_version"))
    throw data_error("the file holds no packings of ours: it has no groups frames, particles and contacts", root.file(),
                     "name a run.h5 or a frame file");
  if (const auto version = root.read_attribute<std::int32_t>("layout_version");
      version.size() != 1 || version[0] < run_layout::oldest_version || version[0] > run_layout::version)
    throw OtherVersion(
        data_error(fmt::format("the file has layout version {}, this program reads {} to {}",
                               version.empty() ? 0 : version[0], run_layout::oldest_version, run_layout::version),
                   root.file(), "use the version of the program that wrote it"));
  all = root.group("particles").group("all");
  read_frames();
  counts = per_frame<std::int64_t>(all.group("count"), "value");
  if (root.has("shapes")) shapes = read_shapes(root.group("shapes"));
  read_box(all.group("box"));

  const auto rows = [](const Group& group, const char* name) {
    const Shape shape = group.dataset(name).shape();
    return shape.empty() ? 0 : shape[0];
  };
  contacts = root.group("contacts");
  contact_offset = read_offsets(contacts, "offset", heads.size(), rows(contacts, "i"));
  walls = root.group("walls");
  wall_offset = read_offsets(walls, "offset", heads.size(), rows(walls, "kind"));
  bead_offset = read_offsets(walls, "bead_offset", wall_offset.back(), rows(walls, "bead"));
  for_each_field(wall_fields, [&](const auto& f) {
    if (f.name == std::string_view("role")) roles = walls.has(f.in_file());
  });
}

/// What is one value a frame, but the cell.
void RunFile::State::read_frames() {
  const Group frames = root.group("frames"), observables = root.group("observables");
  heads.resize(frames.read<std::int64_t>("step").size());
  const std::string prefix = "observables/";
  for_each_field(frame_fields, [&]<class T>(const Field<Packing, T>& f) {
    const std::string name = f.in_file();
    if constexpr (std::is_same_v<T, std::string>) {
      if (f.later && !frames.has(name)) return;
      auto texts = frames.read_strings(name);
      if (texts.size() != heads.size()) damaged(frames, fmt::format("there is not one {} for each frame", name));
      for (std::size_t k = 0; k < texts.size(); ++k) heads[k].*f.member = std::move(texts[k]);
    } else {
      const auto values = name.starts_with(prefix)
                              ? per_frame<T>(observables.group(name.substr(prefix.size())), "value")
                              : per_frame<T>(frames, name.c_str());
      for (std::size_t k = 0; k < values.size(); ++k) heads[k].*f.member = values[k];
    }
  });
  for_each_field(energy_fields, [&](const auto& f) {
    const auto values = per_frame<double>(observables.group(f.in_file()), "value");
    for (std::size_t k = 0; k < values.size(); ++k) heads[k].energy.*f.member = values[k];
  });
  if (root.has("knows")) {
    const Group knows = root.group("knows");
    for_each_field(knowledge_fields, [&](const auto& f) {
      if (!knows.has(f.in_file())) return;
      const auto values = per_frame<std::uint8_t>(knows, f.in_file());
      for (std::size_t k = 0; k < values.size(); ++k) heads[k].knows.*f.member = values[k] != 0;
    });
  }
  for (const Packing& p : heads) {
    steps.push_back(p.step);
    times.push_back(p.time);
    fraction.push_back(p.packing_fraction);
    stages.push_back(p.stage);
    relaxations.push_back(p.relaxation);
  }
}

void RunFile::State::read_box(const Group& box) {
  const auto dimensions = box.read_attribute<std::int32_t>("dimension");
  if (dimensions.size() != 1 || (dimensions[0] != 2 && dimensions[0] != 3))
    damaged(box, "its dimension is neither 2 nor 3");
  dimension = dimensions[0];
  for_each_field(domain_fields, [&]<class T>(const Field<Domain, T>& f) {
    if (f.later && !box.has(f.in_file())) return;
    if constexpr (std::is_same_v<T, std::array<bool, 3>>) {
      const auto values = per_frame<std::uint8_t>(box, f.in_file(), 3);
      for (std::size_t n = 0; n < values.size(); ++n) (heads[n / 3].domain.*f.member)[n % 3] = values[n] != 0;
    } else {
      constexpr std::size_t numbers = sizeof(T) / sizeof(double);
      const auto values = per_frame<double>(box, f.in_file(), numbers);
      for (std::size_t k = 0; k < heads.size(); ++k)
        std::memcpy(&(heads[k].domain.*f.member), &values[k * numbers], sizeof(T));
    }
  });
}

template <class T>
std::vector<T> RunFile::State::grain_values(const Field<Grains, std::vector<T>>& f, std::size_t k, hsize_t n) const {
  const char* name = f.in_file();
  const hsize_t width = width_in_file(f.shape, dimension);
  if (f.kept == Kept::each_frame || all.is_group(name)) {
    const auto data = all.group(name).dataset("value");
    return values_of<T>(width == 0 ? data.template read<Number<T>>({k, 0}, {1, n})
                                   : data.template read<Number<T>>({k, 0, 0}, {1, n, width}),
                        f.shape, dimension);
  }
  auto values = values_of<T>(all.read<Number<T>>(name), f.shape, dimension);
  if (values.size() != n) damaged(all, fmt::format("'{}' has {} entries for {} grains", name, values.size(), n));
  return values;
}

Grains RunFile::State::grains(std::size_t k, Knowledge& knows) const {
  if (counts[k] < 0) damaged(all, fmt::format("frame {} has {} grains", k, counts[k]));
  const auto n = static_cast<hsize_t>(counts[k]);
  Grains g;
  for_each_field(grain_fields, [&](const auto& f) {
    if (f.presence == Presence::clusters && shapes.empty()) return;
    if (f.later && !all.has(f.in_file())) {
      (g.*f.member).resize(n);
      if (f.known != nullptr) knows.*f.known = false;
      return;
    }
    g.*f.member = grain_values(f, k, n);
  });
  return g;
}

Contacts RunFile::State::read_contacts(std::size_t k, std::size_t grains, std::size_t wall_count,
                                       Knowledge& knows) const {
  const hsize_t first = contact_offset[k], n = contact_offset[k + 1] - first;
  Contacts c;
  for_each_field(contact_fields, [&]<class T>(const Field<Contacts, std::vector<T>>& f) {
    if (f.later && !contacts.has(f.in_file())) {
      (c.*f.member).resize(n);
      if (f.known != nullptr) knows.*f.known = false;
      return;
    }
    c.*f.member = values_of<T>(read_rows<Number<T>>(contacts, f.in_file(), first, n, width_in_file(f.shape, dimension)),
                               f.shape, dimension);
  });
  for (std::size_t m = 0; m < n; ++m) {
    const std::int64_t j = c.j[m];
    if (c.i[m] >= grains || j >= static_cast<std::int64_t>(grains) || j < -static_cast<std::int64_t>(wall_count))
      damaged(contacts, fmt::format("contact {} of frame {} is between {} and {}, but there are {} grains and {} walls",
                                    m, k, c.i[m], j, grains, wall_count));
  }
  return c;
}

std::vector<Wall> RunFile::State::read_walls(std::size_t k) const {
  const hsize_t first = wall_offset[k], n = wall_offset[k + 1] - first;
  std::vector<Wall> out(n);
  for_each_field(wall_fields, [&]<class T>(const Field<Wall, T>& f) {
    if (f.later && !walls.has(f.in_file())) return;
    const hsize_t width = width_in_file(f.shape, 3);
    if constexpr (std::is_same_v<T, std::vector<Vec3>>) {
      const hsize_t bead = bead_offset[first], beads = bead_offset[first + n] - bead;
      const auto all_beads = values_of<Vec3>(read_rows<double>(walls, f.in_file(), bead, beads, width), f.shape, 3);
      for (std::size_t w = 0; w < n; ++w)
        for (std::size_t b = bead_offset[first + w]; b < bead_offset[first + w + 1]; ++b)
          (out[w].*f.member).push_back(all_beads[b - bead]);
    } else {
      const auto values =
          values_of<Stored<T>>(read_rows<Number<Stored<T>>>(walls, f.in_file(), first, n, width), f.shape, 3);
      for (std::size_t w = 0; w < n; ++w) out[w].*f.member = static_cast<T>(values[w]);
    }
  });
  for (const Wall& wall : out) {
    if (static_cast<std::uint8_t>(wall.kind) > static_cast<std::uint8_t>(WallKind::cylinder))
      damaged(walls, fmt::format("a wall is of kind {}", static_cast<int>(wall.kind)));
    if (static_cast<std::uint8_t>(wall.role) > static_cast<std::uint8_t>(WallRole::lid))
      damaged(walls, fmt::format("a wall has role {}", static_cast<int>(wall.role)));
  }
  return out;
}

RunFile::RunFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
RunFile::RunFile(RunFile&&) noexcept = default;
RunFile& RunFile::operator=(RunFile&&) noexcept = default;

RunFile::RunFile(const std::filesystem::path& path, Look look) {
  const bool sealed = ends_in_seal(path);
  if (sealed && look == Look::content && !seal_fits(path)) throw does_not_fit_seal(path);
  const hdf5::Lock lock;
  state_ = std::make_unique<State>(hdf5::File::open(path));
  if (!sealed && state_->root.has_attribute(run_layout::sealed))
    throw data_error("the file is damaged or was changed: it has lost its seal", path.string(), advice);
}

RunCheck check_run(const std::filesystem::path& path) {
  using Verdict = RunCheck::Verdict;
  bool sealed = false;
  try {
    sealed = ends_in_seal(path);
    if (sealed && !seal_fits(path)) return {Verdict::damaged, does_not_fit_seal(path).what()};
  } catch (const Error& error) {
    return {Verdict::unreadable, error.what()};
  }
  try {
    const RunFile run(path, Look::structure);
  } catch (const OtherVersion& error) {
    return {Verdict::unreadable, error.what()};
  } catch (const Error& error) {
    return {Verdict::damaged, error.what()};
  }
  return {sealed ? Verdict::whole : Verdict::not_covered, {}};
}

RunFile::~RunFile() {
  const hdf5::Lock lock;
  state_.reset();
}

std::size_t RunFile::frames() const { return state_->heads.size(); }
const std::vector<std::int64_t>& RunFile::steps() const { return state_->steps; }
const std::vector<double>& RunFile::times() const { return state_->times; }
const std::vector<std::string>& RunFile::stages() const { return state_->stages; }
const std::vector<std::string>& RunFile::relaxations() const { return state_->relaxations; }
const std::vector<double>& RunFile::packing_fractions() const { return state_->fraction; }
const std::vector<ClusterShape>& RunFile::shapes() const { return state_->shapes; }

Provenance RunFile::provenance() const {
  const hdf5::Lock lock;
  const Group parameters = state_->root.group("parameters");
  Provenance provenance;
  for (const std::string& name : parameters.attribute_names()) {
    if (name == "layout_version" || name == "program") continue;
    if (const auto text = parameters.read_text_attribute(name))
      (name == "version" ? provenance.version : provenance.further[name]) = *text;
  }
  if (const auto config = parameters.read_strings("config"); config.size() == 1) provenance.study = config[0];
  return provenance;
}

Packing RunFile::frame(std::size_t k) const {
  const State& s = *state_;
  if (k >= frames()) throw data_error(fmt::format("there is no frame {}: the file has {}", k, frames()), s.root.file());
  const hdf5::Lock lock;
  Packing p = s.heads[k];
  p.dimension = s.dimension;
  p.walls = s.read_walls(k);
  if (!s.roles) guess_roles(p);
  p.grains = s.grains(k, p.knows);
  p.contacts = s.read_contacts(k, p.grains.size(), p.walls.size(), p.knows);
  p.shapes = s.shapes;
  if (const std::string problem = cluster_problem(p); !problem.empty())
    damaged(s.root, fmt::format("in frame {}, {}", k, problem));
  return p;
}

void write_frame(const std::filesystem::path& path, const Packing& packing) {
  std::string image;
  {
    const hdf5::Lock lock;
    hdf5::File file = hdf5::File::create_image(path.string());
    {
      RunWriter writer(file.root(), 1);  // its groups are closed before their file
      writer.append(packing);
      writer.finish({});
    }
    image = file.close_image();
  }
  write_text(path, seal(std::move(image)));
}

Packing read_frame(const std::filesystem::path& path) {
  std::string image = unseal(read_text(path), path.string());
  const hdf5::Lock lock;
  const RunFile file(std::make_unique<RunFile::State>(hdf5::File::open_image(std::move(image), path.string())));
  if (file.frames() != 1)
    throw data_error(fmt::format("the file holds {} frames where one is expected", file.frames()), path.string());
  return file.frame(0);
}

void assemble_run(const std::vector<std::filesystem::path>& frames, const std::filesystem::path& run_h5,
                  const Provenance& provenance) {
  Aside aside(run_h5);
  {
    // The lock is held call by call only: other simulations go on writing their frames meanwhile.
    hdf5::File file = hdf5::File::create(aside.path());
    {
      RunWriter writer(file.root(), frames.size());  // its groups are closed before their file
      for (const auto& path : frames) {
        writer.append(read_frame(path));
        file.check();
      }
      writer.finish(provenance);
    }
    file.close();
  }
  seal_file(aside.path());
  aside.commit();
}

}  // namespace jam
