#pragma once
#include <vector>

#include <ringwatch/monitor/incremental/rebuild_policy.h>
#include <ringwatch/monitor/incremental/run_certificate.h>

namespace ringwatch {

/// Mends a certificate around an element that exceeds its allowance at x: state × element → state in which the element
/// and its neighbours are within their allowances again, or a refusal. Weights of its nodes are turned with the body,
/// which changes no sum; allowances are distributed again among the elements of its neighbourhood; weights are swept
/// there, in neighbourhoods that grow; and last, if mayRaise, the certified eigenvalue is raised, which is free for all
/// other elements.
///
/// Returns the elements that have new reference gradients and balls, all of them of x. Empty for a refusal: weights and
/// allowances are then those before, and the neighbourhood's values and balls those of x. Theorem 20,
/// docs/theory/incremental_certificate.md.
std::vector<ElementRef> localUpdate(RunCertificate& state, NodeVectorsView x, ElementRef element,
                                    const RebuildPolicy& policy, bool mayRaise);

}  // namespace ringwatch
