#pragma once
#include <ringwatch/base/backoff.h>

namespace ringwatch {

/// When an incremental certificate is mended around single elements, when it is rebuilt from scratch, and how much room
/// it leaves. No constant here bears on what is proven (Theorems 14 to 21, docs/theory/incremental_certificate.md):
/// each trades evaluations against the width of the bound. Shares are relative to the eigenvalue, rad²/s², unless said
/// otherwise; twice those of the step.
struct RebuildPolicy {
  // Rebuilds.
  /// Room of the certified eigenvalue above the tight bound of a rebuild; allowances share it. 3 % of the step: with
  /// less, elements soon exceed their allowances; with more, the bound is too wide for a bracket of 5 %.
  double slack = 0.06;
  /// Sweeps of a rebuild, at most. Later ones gain little on any mesh.
  int sweeps = 12;
  /// A rebuild ends when two sweeps gain less: 0.25 % of the step, a tenth of the slack.
  double leastGain = 0.005;
  /// Or at this share of the eigenvalue that is wanted, since what is left is room enough for a long way: 0.7 of the
  /// step.
  double enoughOfWanted = 0.5;
  /// The first weights where a step is taken: once the certified eigenvalue is at most this share of what the step
  /// allows, sweeps go on, one at least, until they have taken as much work as so many forces, or two gain less than
  /// leastGainAtFirst. Where few elements stand in the way, as on jittered meshes, that is a second or third sweep. A
  /// rebuild follows in the run where the bracket is too wide.
  double enoughOfCeiling = 0.9, forcesOfFirstSweeps = 40, leastGainAtFirst = 0.05;
  /// Updates between rebuilds that may not help. A rebuild costs as much as 150 to 400 steps.
  Backoff::Gaps rebuilds{.first = 40, .last = 10240, .factor = 4};
  /// Share of all elements over their allowances from which a rebuild is cheaper than local updates, each of which
  /// evaluates a neighbourhood of some tens of elements.
  double tooManyViolations = 0.05;
  /// Room below a caller's eigenvalue that a proof for it must have: without any, all validity balls would be points.
  double proofMargin = 1e-3;

  // Under a budget.
  /// The most by which the certified eigenvalue rises at once for elements that have left their balls; those that need
  /// more are evaluated by overdraft.
  double mostRaise = 1.1;
  /// The work of evaluations that are done at an update whatever there is for it, over that of the raise instead.
  double evaluationsForRaise = 0.25;
  /// The least: a raise visits the allowance of every element.
  double raise = 1.05;
  /// Updates between evaluations of all elements that may not help, and the share of the certified eigenvalue by which
  /// one that helps lowers it.
  Backoff::Gaps refreshes{.first = 4, .last = 640, .factor = 2};
  double helpfulRefresh = 0.01;
  /// The certified eigenvalue above what the last rebuild gave, at today's lower bound, from which all elements are
  /// evaluated once that can be paid for: 12 % of the step.
  double tooHigh = 1.25;

  // Local updates.
  /// Times that the neighbourhood grows by a ring of elements before an update is refused, and sweeps of its weights
  /// each time. Weights farther away hardly reach the element.
  int growths = 2, localSweeps = 3;
  /// Share of the slack that must be regained at every node of the neighbourhood: while sweeps are left, and after the
  /// last one. With less, the same elements would exceed their allowances again at once.
  double wantedRegain = 0.25, leastRegain = 0.05;
  /// Share of the slack above what a neighbourhood needs to which the certified eigenvalue is raised when an update is
  /// refused otherwise.
  double raisedSlack = 0.5;
  /// Angle by which a node's surroundings must have turned, rad, before its weights are turned with them: below, the
  /// 16 bits of the weights lose as much as a turn regains.
  float leastRotation = 0.01F;
  /// Elements whose reference gradients tell how a node's surroundings have turned: the first of its elements.
  int elementsOfFrame = 6;
  /// An element above this share of its allowance is close to the limit: the top mode may have come there, and a
  /// certificate that cannot be mended locally is about to be lost.
  double nearLimit = 0.9, nearlyLost = 0.97;

  // Following a lower bound.
  /// Where the certified eigenvalue is put when it is moved: as a share of the width that is allowed above the lower
  /// bound, in the step. It is raised from below relaxBelow.
  double targetOfWidth = 0.8, relaxBelow = 0.6;
  /// Share of the slack above the tight bound of the last rebuild below which the certified eigenvalue is not lowered:
  /// where the weights themselves are wide, as on regular grids, lowering only sends elements out of their balls.
  double leastSlack = 0.3;
  /// Lowerings by less are not worth the visit of every element that follows.
  double leastLowering = 0.01;
  /// Updates between lowerings that may not help. One that is wanted again within `soon` did not help for long.
  Backoff::Gaps lowerings{.first = 40, .last = 640, .factor = 2};
  int soon = 200;
  /// The certified eigenvalue above what the last rebuild gave, at today's lower bound, from which a rebuild is tried;
  /// below, only after as many updates as it takes a state to change much.
  double drifted = 1.05;
  int updatesOfChange = 640;
  /// A rebuild that lowers the certified eigenvalue by less has not helped.
  double helpfulRebuild = 0.03;

  // Selections of a handler.
  /// Share of all elements in the neighbourhood of what is new or too high from which a choice from scratch, which
  /// sweeps all weights together, costs no more.
  double tooLargeRegion = 0.8;
};

}  // namespace ringwatch
