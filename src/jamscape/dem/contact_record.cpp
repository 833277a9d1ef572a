#include "jamscape/dem/contact_record.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "jamscape/base/error.hpp"

namespace jam {

EnergyLedger ledger_of(const Booked& booked, double kinetic, const ElasticEnergy& elastic, NormalLaw kind) {
  EnergyLedger ledger;
  ledger.kinetic = kinetic;
  ledger.elastic = elastic.normal + elastic.tangential;
  ledger.damped = booked.damped;
  ledger.rubbed = hertzian(kind) ? booked.rubbed - elastic.tangential : booked.rubbed;
  ledger.wall_work = booked.wall_work;
  ledger.gravity_work = booked.gravity_work;
  return ledger;
}

void sort_contacts(Contacts& c) {
  std::vector<std::size_t> order(c.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(c.i[a], c.j[a], c.part_i[a], c.part_j[a]) < std::tuple(c.i[b], c.j[b], c.part_i[b], c.part_j[b]);
  });
  const auto permute = [&](auto& values) {
    const auto old = values;
    for (std::size_t k = 0; k < order.size(); ++k) values[k] = old[order[k]];
  };
  permute(c.i), permute(c.j), permute(c.part_i), permute(c.part_j), permute(c.image), permute(c.overlap);
  permute(c.normal_force), permute(c.normal), permute(c.tangential_force), permute(c.point), permute(c.sliding);
}

void refuse_sums(const std::string& body, std::int64_t step) {
  throw Error(ExitCode::bug, "the contacts of " + body + " at step " + std::to_string(step) +
                                 " do not add up to the force it was moved with");
}

}  // namespace jam
