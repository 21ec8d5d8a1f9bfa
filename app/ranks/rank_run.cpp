#include <ringwatch/app/ranks/rank_run.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/output/provenance.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/ranks/rank_frames.h>
#include <ringwatch/app/ranks/rank_threads.h>
#include <ringwatch/app/ranks/together.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/run_summary.h>
#include <ringwatch/app/run/runner.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/distributed/exchange.h>
#include <ringwatch/distributed/rank_domain.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>

namespace ringwatch {
namespace {

/// What is asked of a run from outside: of any rank, and, from the next maximum over them on, of all.
class Wishes {
 public:
  explicit Wishes(const RankRunRequest& request) : request_(request) {}
  /// Of this rank since the last call: the larger one goes before others.
  int asked() const { return request_.interrupt->load() ? end : request_.checkpoint->exchange(false) ? save : none; }
  void agree(int asked) {
    if (asked == end) interrupt = true;
    if (asked == save) checkpoint = true;
  }
  std::atomic<bool> interrupt = false, checkpoint = false;

 private:
  enum : int { none, save, end };
  const RankRunRequest& request_;
};

/// Every maximum over the ranks tells them what is asked of the run: all know it at the same place of it.
class RunDomain final : public RankDomain {
 public:
  RunDomain(Ranks& ranks, Halo& halo, RankBody& part, Wishes& wishes)
      : RankDomain(ranks, halo, part), ranks_(ranks), wishes_(wishes) {}
  void largest(std::span<double> numbers, const std::function<void()>& meanwhile = {}) override {
    std::vector<double> told(numbers.begin(), numbers.end());
    told.push_back(wishes_.asked());
    ranks_.largest(told, meanwhile);
    wishes_.agree(static_cast<int>(told.back()));
    std::copy(told.begin(), told.end() - 1, numbers.begin());
  }
  void together(const std::function<void()>& work) override {
    knownToAll = true;
    ringwatch::together(ranks_, work);
    knownToAll = false;
  }
  bool knownToAll = false;  // a fault is being told by together()

 private:
  Ranks& ranks_;
  Wishes& wishes_;
};

class RankRun {
 public:
  RankRun(Ranks& ranks, const RankRunRequest& request) : ranks_(ranks), request_(request), wishes_(request) {}

  ExitStatus go(const std::function<void(const std::string&)>& print) {
    begin();
    try {
      const RunResult result = runScene(scene_, part_->body(), options_);
      if (result.reason == ExitReason::failed) abortAll(ranks_, result.reasonText, ExitStatus::unstable);
      auto status = static_cast<int>(result.exitStatus());
      try {
        if (first() && !request_.quiet) print(summaryText(scene_, *whole_, result, request_.folder));
      } catch (const std::exception& fault) {
        // Where the run was interrupted the terminal may be what is gone.
        if (result.reason != ExitReason::interrupted) endAll(ranks_, fault.what(), ExitStatus::unstable);
      }
      ranks_.share(&status, sizeof status, 0);  // of the first rank, which knows of all events
      return static_cast<ExitStatus>(status);
    } catch (const RunFailed& fault) {
      endAll(ranks_, fault.what(), ExitStatus::unstable);
    } catch (const std::exception& fault) {
      if (domain_->knownToAll) throw;
      endAll(ranks_, faultText(fault), ExitStatus::badInput);
    }
  }

 private:
  bool first() const { return ranks_.rank() == 0; }

  /// Every rank reads the scene and makes the whole body, and keeps its part.
  void begin() {
    std::optional<TimedLoads> allLoads;
    State all;
    together(ranks_, [&] {
      readScenes();
      Mesh mesh = sceneMesh(scene_, options_.notes);
      const int threads = threadsOfRank(ranks_, request_.threads, mesh);
      whole_ = std::make_unique<Body>(sceneBody(scene_, std::move(mesh), threads));
      for (std::string& note : bodyNotes(*whole_)) options_.notes.push_back(std::move(note));
      if (saved_) {
        requireSameMesh(*saved_, scene_, *whole_);
        resumeMotion(whole_->constraints(), saved_->parts.at("moved").get<std::vector<double>>());
      }
      all = saved_ ? saved_->state : sceneInitialState(scene_, BodySystem(*whole_, scene_.damping));
      allLoads.emplace(scene_, *whole_);
      if (!scene_.handler.empty()) choose();
    });
    Partition partition = cutTogether(ranks_, whole_->mesh());
    together(ranks_, [&] { takePart(partition, *allLoads, all); });
    frames_ = std::make_unique<RankFrames>(ranks_, *part_);
    of_.pieces = frames_.get();
  }

  void readScenes() {
    if (request_.resumed.empty()) {
      scene_ = readScene(request_.scene, request_.overrides);
    } else {
      saved_ = readCheckpoint(request_.resumed);
      requireWrittenBy(*saved_, true, request_.resumed);
      if (!request_.scene.empty()) requireSameScene(*saved_, readScene(request_.scene, {}), request_.resumed);
      scene_ = sceneOf(*saved_);
      options_.resume = &*saved_;
    }
    requireTaken(scene_, SceneUse::ranks);
  }

