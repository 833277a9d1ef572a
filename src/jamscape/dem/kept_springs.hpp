// The tangential springs of a list of pairs, for the list that replaces it.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "jamscape/dem/pair_list.hpp"

namespace jam {

/// The springs of an old list by the places of its bodies at that time.
template <int D>
class KeptSprings {
 public:
  KeptSprings(const PairList<D>& old, std::size_t grains) : old_(old) {
    first_.assign(grains + 1, 0);
    std::vector<std::size_t> held;
    held.reserve(old.touching() + old.touching() / 8);
    for (std::size_t k = 0; k < old.size(); ++k) {
      bool any = false;
      for (std::size_t c = 0; c < PairList<D>::spring_size; ++c) any |= old.spring(k)[c * block] != 0;
      if (!any) continue;
      held.push_back(k);
      ++first_[old.i[k] + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    partner_.resize(held.size());
    pair_.resize(held.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const std::size_t k : held) {
      const std::uint32_t at = next[old.i[k]]++;
      partner_[at] = old.j[k];
      pair_[at] = k;
    }
  }

  /// Copies the spring of the pair (a, b), if there is one, into `to` (stride `block`).
  void fetch(std::uint32_t a, std::uint32_t b, double* to) const {
    if (!copy(a, b, 1.0, to) && b + 1 < first_.size()) copy(b, a, D == 2 ? 1.0 : -1.0, to);
  }

 private:
  bool copy(std::uint32_t a, std::uint32_t b, double sign, double* to) const {
    for (std::uint32_t q = first_[a]; q < first_[a + 1]; ++q)
      if (partner_[q] == b) {
        for (std::size_t c = 0; c < PairList<D>::spring_size; ++c)
          to[c * block] = sign * old_.spring(pair_[q])[c * block];
        return true;
      }
    return false;
  }

  const PairList<D>& old_;
  std::vector<std::uint32_t> first_, partner_;
  std::vector<std::size_t> pair_;
};

}  // namespace jam
