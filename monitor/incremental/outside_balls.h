#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/body.h>
#include <ringwatch/monitor/incremental/validity_balls.h>

namespace ringwatch {

/// Finds the elements that are outside their balls, and those that damp more than counts, in one pass over a body.
class OutsideBalls {
 public:
  /// Each element by its own numbers alone, in the order of their blocks. Unless nullptr, `evaluation` is filled in by
  /// the same pass; its visitor is not used. blocks: those of the body with their `balls`, and where damping depends on
  /// velocities with its coefficients `counted`, by place, of which `rateHasRisen(place)` tells that they are too low.
  template <class Block>
  std::vector<ElementRef> find(const Body& body, std::vector<Block>& blocks, NodeVectorsView x,
                               StepEvaluation* evaluation);
  Body::Workspace& workspace() { return workspace_; }

 private:
  Body::Workspace workspace_;
  std::vector<std::vector<std::vector<std::int32_t>>> outside_;  // elements, [block][patch], kept for their memory
};

template <class Block>
std::vector<ElementRef> OutsideBalls::find(const Body& body, std::vector<Block>& blocks, NodeVectorsView x,
                                           StepEvaluation* evaluation) {
  outside_.resize(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    outside_[b].resize(body.blocks()[b]->layout().patches.size());
    for (auto& list : outside_[b]) list.clear();
  }
  class Check final : public PatchVisitor {
   public:
    Check(std::vector<Block>& blocks, std::vector<std::vector<std::vector<std::int32_t>>>& outside)
        : blocks_(blocks), outside_(outside) {}
    void visitPatch(std::size_t block, const PatchPass& pass) override {
      blocks_[block].balls.checkPatch(pass, outside_[block][pass.index()]);
    }

   private:
    std::vector<Block>& blocks_;
    std::vector<std::vector<std::vector<std::int32_t>>>& outside_;
  };
  Check check(blocks, outside_);
  StepEvaluation checkOnly;
  checkOnly.wantsForce = false;
  StepEvaluation& asked = evaluation ? *evaluation : checkOnly;
  asked.visitor = &check;
  body.evaluate(x, asked, workspace_);
  asked.visitor = nullptr;
  std::vector<ElementRef> found;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (const auto& list : outside_[b])
      for (const std::int32_t e : list) found.push_back({static_cast<std::int32_t>(b), e});
  const std::size_t byBalls = found.size();
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t place = 0; place < blocks[b].counted.size(); ++place)
      if (const std::int32_t e = body.blocks()[b]->layout().elements[place]; e >= 0 && blocks[b].rateHasRisen(place))
        found.push_back({static_cast<std::int32_t>(b), e});
  if (found.size() > byBalls) sortUnique(found);
  return found;
}

}  // namespace ringwatch
