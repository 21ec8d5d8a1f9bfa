#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/short_floats.h>
#include <ringwatch/handlers/selection/certified_selection.h>
#include <ringwatch/monitor/incremental/certificate_state.h>
#include <ringwatch/monitor/incremental/rebuild_policy.h>

namespace ringwatch {

/// A certified selection that is kept while state, step and mesh change. The explicit elements have a CertificateState
/// whose allowances follow the positions: it remembers the weights D_e of each, the deformation gradients F0 at which
/// l_e was evaluated, and how fast l_e can grow from there (TangentGrowth); at other positions, with R_e the rotation
/// that brings F0 closest to F,
///   K_e(x) ≼ β_e R_e D_e R_eᵀ,   β_e = l_e(δ),   δ = max_q |F_q - R_e F0_q|,
/// holds without evaluating K_e, for objective laws; R_e = 1 for others and at nodes that are held in some directions
/// only. What is summed at the nodes from that is the proof; elements are evaluated again only where it fails: at nodes
/// whose sum is above lambda m_i, and if that does not help, or elements are new, the choice is made again among them
/// and their neighbours, with all others as they are. Theorem 33, docs/theory/handlers.md.
class IncrementalSelection {
 public:
  /// The choice for a limit of lambda, rad²/s², at positions x (3×N, m): from scratch the first time and where
  /// RebuildPolicy::tooLargeRegion of all elements would be chosen from again. keep: elements that stay chosen; others
  /// that were chosen are given back only where the choice is made again. Constraints of elements that it knows must be
  /// those they were chosen with. Throws as selectCertified.
  const CertifiedSelection& choose(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep);
  /// Goes over to a mesh after a cut: elements that the cut has changed are new.
  void carryOver(const CutMesh& cut);

  /// Elements of which the last choice evaluated a tangent.
  std::int64_t evaluatedElements() const { return static_cast<std::int64_t>(chosenElements(evaluated_).size()); }
  /// The last choice; its `evaluations` are all that it took.
  const CertifiedSelection& last() const { return last_; }
  /// CertificateState::verify of the explicit elements at positions x, for the lambda of the last choice; for tests.
  double verify(const Body& body, const NodeVectors& x) const;

 private:
  class Choice;
  struct Growth {  // of l_e about F0, N/m
    double value = 0;
    RoundedUp<float> linear, quadratic;
    RoundedDown<float> radius = -1.0;  // < 0: not known
    TangentGrowth unpacked() const {
      return {value, static_cast<double>(linear), static_cast<double>(quadratic), static_cast<double>(radius)};
    }
  };
  struct Known {  // elements of a block
    std::vector<Growth> growth;
    std::vector<float> reference;  // [element][quadrature point][9], F0
  };

  bool knows(const Body& body) const;
  const CertifiedSelection& chooseFromScratch(const Body& body, const NodeVectors& x, double lambda,
                                              const ElementFlags& keep);

  RebuildPolicy policy_;
  CertifiedSelection last_;
  double lambda_ = 0;
  std::vector<Known> known_;  // by block; empty before the first choice
  ElementFlags evaluated_;
};

}  // namespace ringwatch
