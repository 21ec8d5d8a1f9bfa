#include <ringwatch/monitor/lazy_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/nodal_shapes.h>
#include <ringwatch/monitor/scaled_tangent.h>
#include <ringwatch/monitor/tangent_growth.h>

namespace ringwatch {
namespace {

constexpr int lanes = PatchLayout::lanes;
constexpr int coldSweeps = 12;         // of a retarget, at most
constexpr double leastShare = 0.9;     // of what counts as risen
constexpr double leastGain = 0.005;    // of two sweeps; half of it in the step
constexpr int soon = 200;              // updates after which a lowering counts as wanted again too soon
constexpr int leastGapOfChange = 640;  // updates that it takes a state to change much

double largest(const Eigen::Matrix3d& S) {
  Eigen::Matrix3d A = S;
  double work[12];
  const auto extremes = extremeEigenvalues(A.data(), 3, work, false);
  return extremes.largest + eigenvalueRounding * extremes.scale;
}

/// Largest t with base + t part ≼ sigma I; 0 when base alone is too large.
double roomFor(const Eigen::Matrix3d& base, const Eigen::Matrix3d& part, double sigma) {
  const Eigen::LLT<Eigen::Matrix3d> factor(sigma * Eigen::Matrix3d::Identity() - base);
  if (factor.info() != Eigen::Success) return 0;
  const Eigen::Matrix3d half = factor.matrixL().solve(part);
  const double top = largest(factor.matrixL().solve(half.transpose()));
  return top > 0 ? 1 / (top * (1 + 1e-12)) : std::numeric_limits<double>::infinity();
}

/// Where sigma is put when it is steered.
double comfortable(LowerBound lower, double width) { return (1 + 0.8 * width) * (1 + 0.8 * width) * lower.value; }

bool isBefore(const LazyBound::Risen& a, const LazyBound::Risen& b) {
  return a.share != b.share ? a.share > b.share : a.element < b.element;
}

}  // namespace

LazyBound::LazyBound(const Body& body, double slack)
    : body_(body), slack_(slack), shapes_(body), bodyVersion_(body.version()) {
  for (const auto& block : body.blocks()) {
    const std::size_t places = block->layout().elements.size();
    blocks_.push_back({ValidityBalls(*block), std::vector<float>(places), std::vector<float>(places),
                       std::vector<Bfloat16>(places), std::vector<Bfloat16>(places)});
  }
}

void LazyBound::setBall(std::int32_t b, std::int32_t element, const Evaluated& evaluated) {
  BlockData& data = blocks_[static_cast<std::size_t>(b)];
  const std::size_t place = placeOf({b, element});
  data.value[place] = roundedUp(evaluated.value);
  data.balls.setRadius(place,
                       ballRadius(evaluated.drift.law, evaluated.drift.inversionDistance, evaluated.value,
                                  static_cast<double>(data.budget[place]), data.reach[place]),
                       evaluated.fromAnchor);
}

void LazyBound::evaluatePack(const NodeVectors& x, std::int32_t b, const std::int32_t* elements, const double* known,
                             bool withReach, Evaluated* results) {
  const ElementBlock& block = *body_.blocks()[static_cast<std::size_t>(b)];
  BlockData& data = blocks_[static_cast<std::size_t>(b)];
  const auto points = static_cast<int>(block.rule().points.size());
  double value[lanes], reach[lanes];
  TangentDrift drift[lanes];
  std::vector<double> F(static_cast<std::size_t>(9 * points * lanes));
  if (known) std::copy_n(known, lanes, value);
  if (!known) shapes_.elementValues(b, elements, x, value);
  if (withReach) strainNormBounds(body_, shapes_, b, elements, reach);
  block.deformationOf(elements, x.data(), F.data(), drift);
  for (int lane = 0; lane < lanes; ++lane) {
    if (elements[lane] < 0) continue;
    const std::size_t place = placeOf({b, elements[lane]});
    if (withReach) data.reach[place] = Bfloat16::up(reach[lane]);
    results[lane] = {value[lane], drift[lane], data.balls.setReferenceGradient(place, F.data(), points, lane)};
  }
}

void LazyBound::evaluate(const NodeVectors& x, const std::vector<ElementRef>& elements, bool withReach,
                         std::vector<Evaluated>& results) {
  results.resize(elements.size());
  // Packs of elements of one block.
  struct Pack {
    std::int32_t block;
    std::int32_t element[lanes];
    std::size_t at[lanes];
    int count = 0;
  };
  std::vector<Pack> packs;
  std::vector<std::ptrdiff_t> open(blocks_.size(), -1);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    std::ptrdiff_t& p = open[static_cast<std::size_t>(elements[i].block)];
    if (p < 0) {
      p = static_cast<std::ptrdiff_t>(packs.size());
      packs.push_back({elements[i].block, {}, {}, 0});
      std::fill(std::begin(packs.back().element), std::end(packs.back().element), -1);
    }
    Pack& pack = packs[static_cast<std::size_t>(p)];
    pack.element[pack.count] = elements[i].element;
    pack.at[pack.count] = i;
    if (++pack.count == lanes) p = -1;
  }
  parallelFor(
      0, static_cast<std::int64_t>(packs.size()), body_.threads(),
      [&](std::int64_t k) {
        const Pack& pack = packs[static_cast<std::size_t>(k)];
        Evaluated own[lanes];
        evaluatePack(x, pack.block, pack.element, nullptr, withReach, own);
        for (int lane = 0; lane < pack.count; ++lane) {
          results[pack.at[lane]] = own[lane];
          setBall(pack.block, pack.element[lane], own[lane]);
        }
      },
      8);
  for (std::size_t i = 0; i < elements.size(); ++i) note(elements[i], results[i].drift);
  spent_.evaluated += static_cast<std::int64_t>(elements.size());
}

