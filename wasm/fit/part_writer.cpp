#include "fit/part_writer.h"

#include <numeric>

#include "mesh/corner.h"

namespace limber {

namespace {

Vec3 inFile(const Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Sets the position of a vertex and, with symmetry, that of its image.
void writePosition(uint32_t v, const Vec3& position, const ResultMirror* mirror,
                   std::vector<Vec3>& positions) {
  const uint32_t image = mirror ? mirror->partners[v] : v;
  positions[v] = inFile(mirror && image == v ? mirror->plane.onto(position) : position);
  if (image != v) positions[image] = inFile(mirror->plane.image(positions[v]));
}

// Sets the triangle that is the mirror image of triangle t.
void writeImage(uint32_t t, const ResultMirror& mirror, const TriangleMesh& before, MeshAt& result) {
  const uint32_t image = mirror.triangleImages[t];
  for (uint32_t c = 0; c < 3; ++c) {
    const uint32_t from = (3 - c) % 3, v = mirror.partners[result.mesh.triangles[t][from]];
    result.mesh.triangles[image][c] = v;
    const Corner source = Corner::fromFlatIndex(result.flips.corners[Corner(t, from).flatIndex()]);
    result.flips.corners[Corner(image, c).flatIndex()] =
        cornerAt(before, mirror.triangleImages[source.triangle()], v).flatIndex();
  }
}

}  // namespace

Flips unflipped(const TriangleMesh& mesh) {
  Flips flips{mesh.triangles, std::vector<uint32_t>(3 * size_t{mesh.triangleCount()})};
  std::iota(flips.corners.begin(), flips.corners.end(), 0u);
  return flips;
}

void writePart(const FitPart& part, const std::vector<uint32_t>& corners, const StartResult& start,
               MeshAt& result) {
  for (uint32_t v = 0; v < part.wholeVertex.size(); ++v) {
    const bool followsImage = part.mirror && part.mirror->partners[v] < v;
    if (!part.locked[v] && !followsImage)
      writePosition(part.wholeVertex[v], part.frame.fromFrame(part.result.positions[v]), start.mirror,
                    result.mesh.positions);
  }
  for (uint32_t t = 0; t < part.wholeTriangle.size(); ++t) {
    const uint32_t there = part.wholeTriangle[t];
    for (uint32_t c = 0; c < 3; ++c) {
      const Corner corner = Corner::fromFlatIndex(corners[Corner(t, c).flatIndex()]);
      result.mesh.triangles[there][c] = part.wholeVertex[part.result.triangles[t][c]];
      result.flips.corners[Corner(there, c).flatIndex()] =
          Corner(part.wholeTriangle[corner.triangle()], corner.index()).flatIndex();
    }
    if (part.hasImage) writeImage(there, *start.mirror, start.mesh, result);
  }
}

}  // namespace limber
