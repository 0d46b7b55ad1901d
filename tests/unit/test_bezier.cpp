#include "core/bezier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace erg {
namespace {

const std::vector<BezierCurve>& curves() {
  static const std::vector<BezierCurve> all{
      {},
      {{0, 0}, {1, 1}},
      {{0.5, 0}, {0.5, 1}},
      {{1, 0}, {0, 1}},  // vertical in the middle
      {{0, 1}, {1, 0}},
      {{1, 1}, {1, 1}},
      {{0, 0}, {0, 0}},
  };
  return all;
}

TEST(Bezier, TheDefaultIsTheStraightLine) {
  const BezierCurve line;
  for (int i = 0; i <= 100; ++i) EXPECT_NEAR(line.at(i / 100.0), i / 100.0, 1e-14);
}

TEST(Bezier, EveryCurveStartsAtZeroAndEndsAtOne) {
  for (const BezierCurve& curve : curves()) {
    EXPECT_EQ(curve.at(0), 0.0);
    EXPECT_EQ(curve.at(1), 1.0);
  }
}

TEST(Bezier, OutsideIsClamped) {
  for (const BezierCurve& curve : curves()) {
    EXPECT_EQ(curve.at(-3), 0.0);
    EXPECT_EQ(curve.at(1e300), 1.0);
    EXPECT_EQ(curve.at(std::nan("")), 0.0);
  }
}

TEST(Bezier, LiesOnTheCurve) {
  // Points of the curve itself, x(t) and y(t) from de Casteljau's construction.
  const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
  const auto point = [&](double first, double second, double t) {
    const double left = mix(mix(0, first, t), mix(first, second, t), t);
    const double right = mix(mix(first, second, t), mix(second, 1, t), t);
    return mix(left, right, t);
  };
  const BezierCurve curve{{0.3, 0.1}, {0.7, 0.9}};
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    EXPECT_NEAR(curve.at(point(0.3, 0.7, t)), point(0.1, 0.9, t), 1e-13);
  }
}

TEST(Bezier, TurnedHalfRoundGivesTheMirroredCurve) {
  const BezierCurve curve{{0.2, 0.6}, {0.9, 0.3}};
  const BezierCurve turned{{0.1, 0.7}, {0.8, 0.4}};
  for (int i = 0; i <= 50; ++i) EXPECT_NEAR(turned.at(i / 50.0), 1 - curve.at(1 - i / 50.0), 1e-12);
}

TEST(Bezier, StaysInTheUnitSquare) {
  for (const BezierCurve& curve : curves()) {
    for (int i = 0; i <= 1000; ++i) {
      EXPECT_GE(curve.at(i / 1000.0), 0.0);
      EXPECT_LE(curve.at(i / 1000.0), 1.0);
    }
  }
}

TEST(Bezier, RisesWhereItsControlPointsDo) {
  for (const BezierCurve& curve : curves()) {
    if (curve.first.y > curve.second.y) continue;
    for (int i = 1; i <= 1000; ++i) EXPECT_GE(curve.at(i / 1000.0), curve.at((i - 1) / 1000.0) - 1e-12);
  }
}

}  // namespace
}  // namespace erg
