// The parts of the search for modes, each compared with a dense or analytic solution.

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/parallel.h"
#include "fit/search/budgeted_step.h"
#include "fit/search/damping.h"
#include "fit/search/fit_solver.h"
#include "fit/search/stop_rule.h"
#include "fit/tuning.h"
#include "linear/block_matrix.h"
#include "linear/conjugate_gradients.h"

namespace limber {
namespace {

constexpr int kCoordinates = 12, kResiduals = 5;

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

// dx^T A dx - 2 g^T dx + w |r + J dx|^2 with small residuals, so that none is clipped.
struct Problem {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
  Mismatch mismatch;

  explicit Problem(unsigned seed) {
    const Eigen::MatrixXd root = randomMatrix(kCoordinates, kCoordinates, seed);
    hessian = root * root.transpose() + Eigen::MatrixXd::Identity(kCoordinates, kCoordinates);
    gradient = randomMatrix(kCoordinates, 1, seed + 1);
    mismatch.residual = 0.02 * randomMatrix(kResiduals, 1, seed + 2).cwiseMax(-4).cwiseMin(4);
    mismatch.jacobian = randomMatrix(kCoordinates, kResiduals, seed + 3);
  }
  BudgetedStep step() const {
    Eigen::MatrixXd columns(kCoordinates, 1 + kResiduals);
    columns << gradient, mismatch.jacobian;
    return {gradient, mismatch, hessian.ldlt().solve(columns)};
  }
  Eigen::VectorXd minimum(double weight) const {
    const Eigen::MatrixXd& transposed = mismatch.jacobian;
    return (hessian + weight * transposed * transposed.transpose())
        .ldlt()
        .solve(gradient - weight * transposed * mismatch.residual);
  }
  double surfaceTerms(const Eigen::VectorXd& dx) const { return dx.dot(hessian * dx) - 2 * gradient.dot(dx); }
};

TEST(BudgetedStep, isTheMinimumForAnyResidualWeight) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Problem problem(seed);
    const BudgetedStep step = problem.step();
    for (const double weight : {1e-3, 1.0, 1e3}) {
      const Eigen::VectorXd minimum = problem.minimum(weight);
      EXPECT_LT((step.step(weight) - minimum).norm(), 1e-9 * minimum.norm()) << seed << " " << weight;
      EXPECT_NEAR(step.growth(weight), problem.surfaceTerms(minimum), 1e-9) << seed << " " << weight;
    }
  }
}

TEST(BudgetedStep, spendsTheBudgetUnlessTheRangeOfWeightsEndsBefore) {
  const BudgetedStep step = Problem(4).step();
  const double budget = 0.5 * (step.growth(1e-3) + step.growth(1e3));
  const double weight = step.weightWithinBudget(budget, 1e-3, 1e3);
  EXPECT_LE(step.growth(weight), budget);
  EXPECT_GT(step.growth(1.0001 * weight), budget);
  EXPECT_EQ(step.weightWithinBudget(step.growth(1e3), 1e-3, 1e3), 1e3);
  EXPECT_NEAR(step.weightWithinBudget(step.growth(1e-4), 1e-3, 1e3), 1e-3, 1e-9);
}

BlockMatrix blocksOf(const Eigen::MatrixXd& dense) {
  const auto nodes = static_cast<uint32_t>(dense.rows() / 3);
  BlockMatrix matrix;
  matrix.start.push_back(0);
  for (uint32_t i = 0; i < nodes; ++i) {
    for (uint32_t j = 0; j < nodes; ++j) {
      matrix.column.push_back(j);
      matrix.blocks.push_back(dense.block<3, 3>(3 * i, 3 * j));
    }
    matrix.start.push_back(static_cast<uint32_t>(matrix.column.size()));
  }
  return matrix;
}

