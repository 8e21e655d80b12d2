#include "soup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/job.h"
#include "mesh/repair/weld.h"

namespace limber::fuzz {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

void addVertex(Soup& soup, double x, double y, double z) {
  for (const double value : {x, y, z}) soup.positions.push_back(static_cast<float>(value));
}

void addTriangle(Soup& soup, uint32_t a, uint32_t b, uint32_t c) {
  soup.indices.insert(soup.indices.end(), {a, b, c});
}

uint32_t vertexCount(const Soup& soup) {
  return static_cast<uint32_t>(soup.positions.size() / 3);
}

// A strip of `columns` x `rows` quads whose sides may be joined, with or without a twist.
struct Strip {
  uint32_t columns, rows;
  bool joinsColumns, joinsRows, isTwisted;
};

uint32_t stripVertex(const Strip& strip, uint32_t first, uint32_t column, uint32_t row) {
  const uint32_t rowVertices = strip.joinsRows ? strip.rows : strip.rows + 1;
  if (strip.joinsColumns && column == strip.columns) {
    column = 0;
    if (strip.isTwisted) row = strip.rows - row;
  }
  return first + column * rowVertices + (strip.joinsRows ? row % strip.rows : row);
}

void addStrip(Soup& soup, const Strip& strip) {
  const uint32_t first = vertexCount(soup);
  const uint32_t columns = strip.joinsColumns ? strip.columns : strip.columns + 1;
  const uint32_t rows = strip.joinsRows ? strip.rows : strip.rows + 1;
  for (uint32_t i = 0; i < columns; ++i)
    for (uint32_t j = 0; j < rows; ++j) {
      const double u = static_cast<double>(i) / strip.columns, v = static_cast<double>(j) / strip.rows;
      const double around = kTurn * u, across = strip.isTwisted ? around / 2 : kTurn * v;
      if (strip.isTwisted)
        addVertex(soup, (2 + (v - 0.5) * std::cos(across)) * std::cos(around),
                  (2 + (v - 0.5) * std::cos(across)) * std::sin(around), (v - 0.5) * std::sin(across));
      else if (strip.joinsColumns && strip.joinsRows)
        addVertex(soup, (2 + std::cos(across)) * std::cos(around), (2 + std::cos(across)) * std::sin(around),
                  std::sin(across));
      else if (strip.joinsColumns)
        addVertex(soup, std::cos(around), std::sin(around), 2 * v);
      else
        addVertex(soup, u, v, 0.1 * std::sin(5 * u) * std::cos(3 * v));
    }
  for (uint32_t i = 0; i < strip.columns; ++i)
    for (uint32_t j = 0; j < strip.rows; ++j) {
      const uint32_t a = stripVertex(strip, first, i, j), b = stripVertex(strip, first, i + 1, j),
                     c = stripVertex(strip, first, i + 1, j + 1), d = stripVertex(strip, first, i, j + 1);
      addTriangle(soup, a, b, c);
      addTriangle(soup, a, c, d);
    }
}

void addRandomTriangles(Soup& soup, FuzzInput& input, uint32_t count) {
  const uint32_t vertices = 3 + input.below(count + 3), first = vertexCount(soup);
  for (uint32_t v = 0; v < vertices; ++v)
    addVertex(soup, input.real(-1, 1), input.real(-1, 1), input.chance(128) ? 0 : input.real(-1, 1));
  for (uint32_t t = 0; t < count; ++t)
    addTriangle(soup, first + input.below(vertices), first + input.below(vertices),
                first + input.below(vertices));
}

// Triangles that have one vertex, or one edge, in common.
void addFans(Soup& soup, FuzzInput& input, uint32_t count, bool shareAnEdge) {
  const uint32_t first = vertexCount(soup);
  addVertex(soup, 0, 0, 0);
  addVertex(soup, 0, 0, 1);
  for (uint32_t t = 0; t < count; ++t) {
    const double angle = kTurn * t / count;
    addVertex(soup, std::cos(angle), std::sin(angle), input.real(0, 1));
    addVertex(soup, std::cos(angle + 0.1), std::sin(angle + 0.1), input.real(0, 1));
    const uint32_t c = first + 2 + 2 * t;
    if (shareAnEdge)
      addTriangle(soup, first, first + 1, c);
    else
      addTriangle(soup, first, c, c + 1);
  }
}

void addShape(Soup& soup, FuzzInput& input, uint32_t mostTriangles) {
  const uint32_t size = 1 + input.below(static_cast<uint32_t>(std::sqrt(mostTriangles / 2.0)));
  const uint32_t count = 1 + input.below(mostTriangles);
  const uint32_t columns = std::max<uint32_t>(3, size),
                 rows = std::max<uint32_t>(1, mostTriangles / 2 / columns);
  switch (input.byte() % 8) {
    case 0:
      return addStrip(soup, {columns, rows, false, false, false});
    case 1:
      return addStrip(soup, {columns, rows, true, false, false});
    case 2:
      return addStrip(soup, {columns, std::max<uint32_t>(3, rows), true, true, false});
    case 3:
      return addStrip(soup, {columns, rows, true, false, true});
    case 4:
      return addFans(soup, input, count, false);
    case 5:
      return addFans(soup, input, count, true);
    case 6:  // many parts
      for (uint32_t part = 0; part < count / 4; ++part) {
        const uint32_t a = vertexCount(soup);
        const double x = input.real(-5, 5), y = input.real(-5, 5);
        addVertex(soup, x, y, 0);
        addVertex(soup, x + 1, y, 0);
        addVertex(soup, x, y + 1, 0);
        addVertex(soup, x, y, 1);
        addTriangle(soup, a, a + 2, a + 1);
        addTriangle(soup, a, a + 1, a + 3);
        addTriangle(soup, a + 1, a + 2, a + 3);
        addTriangle(soup, a, a + 3, a + 2);
      }
      return;
    default:
      return addRandomTriangles(soup, input, count);
  }
}

void damage(Soup& soup, FuzzInput& input) {
  const uint32_t triangles = static_cast<uint32_t>(soup.indices.size() / 3);
  const auto anyIndex = [&] { return input.below(static_cast<uint32_t>(soup.indices.size())); };
  switch (input.byte() % 6) {
    case 0:  // a coordinate that is anything
      soup.positions[input.below(static_cast<uint32_t>(soup.positions.size()))] = input.anyFloat();
      break;
    case 1:  // a corner elsewhere, rarely out of range
      soup.indices[anyIndex()] =
          input.chance(16) ? vertexCount(soup) + input.below(10) : input.below(vertexCount(soup));
      break;
    case 2: {  // a face again, and turned
      const uint32_t t = 3 * input.below(triangles);
      addTriangle(soup, soup.indices[t], soup.indices[t + 2], soup.indices[t + 1]);
      break;
    }
    case 3: {  // a face turned
      const uint32_t t = 3 * input.below(triangles);
      std::swap(soup.indices[t], soup.indices[t + 1]);
      break;
    }
    case 4: {  // two vertices at one place
      const uint32_t a = 3 * input.below(vertexCount(soup)), b = 3 * input.below(vertexCount(soup));
      std::copy_n(soup.positions.begin() + b, 3, soup.positions.begin() + a);
      break;
    }
    default: {  // a vertex elsewhere
      const uint32_t v = 3 * input.below(vertexCount(soup));
      for (uint32_t c = 0; c < 3; ++c) soup.positions[v + c] = static_cast<float>(input.real(-3, 3));
    }
  }
}

}  // namespace

Soup drawSoup(FuzzInput& input, uint32_t mostTriangles) {
  Soup soup;
  const uint32_t shapes = 1 + input.byte() % 3;
  for (uint32_t k = 0; k < shapes; ++k) addShape(soup, input, mostTriangles / shapes);
  if (soup.indices.empty()) return soup;
  for (uint32_t k = input.byte() % 16; k > 0; --k) damage(soup, input);
  if (input.chance(64)) {
    const auto scale = static_cast<float>(std::pow(10, input.real(-30, 30)));
    const bool isFlat = input.chance(64);
    for (size_t i = 0; i < soup.positions.size(); ++i)
      if (!isFlat || i % 3 != 0) soup.positions[i] *= scale;
  }
  return soup;
}

TriangleMesh drawMesh(FuzzInput& input, uint32_t mostTriangles) {
  Soup soup = drawSoup(input, mostTriangles);
  for (float& value : soup.positions)
    if (!std::isfinite(value)) value = 0;
  for (uint32_t& v : soup.indices) v %= std::max<uint32_t>(1, vertexCount(soup));
  Job job;
  return weld(soup.positions, soup.indices, {}, job).mesh;
}

}  // namespace limber::fuzz
