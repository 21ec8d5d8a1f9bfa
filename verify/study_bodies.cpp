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

}  // namespace ringwatch::detail
