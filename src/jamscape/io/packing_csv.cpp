#include "jamscape/io/packing_csv.hpp"

#include "jamscape/io/contact_table.hpp"
#include "jamscape/io/csv.hpp"
#include "jamscape/io/particle_table.hpp"

namespace jam {

ImportedPacking read_packing_csv(const std::filesystem::path& particles, const std::filesystem::path& contacts) {
  ImportedPacking imported;
  imported.packing = read_particles(CsvFile::read(particles), imported.notes);
  read_contacts(CsvFile::read(contacts), imported.packing, imported.notes);
  return imported;
}

void write_packing_csv(const Packing& packing, const std::filesystem::path& particles,
                       const std::filesystem::path& contacts) {
  write_csv(particles, particle_table(packing), particle_metadata(packing));
  write_csv(contacts, contact_table(packing), contact_metadata(packing));
}

}  // namespace jam
