#pragma once

// Real meshes that may exist next to the repository; the tests that use them are skipped without them.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace limber::shared_meshes {

// The folder of the meshes: $LIMBER_SHARED/meshes, or ../shared/meshes next to the repository. May not exist.
inline std::filesystem::path folder() {
  const char* given = std::getenv("LIMBER_SHARED");
  const auto shared = given ? std::filesystem::path(given)
                            : std::filesystem::path(__FILE__).parent_path() / "../../../shared";
  return shared / "meshes";
}

// A triangle soup as `weld` takes it.
struct Soup {
  std::vector<float> positions;
  std::vector<uint32_t> indices;
};

// Reads positions and faces of an OBJ file, nothing else; polygons become fans.
inline Soup readObj(const std::filesystem::path& path) {
  Soup soup;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      for (int c = 0; c < 3 && words >> word; ++c)
        soup.positions.push_back(std::strtof(word.c_str(), nullptr));
    } else if (word == "f") {
      std::vector<uint32_t> face;
      const long count = static_cast<long>(soup.positions.size() / 3);
      while (words >> word) {
        const long index = std::strtol(word.c_str(), nullptr, 10);
        face.push_back(static_cast<uint32_t>(index < 0 ? count + index : index - 1));
      }
      for (size_t i = 2; i < face.size(); ++i)
        soup.indices.insert(soup.indices.end(), {face[0], face[i - 1], face[i]});
    }
  }
  return soup;
}

}  // namespace limber::shared_meshes