// By a factorisation, and by conjugate gradients, which end at 1e-2 in another norm.
TEST(DampedSystem, solvesTheDampedSystemOfTheVerticesThatAreNotLocked) {
  Job job;
  const Problem problem(5);
  const BlockMatrix hessian = blocksOf(problem.hessian);
  const Eigen::VectorXd diagonal = randomMatrix(kCoordinates, 1, 6).cwiseAbs();
  const double damping = 0.3;
  const std::vector<int> free = {0, 1, 2, 3, 4, 5, 9, 10, 11};
  Eigen::MatrixXd damped = problem.hessian;
  damped.diagonal() += damping * diagonal;
  const Eigen::VectorXd expected =
      Eigen::MatrixXd(damped(free, free)).ldlt().solve(Eigen::VectorXd(problem.gradient(free)));
  const std::vector<uint8_t> locked = {0, 0, 1, 0};
  const auto expectSolution = [&](const Eigen::VectorXd& found, double tolerance) {
    EXPECT_EQ(found.segment<3>(6), Eigen::Vector3d::Zero());
    EXPECT_LT((Eigen::VectorXd(found(free)) - expected).norm(), tolerance * expected.norm());
  };
  expectSolution(FitSolver(locked, job).solve({hessian, diagonal, damping}, problem.gradient), 1e-10);
  expectSolution(conjugateGradients({hessian, diagonal, damping, locked}, problem.gradient, job), 5e-2);
}

// A chain of nodes; each 50th couples `factor` times as strongly to the next.
BlockMatrix chainOf(uint32_t nodes, double factor) {
  BlockMatrix chain;
  chain.start.push_back(0);
  for (uint32_t i = 0; i < nodes; ++i) {
    for (uint32_t j = i == 0 ? 0 : i - 1; j <= std::min(i + 1, nodes - 1); ++j) chain.column.push_back(j);
    chain.start.push_back(static_cast<uint32_t>(chain.column.size()));
  }
  chain.blocks.assign(chain.column.size(), Eigen::Matrix3d::Zero());
  for (uint32_t i = 0; i < nodes; ++i) {
    const Eigen::Matrix3d root = randomMatrix(3, 3, i + 1), square = root * root.transpose();
    // Symmetric to the last bit, as the product need not be.
    const Eigen::Matrix3d block = (i % 50 == 0 ? factor : 1) / 2 * (square + square.transpose());
    chain.at(i, i) += block;
    if (i + 1 == nodes) continue;
    chain.at(i + 1, i + 1) += block;
    chain.at(i, i + 1) = chain.at(i + 1, i) = -block;
  }
  return chain;
}

struct ChainProblem {
  static constexpr Eigen::Index kNodes = 5000;
  explicit ChainProblem(double factor) : chain(chainOf(kNodes, factor)) {}

  BlockMatrix chain;
  Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(3 * kNodes, 2.0);
  Eigen::MatrixXd b = randomMatrix(3 * kNodes, 4, 7);
  std::vector<uint8_t> isFixed;
  ShiftedMatrix matrix{chain, diagonal, 0.1, isFixed};

  Eigen::SparseMatrix<double> whole() const {
    Eigen::SparseMatrix<double> sum;
    chain.writeTo(sum);
    for (Eigen::Index i = 0; i < 3 * kNodes; ++i) sum.coeffRef(i, i) += 0.1 * diagonal[i];
    return sum;
  }
  Eigen::MatrixXd exact() const {
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(whole()).solve(b);
  }
  // x^T A x / 2 - b^T x of the shifted matrix, per column.
  Eigen::VectorXd model(const Eigen::MatrixXd& x) const {
    return (x.cwiseProduct(whole() * x) / 2 - b.cwiseProduct(x)).colwise().sum().transpose();
  }
};

// The blocks of row i, transposed, are those of column i.
TEST(BlockMatrix, isTheSymmetricMatrixOfItsBlocks) {
  const BlockMatrix chain = chainOf(7, 3);
  Eigen::SparseMatrix<double> written;
  chain.writeTo(written);
  const Eigen::MatrixXd dense = written;
  EXPECT_EQ(dense, dense.transpose());
  for (uint32_t i = 0; i < 7; ++i)
    for (uint32_t j = 0; j < 7; ++j) {
      const bool isNear = i <= j + 1 && j <= i + 1;
      const Eigen::Matrix3d expected = isNear ? chain.at(i, j) : Eigen::Matrix3d::Zero();
      EXPECT_EQ((dense.block<3, 3>(3 * i, 3 * j)), expected) << i << " " << j;
    }
}

