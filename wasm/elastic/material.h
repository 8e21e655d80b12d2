#pragma once

namespace limber {

// The homogeneous isotropic material of a body. Lengths are in units of the mesh.
struct ElasticMaterial {
  double young = 0;      // E, Pa, > 0
  double poisson = 0;    // nu, in (-1, 0.5)
  double density = 0;    // rho, kg/m3, > 0
  double thickness = 0;  // h of a shell, in units of the mesh, > 0
  double unit = 1;       // metres per unit of the mesh, > 0
};

// E = rho = unit = 1: the material of a frame in which frequencies are dimensionless.
constexpr ElasticMaterial unitMaterial(double thickness, double poisson = 0.3) {
  return {1, poisson, 1, thickness, 1};
}

}  // namespace limber