void LazyBound::note(ElementRef element, const TangentDrift& drift) {
  if (drift.determinant < spent_.leastDeterminant) {
    spent_.leastDeterminant = drift.determinant;
    spent_.leastDeterminantElement = element;
  }
  const double modulus = body_.blocks()[static_cast<std::size_t>(element.block)]->material().restModulus();
  const Bfloat16 compression = Bfloat16::up(drift.law.negative / modulus);
  blocks_[static_cast<std::size_t>(element.block)].compression[placeOf(element)] = compression;
  mostCompression_ = std::max(mostCompression_, static_cast<double>(compression));
}

std::vector<ElementRef> LazyBound::compressedElements(double least) const {
  if (!(mostCompression_ > least)) return {};
  std::vector<Risen> found;  // by compression
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (std::size_t place = 0; place < blocks_[b].compression.size(); ++place) {
      const double compression = blocks_[b].compression[place];
      if (compression > least)
        found.push_back({compression, {static_cast<std::int32_t>(b), body_.blocks()[b]->layout().elements[place]}});
    }
  std::sort(found.begin(), found.end(), isBefore);
  std::vector<ElementRef> result;
  for (const Risen& entry : found) result.push_back(entry.element);
  return result;
}

std::vector<ElementRef> LazyBound::hottestElements(std::size_t count) {
  if (!started_) return {};
  std::vector<std::span<const float>> values;
  for (const BlockData& data : blocks_) values.emplace_back(data.value);
  const std::vector<double>& nodal = shapes_.sumsOf(values);
  std::vector<std::int32_t> nodes(static_cast<std::size_t>(body_.nodeCount()));
  std::iota(nodes.begin(), nodes.end(), 0);
  const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(std::min(count, nodes.size()));
  std::partial_sort(nodes.begin(), end, nodes.end(), [&](std::int32_t a, std::int32_t b) {
    const double at = nodal[static_cast<std::size_t>(a)], other = nodal[static_cast<std::size_t>(b)];
    return at != other ? at > other : a < b;
  });
  std::vector<ElementRef> result;
  for (auto node = nodes.begin(); node != end; ++node) {
    double most = 0;
    ElementRef hottest;
    for (const NodalBound::Incidence at : shapes_.incidences(*node)) {
      const ElementRef e = shapes_.elementAt(at);
      const double part =
          static_cast<double>(blocks_[static_cast<std::size_t>(e.block)].value[placeOf(e)]) * shapes_.shape(at).trace();
      if (part > most) {
        most = part;
        hottest = e;
      }
    }
    if (most > 0) result.push_back(hottest);
  }
  shapes_.releaseSums();
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void LazyBound::dealBudgets(const NodeVectors& x) {
  mostCompression_ = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    BlockData& data = blocks_[b];
    constexpr std::int32_t chunk = 8;
    const std::int32_t batches = block.layout().batchCount();
    std::vector<TangentDrift> drifts(static_cast<std::size_t>(batches) * lanes);
    parallelFor(0, (batches + chunk - 1) / chunk, body_.threads(), [&](std::int64_t c) {
      const std::int32_t end = std::min(batches, static_cast<std::int32_t>(c + 1) * chunk);
      for (auto batch = static_cast<std::int32_t>(c) * chunk; batch < end; ++batch) {
        const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
        Evaluated own[lanes];
        double swept[lanes] = {};
        for (int lane = 0; lane < lanes; ++lane)
          if (elements[lane] >= 0) swept[lane] = shapes_.value({static_cast<std::int32_t>(b), elements[lane]});
        evaluatePack(x, static_cast<std::int32_t>(b), elements, swept, true, own);
        for (int lane = 0; lane < lanes; ++lane) {
          if (elements[lane] < 0) continue;
          const std::size_t place = static_cast<std::size_t>(batch * lanes + lane);
          drifts[place] = own[lane].drift;
          double room = std::numeric_limits<double>::infinity();
          for (std::int32_t node : block.nodesOf(elements[lane]))
            if (shapes_.nodal()[static_cast<std::size_t>(node)] > 0)
              room = std::min(room, sigma_ / shapes_.nodal()[static_cast<std::size_t>(node)]);
          data.budget[place] = swept[lane] > 0 ? roundedDown(swept[lane] * room * (1 - 1e-12)) : 0;
          setBall(static_cast<std::int32_t>(b), elements[lane], own[lane]);
          // Nothing of a wholly constrained element is left in the problem.
          if (body_.constraints().any() && own[lane].value == 0 && data.reach[place] <= 1e-200)
            data.balls.setNeverOutside(place);
        }
      }
    });
    for (std::size_t i = 0; i < drifts.size(); ++i)
      if (block.layout().elements[i] >= 0) note({static_cast<std::int32_t>(b), block.layout().elements[i]}, drifts[i]);
    spent_.evaluated += block.elementCount();
    data.balls.invalidateAll();
  }
  shapes_.releaseSums();
  frames_.resize(static_cast<std::size_t>(body_.nodeCount()));
  parallelFor(
      0, body_.nodeCount(), body_.threads(),
      [&](std::int64_t node) { frames_[static_cast<std::size_t>(node)] = frameOf(static_cast<std::int32_t>(node)); },
      64);
}

