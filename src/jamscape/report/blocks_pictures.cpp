// Blocks of single packings: what the force network looks like, and its persistence diagrams.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "jamscape/io/csv.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/observe/persistence_measures.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/drawing.hpp"
#include "jamscape/report/shape_json.hpp"

namespace jam {
namespace {

/// One coordinate of all nodes, quantised between the ends of the picture and a margin around it.
std::string packed_axis(const Drawing& d, int axis, double margin) {
  std::vector<double> values;
  values.reserve(d.position.size());
  for (const Vec3& at : d.position) values.push_back(at[axis]);
  return packed_words(values, d.lower[axis] - margin, d.upper[axis] + margin);
}

/// In two dimensions quaternions turn about z: w and z say all.
Json clusters_json(const Drawing& d) {
  Json shapes = Json::array();
  for (const ClusterShape& shape : d.shapes) shapes.push_back(shape_json(shape));
  std::array<std::vector<double>, 4> turned;
  for (const Quaternion& q : d.orientation) {
    const double parts[] = {q.w, q.x, q.y, q.z};
    for (std::size_t k = 0; k < 4; ++k) turned[k].push_back(parts[k]);
  }
  Json orientation = Json::array();
  for (std::size_t k = 0; k < 4; ++k)
    if (d.dimension == 3 || k == 0 || k == 3) orientation.push_back(packed_words(turned[k], -1, 1));
  const double most = d.stress.empty() ? 1 : std::max(1.0, *std::max_element(d.stress.begin(), d.stress.end()));
  Json out = {{"shapes", std::move(shapes)},
              {"orientation", std::move(orientation)},
              {"stress", packed_words(d.stress, 0, most)},
              {"stress_max", rounded(most)}};
  if (d.shapes.size() > 1)
    out["shape"] = packed_indices(std::vector<std::uint32_t>(d.shape.begin(), d.shape.end()), false);
  if (d.cylinder) {
    Json centre = Json::array();
    for (int k = 0; k < 3; ++k) centre.push_back(rounded(d.cylinder->centre[k], 7));
    out["cylinder"] = {
        {"axis", d.cylinder->axis}, {"centre", std::move(centre)}, {"radius", rounded(d.cylinder->radius)}};
  }
  return out;
}

Json drawing_json(const Drawing& d) {
  const double radius_max = d.radius.empty() ? 1 : *std::max_element(d.radius.begin(), d.radius.end());
  const double force_max = d.force.empty() ? 1 : *std::max_element(d.force.begin(), d.force.end());
  // A diameter, so that what leaves the picture by a little keeps its place.
  const Json margin = rounded(2 * radius_max, 7);
  const bool wide = d.position.size() > 65535;
  Json out;
  out["lower"] = Json::array();
  out["upper"] = Json::array();
  out["margin"] = margin;
  out["axes"] = Json::array();
  for (int axis = 0; axis < d.dimension; ++axis) {
    out["lower"].push_back(rounded(d.lower[axis], 7));
    out["upper"].push_back(rounded(d.upper[axis], 7));
    out["axes"].push_back(packed_axis(d, axis, margin.get<double>()));
  }
  out["grains"] = d.grains;
  out["beads"] = d.beads;
  out["nodes"] = d.position.size();
  out["radius"] = packed_words(d.radius, 0, radius_max);
  out["radius_max"] = rounded(radius_max);
  out["contacts"] = d.lines();
  out["pairs"] = packed_indices(d.ends, wide);
  out["force"] = packed_words(d.force, 0, force_max);
  out["force_max"] = rounded(force_max);
  if (!d.shapes.empty()) out["clusters"] = clusters_json(d);
  return out;
}

struct Points {
  std::vector<double> birth_death;  // two a point
  std::string essential;            // one byte a point
};

/// Points by frame and dimension.
std::map<std::int64_t, std::map<int, Points>> diagrams_by_frame(const Table& table) {
  const std::vector<double> frame = table.numbers("frame");
  const std::vector<double> dimension = table.numbers("dimension");
  const std::vector<double> birth = table.numbers("birth");
  const std::vector<double> death = table.numbers("death");
  const std::vector<double> essential = table.numbers("essential");
  std::map<std::int64_t, std::map<int, Points>> out;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    Points& points = out[static_cast<std::int64_t>(frame[k])][static_cast<int>(dimension[k])];
    points.birth_death.push_back(birth[k]);
    points.birth_death.push_back(death[k]);
    points.essential.push_back(essential[k] != 0 ? '\1' : '\0');
  }
  return out;
}

/// Components and loops always, voids where any frame of the system has some.
int last_dimension(const std::map<std::int64_t, std::map<int, Points>>& frames) {
  int last = 1;
  for (const auto& [frame, dimensions] : frames)
    if (!dimensions.empty()) last = std::max(last, dimensions.rbegin()->first);
  return last;
}

/// How many points are in each bin, as the measure persistence_bins counts them.
Json bins_json(const Points& points, int dimension, const MeasureOptions& options) {
  Diagram diagram;
  for (std::size_t k = 0; k < points.essential.size(); ++k)
    diagram.pairs.push_back(
        {dimension, points.birth_death[2 * k], points.birth_death[2 * k + 1], points.essential[k] != '\0', -1, -1});
  const BinCounts b = persistence_bins(diagram, dimension, bin_options(options));
  return {{"rough", b.rough}, {"strong", b.strong}, {"medium", b.medium}, {"weak", b.weak}};
}

Json diagram_json(const std::map<int, Points>& dimensions, int last, const MeasureOptions& options) {
  double largest = 1;
  for (const auto& [dimension, points] : dimensions) {
    for (const double value : points.birth_death) largest = std::max(largest, value);
  }
  Json list = Json::array();
  for (int dimension = 0; dimension <= last; ++dimension) {
    const auto found = dimensions.find(dimension);
    const Points points = found != dimensions.end() ? found->second : Points{};
    list.push_back({{"pairs", points.essential.size()},
                    {"values", packed_words(points.birth_death, 0, largest)},
                    {"essential", base64(points.essential)},
                    {"bins", bins_json(points, dimension, options)}});
  }
  return {{"dimensions", std::move(list)}, {"value_max", rounded(largest)}};
}

/// One list of frames per system, or null when all are empty.
template <class Frames>
Json per_system(const std::vector<PictureSource>& sources, const Frames& frames_of) {
  Json systems = Json::array();
  bool any = false;
  for (const PictureSource& source : sources) {
    Json frames = source.frames.empty() ? Json::array() : frames_of(source);
    any = any || !frames.empty();
    systems.push_back(std::move(frames));
  }
  return any ? Json{{"systems", std::move(systems)}} : Json();
}

Json labelled(const PictureSource& source, const PictureFrame& frame, Json data) {
  data["rho"] = rounded(frame.rho, 6);
  if (frame.own) data["own"] = true;
  if (!frame.stage.empty()) data["stage"] = frame.stage;
  data["realisation"] = source.task.realisation;
  return data;
}

}  // namespace

