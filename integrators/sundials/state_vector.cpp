#include <ringwatch/integrators/sundials/state_vector.h>

#include <algorithm>
#include <cmath>

namespace ringwatch::detail {
namespace {

using Array = Eigen::Map<Eigen::ArrayXd>;
Array partOf(N_Vector y, int part) {
  NodeVectors& values = part == 0 ? positions(y) : velocities(y);
  return {values.data(), values.size()};
}
double length(N_Vector y) { return static_cast<double>(positions(y).size() + velocities(y).size()); }

/// Calls f with the positions of all vectors, then with their velocities. SUNDIALS lets results alias arguments; every
/// operation here is by element.
template <class F, class... Vectors>
void each(const F& f, Vectors... y) {
  for (int part = 0; part < 2; ++part) f(partOf(y, part)...);
}

void destroy(N_Vector y) {
  auto* content = static_cast<StateVectorContent*>(y->content);
  if (content && content->owned) {
    delete content->x;
    delete content->v;
  }
  delete content;
  y->content = nullptr;
  N_VFreeEmpty(y);
}

N_Vector clone(N_Vector y) {
  N_Vector result = N_VNewEmpty(y->sunctx);
  N_VCopyOps(y, result);
  result->content =
      new StateVectorContent{new NodeVectors(3, positions(y).cols()), new NodeVectors(3, velocities(y).cols()), true};
  return result;
}

}  // namespace

N_Vector wrapState(NodeVectors& x, NodeVectors& v, SUNContext context) {
  N_Vector y = N_VNewEmpty(context);
  y->content = new StateVectorContent{&x, &v, false};
  N_Vector_Ops ops = y->ops;
  ops->nvgetvectorid = [](N_Vector) { return SUNDIALS_NVEC_CUSTOM; };
  ops->nvclone = clone;
  ops->nvdestroy = destroy;
  ops->nvgetlength = [](N_Vector a) { return static_cast<sunindextype>(length(a)); };
  ops->nvspace = [](N_Vector a, sunindextype* reals, sunindextype* integers) {
    *reals = static_cast<sunindextype>(length(a));
    *integers = 0;
  };
  ops->nvlinearsum = [](realtype a, N_Vector p, realtype b, N_Vector q, N_Vector r) {
    each([&](auto s, auto t, auto u) { u = a * s + b * t; }, p, q, r);
  };
  ops->nvconst = [](realtype c, N_Vector p) { each([&](auto s) { s.setConstant(c); }, p); };
  ops->nvprod = [](N_Vector p, N_Vector q, N_Vector r) { each([](auto s, auto t, auto u) { u = s * t; }, p, q, r); };
  ops->nvdiv = [](N_Vector p, N_Vector q, N_Vector r) { each([](auto s, auto t, auto u) { u = s / t; }, p, q, r); };
  ops->nvscale = [](realtype c, N_Vector p, N_Vector r) { each([&](auto s, auto u) { u = c * s; }, p, r); };
  ops->nvabs = [](N_Vector p, N_Vector r) { each([](auto s, auto u) { u = s.abs(); }, p, r); };
  ops->nvinv = [](N_Vector p, N_Vector r) { each([](auto s, auto u) { u = s.inverse(); }, p, r); };
  ops->nvaddconst = [](N_Vector p, realtype b, N_Vector r) { each([&](auto s, auto u) { u = s + b; }, p, r); };
  ops->nvdotprod = [](N_Vector p, N_Vector q) {
    double sum = 0;
    each([&](auto s, auto t) { sum += (s * t).sum(); }, p, q);
    return sum;
  };
  ops->nvmaxnorm = [](N_Vector p) {
    double largest = 0;
    each([&](auto s) { largest = s.size() > 0 ? std::max(largest, s.abs().maxCoeff()) : largest; }, p);
    return largest;
  };
  ops->nvmin = [](N_Vector p) {
    double least = HUGE_VAL;
    each([&](auto s) { least = s.size() > 0 ? std::min(least, s.minCoeff()) : least; }, p);
    return least;
  };
  ops->nvl1norm = [](N_Vector p) {
    double sum = 0;
    each([&](auto s) { sum += s.abs().sum(); }, p);
    return sum;
  };
  ops->nvwl2norm = [](N_Vector p, N_Vector w) {
    double sum = 0;
    each([&](auto s, auto t) { sum += (s * t).square().sum(); }, p, w);
    return std::sqrt(sum);
  };
  ops->nvwrmsnorm = [](N_Vector p, N_Vector w) { return N_VWL2Norm(p, w) / std::sqrt(length(p)); };
  return y;
}

}  // namespace ringwatch::detail