void LazyBound::retarget(const NodeVectors& x, int sweeps) {
  shapes_.reset();  // warm shapes get stuck at a front that moves through the mesh
  shapes_.evaluate(x, sweeps, NodalBound::Start::rootOfStiffness, leastGain);
  spent_.evaluated += shapes_.evaluations();
  ++spent_.retargets;
  retarget_.restart();
  tightOverLower_ = 0;
}

std::vector<ElementRef> LazyBound::elementsOutsideBall(const NodeVectors& x, StepEvaluation* evaluation) {
  outside_.resize(blocks_.size());
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    outside_[b].resize(body_.blocks()[b]->layout().patches.size());
    for (auto& list : outside_[b]) list.clear();
    blocks_[b].balls.beginCheck();
  }
  class Check final : public PatchVisitor {
   public:
    explicit Check(LazyBound& bound) : bound_(bound) {}
    void visitPatch(std::size_t block, const PatchPass& pass) override {
      bound_.blocks_[block].balls.checkPatch(pass, bound_.outside_[block][static_cast<std::size_t>(pass.index())]);
    }

   private:
    LazyBound& bound_;
  };
  Check check(*this);
  StepEvaluation checkOnly;
  checkOnly.wantsForce = false;
  StepEvaluation& asked = evaluation ? *evaluation : checkOnly;
  asked.visitor = &check;
  body_.evaluate(x, asked, workspace_);
  asked.visitor = nullptr;
  std::vector<ElementRef> outside;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (const auto& list : outside_[b])
      for (std::int32_t e : list) outside.push_back({static_cast<std::int32_t>(b), e});
  return outside;
}

