#include <ringwatch/app/ranks/rank_inspect.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/ranks/msh_share.h>
#include <ringwatch/app/ranks/part_checks.h>
#include <ringwatch/app/ranks/rank_threads.h>
#include <ringwatch/app/ranks/together.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/distributed/element_cut.h>
#include <ringwatch/distributed/element_order.h>
#include <ringwatch/distributed/exchange.h>
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/rank_domain.h>
#include <ringwatch/meshes/formats/msh_outline.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/event.h>

namespace ringwatch {
namespace {

void requireDistributable(const InspectOptions& options) {
  for (const auto& [given, option] : {std::pair{options.step.has_value(), "--step"},
                                      {options.repair, "--repair"},
                                      {!options.metrics.empty(), "--metric"},
                                      {options.width.has_value(), "--width"},
                                      {options.lanczos.has_value(), "--lanczos"},
                                      {options.exact, "--exact"},
                                      {options.prove.has_value(), "--prove"},
                                      {options.stretch.has_value(), "--stretch"},
                                      {options.distribution, "--distribution"},
                                      {options.picture.has_value(), "--picture"},
                                      {options.vtu.has_value(), "--vtu"},
                                      {options.certificate.has_value(), "--certificate"},
                                      {static_cast<bool>(options.page), "--report"}})
    if (given)
      throw InputError(fmt::format(
          "{}: is not distributed over ranks; leave it out, or inspect with one process, without mpirun", option));
}

/// x: of the part, 3×N, m.
CriticalStep bracketOnRanks(Ranks& ranks, RankBody& part, NodeVectorsView x, const StepRule& rule) {
  Halo halo(ranks, part);
  RankDomain domain(ranks, halo, part);
  std::optional<CriticalStep> step;
  RankFault fault;
  try {
    step = criticalStep(part.body(), x, rule);
  } catch (const NumericalError& found) {  // by all ranks
    fault = {ExitStatus::unstable, found.what()};
  } catch (const InputError& found) {
    fault = {ExitStatus::badInput, found.what()};
  }
  requireNoFault(ranks, fault);
  return *step;
}

/// globalFrequency() on every rank, with tangent products that each computes on its part: the same bits as on one
/// process, since sums at owned nodes have the terms and the order of the whole (Theorem 78,
/// docs/theory/distribution.md).
GlobalFrequency globalOnRanks(Ranks& ranks, const RankBody& part, const Body& whole, const NodeVectors& x) {
  const NodeVectors own = x(Eigen::all, part.globalNodes());
  NodeVectors v, product;
  Body::Workspace workspace;
  return globalFrequency(whole, x, GlobalFrequency::usualTolerance, GlobalFrequency::mostRestarts,
                         [&](NodeVectorsView ofWhole, NodeVectors& Kv) {
                           v = ofWhole(Eigen::all, part.globalNodes());
                           part.body().tangentProduct(own, v, product, workspace);
                           Kv = gathered(ranks, part, product);
                           Kv.resize(3, x.cols());
                           ranks.share(Kv.data(), sizeof(double) * static_cast<std::size_t>(Kv.size()), 0);
                         });
}

/// A mesh of which each rank has read a share and holds a part.
class MeshInParts final : public InspectedParts {
 public:
  MeshInParts(Ranks& ranks, const InspectOptions& options) : ranks_(ranks), options_(options) {}

