// Prints the generated pages of docs/reference, or says which of those stored are stale.
//
//   reference FOLDER            compares
//   reference --write FOLDER    writes
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "jamscape/observe/explain.hpp"
#include "jamscape/packing/fields.hpp"
#include "jamscape/study/study.hpp"

namespace {

constexpr const char* origin = "<!-- Generated from the declarations in the code; do not edit. -->";

/// In a cell of a table, a bar would end it.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string options_page() {
  std::string page = fmt::format(
      "{}\n\n# Options of a study file\n\n"
      "`jamscape explain KEY` prints the same. Numbers are in scaled units: the mean diameter d, the mean mass m "
      "and the collision time tau_c. Options of a stage stand in a `[[stage]]` table, or as `stage.NAME.key` in a "
      "`[[system]]`. Sources: S1 and S2 as in [references.bib](../references.bib), theory is "
      "[theory.md](../theory.md).\n",
      origin);
  std::string group = "?";
  for (const jam::KnownOption& o : jam::known_options()) {
    const std::size_t dot = o.key.find('.');
    const std::string of = dot == std::string::npos ? "" : o.key.substr(0, dot);
    if (of != group) {
      group = of;
      page += fmt::format("\n## {}\n\n| key | meaning | value | range | default | source |\n|{}\n",
                          group.empty() ? "(top)" : group, "---|---|---|---|---|---|");
    }
    page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", o.key, cell(o.meta.text), cell(o.type), cell(o.range),
                        cell(o.default_value), cell(o.meta.source));
  }
  return page;
}

template <class T>
std::string number_type() {
  if constexpr (std::is_same_v<T, std::string>)
    return "text";
  else if constexpr (requires { typename T::value_type; })
    return number_type<typename T::value_type>();
  else if constexpr (std::is_same_v<T, jam::Vec3> || std::is_same_v<T, jam::Quaternion> || std::is_same_v<T, double>)
    return "f64";
  else if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>)
    return "u8";
  else if constexpr (std::is_integral_v<T>)
    return fmt::format("{}{}", std::is_signed_v<T> ? "i" : "u", 8 * sizeof(T));
  else
    return "f64";
}

const char* width_of(jam::FieldShape shape) {
  switch (shape) {
    case jam::FieldShape::scalar:
      return "";
    case jam::FieldShape::vector:
    case jam::FieldShape::image:
      return "D";
    case jam::FieldShape::rotation:
      return "1 in 2D, 3 in 3D";
    case jam::FieldShape::quaternion:
      return "4";
    case jam::FieldShape::place:
      return "3";
  }
  return "";
}

const char* when(jam::Presence presence) {
  switch (presence) {
    case jam::Presence::always:
      return "";
    case jam::Presence::clusters:
      return "clusters: ";
    case jam::Presence::beads:
      return "walls of beads: ";
    case jam::Presence::cylinder:
      return "cylinders: ";
  }
  return "";
}

/// The table of one group; `path` stands in front of names that have no path of their own.
template <class Fields>
std::string field_table(const char* title, const char* path, const Fields& fields) {
  std::string page = fmt::format(
      "\n## {}\n\n| in `run.h5` | numbers | components | unit | CSV columns | meaning |\n"
      "|---|---|---|---|---|---|\n",
      title);
  jam::for_each_field(fields, [&](const auto& f) {
    using Value = typename std::remove_cvref_t<decltype(f)>::Value;
    const std::string_view columns = f.columns ? f.columns : "", name = f.in_file();
    page += fmt::format("| `{}{}` | {} | {} | {} | {} | {}{} |\n", name.starts_with("observables/") ? "/" : path, name,
                        number_type<Value>(), width_of(f.shape), f.unit, columns.substr(0, columns.find('|')),
                        when(f.presence), cell(f.meaning));
  });
  return page;
}

std::string files_page() {
  return fmt::format("{}\n\n{}", origin, R"(# Files: a run, a packing

`tasks/HASH/run.h5` holds all frames of one simulation, as HDF5; `jamscape export` writes each frame as two CSV tables. Both
hold the fields below, units are those of the study (d, m, tau_c in scaled units). Signs: the unit normal points from i to
j, a positive normal force pushes, and the force on i is `-fn normal + ft`. Wall w is the grain number `-1 - w`.

For T frames, at most N grains and D dimensions: what changes with time in the particle group (H5MD 1.1) is a group `NAME`
with `step[T]`, `time[T]`, `value[T][N]` or `[T][N][components]`, padded beyond the frame's number of grains,
`/particles/all/count/value[T]`; what does not (radii, masses, mostly) is an array `NAME[N]`. Other values of a frame are `[T]`. Contacts of frame t are the rows
`/contacts/offset[t]` to `/contacts/offset[t + 1] - 1` of the arrays below `/contacts`, walls likewise. Every group has
the attribute `layout_version`. Behind the HDF5 data stand 127 bytes, a seal over all bytes before them.

```python
import h5py
import numpy as np

with h5py.File("run.h5", "r") as run:
    last = len(run["frames/step"]) - 1
    grains = run["particles/all/count/value"][last]
    x = run["particles/all/position/value"][last][:grains]
    first, end = run["contacts/offset"][last], run["contacts/offset"][last + 1]
    j, fn = run["contacts/j"][first:end], run["contacts/fn"][first:end]
    print(f"{grains} grains, {np.sum(j >= 0)} contacts between them, mean normal force {fn[j >= 0].mean():.4g}")
```
)") + field_table("Frames", "/frames/", jam::frame_fields) +
         field_table("Grains", "/particles/all/", jam::grain_fields) +
         field_table("Contacts", "/contacts/", jam::contact_fields) +
         field_table("Walls", "/walls/", jam::wall_fields) +
         field_table("Cell (tilt only where a cell is tilted)", "/particles/all/box/", jam::domain_fields) +
         field_table("Energies", "/observables/", jam::energy_fields) +
         field_table("Shapes of clusters", "/shapes/", jam::shape_fields) +
         field_table("Arms of the shapes", "/shapes/", jam::arm_fields) +
         field_table("What the packings know (left out where they know all)", "/knows/", jam::knowledge_fields);
}

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  const bool write = argc == 3 && std::string(argv[1]) == "--write";
  if (argc != 2 && !write) {
    std::cerr << "usage: reference [--write] FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[argc - 1];
  const std::vector<std::pair<std::string, std::string>> pages = {
      {"options.md", options_page()},
      {"files.md", files_page()},
      {"measures.md", fmt::format("{}\n\n{}", origin, jam::measures_reference())}};
  int stale = 0;
  for (const auto& [name, text] : pages) {
    if (write) {
      std::ofstream(folder / name, std::ios::binary) << text;
    } else if (read(folder / name) != text) {
      std::cerr << (folder / name).string() << " is stale; to renew it: " << argv[0] << " --write " << folder.string()
                << "\n";
      stale = 1;
    }
  }
  return stale;
}
