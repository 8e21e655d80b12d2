#include "elastic/solvers/solver_constraints.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "shapes.h"

namespace limber {
namespace {

constexpr std::array kModels = {
    SolverModel{StretchElement::Membrane, BendElement::HingeByArea},
    SolverModel{StretchElement::Membrane, BendElement::HingeByLength},
    SolverModel{StretchElement::EdgeSprings, BendElement::Hinge},
    SolverModel{StretchElement::EdgeSprings, BendElement::CrossSprings},
};
const SolverConstants kConstants{
    .stretch = 700, .secondStretch = 300, .bend = 0.3, .surfaceDensity = 2, .unit = 0.5};

SolverConstraints constraintsOf(const TriangleMesh& mesh, const SolverModel& model,
                                const SolverConstants& constants = kConstants) {
  return {mesh, buildTopology(mesh), model, constants};
}

double energy(const SolverConstraints& constraints, std::span<const Vec3> positions) {
  double sum = 0;
  for (uint32_t c = 0; c < constraints.count(); ++c) sum += constraints.energyAt(c, positions);
  return sum;
}

double bendEnergy(const SolverConstraints& constraints, std::span<const Vec3> positions) {
  double sum = 0;
  for (uint32_t c = constraints.stretchCount(); c < constraints.count(); ++c)
    sum += constraints.energyAt(c, positions);
  return sum;
}

std::vector<Vec3> randomlyMoved(std::span<const Vec3> positions, double size, uint32_t seed) {
  TriangleMesh mesh;
  mesh.positions.assign(positions.begin(), positions.end());
  return shapes::jittered(mesh, size, seed).positions;
}

// An irregular closed surface and an irregular open one.
std::vector<TriangleMesh> bodies() {
  return {shapes::jittered(shapes::sphere(1), 0.15, 3), shapes::jittered(shapes::grid(4, 3), 0.06, 4)};
}

TEST(SolverConstraints, listTrianglesOrEdgesAndThenInnerEdges) {
  const TriangleMesh mesh = shapes::grid(3, 2);
  const Topology topology = buildTopology(mesh);
  const SolverConstraints membrane(mesh, topology, kModels[0], kConstants);
  EXPECT_EQ(membrane.stretchCount(), mesh.triangleCount());
  const auto inner = std::ranges::count(topology.edges, 2u, &Topology::Edge::useCount);
  EXPECT_EQ(membrane.count() - membrane.stretchCount(), inner);
  EXPECT_EQ(membrane[0].vertices[1], mesh.triangles[0][1]);
  const SolverConstraints springs(mesh, topology, kModels[3], kConstants);
  EXPECT_EQ(springs.stretchCount(), topology.edges.size());
  EXPECT_EQ(springs.count() - springs.stretchCount(), inner);
  EXPECT_EQ(springs[springs.stretchCount()].kind, ConstraintKind::Bend);
}

TEST(SolverConstraints, areWithoutStrainAtRestAndAfterARigidMotion) {
  for (const TriangleMesh& mesh : bodies())
    for (const SolverModel& model : kModels) {
      const SolverConstraints constraints = constraintsOf(mesh, model);
      // A rotation by 2.5 about (2, -1, 2) / 3, and a displacement.
      const Vec3 axis = Vec3{2, -1, 2} / 3;
      std::vector<Vec3> moved;
      for (const Vec3& p : constraints.rest())
        moved.push_back(p * std::cos(2.5) + cross(axis, p) * std::sin(2.5) +
                        axis * (dot(axis, p) * (1 - std::cos(2.5))) + Vec3{3, 1, -2});
      for (uint32_t c = 0; c < constraints.count(); ++c) {
        EXPECT_LT(constraints.strainAt(c, constraints.rest()).strain.norm(), 1e-13);
        EXPECT_LT(constraints.strainAt(c, moved).strain.norm(), 1e-12);
      }
    }
}

TEST(SolverConstraints, haveJacobiansThatMatchCentralDifferences) {
  constexpr double step = 1e-6;
  for (const TriangleMesh& mesh : bodies())
    for (const SolverModel& model : kModels)
      for (uint32_t seed = 0; seed < 3; ++seed) {
        const SolverConstraints constraints = constraintsOf(mesh, model);
        std::vector<Vec3> x = randomlyMoved(constraints.rest(), 0.06, seed);
        for (uint32_t c = 0; c < constraints.count(); ++c) {
          const ConstraintStrain exact = constraints.strainAt(c, x);
          for (int k = 0; k < constraints[c].vertexCount; ++k)
            for (int axis = 0; axis < 3; ++axis) {
              double& coordinate = x[constraints[c].vertices[k]][axis];
              const double kept = coordinate;
              coordinate = kept + step;
              const Eigen::Vector3d above = constraints.strainAt(c, x).strain;
              coordinate = kept - step;
              const Eigen::Vector3d below = constraints.strainAt(c, x).strain;
              coordinate = kept;
              const Eigen::Vector3d difference = (above - below) / (2 * step);
              EXPECT_LT((difference - exact.jacobian.col(3 * k + axis)).norm(), 1e-6 * exact.jacobian.norm());
            }
          EXPECT_EQ(exact.jacobian.rightCols(12 - 3 * constraints[c].vertexCount).norm(), 0);
        }
      }
}

TEST(SolverConstraints, haveTheEnergyOfAUniformlyStretchedSheet) {
  const TriangleMesh mesh = shapes::grid(5, 4, 2, 1);
  const SolverConstraints constraints = constraintsOf(mesh, kModels[0]);
  // F = diag(1.2, 0.9) with a shear of 0.1 and a rotation out of the plane.
  std::vector<Vec3> moved;
  for (const Vec3& p : constraints.rest()) moved.push_back({1.2 * p.x + 0.1 * p.y, 0, 0.9 * p.y});
  const double xx = 0.5 * (1.44 - 1), yy = 0.5 * (0.01 + 0.81 - 1), xy = 0.5 * 1.2 * 0.1, area = 2 * 0.25;
  const double expected = area * (700 * (xx * xx + yy * yy + 2 * xy * xy) + 150 * (xx + yy) * (xx + yy));
  EXPECT_NEAR(energy(constraints, moved), expected, 1e-12 * expected);
}

// The derivative of J^T strain with respect to positions, by central differences: it is J^T J plus the stress
// stiffness, except that the latter also acts along a spring. If a constraint is stretched, tension is all of
// the stress.
TEST(SolverConstraints, haveASecondDerivativeOfJacobiansAndStress) {
  constexpr double step = 1e-6;
  const TriangleMesh mesh = shapes::jittered(shapes::grid(1, 1), 0.1, 2);
  for (const SolverModel& model : {kModels[0], kModels[3]}) {
    const SolverConstraints constraints = constraintsOf(mesh, model);
    for (const double size : {1.3, 0.7}) {
      std::vector<Vec3> x;
      for (const Vec3& p : constraints.rest())
        x.push_back({size * p.x + 0.1 * p.y, 0.2 * p.x, 0.9 * size * p.y});
      for (uint32_t c = 0; c < constraints.stretchCount(); ++c) {
        const auto forces = [&] {
          const ConstraintStrain at = constraints.strainAt(c, x);
          return Eigen::VectorXd(at.jacobian.transpose() * at.strain);
        };
        const ConstraintStrain at = constraints.strainAt(c, x);
        Eigen::MatrixXd expected = at.jacobian.transpose() * at.jacobian;
        const Eigen::Matrix4d stress = constraints.stressStiffnessAt(c, x, StressKind::All);
        const Eigen::Matrix4d tension = constraints.stressStiffnessAt(c, x, StressKind::Tension);
        if (size > 1)
          EXPECT_LT((stress - tension).norm(), 1e-12 * stress.norm());
        else
          EXPECT_LT(tension.norm(), stress.norm());
        const int count = constraints[c].vertexCount;
        Eigen::Matrix3d across = Eigen::Matrix3d::Identity();
        if (count == 2) {
          const Eigen::Vector3d along = at.jacobian.block<1, 3>(0, 0).transpose().normalized();
          across -= along * along.transpose();
        }
        EXPECT_GT(stress.norm(), 0);
        for (int k = 0; k < count; ++k)
          for (int l = 0; l < count; ++l) expected.block<3, 3>(3 * k, 3 * l) += stress(k, l) * across;
        for (int k = 0; k < 3 * count; ++k) {
          double& coordinate = x[constraints[c].vertices[k / 3]][k % 3];
          const double kept = coordinate;
          coordinate = kept + step;
          const Eigen::VectorXd above = forces();
          coordinate = kept - step;
          const Eigen::VectorXd below = forces();
          coordinate = kept;
          EXPECT_LT(((above - below) / (2 * step) - expected.col(k)).norm(), 1e-7 * expected.norm());
        }
      }
    }
  }
}

TEST(SolverConstraints, areNotSoftenedByTension) {
  for (const TriangleMesh& mesh : bodies())
    for (const SolverModel& model : kModels) {
      const SolverConstraints constraints = constraintsOf(mesh, model);
      const std::vector<Vec3> x = randomlyMoved(constraints.rest(), 0.1, 5);
      for (uint32_t c = 0; c < constraints.count(); ++c) {
        const Eigen::Matrix4d stress = constraints.stressStiffnessAt(c, x, StressKind::Tension);
        const Eigen::Vector4d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(stress).eigenvalues();
        EXPECT_GE(values[0], -1e-12 * (1 + values[3]));
      }
    }
}

TEST(SolverConstraints, haveTheEnergyOfSpringsThatStretch) {
  const TriangleMesh mesh = shapes::grid(1, 1);
  const SolverConstraints constraints = constraintsOf(mesh, kModels[3]);
  std::vector<Vec3> moved;  // every length times 1.1
  for (const Vec3& p : constraints.rest()) moved.push_back(p * 1.1);
  // Sides of 0.5 m, a diagonal edge, and the cross spring along the other diagonal.
  const double expected = 0.5 * 700 * 0.01 * (4 * 0.25 + 0.5) + 0.5 * 0.3 * 0.01 * 0.5;
  EXPECT_NEAR(energy(constraints, moved), expected, 1e-12 * expected);
}

// A strip along x rolled around a cylinder about y without stretch: all edges across it fold by the same
// angle, cell / R, and the diagonals by none. Half of the outermost cells on both sides is not adjacent to an
// interior edge. Hinges by area have three times the energy 1/2 D / R^2 per area of a plate with this D, for
// cells of any shape.
TEST(SolverConstraints, haveTheEnergyOfASheetThatIsRolledUp) {
  constexpr int cells = 12;
  constexpr double width = 3, height = 0.7, radius = 2;
  const TriangleMesh mesh = shapes::grid(cells, 1, width, height);
  const double cell = width / cells, fold = cell / radius, chord = 2 * radius * std::sin(fold / 2);
  SolverConstants constants = kConstants;
  constants.unit = 1;
  std::vector<Vec3> rolled;
  for (const Vec3& p : mesh.positions) {
    const double around = p.x / radius;
    rolled.push_back({radius * std::sin(around), p.y, radius * std::cos(around)});
  }
  TriangleMesh flat = shapes::grid(cells, 1, chord * cells, height);  // chords of the cylinder, rolled out
  const double inner = (cells - 1) * chord * height;
  const double byArea = 3 * 0.5 * constants.bend * (fold / chord) * (fold / chord) * inner;
  EXPECT_NEAR(bendEnergy(constraintsOf(flat, kModels[0], constants), rolled), byArea, 1e-11 * byArea);
  const double byLength = 0.5 * constants.bend * fold * fold * height * (cells - 1);
  EXPECT_NEAR(bendEnergy(constraintsOf(flat, kModels[1], constants), rolled), byLength, 1e-11 * byLength);
  const double plain = byLength / height;
  EXPECT_NEAR(bendEnergy(constraintsOf(flat, kModels[2], constants), rolled), plain, 1e-11 * plain);
}

TEST(SolverConstraints, measureTheAngleOfAHingeWhateverTheWindingOfItsTriangles) {
  for (const double angle : {-3.0, -1.2, 0.0, 0.8, 3.1}) {
    TriangleMesh mesh = shapes::grid(1, 1);
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0.6, -1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
    SolverConstants constants = kConstants;
    constants.unit = 1;
    std::vector<Vec3> folded = mesh.positions;
    folded[3] = {0.6, -std::cos(angle), std::sin(angle)};
    const double expected = 0.5 * constants.bend * angle * angle;
    EXPECT_NEAR(bendEnergy(constraintsOf(mesh, kModels[2], constants), folded), expected, 1e-12);
    std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
    EXPECT_NEAR(bendEnergy(constraintsOf(mesh, kModels[2], constants), folded), expected, 1e-12);
  }
}

TEST(SolverConstraints, stayFiniteForTrianglesWithoutArea) {
  TriangleMesh mesh = shapes::grid(1, 1);
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, -1, 0}, {0.5, 1, 0}, {0.5, 1e-9, 0.7}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 4}, {2, 1, 4}, {0, 2, 5}};
  for (const SolverModel& model : kModels) {
    const SolverConstraints constraints = constraintsOf(mesh, model);
    for (uint32_t seed = 0; seed < 4; ++seed) {
      std::vector<Vec3> x = randomlyMoved(constraints.rest(), 0.1 * seed, seed);
      if (seed == 3) x[4] = x[0];  // triangles lose their area, edges their length
      for (uint32_t c = 0; c < constraints.count(); ++c) {
        const ConstraintStrain at = constraints.strainAt(c, x);
        EXPECT_TRUE(at.strain.allFinite() && at.jacobian.allFinite());
      }
    }
  }
}