LazyBound::Outcome LazyBound::follow(const NodeVectors& x, bool mayRaise, StepEvaluation* evaluation) {
  risen_.clear();
  const std::vector<ElementRef> outside = elementsOutsideBall(x, evaluation);
  std::vector<Evaluated> now;
  evaluate(x, outside, false, now);
  anchored_ = outside;
  for (std::size_t i = 0; i < outside.size(); ++i) {
    if (!std::isfinite(now[i].value)) return Outcome::notFinite;
    const double budget = budgetOf(outside[i]), value = now[i].value;
    const double share = budget > 0 ? value / budget : value > 0 ? std::numeric_limits<double>::infinity() : 0;
    if (share > leastShare) risen_.push_back({share, outside[i]});
  }
  std::sort(risen_.begin(), risen_.end(), isBefore);
  const auto overEnd = std::find_if(risen_.begin(), risen_.end(), [](const Risen& r) { return r.share <= 1; });
  // When very many are over their budgets, mending one by one costs more than starting from scratch.
  if (static_cast<double>(overEnd - risen_.begin()) > 0.05 * static_cast<double>(body_.mesh().elementCount()))
    return Outcome::flooded;
  for (auto over = risen_.begin(); over != overEnd; ++over) {
    const ElementRef e = over->element;
    const BlockData& data = blocks_[static_cast<std::size_t>(e.block)];
    if (data.value[placeOf(e)] <= data.budget[placeOf(e)]) continue;  // a neighbour's repair served it
    if (!repair(x, e, mayRaise)) return Outcome::failed;
  }
  for (ElementRef e : anchored_) blocks_[static_cast<std::size_t>(e.block)].balls.ballChanged(placeOf(e));
  return Outcome::fine;
}

void LazyBound::followBody() {
  if (bodyVersion_ == body_.version()) return;
  bodyVersion_ = body_.version();
  started_ = false;
  // The next attempt must not wait for its turn.
  retarget_.reset();
}

UpperBound LazyBound::update(const NodeVectors& x, StepEvaluation* evaluation) {
  spent_ = {};
  followBody();
  retarget_.tick();
  lowering_.tick();
  if (!started_ && evaluation) body_.evaluate(x, *evaluation, workspace_);
  const Outcome outcome = started_ ? follow(x, true, evaluation) : Outcome::flooded;
  if (outcome == Outcome::flooded || outcome == Outcome::failed) {
    retarget(x, coldSweeps);
    sigma_ = shapes_.last() * (1 + slack_);
    started_ = std::isfinite(sigma_);
    if (started_) dealBudgets(x);
  } else if (outcome == Outcome::notFinite) {
    started_ = false;
    sigma_ = std::numeric_limits<double>::quiet_NaN();
  }
  return {sigma_};
}

bool LazyBound::certify(const NodeVectors& x, double sigma, StepEvaluation* evaluation) {
  spent_ = {};
  followBody();
  retarget_.tick();
  lowering_.tick();
  if (started_ && sigma_ <= sigma) {
    const Outcome outcome = follow(x, false, evaluation);
    if (outcome == Outcome::fine) return true;
    started_ = false;
    if (outcome == Outcome::notFinite) return false;
  } else if (evaluation) {
    body_.evaluate(x, *evaluation, workspace_);
  }
  // From scratch, but not at every step while it keeps failing.
  if (!retarget_.due()) return false;
  retarget(x, coldSweeps);
  const double tight = shapes_.last();
  const bool proven = tight <= sigma * (1 - 1e-3);
  retarget_.tried(proven);
  // What was found serves update() in any case.
  sigma_ = proven ? sigma : tight * (1 + slack_);
  started_ = std::isfinite(sigma_);
  if (started_) dealBudgets(x);
  return proven;
}

