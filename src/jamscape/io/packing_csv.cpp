#include "jamscape/io/packing_csv.hpp"

#include <fmt/format.h>

#include <utility>

#include "jamscape/base/error.hpp"
#include "jamscape/io/contact_table.hpp"
#include "jamscape/io/frame_column.hpp"
#include "jamscape/io/number_text.hpp"
#include "jamscape/io/particle_table.hpp"

namespace jam {

ImportedPacking read_packing_csv(const std::filesystem::path& particles, const std::filesystem::path& contacts) {
  CsvFile grains = CsvFile::read(particles);
  return read_packing(std::move(grains), CsvFile::read(contacts), {});
}

ImportedPacking read_packing(CsvFile particles, CsvFile contacts, std::optional<double> frame) {
  ImportedPacking imported;
  const bool grains = tells_frames(particles),
             pairs = tells_frames(contacts);  // one may be of the frame and not say so
  const FrameRows p = one_frame(std::move(particles), grains || !pairs ? frame : std::nullopt);
  const FrameRows c = one_frame(std::move(contacts), pairs ? frame : std::nullopt);
  if (p.frame && c.frame && *p.frame != *c.frame)
    throw data_error(
        fmt::format("the grains are of frame {}, the contacts of frame {}", to_text(*p.frame), to_text(*c.frame)),
        c.table.file(), "give two tables of one frame");
  imported.packing = read_particles(p.table, imported.notes).packing;
  read_contacts(c.table, imported.packing, imported.notes);
  return imported;
}

void write_packing_csv(const Packing& packing, const std::filesystem::path& particles,
                       const std::filesystem::path& contacts) {
  write_csv(particles, particle_table(packing), particle_metadata(packing));
  write_csv(contacts, contact_table(packing), contact_metadata(packing));
}

}  // namespace jam
