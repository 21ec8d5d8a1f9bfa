// What single precision would give: the force of linear tetrahedra in packs of floats, twice as many lanes as the
// library's, beside the library's own in the same run; with the error that it costs.
#include <cstring>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include <bench/support.h>

namespace ringwatch::bench {
namespace {

using F = Pack<float, 2 * nativeWidth>;
constexpr int lanes = F::width;
typedef float Quad __attribute__((vector_size(16)));

RINGWATCH_INLINE Quad loadQuad(const float* p) {
  Quad q;
  std::memcpy(&q, p, sizeof q);
  return q;
}
/// Four rows to columns, or back.
RINGWATCH_INLINE void transpose(Quad (&r)[4]) {
  const Quad a = __builtin_shufflevector(r[0], r[1], 0, 4, 1, 5), b = __builtin_shufflevector(r[2], r[3], 0, 4, 1, 5);
  const Quad c = __builtin_shufflevector(r[0], r[1], 2, 6, 3, 7), d = __builtin_shufflevector(r[2], r[3], 2, 6, 3, 7);
  r[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
  r[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
  r[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
  r[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}
/// As loadRows and addRows, for floats.
RINGWATCH_INLINE void loadFloatRows(const float* table, const std::uint16_t* row, F (&c)[3]) {
  for (int g = 0; g < lanes / 4; ++g) {
    Quad r[4];
    for (int i = 0; i < 4; ++i) r[i] = loadQuad(table + 4 * row[4 * g + i]);
    transpose(r);
    for (int k = 0; k < 3; ++k) std::memcpy(reinterpret_cast<char*>(&c[k].v) + 16 * g, &r[k], sizeof(Quad));
  }
}
RINGWATCH_INLINE void addFloatRows(float* table, const std::uint16_t* row, const F (&c)[3]) {
  for (int g = 0; g < lanes / 4; ++g) {
    Quad r[4] = {};
    for (int k = 0; k < 3; ++k) std::memcpy(&r[k], reinterpret_cast<const char*>(&c[k].v) + 16 * g, sizeof(Quad));
    transpose(r);
    for (int i = 0; i < 4; ++i) {
      const Quad sum = loadQuad(table + 4 * row[4 * g + i]) + r[i];
      std::memcpy(table + 4 * row[4 * g + i], &sum, sizeof sum);
    }
  }
}

/// Forces of a body of linear tetrahedra in its own patches. Positions are taken from the patch's first node in double
/// precision before they are rounded, so that the error goes with the patch and not with the body; patches add in
/// floats, nodes sum their patches in doubles.
template <class Law>
class FloatForce {
 public:
  FloatForce(const Body& body, const Law& law) : layout_(body.blocks()[0]->layout()), law_(law) {
    const ElementBlock& block = *body.blocks()[0];
    const NodeVectors& X = body.mesh().X;
    for (const Patch& patch : layout_.patches) {
      batchBegin_.push_back(geometry_.size() / 10);
      constexpr int own = lanes;
      for (std::int32_t b = patch.batchBegin; b < patch.batchEnd; b += 2) {
        F geometry[10];
        std::uint16_t local[4][lanes];
        for (int lane = 0; lane < lanes; ++lane) {
          // Where there is no element the first one stands in, weightless.
          std::int32_t from = b + lane / own, at = lane % own;
          const std::int32_t e = from < patch.batchEnd ? layout_.elements[from * own + at] : -1;
          if (e < 0) from = b, at = 0;
          const auto nodes = block.nodesOf(layout_.elements[from * own + at]);
          Eigen::Matrix3d J;
          for (int k = 0; k < 3; ++k) J.col(k) = X.col(nodes[k + 1]) - X.col(nodes[0]);
          const Eigen::Matrix3d inverse = J.inverse();
          for (int i = 0; i < 9; ++i) geometry[i].set(lane, static_cast<float>(inverse(i / 3, i % 3)));
          geometry[9].set(lane, e < 0 ? 0.0F : static_cast<float>(J.determinant() / 6));
          for (int a = 0; a < 4; ++a) local[a][lane] = layout_.localNodes[(from * 4 + a) * own + at];
        }
        geometry_.insert(geometry_.end(), geometry, geometry + 10);
        local_.insert(local_.end(), &local[0][0], &local[0][0] + 4 * lanes);
      }
    }
    batchBegin_.push_back(geometry_.size() / 10);
    slots_.resize(4 * layout_.nodes.size());
    nodeCount_ = body.nodeCount();
    slotBegin_.assign(static_cast<std::size_t>(nodeCount_) + 1, 0);
    for (const std::int32_t node : layout_.nodes) ++slotBegin_[static_cast<std::size_t>(node) + 1];
    for (std::size_t i = 1; i < slotBegin_.size(); ++i) slotBegin_[i] += slotBegin_[i - 1];
    slot_.resize(layout_.nodes.size());
    std::vector<std::int32_t> next(slotBegin_.begin(), slotBegin_.end() - 1);
    for (std::size_t s = 0; s < slot_.size(); ++s) slot_[next[layout_.nodes[s]]++] = static_cast<std::int32_t>(s);
  }

  void operator()(const NodeVectors& x, NodeVectors& f) {
    for (std::size_t p = 0; p < layout_.patches.size(); ++p) addPatch(p, x.data());
    f.resize(3, nodeCount_);
    for (std::int32_t i = 0; i < nodeCount_; ++i) {
      double sum[3] = {0, 0, 0};
      for (std::int32_t s = slotBegin_[i]; s < slotBegin_[static_cast<std::size_t>(i) + 1]; ++s)
        for (std::size_t k = 0; k < 3; ++k)
          sum[k] += static_cast<double>(slots_[4 * static_cast<std::size_t>(slot_[s]) + k]);
      for (int k = 0; k < 3; ++k) f(k, i) = sum[k];
    }
  }

 private:
  void addPatch(std::size_t p, const double* x) {
    const Patch& patch = layout_.patches[p];
    const Law law = law_;
    alignas(64) float rows[4 * 1024];
    const int count = patch.nodeEnd - patch.nodeBegin;
    const std::int32_t* nodes = layout_.nodes.data() + patch.nodeBegin;
    const double* origin = x + 3 * static_cast<std::ptrdiff_t>(nodes[0]);
    for (int i = 0; i < count; ++i) {
      const double* from = x + 3 * static_cast<std::ptrdiff_t>(nodes[i]);
      for (int c = 0; c < 3; ++c) rows[4 * i + c] = static_cast<float>(from[c] - origin[c]);
      rows[4 * i + 3] = 0;
    }
    float* slots = slots_.data() + 4 * static_cast<std::ptrdiff_t>(patch.nodeBegin);
    std::fill(slots, slots + 4 * static_cast<std::ptrdiff_t>(count), 0.0F);
    for (std::int32_t b = batchBegin_[p]; b < batchBegin_[p + 1]; ++b) {
      const std::uint16_t* local = local_.data() + static_cast<std::ptrdiff_t>(b) * 4 * lanes;
      const F* geometry = geometry_.data() + static_cast<std::ptrdiff_t>(b) * 10;
      F at[4][3], force[4][3];
      for (int a = 0; a < 4; ++a) loadFloatRows(rows, local + a * lanes, at[a]);
      Matrix3<F> J1, D;
      for (int i = 0; i < 9; ++i) {
        J1.m[i] = geometry[i];
        D.m[i] = at[i % 3 + 1][i / 3] - at[0][i / 3];
      }
      const Matrix3<F> T = timesTranspose(geometry[9] * law.stress(D * J1), J1);
      for (int i = 0; i < 3; ++i) {
        force[0][i] = -(T(i, 0) + T(i, 1) + T(i, 2));
        for (int j = 0; j < 3; ++j) force[j + 1][i] = T(i, j);
      }
      for (int a = 0; a < 4; ++a) addFloatRows(slots, local + a * lanes, force[a]);
    }
  }

  const PatchLayout& layout_;
  Law law_;
  std::int32_t nodeCount_ = 0;
  std::vector<std::int32_t> batchBegin_;  // by patch
  AlignedVector<F> geometry_;
  std::vector<std::uint16_t> local_;
  AlignedVector<float> slots_;
  std::vector<std::int32_t> slotBegin_, slot_;
};

void singleForce(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  std::visit(
      [&](const auto& law) {
        FloatForce force(s.body, law);
        NodeVectors f, expected;
        s.body.internalForce(s.x, expected, s.workspace);
        for (auto _ : state) {
          force(s.x, f);
          benchmark::DoNotOptimize(f.data());
          benchmark::ClobberMemory();
        }
        report(state, s.body.mesh().elementCount(), relativeDifference(f, expected));
      },
      makeMaterial(c.law, 30e3, 0.3, 1000).law);
}
void doubleForce(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  NodeVectors f;
  s.body.internalForce(s.x, f, s.workspace);
  for (auto _ : state) {
    s.body.internalForce(s.x, f, s.workspace);
    benchmark::DoNotOptimize(f.data());
    benchmark::ClobberMemory();
  }
  report(state, s.body.mesh().elementCount(), f.rowwise().sum().norm() / f.colwise().norm().sum());
}

void registerAll() {
  for (const int elements : {5000, 100000, 1000000})
    for (const LawInfo& law : allLaws()) {
      const Case c{"tet4", elements, std::string(law.name), 1};
      const auto add = [&](const char* pass, void (*run)(benchmark::State&, const Case&)) {
        benchmark::RegisterBenchmark((std::string(pass) + "/" + c.name()).c_str(), [=](benchmark::State& state) {
          run(state, c);
        })->Unit(benchmark::kMicrosecond);
      };
      add("force_double", doubleForce);
      add("force_single", singleForce);
    }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
