#pragma once
#include <memory>
#include <utility>

#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// A block around another one of the same mesh block, with its material, rule and layout. What does not depend on
/// forces is the inner block's.
class WrappedBlock : public ElementBlock {
 public:
  void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const final {
    inner_->minimumDeterminantBatch(batch, x, determinants);
  }
  void stressBatch(std::int32_t batch, const double* x, double* stress, double* F) const final {
    inner_->stressBatch(batch, x, stress, F);
  }
  void volumeBatch(std::int32_t batch, double* volumes) const final { inner_->volumeBatch(batch, volumes); }
  bool goesByDirections() const final { return inner_->goesByDirections(); }

 protected:
  WrappedBlock(const MeshBlock& block, std::unique_ptr<ElementBlock> inner)
      : ElementBlock(block, inner->material(), inner->rule(), inner->layout(), inner->hourglassControl()),
        inner_(std::move(inner)) {}

  const ElementBlock& inner() const { return *inner_; }

 private:
  std::unique_ptr<ElementBlock> inner_;
};

}  // namespace ringwatch
