#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "fuzz_targets.h"

// The fuzz targets of the core, with all inputs that have ever failed and with random inputs. `npm run fuzz`
// looks for more.

namespace limber::fuzz {
namespace {

class EveryFuzzTarget : public testing::TestWithParam<FuzzTarget> {};

TEST_P(EveryFuzzTarget, keepsItsPromisesWithWhatOnceFailed) {
  const auto folder = std::filesystem::path(LIMBER_FUZZ_FINDINGS) / GetParam().name;
  if (!std::filesystem::exists(folder)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<uint8_t> bytes(std::istreambuf_iterator<char>(file), {});
    runTarget(GetParam(), bytes);
  }
}

TEST_P(EveryFuzzTarget, keepsItsPromisesWithRandomBytes) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::vector<uint8_t> bytes(random() % 512);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
    runTarget(GetParam(), bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryFuzzTarget, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace limber::fuzz
