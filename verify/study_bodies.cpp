#include <ringwatch/verify/study_bodies.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/global_frequency.h>

namespace ringwatch::detail {

double highestEigenvalue(const Body& body, double tolerance) {
  if (body.mesh().elementCount() == 0) return 0;
  const GlobalFrequency top = globalFrequency(body, body.mesh().X, tolerance);
  if (!top.converged) throw NumericalError("the highest frequency of a body of the study did not converge");
  return top.lambda;
}

void flattenOneElement(Mesh& mesh, double height) {
  const Eigen::Vector3d low = mesh.X.rowwise().minCoeff(), high = mesh.X.rowwise().maxCoeff();
  const MeshBlock& block = mesh.blocks[0];
  for (std::size_t e = block.elementCount() / 2; e < block.elementCount(); ++e)
    for (int a = 0; a < 4; ++a) {
      const std::int32_t* nodes = block.element(e);
      const Eigen::Vector3d X = mesh.X.col(nodes[a]);
      if (((X - low).array() < 1e-9).any() || ((high - X).array() < 1e-9).any()) continue;
      const Eigen::Vector3d foot =
          (mesh.X.col(nodes[(a + 1) % 4]) + mesh.X.col(nodes[(a + 2) % 4]) + mesh.X.col(nodes[(a + 3) % 4])) / 3;
      mesh.X.col(nodes[a]) = foot + height * (X - foot);
      return;
    }
  throw NumericalError("a bar without inner nodes has no element to flatten");
}

}  // namespace ringwatch::detail