Eigen::Quaternionf LazyBound::frameOf(std::int32_t node) const {
  constexpr int enough = 6;  // elements; the same ones every time
  Matrix3<double> F = Matrix3<double>::zero();
  int count = 0;
  for (const NodalBound::Incidence at : shapes_.incidences(node)) {
    if (++count > enough) break;
    const ElementRef e = shapes_.elementAt(at);
    blocks_[static_cast<std::size_t>(e.block)].balls.addReferenceGradient(placeOf(e), F.m);
  }
  const Matrix3<double> R = closestRotation(F);
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = R.m[i];
  return Eigen::Quaterniond(matrix).cast<float>();
}

/// D ← Q D Qᵀ for all elements at a node with the same Q leaves the eigenvalues of its sum where they are, but for
/// rounding. Returns the nodes that were turned by enough to matter. Anchors must be of now.
std::vector<std::int32_t> LazyBound::turnShapes(const std::vector<std::int32_t>& nodes) {
  constexpr float enough = 0.01F;  // rad
  std::vector<std::int32_t> turned;
  for (const std::int32_t node : nodes) {
    // Where components are constrained the sum is cut along fixed axes.
    if (body_.constraints().any() && body_.constraints().freeComponents(node) < 3) continue;
    const Eigen::Quaternionf frame = frameOf(node);
    if (frame.angularDistance(frames_[static_cast<std::size_t>(node)]) < enough) continue;
    const Eigen::Matrix3d Q =
        (frame * frames_[static_cast<std::size_t>(node)].conjugate()).normalized().toRotationMatrix().cast<double>();
    for (const NodalBound::Incidence at : shapes_.incidences(node))
      shapes_.setShape(at, Q * shapes_.shape(at) * Q.transpose());
    frames_[static_cast<std::size_t>(node)] = frame;
    turned.push_back(node);
  }
  return turned;
}

Eigen::Matrix3d LazyBound::sumOfBudgets(std::int32_t node) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const NodalBound::Incidence at : shapes_.incidences(node))
    sum += budgetOf(shapes_.elementAt(at)) * shapes_.shape(at);
  return sum;
}

