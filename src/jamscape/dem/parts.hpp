// A large packing is cut into parts, so that several threads share a step: grains, which are in spatial order, by
// index, and wall beads, which go along their wall, too. The cut depends on the numbers of bodies alone, never on the
// number of threads, and so do the order of sums and every bit of a result.
//
//   pairs within a part    belong to it: all parts at a time
//   pairs of two parts     come after, in rounds: no part is in two pairs of parts of a round
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
  static constexpr std::size_t most_grains(int dimension) { return dimension == 2 ? 4096 : 8192; }
  /// Parts are a multiple of this many, about: two and four threads then have equal shares.
  static constexpr std::size_t even = 4;
  static constexpr std::size_t beads_of_part = 256;
  /// Grains of a part are a multiple of this, the tile of the pair list.
  static constexpr std::size_t tile = 64;

  Parts() = default;
  Parts(int dimension, std::size_t grains, std::size_t beads);

  /// That hold grains, the first ones.
  std::size_t with_grains() const { return with_grains_; }
  std::size_t size() const { return size_; }
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
  /// The same, and all beads with the last one.
  Range bodies(std::size_t part) const {
    return {part * length_, part + 1 == with_grains_ ? grains_ + beads_ : (part + 1) * length_};
  }

 private:
  std::size_t grains_ = 0, beads_ = 0, length_ = 0, with_grains_ = 1, size_ = 1;
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
