// Whatever a file has: welding, inspection, quality, curvature, mirror images, distances.

#include "mesh/repair/weld.h"

#include "compare/surface_distance.h"
#include "fields/curvature.h"
#include "mesh/quality.h"
#include "mesh/repair/inspect.h"
#include "mesh/topology.h"
#include "promises.h"
#include "simplify/symmetry/mirror_images.h"
#include "soup.h"

namespace limber::fuzz {

void fuzzWeld(FuzzInput& input) {
  const Soup soup = drawSoup(input, 200);
  Job job;
  WeldOptions options;
  if (input.chance(64)) options.tolerance = input.anyFloat();
  options.keepDuplicates = input.chance(64);
  const WeldResult welded = weld(soup.positions, soup.indices, options, job);
  const TriangleMesh& mesh = welded.mesh;
  requireMesh(mesh);
  require(welded.sourceOfTriangle.size() == mesh.triangleCount(), "every triangle has a source");
  require(welded.vertexOfSource.size() == soup.positions.size() / 3, "every source vertex has an entry");
  const Inspection inspection = inspect(mesh);
  require(inspection.faces == mesh.triangleCount(), "an inspection counts all faces");
  require(options.keepDuplicates ||
              inspection.faces + welded.duplicateFaces + welded.degenerateFaces == soup.indices.size() / 3,
          "every face is kept or counted");
  const QualityReport quality = measureQuality(mesh);
  require(quality.minAngle >= 0 && quality.minAngle <= 60.0001, "the smallest angle is in [0, 60]");
  const Curvature curvature = meanCurvature(mesh, buildTopology(mesh), job);
  require(curvature.vertex.size() == mesh.vertexCount(), "every vertex has a curvature");
  for (const float k : curvature.vertex) require(!std::isnan(k), "a curvature is a number");
  findMirrorImages(mesh, {}, static_cast<int>(input.byte() % 3), job);
  const SurfaceDistance distance = measureSurfaceDistance(mesh, mesh, {.samples = 64}, job);
  require(!std::isnan(distance.hausdorff) && !std::isnan(distance.mean), "a distance is a number");
}

}  // namespace limber::fuzz