bool LazyBound::repair(const NodeVectors& x, ElementRef element, bool mayRaise) {
  constexpr int growths = 2, sweeps = 3;
  ++spent_.repairs;
  std::vector<ElementRef> seed{element}, ring;
  for (int growth = 0;; ++growth) {
    // Patch: free nodes of the seed; ring: all elements at them; rim: all free nodes of the ring.
    std::vector<std::int32_t> patch, rim;
    auto freeNodesOf = [&](const std::vector<ElementRef>& elements) {
      std::vector<std::int32_t> nodes;
      for (ElementRef e : elements)
        for (std::int32_t node : body_.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element))
          if (!body_.constraints().any() || body_.constraints().freeComponents(node) > 0) nodes.push_back(node);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      return nodes;
    };
    patch = freeNodesOf(seed);
    ring.clear();
    for (std::int32_t node : patch)
      for (const NodalBound::Incidence at : shapes_.incidences(node)) ring.push_back(shapes_.elementAt(at));
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    rim = freeNodesOf(ring);
    auto valueOf = [&](ElementRef e) {
      return static_cast<double>(blocks_[static_cast<std::size_t>(e.block)].value[placeOf(e)]);
    };

    // What the elements outside the ring use of sigma at the rim, and where those of the ring meet it.
    struct Meeting {
      std::size_t rim, ring;
      NodalBound::Incidence at;
    };
    std::vector<Meeting> meetings;
    std::vector<Eigen::Matrix3d> outside(rim.size()), inside(rim.size());
    for (std::size_t i = 0; i < rim.size(); ++i) {
      outside[i].setZero();
      for (const NodalBound::Incidence at : shapes_.incidences(rim[i])) {
        const ElementRef e = shapes_.elementAt(at);
        const auto own = std::lower_bound(ring.begin(), ring.end(), e);
        if (own != ring.end() && *own == e)
          meetings.push_back({i, static_cast<std::size_t>(own - ring.begin()), at});
        else
          outside[i] += budgetOf(e) * shapes_.shape(at);
      }
      outside[i] = freePart(body_, rim[i], outside[i] / body_.lumpedMass()[rim[i]]);
    }
    std::vector<Evaluated> now;
    evaluate(x, ring, false, now);
    const std::vector<std::int32_t> turned = growth == 0 ? turnShapes(patch) : std::vector<std::int32_t>();
    if (!turned.empty()) {
      // Turned shapes are rounded: budgets there pay for what that adds to the sums.
      for (const std::int32_t node : turned) {
        const double share = sigma_ * body_.lumpedMass()[node] / largest(sumOfBudgets(node));
        if (share > 1) continue;
        for (const NodalBound::Incidence at : shapes_.incidences(node)) {
          const ElementRef e = shapes_.elementAt(at);
          float& budget = blocks_[static_cast<std::size_t>(e.block)].budget[placeOf(e)];
          budget = roundedDown(static_cast<double>(budget) * share * (1 - 1e-12));
        }
      }
      evaluate(x, ring, true, now);
      if (std::all_of(ring.begin(), ring.end(), [&](ElementRef e) { return valueOf(e) <= budgetOf(e); })) {
        anchored_.insert(anchored_.end(), ring.begin(), ring.end());
        return true;
      }
    }
    for (int sweep = 0;; ++sweep) {
      if (sweep > 0) evaluate(x, ring, true, now);  // with new shapes
      double least = std::numeric_limits<double>::infinity();
      std::vector<double> room(rim.size());
      std::fill(inside.begin(), inside.end(), Eigen::Matrix3d::Zero());
      for (const Meeting& m : meetings) inside[m.rim] += valueOf(ring[m.ring]) * shapes_.shape(m.at);
      for (std::size_t i = 0; i < rim.size(); ++i) {
        inside[i] = freePart(body_, rim[i], inside[i] / body_.lumpedMass()[rim[i]]);
        room[i] = roomFor(outside[i], inside[i], sigma_);
        least = std::min(least, room[i]);
      }
      const bool last = sweep == sweeps && growth == growths;
      bool deal = least > 1 + (sweep == sweeps ? 0.05 : 0.25) * slack_;
      if (!deal && last && mayRaise) {
        // Everybody else's proof holds for a larger sigma too.
        double need = 0;
        for (std::size_t i = 0; i < rim.size(); ++i) need = std::max(need, largest(outside[i] + inside[i]));
        sigma_ = std::max(sigma_, need * (1 + 0.5 * slack_));
        ++spent_.raises;
        for (std::size_t i = 0; i < rim.size(); ++i) room[i] = roomFor(outside[i], inside[i], sigma_);
        deal = true;
      }
      if (deal) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
          const ElementRef e = ring[k];
          double own = std::numeric_limits<double>::infinity();
          for (std::int32_t node : body_.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element)) {
            const auto at = std::lower_bound(rim.begin(), rim.end(), node);
            if (at != rim.end() && *at == node) own = std::min(own, room[static_cast<std::size_t>(at - rim.begin())]);
          }
          BlockData& data = blocks_[static_cast<std::size_t>(e.block)];
          const std::size_t place = placeOf(e);
          if (std::isfinite(own)) data.budget[place] = roundedDown(valueOf(e) * own * (1 - 1e-12));
          setBall(e.block, e.element, now[k]);
        }
        anchored_.insert(anchored_.end(), ring.begin(), ring.end());
        return true;
      }
      if (sweep == sweeps) break;
      // Shapes at the patch's own nodes: what they gain there costs nothing outside the ring.
      std::vector<Eigen::Matrix3d> factors;
      for (const std::int32_t node : patch) {
        const auto at = static_cast<std::size_t>(std::lower_bound(rim.begin(), rim.end(), node) - rim.begin());
        Eigen::Matrix3d S = (outside[at] + inside[at]) / sigma_;
        for (int c = 0; c < 3; ++c)
          if (freeFactor(body_, node, c) == 0) S(c, c) = 1;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(S);
        const Eigen::Vector3d power = solver.eigenvalues().cwiseMax(1e-3).array().pow(-0.25);
        factors.push_back(solver.eigenvectors() * power.asDiagonal() * solver.eigenvectors().transpose());
        frames_[static_cast<std::size_t>(node)] = frameOf(node);
      }
      for (const ElementRef e : ring) {
        std::vector<Eigen::Matrix3d> own;
        for (const std::int32_t node : body_.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element)) {
          own.push_back(shapes_.shape(shapes_.incidenceOf(e, static_cast<int>(own.size()))));
          const auto at = std::lower_bound(patch.begin(), patch.end(), node);
          if (at == patch.end() || *at != node) continue;
          const Eigen::Matrix3d& R = factors[static_cast<std::size_t>(at - patch.begin())];
          own.back() = R * own.back() * R;
        }
        shapes_.setShapes(e, own);
      }
    }
    if (growth == growths) return false;
    seed = ring;
  }
}

