// The curve editors by hand: grab, drag, snap, type, reset.
#include <gtest/gtest.h>

#include "in_a_column.h"
#include "ui/widgets/curve_editor.h"

namespace erg::test {

using ui::CurveFrame;

namespace {

CurveFrame strength_frame() {
  CurveFrame frame;
  frame.x_label = "step";
  frame.y_label = "strength";
  frame.x = {0, 99};
  frame.y = {3, 8};
  frame.height = 170;
  return frame;
}

ImVec2 in_box(const UiHarness& hand, double x, double y) {
  const ui::WidgetPlace box = hand.place("curve/box");
  return {box.low.x + static_cast<float>(x) * (box.high.x - box.low.x),
          box.high.y - static_cast<float>(y) * (box.high.y - box.low.y)};
}

struct CurveHand {
  BezierCurve curve;
  CurveFrame frame = strength_frame();
  int changes = 0;
  UiHarness hand = in_a_column([this] { changes += ui::edit_curve("curve", curve, frame) ? 1 : 0; });
};

TEST(CurveEditor, AControlPointGoesWhereItIsDragged) {
  CurveHand box;
  box.hand.drag(box.hand.place("curve/first").middle(), in_box(box.hand, 0.8, 0.1));
  EXPECT_NEAR(box.curve.first.x, 0.8, 0.01);
  EXPECT_NEAR(box.curve.first.y, 0.1, 0.02);
  EXPECT_EQ(box.curve.second, BezierCurve{}.second);
  EXPECT_GT(box.changes, 0);
}

TEST(CurveEditor, PointsAreLargeEnoughToGrabBesideTheirMiddle) {
  CurveHand box;
  const ImVec2 middle = box.hand.place("curve/second").middle();
  box.hand.drag({middle.x + 9, middle.y - 4}, in_box(box.hand, 0.5, 0.9));
  EXPECT_NEAR(box.curve.second.x, 0.5, 0.01);
  EXPECT_NEAR(box.curve.second.y, 0.9, 0.02);
}

TEST(CurveEditor, APointDraggedOutOfTheBoxStaysInIt) {
  CurveHand box;
  box.hand.drag(box.hand.place("curve/first").middle(), in_box(box.hand, -0.5, 1.7));
  EXPECT_EQ(box.curve.first, (CurvePoint{0, 1}));
}

TEST(CurveEditor, ShiftSnapsToTenths) {
  CurveHand box;
  hold_shift(true);
  box.hand.drag(box.hand.place("curve/first").middle(), in_box(box.hand, 0.72, 0.18));
  hold_shift(false);
  EXPECT_DOUBLE_EQ(box.curve.first.x, 0.7);
  EXPECT_DOUBLE_EQ(box.curve.first.y, 0.2);
}

TEST(CurveEditor, ASeasonThatWeakensIsDrawnAndDraggedUpsideDown) {
  CurveHand box;
  box.frame.y = {8, 3};
  box.hand.frames();
  EXPECT_LT(box.hand.place("curve/first").middle().y, box.hand.place("curve/second").middle().y);
  box.hand.drag(box.hand.place("curve/first").middle(), in_box(box.hand, 0.5, 1));
  EXPECT_NEAR(box.curve.first.y, 0, 1e-6) << "the upper edge is the first strength";
}

TEST(CurveEditor, NumbersAreTypedAndHeldToTheBox) {
  CurveHand box;
  box.hand.enter("curve/end/x", "0.25");
  EXPECT_DOUBLE_EQ(box.curve.second.x, 0.25);
  box.hand.enter("curve/end/y", "7");
  EXPECT_DOUBLE_EQ(box.curve.second.y, 1);
  box.hand.enter("curve/start/y", "-3");
  EXPECT_DOUBLE_EQ(box.curve.first.y, 0);
}

TEST(CurveEditor, ResetGivesTheStraightLineBack) {
  CurveHand box;
  EXPECT_FALSE(box.hand.place("curve/RESET").enabled);
  box.hand.drag(box.hand.place("curve/first").middle(), in_box(box.hand, 0.9, 0.2));
  ASSERT_FALSE(box.curve == BezierCurve{});
  box.hand.click("curve/RESET");
  EXPECT_EQ(box.curve, BezierCurve{});
}

struct PointsHand {
  std::vector<CurvePoint> standard{{0, 1}, {50, 4}, {100, 2}};
  std::vector<CurvePoint> points = standard;
  UiHarness hand = in_a_column([this] {
    CurveFrame frame;
    frame.x = {0, 100};
    frame.y = {0, 5};
    frame.height = 170;
    ui::edit_points("curve", points, standard, frame);
  });
};

TEST(PointsEditor, PointsAreMovedAddedAndRemoved) {
  PointsHand box;
  box.hand.drag(box.hand.place("curve/point 1").middle(), in_box(box.hand, 0.3, 0.6));
  ASSERT_EQ(box.points.size(), 3u);
  EXPECT_NEAR(box.points[1].x, 30, 1);
  EXPECT_NEAR(box.points[1].y, 3, 0.1);

  box.hand.click(in_box(box.hand, 0.8, 0.9));
  box.hand.press();
  box.hand.release();
  ASSERT_EQ(box.points.size(), 4u);
  EXPECT_NEAR(box.points[2].x, 80, 1);
  EXPECT_NEAR(box.points[2].y, 4.5, 0.1);

  box.hand.click(box.hand.place("curve/point 2").middle(), 1);
  EXPECT_EQ(box.points.size(), 3u);
  box.hand.click("curve/RESET");
  EXPECT_EQ(box.points, box.standard);
}

TEST(PointsEditor, EndsStayAtTheEndsAndPointsBetweenTheirNeighbours) {
  PointsHand box;
  box.hand.drag(box.hand.place("curve/point 0").middle(), in_box(box.hand, 0.6, 0.8));
  EXPECT_EQ(box.points[0].x, 0);
  EXPECT_NEAR(box.points[0].y, 4, 0.1);
  box.hand.drag(box.hand.place("curve/point 1").middle(), in_box(box.hand, 1.4, 0.5));
  EXPECT_LT(box.points[1].x, 100);
  EXPECT_GT(box.points[1].x, 98);
  box.hand.click(box.hand.place("curve/point 0").middle(), 1);
  EXPECT_EQ(box.points.size(), 3u) << "an end cannot be removed";
}

}  // namespace
}  // namespace erg::test
