// A large packing is cut into parts, so that several threads share a step: grains, which are in spatial order, by
// index, and wall beads, which go along their wall, too. The cut depends on the numbers of bodies alone, never on the
// number of threads, and so do the order of sums and every bit of a result.
//
//   pairs of two parts     come first, in rounds: no part is in two pairs of parts of a round
//   pairs within a part    come after, all parts at a time, stretch by stretch: a stretch of grains has the pairs whose
//                          first body is in it. No body comes before the first one of its pairs, so then the forces on
//                          the stretch are complete, and it is moved while the cache still holds it
//   sums (energies, ...)   are taken by part, and added in the order of parts
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace jam {

class Parts {
 public:
  /// Fewer grains than this are one part, together with all beads: threads would gain little there.
  static constexpr std::size_t least_grains = 20000;
  /// Grains of a part at most. Smaller parts share more pairs with others, whose bodies have to be fetched once more:
  /// spheres more than discs. Larger ones leave too few for many threads.
  static constexpr std::size_t most_grains(int dimension) { return dimension == 2 ? 4096 : 32768; }
  /// Parts are a multiple of this many, about: two threads then have equal shares.
  static constexpr std::size_t even = 2;
  static constexpr std::size_t beads_of_part = 256;
  /// Grains of a stretch; a packing of one part is one stretch.
  static constexpr std::size_t stretch_length = 1024;
  /// The widest tile of the pair list; stretches are a multiple of it.
  static constexpr std::size_t widest_tile = 64;

  Parts() = default;
  Parts(int dimension, std::size_t grains, std::size_t beads);

  /// Threads that find something to do, of so many: one for each part with grains.
  int threads_of_use(int wanted) const { return std::clamp(wanted, 1, static_cast<int>(with_grains_)); }
  /// That hold grains, the first ones.
  std::size_t with_grains() const { return with_grains_; }
  std::size_t size() const { return size_; }
  /// Grains of a tile of the pair list. Out of the cache, fewer bodies in use at a time are better.
  std::size_t tile() const { return with_grains_ == 1 ? widest_tile : widest_tile / 2; }
  std::uint32_t of(std::size_t body) const {
    if (size_ == 1) return 0;
    return static_cast<std::uint32_t>(body < grains_ ? body / length_
                                                     : with_grains_ + (body - grains_) / beads_of_part);
  }

  struct Range {
    std::size_t begin, end;
  };
  /// The grains of a part that holds some.
  Range grains(std::size_t part) const { return {part * length_, std::min(grains_, (part + 1) * length_)}; }
  /// Stretches are counted through all parts.
  std::size_t stretches() const { return stretches_; }
  /// Those of a part that holds grains.
  Range stretches_of(std::size_t part) const {
    const std::size_t each = length_ / stretch_;
    return {part * each, std::min((part + 1) * each, stretches_)};
  }
  std::size_t stretch_of(std::size_t grain) const { return grain / stretch_; }
  /// The grains of a stretch.
  Range stretch(std::size_t s) const { return {s * stretch_, std::min(grains_, (s + 1) * stretch_)}; }
  /// The same, and all beads with the last one.
  Range bodies_of_stretch(std::size_t s) const {
    return {stretch(s).begin, s + 1 == stretches_ ? grains_ + beads_ : stretch(s).end};
  }

 private:
  std::size_t grains_ = 0, beads_ = 0;
  std::size_t length_ = 1, stretch_ = 1;  // grains of a part and of a stretch at most
  std::size_t with_grains_ = 1, size_ = 1, stretches_ = 1;
};

/// Two parts a < b, and how many pairs of bodies they share.
struct Neighbours {
  std::uint32_t a, b;
  std::size_t pairs;
};

/// The round of each: in one round, no part occurs twice. The ones with most pairs come first, so that they share
/// rounds with their like and threads wait little for each other.
std::vector<std::uint32_t> deal_rounds(std::span<const Neighbours> neighbours, std::size_t parts);

}  // namespace jam
