#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <regex>
#include <string>

#include "mesh/inspect.h"
#include "mesh/weld.h"
#include "shared_meshes.h"

// Compares what we find in real files with what other tools found, as their index lists it.

namespace limber {
namespace {

// The number that `pattern` captures in `text`, or `otherwise`.
int64_t number(const std::string& text, const char* pattern, int64_t otherwise) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? std::stol(match[1]) : otherwise;
}

void expectFacts(const std::string& name, const std::string& facts) {
  const auto soup = shared_meshes::readObj(shared_meshes::folder() / name);
  Job job;
  const WeldResult body = weld(soup.positions, soup.indices, {.keepDuplicates = true}, job);
  const Inspection found = inspect(body.mesh);
  EXPECT_EQ(body.degenerateFaces, number(facts, R"((\d+) degenerate)", 0));
  EXPECT_EQ(body.duplicateFaces, number(facts, R"((\d+) duplicate)", 0));
  EXPECT_EQ(static_cast<int64_t>(soup.indices.size() / 3), number(facts, R"(; (\d+)[ ;])", 0));
  EXPECT_EQ(found.nonManifoldEdges, number(facts, R"((\d+) e,)", 0));
  // The index also counts ends of non-manifold edges where several fans meet; one mesh has such.
  if (name != "openscad_nonmanifold_crash.obj")
    EXPECT_EQ(found.nonManifoldVertices, number(facts, R"(e, (\d+) v\))", 0));
  EXPECT_EQ(found.boundaryLoops, number(facts, R"(\((\d+) loops\))", 0));
  EXPECT_EQ(found.orientationClashes, 0u);
  EXPECT_EQ(body.flippedFaces > 0 && body.duplicateFaces == 0, facts.find("clashes") != std::string::npos);
  if (facts.find(" chi ") != std::string::npos)
    EXPECT_EQ(found.eulerCharacteristic, number(facts, R"( chi (-?\d+))", 0));
  else
    EXPECT_EQ(found.genus, number(facts, R"( genus (\d+))", -1));
}

TEST(InspectFiles, agreesWithTheIndexOfTheRealMeshes) {
  std::ifstream index(shared_meshes::folder() / "INDEX.md");
  if (!index) GTEST_SKIP() << "no meshes in " << shared_meshes::folder();
  const std::regex row(R"(\| (\S+\.obj) \|.*\| ([^|]*) \|)");
  int checked = 0;
  std::smatch match;
  for (std::string line; std::getline(index, line);) {
    if (!std::regex_match(line, match, row)) continue;
    const std::string name = match[1], facts = match[2];
    if (facts.find("no usable faces") != std::string::npos || facts.find("non-finite") != std::string::npos)
      continue;
    SCOPED_TRACE(name + ": " + facts);
    expectFacts(name, facts);
    ++checked;
  }
  EXPECT_GT(checked, 40);
}

}  // namespace
}  // namespace limber