void LazyBound::ease(LowerBound lower, double width) {
  if (!started_ || !(sigma_ < (1 + 0.6 * width) * (1 + 0.6 * width) * lower.value)) return;
  const double eased = comfortable(lower, width);
  for (BlockData& data : blocks_)
    for (float& budget : data.budget)
      budget = roundedDown(static_cast<double>(budget) * (eased / sigma_) * (1 - 1e-12));
  sigma_ = eased;
}

bool LazyBound::steer(const NodeVectors& x, LowerBound lower, double width) {
  if (!started_ || !(lower.value > 0)) return false;
  const double allowed = (1 + width) * (1 + width) * lower.value;
  if (sigma_ <= allowed) return false;
  // What the family of shapes reached at the last retarget it will hardly undercut now: where that is wide, as on
  // regular grids, lowering sigma would only send elements out of their balls.
  if (tightOverLower_ == 0) tightOverLower_ = shapes_.last() / lower.value;
  const double target = std::max(comfortable(lower, width), tightOverLower_ * (1 + 0.3 * slack_) * lower.value);
  // Lowering sigma scales every budget; balls shrink at least in proportion to the gaps, since r is concave in the gap.
  if (target < 0.99 * sigma_ && lowering_.due()) {
    // One that was wanted again so soon did not help for long.
    lowering_.tried(lowering_.since() >= soon);
    const double factor = target / sigma_;
    sigma_ = target;
    for (BlockData& data : blocks_) {
      for (std::size_t place = 0; place < data.budget.size(); ++place) {
        const auto value = static_cast<double>(data.value[place]);
        const double before = static_cast<double>(data.budget[place]) - value;
        data.budget[place] = roundedDown(static_cast<double>(data.budget[place]) * factor);
        const double after = static_cast<double>(data.budget[place]) - value;
        const double radius = data.balls.radius(place), error = ValidityBalls::storageError;
        if (radius >= 0 && std::isfinite(radius))
          data.balls.setRadius(place, after > 0 && before > 0 ? (radius + error) * (after / before) : -1, error);
      }
      data.balls.invalidateAll();
    }
    return true;
  }
  // Starting from scratch pays where sigma has drifted above what it gave last; else only a state that has changed much
  // helps.
  const bool drifted = sigma_ > 1.05 * tightOverLower_ * (1 + slack_) * lower.value;
  if (retarget_.due(drifted ? 0 : leastGapOfChange)) {
    spent_ = {};
    retarget(x, coldSweeps);
    const double fresh = shapes_.last() * (1 + slack_);
    retarget_.tried(fresh <= 0.97 * sigma_);
    sigma_ = fresh;
    dealBudgets(x);
    return true;
  }
  return false;
}

double LazyBound::verify(const NodeVectors& x) const {
  double excess = -1;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (std::int32_t e = 0; e < body_.blocks()[b]->elementCount(); ++e) {
      std::int32_t elements[lanes];
      std::fill(elements, elements + lanes, -1);
      elements[0] = e;
      double value[lanes];
      shapes_.elementValues(static_cast<std::int32_t>(b), elements, x, value);
      const double budget = budgetOf({static_cast<std::int32_t>(b), e});
      if (value[0] > 0) excess = std::max(excess, value[0] / budget - 1);
    }
  for (std::int32_t node = 0; node < body_.nodeCount(); ++node) {
    excess =
        std::max(excess, largest(freePart(body_, node, sumOfBudgets(node) / body_.lumpedMass()[node])) / sigma_ - 1);
  }
  return excess;
}

}  // namespace ringwatch
