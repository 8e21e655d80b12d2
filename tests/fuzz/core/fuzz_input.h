#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>

namespace limber::fuzz {

// Draws numbers from the bytes of a fuzzer: the same bytes give the same numbers, and where the bytes are
// used up all numbers are 0.
class FuzzInput {
 public:
  explicit FuzzInput(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : 0; }
  // In [0, count); count > 0.
  uint32_t below(uint32_t count) { return (byte() | static_cast<uint32_t>(byte()) << 8) % count; }
  bool chance(uint32_t outOf256) { return byte() < outOf256; }
  // In [low, high], in 65,536 steps.
  double real(double low, double high) { return low + (high - low) * below(65536) / 65535; }

  // Any float: special values, powers of ten, or four raw bytes.
  float anyFloat() {
    using Limits = std::numeric_limits<float>;
    constexpr float kSpecial[] = {0,
                                  -0.0f,
                                  1,
                                  -1,
                                  Limits::infinity(),
                                  -Limits::infinity(),
                                  Limits::quiet_NaN(),
                                  Limits::denorm_min(),
                                  Limits::min(),
                                  Limits::max(),
                                  Limits::lowest(),
                                  1e-30f,
                                  1e30f,
                                  Limits::epsilon(),
                                  16777217.0f,
                                  1e-20f};
    switch (byte() % 3) {
      case 0:
        return kSpecial[byte() % std::size(kSpecial)];
      case 1:
        return static_cast<float>(std::pow(10, real(-40, 38)));
      default: {
        uint32_t bits = 0;
        for (int k = 0; k < 4; ++k) bits = bits << 8 | byte();
        return std::bit_cast<float>(bits);
      }
    }
  }

  bool isUsedUp() const { return at_ >= bytes_.size(); }

 private:
  std::span<const uint8_t> bytes_;
  size_t at_ = 0;
};

}  // namespace limber::fuzz
