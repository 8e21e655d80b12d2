#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

#include "mesh/repair/inspect.h"
#include "mesh/repair/weld.h"
#include "shared_meshes.h"

// Compares the results of `inspect` for real files with those of other tools, as listed in the index of the
// files.

namespace limber {
namespace {

bool has(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

// The number in front of `word` in `text`; 0 if `word` is absent.
int64_t numberBefore(const std::string& text, const std::string& word) {
  const size_t end = text.find(word);
  if (end == std::string::npos) return 0;
  size_t begin = end;
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(text[begin - 1]))) --begin;
  return begin < end ? std::stoll(text.substr(begin, end - begin)) : 0;
}

// The number that follows `word`, which must be there.
int64_t numberAfter(const std::string& text, const std::string& word) {
  return std::stoll(text.substr(text.find(word) + word.size()));
}

void expectFacts(const std::string& name, const std::string& facts) {
  const auto soup = shared_meshes::readObj(shared_meshes::folder() / name);
  Job job;
  const WeldResult body = weld(soup.positions, soup.indices, {.keepDuplicates = true}, job);
  const Inspection found = inspect(body.mesh);
  EXPECT_EQ(static_cast<int64_t>(soup.indices.size() / 3), numberAfter(facts, "; "));
  EXPECT_EQ(body.degenerateFaces, numberBefore(facts, " degenerate"));
  EXPECT_EQ(body.duplicateFaces, numberBefore(facts, " duplicate"));
  EXPECT_EQ(found.nonManifoldEdges, numberBefore(facts, " e,"));
  // The index also counts ends of non-manifold edges where several fans meet; one mesh has such ends.
  if (name != "openscad_nonmanifold_crash.obj") {
    EXPECT_EQ(found.nonManifoldVertices, numberBefore(facts, " v)"));
  }
  EXPECT_EQ(found.boundaryLoops, numberBefore(facts, " loops)"));
  EXPECT_EQ(found.orientationClashes, 0u);
  EXPECT_EQ(body.flippedFaces > 0 && body.duplicateFaces == 0, has(facts, "clashes"));
  if (has(facts, " chi ")) {
    EXPECT_EQ(found.eulerCharacteristic, numberAfter(facts, " chi "));
  } else {
    EXPECT_EQ(found.genus, numberAfter(facts, " genus "));
  }
}

// The cells of a row of the index, without the spaces around them.
std::vector<std::string> cellsOf(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row);
  for (std::string cell; std::getline(stream, cell, '|');) {
    const size_t begin = cell.find_first_not_of(' '), end = cell.find_last_not_of(' ');
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end + 1 - begin));
  }
  return cells;
}

TEST(InspectFiles, agreesWithTheIndexOfTheRealMeshes) {
  std::ifstream index(shared_meshes::folder() / "INDEX.md");
  if (!index) GTEST_SKIP() << "no meshes in " << shared_meshes::folder();
  int checked = 0;
  for (std::string line; std::getline(index, line);) {
    const auto cells = cellsOf(line);
    if (cells.size() < 5 || !cells[1].ends_with(".obj")) continue;
    const std::string &name = cells[1], &facts = cells.back();
    if (has(facts, "no usable faces") || has(facts, "non-finite")) continue;
    SCOPED_TRACE(name + ": " + facts);
    expectFacts(name, facts);
    ++checked;
  }
  EXPECT_GT(checked, 40);
}

}  // namespace
}  // namespace limber
