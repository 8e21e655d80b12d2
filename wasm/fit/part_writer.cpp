#include "fit/part_writer.h"

#include "transfer/chart_sides.h"

namespace limber {

namespace {

Vec3 inFile(const Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Sets the position of a vertex and, where there is a mirror, that of its image.
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
    const uint32_t source = result.flips.corners[3 * t + from] / 3;
    result.flips.corners[3 * image + c] = cornerAt(before, mirror.triangleImages[source], v);
  }
}

}  // namespace

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
      const uint32_t corner = corners[3 * t + c];
      result.mesh.triangles[there][c] = part.wholeVertex[part.result.triangles[t][c]];
      result.flips.corners[3 * there + c] = 3 * part.wholeTriangle[corner / 3] + corner % 3;
    }
    if (part.hasImage) writeImage(there, *start.mirror, start.mesh, result);
  }
}

}  // namespace limber
