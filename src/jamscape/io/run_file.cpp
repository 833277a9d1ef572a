#include "jamscape/io/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/io/aside.hpp"
#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/run_layout.hpp"
#include "jamscape/io/run_writer.hpp"
#include "jamscape/io/seal.hpp"
#include "jamscape/io/shape_list.hpp"

namespace jam {
namespace {

using hdf5::Group;
using hdf5::Shape;
using run_layout::Components;

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

std::vector<Vec3> vectors(const std::vector<double>& flat, Components stored) {
  const auto width = static_cast<std::size_t>(stored.count);
  std::vector<Vec3> out(flat.size() / width, Vec3{});
  for (std::size_t n = 0; n < out.size(); ++n)
    for (int k = 0; k < stored.count; ++k) out[n][stored.first + k] = flat[n * width + static_cast<std::size_t>(k)];
  return out;
}

Vec3 vector_at(const std::vector<double>& flat, std::size_t n) {
  return {flat[3 * n], flat[3 * n + 1], flat[3 * n + 2]};
}

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
  std::vector<std::int64_t> steps, counts;
  std::vector<double> times, fraction, fraction_plain, lower, upper;
  std::vector<std::uint8_t> periodic;
  std::vector<std::string> stages, relaxations;
  std::vector<ClusterShape> shapes;
  std::vector<EnergyLedger> energy;
  std::vector<std::uint64_t> contact_offset, wall_offset, bead_offset;

