// Events as data: their lines, their beginnings and their ends.
#include <gtest/gtest.h>

#include <ringwatch/monitor/event.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

TEST(EventTracker, EndsAnEventWithTheFirstOfEnoughObservationsWithoutIt) {
  EventTracker tracker(3);
  const auto observe = [&](std::int64_t step, bool now) {
    if (!now)
      tracker.absent(EventKind::violated, step);
    else if (tracker.isNew(EventKind::violated))
      tracker.begin({.kind = EventKind::violated, .step = step});
  };
  const bool seen[] = {false, true, true, false, false, true, false, false, false, false, true};
  for (std::int64_t step = 0; step < std::ssize(seen); ++step) observe(step, seen[step]);
  ASSERT_EQ(tracker.events().size(), 2u);
  EXPECT_EQ(tracker.events()[0].step, 1);
  EXPECT_EQ(tracker.events()[0].end, 6);
  EXPECT_EQ(tracker.events()[1].step, 10);
  EXPECT_FALSE(tracker.events()[1].end);
}

TEST(EventTracker, KeepsKindsApart) {
  EventTracker tracker(1);
  ASSERT_TRUE(tracker.isNew(EventKind::violated));
  tracker.begin({.kind = EventKind::violated, .step = 1});
  EXPECT_TRUE(tracker.isNew(EventKind::inverted));
  tracker.absent(EventKind::inverted, 2);
  EXPECT_FALSE(tracker.isNew(EventKind::violated));
}

TEST(EventText, IsTheLineOfItsKind) {
  Mesh mesh = test::box({"", "tet4", 5, "", 0}, {1, 1, 1});
  mesh.blocks[0].ids[2] = 33;
  const ElementRef element{0, 2};
  const MeshBlock& block = mesh.blocks[0];
  std::string where = "tet4 element 0:2 (number 33), nodes";
  for (int a = 0; a < 4; ++a) where += joinText(" ", mesh.nodeId(block.element(2)[a]));
  ElementCause inverted;
  inverted.leastDeterminant = -0.25;
  inverted.shape.shape = ShapeClass::round;
  ElementCause stretched = inverted;
  stretched.leastDeterminant = stretched.largestStretch = 1.6;
  const struct {
    MonitorEvent event;
    std::string text;
  } cases[] = {
      {{.kind = EventKind::violated,
        .step = 7,
        .time = 0.5,
        .value = 2,
        .h = 1e-3,
        .element = element,
        .cause = stretched},
       "step 7, t = 0.5 s: violated: h = 0.001 s is above the critical step, which is at most 0.0005 s, " + where +
           ": stretched 1.6"},
      {{.kind = EventKind::energyBalance, .value = 0.125},
       "step 0, t = 0 s: energy balance is off by 12.5 % of the largest energy so far"},
      {{.kind = EventKind::inverted, .value = -0.25, .element = element, .cause = inverted},
       "step 0, t = 0 s: " + where + ": inverted, det F = -0.25"},
      {{.kind = EventKind::inverted, .value = -0.25, .handled = true, .element = element, .cause = inverted},
       "step 0, t = 0 s: handled " + where + ": inverted, det F = -0.25"},
      {{.kind = EventKind::nonFinite}, "step 0, t = 0 s: positions or velocities are not finite"},
      {{.kind = EventKind::nonFinite, .tangent = true},
       "step 0, t = 0 s: the tangent is not finite at these positions: no step helps"},
      {{.kind = EventKind::indefinite, .value = -3, .element = element, .cause = stretched},
       "step 0, t = 0 s: tangent indefinite, eigenvalue -3 rad2/s2: no step cures that, " + where + ": stretched 1.6"},
  };
  for (const auto& c : cases) EXPECT_EQ(eventText(c.event, mesh), c.text);
}

// A mesh that is made in memory may have neither numbers of nodes nor of elements: both count from 0.
TEST(EventText, OfAMeshWithoutFileNumbersHasPlaces) {
  Mesh mesh = test::box({"", "tet4", 5, "", 0}, {1, 1, 1});
  mesh.nodeIds.clear();
  mesh.blocks[0].ids.clear();
  std::string nodes;
  for (int a = 0; a < 4; ++a) nodes += joinText(" ", mesh.blocks[0].element(2)[a]);
  EXPECT_EQ(elementText(mesh, {0, 2}), "tet4 element 0:2, nodes" + nodes);
  EXPECT_EQ(
      eventText({.kind = EventKind::violated, .value = 2, .h = 1e-3, .element = ElementRef{0, 2}}, mesh),
      "step 0, t = 0 s: violated: h = 0.001 s is above the critical step, which is at most 0.0005 s, tet4 element "
      "0:2, nodes" +
          nodes);
}

}  // namespace
}  // namespace ringwatch
