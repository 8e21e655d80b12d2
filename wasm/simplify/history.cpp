#include "simplify/history.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace limber {

void refuseHistory() {
  throw std::invalid_argument(
      "The history does not belong to this mesh: simplify the mesh again and use the history of that.");
}

void checkBelongs(const TriangleMesh& input, const History& history) {
  const size_t count = history.kept.size();
  const auto outside = [&](uint32_t v) { return v >= history.vertexCount; };
  const bool fits = history.vertexCount == input.vertexCount() &&
                    history.triangleCount == input.triangleCount() && history.removed.size() == count &&
                    history.trianglesAfter.size() == count && history.positions.size() == 3 * count &&
                    std::ranges::none_of(history.kept, outside) &&
                    std::ranges::none_of(history.removed, outside) &&
                    std::ranges::is_sorted(history.trianglesAfter, std::ranges::greater_equal()) &&
                    (count == 0 || history.trianglesAfter[0] < history.triangleCount);
  if (!fits) refuseHistory();
}

uint32_t collapsesFor(const History& history, uint32_t faces) {
  if (history.triangleCount <= faces) return 0;
  const auto reached = std::ranges::lower_bound(history.trianglesAfter, faces, std::greater());
  const auto index = static_cast<uint32_t>(reached - history.trianglesAfter.begin());
  return std::min(index + 1, history.collapseCount());
}

namespace {

// Returns for each input vertex the vertex that it has been merged into after `count` collapses. Goes
// backwards, so that the survivor of kept[i] is already known when removed[i] needs it.
std::vector<uint32_t> findSurvivors(const History& history, size_t count) {
  std::vector<uint32_t> survivor(history.vertexCount);
  std::iota(survivor.begin(), survivor.end(), 0);
  for (size_t i = count; i-- > 0;) survivor[history.removed[i]] = survivor[history.kept[i]];
  return survivor;
}

// Appends every triangle and advances only if it remains: branch-free, because branches would be
// unpredictable.
void collectTriangles(const TriangleMesh& input, const std::vector<uint32_t>& survivor, uint32_t expected,
                      MeshAt& result) {
  result.mesh.triangles.resize(size_t{expected} + 1);
  result.inputOfTriangle.resize(size_t{expected} + 1);
  uint32_t count = 0;
  for (uint32_t t = 0; t < input.triangleCount(); ++t) {
    const auto& [a, b, c] = input.triangles[t];
    const Triangle triangle{survivor[a], survivor[b], survivor[c]};
    result.mesh.triangles[count] = triangle;
    result.inputOfTriangle[count] = t;
    const auto differ = [&](int i, int j) { return static_cast<uint32_t>(triangle[i] != triangle[j]); };
    count += differ(0, 1) & differ(1, 2) & differ(2, 0);  // branch-free
    if (count > expected) refuseHistory();
  }
  result.mesh.triangles.resize(count);
  result.inputOfTriangle.resize(count);
}

// Numbers the vertices that triangles use in the order of the input; all others get the number after the
// last. Branch-free, because branches would be unpredictable.
std::vector<uint32_t> numberVertices(const TriangleMesh& input, MeshAt& result) {
  std::vector<uint32_t> number(input.vertexCount(), 0);
  for (const Triangle& triangle : result.mesh.triangles)
    for (uint32_t v : triangle) number[v] = 1;
  const auto usedCount = static_cast<uint32_t>(std::ranges::count(number, 1u));
  result.inputOfVertex.resize(size_t{usedCount} + 1);
  result.mesh.positions.resize(size_t{usedCount} + 1);
  uint32_t count = 0;
  for (uint32_t v = 0; v < input.vertexCount(); ++v) {
    const uint32_t used = number[v];
    number[v] = used ? count : usedCount;
    result.inputOfVertex[count] = v;
    result.mesh.positions[count] = input.positions[v];
    count += used;
  }
  result.inputOfVertex.resize(usedCount);
  return number;
}

// Moves the vertices to their positions after `count` collapses.
void positionVertices(const History& history, size_t count, const std::vector<uint32_t>& number,
                      MeshAt& result) {
  for (size_t i = 0; i < count; ++i)
    result.mesh.positions[number[history.kept[i]]] = {history.positions[3 * i], history.positions[3 * i + 1],
                                                      history.positions[3 * i + 2]};
  result.mesh.positions.resize(result.inputOfVertex.size());  // the last one is for vertices without a number
}

// Replaces the indices of vertices in the input by their numbers.
void renumber(const std::vector<uint32_t>& survivor, const std::vector<uint32_t>& number, MeshAt& result) {
  const auto usedCount = static_cast<uint32_t>(result.inputOfVertex.size());
  for (Triangle& triangle : result.mesh.triangles)
    for (uint32_t& v : triangle) v = number[v];
  result.vertexOfInput.resize(survivor.size());
  for (size_t v = 0; v < survivor.size(); ++v) {
    const uint32_t vertex = number[survivor[v]];
    result.vertexOfInput[v] = vertex == usedCount ? kNone : vertex;
  }
}

}  // namespace

MeshAt meshAt(const TriangleMesh& input, const History& history, uint32_t faces) {
  checkBelongs(input, history);
  const size_t count = collapsesFor(history, faces);
  const auto survivor = findSurvivors(history, count);
  MeshAt result;
  const uint32_t expected = count > 0 ? history.trianglesAfter[count - 1] : input.triangleCount();
  collectTriangles(input, survivor, expected, result);
  if (count > 0 && result.mesh.triangleCount() != expected) refuseHistory();
  const auto number = numberVertices(input, result);
  positionVertices(history, count, number, result);
  renumber(survivor, number, result);
  return result;
}

}  // namespace limber