TEST(SolverConstraints, boundTheStiffnessOfFlatTriangles) {
  const auto stiffness = [](double height, const SolverModel& model) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.4, height, 0}, {0.5, -1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
    SolverConstants constants = kConstants;
    constants.unit = 1;
    const SolverConstraints constraints = constraintsOf(mesh, model, constants);
    double most = 0;
    for (uint32_t c = 0; c < constraints.count(); ++c)
      most = std::max(most, constraints.strainAt(c, constraints.rest()).jacobian.squaredNorm());
    return most;
  };
  for (const SolverModel& model : {kModels[0], kModels[2]}) {
    const double atBound = stiffness(1e-4, model);
    EXPECT_LT(10 * stiffness(1e-2, model), atBound);
    for (const double height : {1e-5, 1e-7, 1e-9})
      EXPECT_NEAR(stiffness(height, model), atBound, 0.01 * atBound);
  }
}

TEST(SolverConstraints, refuseMorleysElementAndConstantsOutOfRange) {
  const TriangleMesh mesh = shapes::grid(1, 1);
  EXPECT_THROW(constraintsOf(mesh, {StretchElement::Membrane, BendElement::Morley}), std::invalid_argument);
  SolverConstants constants = kConstants;
  constants.stretch = 0;
  EXPECT_THROW(constraintsOf(mesh, kModels[0], constants), std::invalid_argument);
  constants = kConstants;
  constants.unit = std::nan("");
  EXPECT_THROW(constraintsOf(mesh, kModels[0], constants), std::invalid_argument);
}

TEST(SolverMasses, sumToTheSurfaceDensityTimesTheArea) {
  const TriangleMesh mesh = shapes::grid(3, 5, 2, 1.5);
  for (const MassRule rule : {MassRule::Area, MassRule::Vertex}) {
    const std::vector<double> masses = solverMasses(mesh, rule, kConstants);
    EXPECT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0), 2 * 3 * 0.25, 1e-12);
  }
  const std::vector<double> byArea = solverMasses(mesh, MassRule::Area, kConstants),
                            byVertex = solverMasses(mesh, MassRule::Vertex, kConstants);
  EXPECT_NEAR(byArea[5], 6 * byArea[3], 1e-12);  // an inner vertex has 6 triangles, this corner has one
  EXPECT_EQ(byVertex[5], byVertex[0]);
}

}  // namespace
}  // namespace limber