  /// The elements of the whole body that the handler handles, which may change its masses.
  void choose() {
    of_.handler = makeHandler(scene_.handler, *whole_, integratorCatalog().make(scene_.method), scene_.handlerOptions);
    of_.handler->prepare(whole_->mesh().X, *scene_.step);
    if (const std::string fault = of_.handler->whyNotInParts(); !fault.empty())
      throw InputError(fmt::format("{}: {}", scene_.file.string(), fault));
  }

  void takePart(Partition& partition, const TimedLoads& allLoads, const State& all) {
    const int threads = threadsOfRank(ranks_, request_.threads, whole_->mesh());
    if (of_.handler && &of_.handler->explicitBody() != whole_.get()) {
      // A cluster is solved by one rank.
      for (const std::vector<ElementRef>& elements : clustersOf(*whole_, of_.handler->elements()))
        keepTogether(partition, nodesOfElements(*whole_, elements));
      explicitPart_ = std::make_unique<RankBody>(of_.handler->explicitBody(), partition, ranks_.rank(), threads);
      explicitPart_->nameElementsBy(elementNumbers(complement(of_.handler->chosen())));
      of_.explicitPart = &explicitPart_->body();
    }
    part_ = std::make_unique<RankBody>(*whole_, partition, ranks_.rank(), threads);
    // What the monitor sees of the part: all of it, or the explicit elements.
    halo_ = std::make_unique<Halo>(ranks_, explicitPart_ ? *explicitPart_ : *part_);
    domain_ = std::make_unique<RunDomain>(ranks_, *halo_, *part_, wishes_);
    if (explicitPart_) explicitDomain_ = std::make_unique<RunDomain>(ranks_, *halo_, *explicitPart_, wishes_);
    of_.process = ranks_.name() + ", ";
    of_.ofWhole = summaryJson(scene_, *whole_, {});
    of_.begin.time = all.time;
    of_.begin.x = domain_->taken(all.x);
    of_.begin.v = domain_->taken(all.v);
    of_.loads.emplace(allLoads, part_->body(), part_->globalNodes());
    of_.sent = [this](std::int64_t steps) { return traffic(steps); };
    options_.folder = request_.folder;
    options_.progress = first() && !request_.quiet;
    options_.interrupt = &wishes_.interrupt;
    options_.checkpoint = &wishes_.checkpoint;
    options_.part = &of_;
    options_.provenance = provenanceOf(request_.command, request_.scene);
    of_.ofWhole["provenance"] = options_.provenance;
    of_.ofWhole["provenance"]["mesh_hash"] = fmt::format("{:016x}", hashOf(whole_->mesh()));
    options_.notes.emplace_back("the run was shared among ranks");
    if (scene_.device == RunDevice::automatic)
      options_.notes.emplace_back("device = \"auto\": ranks take their steps on the CPU");
    if (scene_.frameInterval && std::ranges::count(scene_.fields, "critical_step") > 0)
      options_.notes.emplace_back("frames of ranks are without critical_step, which is not distributed");
    if (first())
      of_.whole = whole_.get();
    else
      whole_.reset();
  }

  /// Of all ranks, of a run that has come to so many steps. Collective.
  RunResult::Traffic traffic(std::int64_t steps) {
    const Halo::Traffic& own = halo_->traffic();
    RunResult::Traffic all;
    all.ranks = ranks_.size();
    all.exchanges = own.exchanges;
    all.messages = sumOver(ranks_, own.messages);
    all.bytes = sumOver(ranks_, own.bytes);
    const std::int64_t before = saved_ ? saved_->parts.at("result").at("steps").get<std::int64_t>() : 0;
    all.bytesByModel =
        sumOver(ranks_, part_->ghostNodes()) * 3 * static_cast<std::int64_t>(sizeof(double)) * (steps - before);
    const auto received = static_cast<double>(sumOver(ranks_, own.received)),
               hidden = static_cast<double>(sumOver(ranks_, own.hidden));
    if (received > 0) all.hidden = hidden / received;
    all.waited = own.waited;
    ranks_.largest({&all.waited, 1});
    return all;
  }

  Ranks& ranks_;
  const RankRunRequest& request_;
  Wishes wishes_;
  std::optional<Checkpoint> saved_;
  Scene scene_;
  std::unique_ptr<Body> whole_;  // on the first rank, once all have their parts
  std::unique_ptr<RankBody> part_;
  std::unique_ptr<RankBody> explicitPart_;  // of the same nodes; nullptr where it is all of the part
  std::unique_ptr<Halo> halo_;
  std::unique_ptr<RunDomain> domain_, explicitDomain_;
  std::unique_ptr<RankFrames> frames_;
  RunOfPart of_;
  RunOptions options_;
};

}  // namespace

ExitStatus runSceneOnRanks(Ranks& ranks, const RankRunRequest& request,
                           const std::function<void(const std::string&)>& print) {
  try {
    return RankRun(ranks, request).go(print);
  } catch (const OtherRankFailed& fault) {
    return fault.status;
  }
}

}  // namespace ringwatch