// Columns are solved in groups of three; a column does not depend on the others except for its end.
TEST(ConjugateGradients, solveAlikeWithAnyNumberOfThreads) {
  Job job;
  const ChainProblem problem(10);
  const Eigen::MatrixXd found = conjugateGradients(problem.matrix, problem.b, job), exact = problem.exact();
  for (Eigen::Index k = 0; k < exact.cols(); ++k)
    EXPECT_LT((found.col(k) - exact.col(k)).norm(), 5e-2 * exact.col(k).norm()) << k;
  setThreadCount(3);
  EXPECT_EQ(conjugateGradients(problem.matrix, problem.b, job), found);
  setThreadCount(1);
}

TEST(ConjugateGradients, leaveFixedNodesInPlaceAndColumnsOfZerosAtZero) {
  Job job;
  ChainProblem problem(10);
  problem.isFixed.assign(ChainProblem::kNodes, 0);
  problem.isFixed[3] = problem.isFixed[4000] = 1;
  problem.b.col(1).setZero();
  const Eigen::MatrixXd found = conjugateGradients(problem.matrix, problem.b, job);
  EXPECT_TRUE(found.middleRows(9, 3).isZero(0));
  EXPECT_TRUE(found.middleRows(12000, 3).isZero(0));
  EXPECT_TRUE(found.col(1).isZero(0));
  EXPECT_FALSE(found.col(2).isZero(0));
}

// If some nodes couple far more strongly than others, the step limit is reached first.
TEST(ConjugateGradients, lowerTheModelWhereTheyAreCutShort) {
  Job job;
  const ChainProblem problem(1e8);
  const Eigen::MatrixXd found = conjugateGradients(problem.matrix, problem.b, job), exact = problem.exact();
  EXPECT_GT((found - exact).norm(), 1e-2 * exact.norm());
  const Eigen::VectorXd reached = problem.model(found), least = problem.model(exact);
  for (Eigen::Index k = 0; k < least.size(); ++k) {
    EXPECT_LT(reached[k], 0.5 * least[k]);
    EXPECT_GE(reached[k], least[k]);
  }
}

TEST(Damping, risesAfterPoorStepsAndFallsAfterGoodOnes) {
  Damping damping(3, 0.01, false);
  damping.adapt(0.2, 1);
  EXPECT_DOUBLE_EQ(damping.value(), 0.03);
  damping.adapt(0.5, 1);
  EXPECT_DOUBLE_EQ(damping.value(), 0.03);
  damping.adapt(0.9, 1);
  EXPECT_DOUBLE_EQ(damping.value(), 0.02);
  Damping fast(3, 0.03, true);
  fast.adapt(0.9, 1);
  EXPECT_DOUBLE_EQ(fast.value(), 0.01);
}

TEST(Damping, isExhaustedAfterEnoughRestores) {
  Damping damping(3, 0.01, true);
  int restores = 0;
  for (; !damping.isExhausted() && restores < 100; ++restores) damping.noteRestore();
  EXPECT_GT(restores, 2);
  EXPECT_LT(restores, 10);
}

TEST(Damping, growsForBlockedVerticesAlone) {
  Damping damping(6, 0.01, false);
  Eigen::VectorXd wanted(6), made(6);
  wanted << 1, 0, 0, 0, 1, 0;
  made << 0.4, 0, 0, 0, 0.6, 0;
  const Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(6, 2);
  damping.scaleBlocked(wanted, made);
  EXPECT_EQ(damping.scaled(diagonal), (Eigen::VectorXd(6) << 8, 8, 8, 2, 2, 2).finished());
  damping.scaleBlocked(wanted, wanted);
  damping.scaleBlocked(wanted, wanted);
  EXPECT_EQ(damping.scaled(diagonal), diagonal);
}

TEST(StopRule, endsWhereTheLastRoundsGainLittle) {
  StopRule rule(1e-8, false);
  for (const double merit : {0.01, 0.001, 0.0001}) {
    rule.add(merit);
    EXPECT_FALSE(rule.isMet(merit));
  }
  for (int round = 0; round < 2; ++round) rule.add(0.00009999);
  EXPECT_FALSE(rule.isMet(0.00009999)) << "the round before these gained a lot";
  rule.add(0.00009998);
  EXPECT_TRUE(rule.isMet(0.00009998));
  rule.restart();
  EXPECT_FALSE(rule.isMet(0.00009998));
  EXPECT_TRUE(rule.isMet(1e-9));
}

}  // namespace
}  // namespace limber
