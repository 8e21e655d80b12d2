#pragma once
#include "mesh/topology.h"
namespace limber {
std::vector<uint32_t> solidHosts(const TriangleMesh& mesh, const Topology& topology);
}