Json networks_block(const std::vector<PictureSource>& sources, const MeasureOptions& options) {
  return per_system(sources, [&](const PictureSource& source) {
    Json frames = Json::array();
    const RunFile run(source.folder.run_file(), Look::structure);
    for (const PictureFrame& frame : source.frames)
      frames.push_back(labelled(source, frame, drawing_json(drawing(run.frame(frame.stored), options))));
    return frames;
  });
}

Json diagrams_block(const std::vector<PictureSource>& sources, const MeasureOptions& options) {
  return per_system(sources, [&](const PictureSource& source) {
    Json frames = Json::array();
    const std::filesystem::path file = source.folder.tables() / "diagram.csv";
    if (!std::filesystem::exists(file)) return frames;
    const auto by_frame = diagrams_by_frame(read_csv(file));
    const int last = last_dimension(by_frame);
    std::map<std::size_t, PictureFrame> shown;  // by index in run.h5
    const auto take = [&](const PictureFrame& frame) {
      if (!by_frame.contains(static_cast<std::int64_t>(frame.stored))) return false;
      shown.insert({frame.stored, frame});
      return true;
    };
    for (const PictureFrame& frame : source.frames)
      if (!frame.own) take(frame);
    // Not every frame has a diagram: the next one that has stands in for the frame above rho_c.
    for (const PictureFrame& frame : source.frames)
      for (const PictureFrame& later : source.all)
        if (frame.own && later.rho >= frame.rho && take({later.rho, later.stored, true})) break;
    std::vector<PictureFrame> ordered;
    for (const auto& [stored, frame] : shown) ordered.push_back(frame);
    std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.rho < b.rho; });
    for (const PictureFrame& frame : ordered)
      frames.push_back(
          labelled(source, frame, diagram_json(by_frame.at(static_cast<std::int64_t>(frame.stored)), last, options)));
    return frames;
  });
}

}  // namespace jam
