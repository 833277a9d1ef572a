#include "jamscape/io/archive_file.hpp"

#include <fmt/format.h>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/seal.hpp"

namespace jam {
namespace {

constexpr std::int32_t archive_layout = 1;

/// The group a name stands in, made where it is missing, and the rest of the name.
std::pair<hdf5::Group, std::string> place_of(const hdf5::File& file, const std::string& name) {
  hdf5::Group group = file.root();
  std::size_t first = 0;
  for (std::size_t slash; (slash = name.find('/', first)) != std::string::npos; first = slash + 1) {
    const std::string part = name.substr(first, slash - first);
    group = group.has(part) ? group.group(part) : group.create_group(part);
  }
  return {std::move(group), name.substr(first)};
}

void write_value(hdf5::Group& group, const std::string& name, const std::vector<double>& values) {
  group.write(name, values);
}
void write_value(hdf5::Group& group, const std::string& name, const std::vector<std::int64_t>& values) {
  group.write(name, values);
}
void write_value(hdf5::Group& group, const std::string& name, const std::string& text) {
  group.write(name, std::vector<std::uint8_t>(text.begin(), text.end()));
}

void collect(const hdf5::Group& group, const std::string& prefix, Archive& out) {
  for (const std::string& name : group.names()) {
    const std::string whole = prefix + name;
    if (group.is_group(name)) {
      collect(group.group(name), whole + '/', out);
      continue;
    }
    const hdf5::Dataset data = group.dataset(name);
    switch (data.kind()) {
      case hdf5::Kind::real:
        out[whole] = data.read<double>();
        break;
      case hdf5::Kind::integer:
        out[whole] = data.read<std::int64_t>();
        break;
      case hdf5::Kind::byte: {
        const auto bytes = data.read<std::uint8_t>();
        out[whole] = std::string(bytes.begin(), bytes.end());
        break;
      }
      case hdf5::Kind::other:
        throw data_error(fmt::format("'{}' is of a type no archive holds", whole), group.file());
    }
  }
}

}  // namespace

void write_archive(const std::filesystem::path& path, const Archive& archive) {
  std::string image;
  {
    const hdf5::Lock lock;
    hdf5::File file = hdf5::File::create_image(path.string());
    file.root().attribute("archive_layout", std::vector<std::int32_t>{archive_layout});
    for (const auto& [name, value] : archive) {
      auto [group, last] = place_of(file, name);
      std::visit([&group = group, &last = last](const auto& v) { write_value(group, last, v); }, value);
    }
    image = file.close_image();
  }
  write_text(path, seal(std::move(image)));
}

Archive read_archive(const std::filesystem::path& path) {
  std::string image = unseal(read_text(path), path.string());
  const hdf5::Lock lock;
  const hdf5::File file = hdf5::File::open_image(std::move(image), path.string());
  const hdf5::Group root = file.root();
  if (!root.has_attribute("archive_layout") ||
      root.read_attribute<std::int32_t>("archive_layout") != std::vector<std::int32_t>{archive_layout})
    throw data_error("the file is no checkpoint of this version", path.string(),
                     "remove it and start from the last frame");
  Archive archive;
  collect(root, "", archive);
  return archive;
}

}  // namespace jam