  explicit State(hdf5::File opened);
  template <class T>
  std::vector<T> per_frame(const Group& group, const char* name, std::size_t width = 1) const;
  Grains grains(std::size_t k) const;
  Contacts read_contacts(std::size_t k, std::size_t grains, std::size_t walls) const;
  std::vector<Wall> read_walls(std::size_t k) const;
  template <class T>
  std::vector<T> property(const char* name, std::size_t k, hsize_t n) const;
  std::vector<Vec3> vector_element(const char* name, std::size_t k, hsize_t n, Components stored) const;
};

template <class T>
std::vector<T> RunFile::State::per_frame(const Group& group, const char* name, std::size_t width) const {
  auto values = group.read<T>(name);
  if (values.size() != steps.size() * width)
    damaged(group, fmt::format("'{}' has {} entries for {} frames", name, values.size(), steps.size()));
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
  const Group frames = root.group("frames");
  steps = frames.read<std::int64_t>("step");
  times = per_frame<double>(frames, "time");
  stages = frames.read_strings("stage");
  if (stages.size() != steps.size()) damaged(frames, "there is not one stage name for each frame");
  relaxations.resize(steps.size());
  if (frames.has("relaxation")) relaxations = frames.read_strings("relaxation");
  if (relaxations.size() != steps.size()) damaged(frames, "there is not one relaxation for each frame");

  all = root.group("particles").group("all");
  counts = per_frame<std::int64_t>(all.group("count"), "value");
  if (root.has("shapes")) shapes = read_shapes(root.group("shapes"));
  const Group box = all.group("box");
  const auto dimensions = box.read_attribute<std::int32_t>("dimension");
  if (dimensions.size() != 1 || (dimensions[0] != 2 && dimensions[0] != 3))
    damaged(box, "its dimension is neither 2 nor 3");
  dimension = dimensions[0];
  lower = per_frame<double>(box, "lower", 3);
  upper = per_frame<double>(box, "upper", 3);
  periodic = per_frame<std::uint8_t>(box, "periodic", 3);

  const Group observables = root.group("observables");
  fraction = per_frame<double>(observables.group("packing_fraction"), "value");
  fraction_plain = per_frame<double>(observables.group("packing_fraction_plain"), "value");
  energy.resize(steps.size());
  for (const auto& [name, member] : run_layout::energies) {
    const auto values = per_frame<double>(observables.group(name), "value");
    for (std::size_t k = 0; k < values.size(); ++k) energy[k].*member = values[k];
  }

  const auto rows = [](const Group& group, const char* name) {
    const Shape shape = group.dataset(name).shape();
    return shape.empty() ? 0 : shape[0];
  };
  contacts = root.group("contacts");
  contact_offset = read_offsets(contacts, "offset", steps.size(), rows(contacts, "i"));
  walls = root.group("walls");
  wall_offset = read_offsets(walls, "offset", steps.size(), rows(walls, "kind"));
  bead_offset = read_offsets(walls, "bead_offset", wall_offset.back(), rows(walls, "bead"));
}

template <class T>
std::vector<T> RunFile::State::property(const char* name, std::size_t k, hsize_t n) const {
  if (all.is_group(name)) return all.group(name).dataset("value").read<T>({k, 0}, {1, n});
  auto values = all.read<T>(name);
  if (values.size() != n) damaged(all, fmt::format("'{}' has {} entries for {} grains", name, values.size(), n));
  return values;
}

std::vector<Vec3> RunFile::State::vector_element(const char* name, std::size_t k, hsize_t n, Components stored) const {
  const auto width = static_cast<hsize_t>(stored.count);
  return vectors(all.group(name).dataset("value").read<double>({k, 0, 0}, {1, n, width}), stored);
}

Grains RunFile::State::grains(std::size_t k) const {
  if (counts[k] < 0) damaged(all, fmt::format("frame {} has {} grains", k, counts[k]));
  const auto n = static_cast<hsize_t>(counts[k]);
  const Components plane = run_layout::in_plane(dimension), turn = run_layout::rotation(dimension);
  Grains g;
  g.position = vector_element("position", k, n, plane);
  g.velocity = vector_element("velocity", k, n, plane);
  g.spin = vector_element("angular_velocity", k, n, turn);
  g.angle = vector_element("angle", k, n, turn);
  g.id = property<std::int64_t>("id", k, n);
  g.species = property<std::int32_t>("species", k, n);
  g.radius = property<double>("radius", k, n);
  g.mass = property<double>("mass", k, n);
  if (shapes.empty()) return g;
  g.shape = property<std::int32_t>("shape", k, n);
  g.scale = property<double>("scale", k, n);
  const auto turned = all.group("orientation").dataset("value").read<double>({k, 0, 0}, {1, n, 4});
  for (std::size_t m = 0; m < turned.size(); m += 4)
    g.orientation.push_back({turned[m], turned[m + 1], turned[m + 2], turned[m + 3]});
  return g;
}

Contacts RunFile::State::read_contacts(std::size_t k, std::size_t grains, std::size_t wall_count) const {
  const hsize_t first = contact_offset[k], n = contact_offset[k + 1] - first;
  const Components plane = run_layout::in_plane(dimension);
  const auto width = static_cast<hsize_t>(plane.count);
  Contacts c;
  c.i = read_rows<std::uint32_t>(contacts, "i", first, n);
  c.j = read_rows<std::int32_t>(contacts, "j", first, n);
  c.part_i = read_rows<std::uint16_t>(contacts, "part_i", first, n);
  c.part_j = read_rows<std::uint16_t>(contacts, "part_j", first, n);
  const auto image = read_rows<std::int8_t>(contacts, "image", first, n, width);
  c.image.resize(n);
  for (std::size_t m = 0; m < n; ++m)
    for (std::size_t d = 0; d < width; ++d) c.image[m][d] = image[m * width + d];
  c.overlap = read_rows<double>(contacts, "overlap", first, n);
  c.normal_force = read_rows<double>(contacts, "fn", first, n);
  c.normal = vectors(read_rows<double>(contacts, "normal", first, n, width), plane);
  c.tangential_force = vectors(read_rows<double>(contacts, "ft", first, n, width), plane);
  c.point = vectors(read_rows<double>(contacts, "point", first, n, width), plane);
  c.sliding = read_rows<std::uint8_t>(contacts, "slip", first, n);
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
  const hsize_t first_bead = bead_offset[first], beads = bead_offset[first + n] - first_bead;
  const auto kind = read_rows<std::uint8_t>(walls, "kind", first, n);
  const auto position = read_rows<double>(walls, "position", first, n, 3);
  const auto normal = read_rows<double>(walls, "normal", first, n, 3);
  const auto velocity = read_rows<double>(walls, "velocity", first, n, 3);
  const auto force = read_rows<double>(walls, "force", first, n, 3);
  const auto bead_radius = read_rows<double>(walls, "bead_radius", first, n);
  const auto radius = walls.has("cylinder_radius") ? read_rows<double>(walls, "cylinder_radius", first, n)
                                                   : std::vector<double>(n, 0.0);
  const auto bead = read_rows<double>(walls, "bead", first_bead, beads, 3);
  std::vector<Wall> out(n);
  for (std::size_t w = 0; w < n; ++w) {
    if (kind[w] > static_cast<std::uint8_t>(WallKind::cylinder))
      damaged(walls, fmt::format("a wall is of kind {}", kind[w]));
    out[w] = {static_cast<WallKind>(kind[w]),
              vector_at(position, w),
              vector_at(normal, w),
              vector_at(velocity, w),
              vector_at(force, w),
              bead_radius[w],
              {},
              radius[w]};
    for (std::size_t b = bead_offset[first + w]; b < bead_offset[first + w + 1]; ++b)
      out[w].beads.push_back(vector_at(bead, b - first_bead));
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

std::size_t RunFile::frames() const { return state_->steps.size(); }
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
  Packing p;
  p.dimension = s.dimension;
  p.step = s.steps[k];
  p.time = s.times[k];
  p.stage = s.stages[k];
  p.relaxation = s.relaxations[k];
  p.packing_fraction = s.fraction[k];
  p.packing_fraction_plain = s.fraction_plain[k];
  p.domain.lo = vector_at(s.lower, k);
  p.domain.hi = vector_at(s.upper, k);
  for (std::size_t d = 0; d < 3; ++d) p.domain.periodic[d] = s.periodic[3 * k + d] != 0;
  p.energy = s.energy[k];
  p.walls = s.read_walls(k);
  p.grains = s.grains(k);
  p.contacts = s.read_contacts(k, p.grains.size(), p.walls.size());
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