  MeshFigures read(const Scene& scene) override {
    const std::string source = options_.mesh.string();
    MeshFigures figures;
    RankPart part;
    MeshBox box;
    {
      MshShare file = readMshShare(ranks_, options_.mesh);
      figures.notes = std::move(file.notes);
      for (std::size_t b = 0; b < file.share.blocks.size(); ++b)
        figures.elements.emplace_back(elementInfo(file.share.blocks[b].type).name, file.elementCounts[b]);
      for (const SetNames::Run& run : file.share.sets.ofElements)
        for (const std::string& name : run.sets) figures.elementSets[name] += run.count;
      SharedMesh shared = shareMesh(ranks_, std::move(file.share));
      figures.nodes = shared.nodeCount();
      const auto add = [&](std::vector<std::string> notes) {
        for (std::string& note : notes) figures.notes.push_back(std::move(note));
      };
      bool partlyTurned = false;
      add(mendShared(ranks_, shared, file.elementCounts, source, partlyTurned));
      box = boxOf(ranks_, shared.X);
      std::vector<NumberedElements> pieces = orderElements(ranks_, shared, box.low, box.high);
      const std::vector<std::vector<std::int32_t>> cut = cutElements(ranks_, shared, pieces);
      part = gatherPart(ranks_, std::move(shared), std::move(pieces), cut);
      requireSoundPart(ranks_, part, source, partlyTurned);
      add(partNotes(ranks_, part, source));
    }
    for (const auto& [name, nodes] : part.mesh.nodeSets) figures.nodeSets[name] = sumOver(ranks_, ownedOf(part, nodes));
    figures.quality = qualityOfParts(ranks_, part);
    makeBody(scene, std::move(part), figures);
    hold(scene, box);
    const Body& body = body_->body();
    std::array<double, 2> speeds{0, -infinity};  // the fastest, and against the slowest
    for (const auto& block : body.blocks()) {
      speeds[0] = std::max(speeds[0], block->material().waveSpeed());
      speeds[1] = std::max(speeds[1], -block->material().waveSpeed());
    }
    ranks_.largest(speeds);
    figures.body = BodyFigures{box.high - box.low, -speeds[1], speeds[0]};
    // Each note once, whichever ranks have it.
    std::vector<std::string> notes = bodyNotes(body, ranks_.firstWhere(isHeld(body)) < ranks_.size());
    for (int from = 0; (from = ranks_.firstWhere(!notes.empty())) < ranks_.size();) {
      figures.notes.push_back(ranks_.shareText(notes.empty() ? "" : notes.front(), from));
      std::erase(notes, figures.notes.back());
    }
    return figures;
  }

  CriticalStep bracket(const StepRule& rule) override {
    return bracketOnRanks(ranks_, *body_, body_->body().mesh().X, rule);
  }

  ElementFigures element(ElementRef element) override {
    const Mesh& mesh = body_->body().mesh();
    ElementFigures figures;
    std::optional<ElementRef> local;
    for (std::size_t e = 0; e < mesh.blocks[element.block].elementCount() && !local; ++e)
      if (const ElementRef own(element.block, e); body_->globalElement(own) == element && body_->counts(own))
        local = own;
    const auto from = ranks_.firstWhere(static_cast<bool>(local));
    std::string json;
    if (local) {
      figures.json = elementJson(mesh, *local);
      figures.json["index"] = element.element;
      for (auto& node : figures.json["nodes"]) node = body_->globalNode(node.get<std::int32_t>());
      json = figures.json.dump();
      figures.text = elementText(mesh, *local, element.element);
      figures.quality = elementQuality(mesh.blocks[element.block], local->element, mesh.X);
    }
    figures.json = nlohmann::ordered_json::parse(ranks_.shareText(std::move(json), from));
    figures.text = ranks_.shareText(std::move(figures.text), from);
    ranks_.share(&figures.quality, sizeof figures.quality, from);
    return figures;
  }

 private:
  static std::int64_t ownedOf(const RankPart& part, const std::vector<std::int32_t>& nodes) {
    return std::count_if(nodes.begin(), nodes.end(), [&](std::int32_t node) { return node < part.ownedNodes; });
  }

  /// The body of the part; volume and mass of the whole.
  void makeBody(const Scene& scene, RankPart part, MeshFigures& figures) {
    std::optional<Material> material;
    std::vector<std::unique_ptr<ElementBlock>> blocks;
    Eigen::VectorXd masses;
    std::vector<ExactSum> sums(1 + part.mesh.blocks.size());  // mass of the nodes, and of the elements of each block
    together(ranks_, [&] {
      try {
        const SceneMaterial& chosen = scene.materials.front();
        material = makeMaterial(chosen.model, chosen.parameters, chosen.density);
        for (std::size_t b = 0; b < part.mesh.blocks.size(); ++b) {
          const MeshBlock& block = part.mesh.blocks[b];
          const auto rule = chosen.rules.find(elementInfo(block.type).name);
          blocks.push_back(makeElementBlock(
              part.mesh, block, *material, rule == chosen.rules.end() ? "" : rule->second, scene.hourglassControl,
              layOutPart(part.mesh.nodeCount(), block.nodesPerElement(), block.connectivity, part.places[b])));
          part.places[b] = {};
        }
        masses = lumpedMass(part.mesh, blocks, scene.lumping).ofNode;
        double mass[maxElementNodes];
        for (std::size_t b = 0; b < blocks.size(); ++b)
          for (std::int32_t e = 0; e < blocks[b]->elementCount(); ++e) {
            if (!part.counts({b, e})) continue;
            elementLumpedMass(part.mesh, *blocks[b], scene.lumping, e, mass);
            for (int a = 0; a < blocks[b]->nodesPerElement(); ++a) sums[1 + b].add(mass[a]);
          }
      } catch (const NumericalError& fault) {
        throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));  // the mesh is what the user can mend
      }
    });
    copyToGhosts(ranks_, part, masses.data(), 1);  // theirs lack elements
    for (std::int32_t i = 0; i < part.ownedNodes; ++i) sums[0].add(masses[i]);
    ranks_.sum(sums);
    figures.mass = sums[0].value();
    for (std::size_t b = 1; b < sums.size(); ++b) figures.volume += sums[b].value() / material->density;
    together(ranks_, [&] {
      const int threads = threadsOfRank(ranks_, options_.threads, part.mesh);
      body_.emplace(std::move(part), std::move(blocks), std::move(masses), threads);
    });
  }

