// A column over Z/2 as a set of row indices: a bit for each row, and above 64 of them a bit that says whether any is
// set. Toggling a row and finding the largest cost one word per level; an emptied column is clean for the next. The
// idea is PHAT's bit tree (Bauer, Kerber, Reininghaus, Wagner 2017).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace jam {

class BitColumn {
 public:
  /// Ready for rows 0..rows-1, and empty.
  void reset(std::size_t rows) {
    std::size_t total = 0;
    levels_ = 0;
    do {
      rows = rows > 64 ? (rows + 63) / 64 : 1;
      begin_[levels_++] = total;
      total += rows;
    } while (rows > 1);
    words_.assign(total, 0);
  }

  bool empty() const { return words_[begin_[levels_ - 1]] == 0; }

  /// Adds a row, or takes it out if it is there: a sum over Z/2.
  void toggle(std::size_t row) {
    for (std::size_t level = 0; level < levels_; ++level) {
      auto& word = words_[begin_[level] + row / 64];
      const auto before = word;
      word ^= std::uint64_t{1} << (row % 64);
      if (before != 0 && word != 0) return;
      row /= 64;
    }
  }

  /// The largest row; the column must not be empty.
  std::size_t largest() const {
    std::size_t row = 0;
    for (std::size_t level = levels_; level-- > 0;) {
      row = row * 64 + 63 - static_cast<std::size_t>(std::countl_zero(words_[begin_[level] + row]));
    }
    return row;
  }

 private:
  std::vector<std::uint64_t> words_;
  std::array<std::size_t, 8> begin_{};
  std::size_t levels_ = 0;
};

}  // namespace jam
