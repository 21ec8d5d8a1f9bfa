#pragma once
#include <sundials/sundials_context.h>
#include <sundials/sundials_nvector.h>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch::detail {

/// SUNDIALS' vector over positions and velocities that lie where they are: no copies. Vectors that SUNDIALS clones own
/// theirs.
struct StateVectorContent {
  NodeVectors* x;
  NodeVectors* v;  // may have no columns, for problems of positions alone
  bool owned;
};

/// A vector over x and v, which must outlive it. Destroy it with N_VDestroy.
N_Vector wrapState(NodeVectors& x, NodeVectors& v, SUNContext context);
inline NodeVectors& positions(N_Vector y) { return *static_cast<StateVectorContent*>(y->content)->x; }
inline NodeVectors& velocities(N_Vector y) { return *static_cast<StateVectorContent*>(y->content)->v; }

}  // namespace ringwatch::detail