  /// Holds the nodes of --fix.
  void hold(const Scene& scene, const MeshBox& box) {
    Body& body = body_->body();
    for (const Scene::Fix& fix : scene.fixes) {
      std::vector<std::int32_t> nodes;
      std::vector<std::int64_t> numbers;
      together(ranks_, [&] {
        nodes = fix.nodes.nodesIn(body.mesh());
        numbers = fix.nodes.numbers();
      });
      std::int64_t owned = 0;
      std::vector<std::int64_t> found;
      for (const std::int32_t node : nodes) {
        if (node >= body_->ownedNodes()) continue;
        ++owned;
        if (!numbers.empty()) found.push_back(body.mesh().nodeId(node));
      }
      owned = sumOver(ranks_, owned);
      found = gatherAll(ranks_, found);
      std::sort(found.begin(), found.end());
      for (const std::int64_t number : numbers)
        if (!std::binary_search(found.begin(), found.end(), number)) throw fix.nodes.noSuchNode(number);
      fix.nodes.requireSome(owned, box.low, box.high);
      for (const std::int32_t node : nodes)
        for (int c = 0; c < 3; ++c)
          if (fix.components[c]) body.constraints().fix(node, c);
    }
  }

  Ranks& ranks_;
  const InspectOptions& options_;
  std::optional<RankBody> body_;
};

/// What all ranks find wrong alike, one of them says.
InspectResult inspectInParts(Ranks& ranks, const InspectOptions& options) {
  InspectResult nothing;
  try {
    MeshInParts parts(ranks, options);
    return inspectParts(options, parts);
  } catch (const OtherRankFailed& fault) {
    nothing.status = fault.status;
  } catch (const NumericalError&) {
    throw;  // of together(), on the first rank
  } catch (const InputError&) {
    if (ranks.rank() == 0) throw;
    nothing.status = ExitStatus::badInput;
  } catch (const std::bad_alloc&) {
    endAll(ranks, "out of memory; use more ranks, on more machines", ExitStatus::badInput);
  } catch (const std::exception& fault) {
    endAll(ranks, fault.what(), ExitStatus::badInput);
  }
  return nothing;
}

}  // namespace

InspectResult inspectOnRanks(Ranks& ranks, const InspectOptions& asked) {
  const bool wholeBody = asked.global || asked.displacement || asked.frame;
  // One rank looks, so that all do the same.
  bool inParts = !wholeBody && detail::isMshBinary4(asked.mesh);
  ranks.share(&inParts, sizeof inParts, 0);
  bool begun = false;
  std::optional<RankBody> part;
  const auto inspect = [&] {
    requireDistributable(asked);
    if (inParts) {
      begun = true;  // faults are told
      return inspectInParts(ranks, asked);
    }
    InspectOptions options = asked;
    options.bracket = [&](const Body& body, const NodeVectors& x, const StepRule& rule) {
      begun = true;
      requireNoFault(ranks, {});  // of reading the mesh
      const Partition partition = cutTogether(ranks, body.mesh());
      together(ranks,
               [&] { part.emplace(body, partition, ranks.rank(), threadsOfRank(ranks, asked.threads, body.mesh())); });
      return bracketOnRanks(ranks, *part, NodeVectors(x(Eigen::all, part->globalNodes())), rule);
    };
    options.globalFrequency = [&](const Body& body, const NodeVectors& x) {
      return globalOnRanks(ranks, *part, body, x);
    };
    return inspectMesh(options);
  };
  try {
    try {
      return inspect();
    } catch (const NumericalError& fault) {
      if (!begun) requireNoFault(ranks, {ExitStatus::unstable, fault.what()});
      throw;
    } catch (const std::exception& fault) {
      if (!begun) requireNoFault(ranks, {ExitStatus::badInput, fault.what()});
      throw;
    }
  } catch (const OtherRankFailed& fault) {
    InspectResult nothing;
    nothing.status = fault.status;
    return nothing;
  }
}

}  // namespace ringwatch
