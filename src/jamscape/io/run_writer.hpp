// Writes frames, one after another, into an open HDF5 file in the layout of run_file.hpp.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/io/run_layout.hpp"
#include "jamscape/packing/fields.hpp"

namespace jam {

class RunWriter {
 public:
  /// For exactly `frames` frames.
  RunWriter(hdf5::Group root, std::size_t frames);
  /// Throws a data error for a 2D packing with something out of its plane, one of another dimension or with other
  /// shapes than the first, and for clusters that could not be read back (shape_list.hpp).
  void append(const Packing& packing);
  /// Writes what stands once a file or once a frame; nothing can be appended afterwards.
  void finish(const Provenance& provenance);

 private:
  hdf5::Group make(hdf5::Group& parent, const char* name) const;
  void append_grains(const Grains& grains);
  void append_contacts(const Contacts& contacts);
  void append_walls(const std::vector<Wall>& walls);
  template <class T>
  void append_property(const Field<Grains, std::vector<T>>& field, const Grains& now);
  template <class T>
  void append_grain_row(const char* name, std::size_t frame, std::span<const T> values, hsize_t width);
  template <class T>
  void append_rows(hdf5::Group& group, const std::string& name, std::span<const T> values, hsize_t width);
  template <class T>
  void finish_element(hdf5::Group& parent, const char* name, const std::vector<T>& values, const hdf5::Shape& shape);
  void finish_box();
  void finish_knowledge();
  void link_times(hdf5::Group& group);

  hdf5::Group root_, frames_, particles_, all_, contacts_, walls_;
  std::int32_t layout_ = run_layout::upright_version;
  std::size_t planned_;
  Packing first_;                                ///< lasting properties of the grains, dimension, domain, shapes
  std::vector<Packing> heads_;                   ///< of each frame what is one value a frame
  std::map<std::string, hdf5::Group> elements_;  ///< time-dependent members of particles/all
  std::map<std::string, hdf5::Dataset> open_;    ///< arrays that grow; kept open for the sake of their chunk caches

  std::vector<std::int64_t> grains_;
  std::vector<std::uint64_t> contact_offset_{0}, wall_offset_{0}, bead_offset_{0};
};

}  // namespace jam
