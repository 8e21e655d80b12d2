#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The creases of a hard surface, found from the distribution of its dihedral angles (180 degrees less the
// angle inside: 0 where both triangles are in one plane), each edge counted by its length.
//
// Returns 1 for each edge that is a crease, per edge of the topology; an empty list if the mesh has none as a
// whole. Otsu's threshold (1979) parts the angles into two classes such that as much of their variance as
// possible lies between the classes. The edges of the upper class are creases if
// - more than 3/4 of the variance lies between the classes. That is the part for angles spread evenly over an
//   interval, where no threshold means anything; noise and curvature give less, flat sides with edges between
//   them nearly all; and
// - the mean of the upper class is beyond 60 degrees, from where on normals are split that the file lacks. A
//   regular net on a round surface has two classes too, with its rows and columns, but small angles.
// O(edges).
std::vector<uint8_t> findCreases(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
