#include <ringwatch/app/report/report_page.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/report/bundle.h>
#include <ringwatch/app/report/json_read.h>
#include <ringwatch/base/atomic_file.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;
using json_read::numberOf;
using json_read::textOf;

// Nothing may be asked for from anywhere: the browser holds the page to it.
constexpr const char* policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

std::string seconds(const std::optional<double>& value) { return value ? fmt::format("{:.4g} s", *value) : "unknown"; }
std::string safeSeconds(const std::optional<double>& value) {
  return value ? stepRoundedDown(*value) + " s" : "unknown";
}
std::string optimisticSeconds(const std::optional<double>& value) {
  return value ? stepRoundedUp(*value) + " s" : "unknown";
}

std::string counts(const Json& summary) {
  const auto mesh = summary.find("mesh");
  if (mesh == summary.end() || !mesh->is_object()) return {};
  std::string text = fmt::format("{:.0f} nodes", numberOf(*mesh, "nodes").value_or(0));
  if (const auto elements = mesh->find("elements"); elements != mesh->end() && elements->is_object())
    for (const auto& [name, count] : elements->items())
      if (count.is_number()) text += fmt::format(", {:.0f} {}", count.get<double>(), name);
  return text;
}

std::string eventsOfRun(const PageContent& page) {
  std::string html;
  if (!page.summary.is_object()) return html;
  const Json& s = page.summary;
  if (const auto live = s.find("live"); live != s.end() && live->is_object()) {
    const double time = numberOf(*live, "time").value_or(0), end = numberOf(*live, "end").value_or(0);
    const auto left = numberOf(*live, "seconds_left");
    html += fmt::format(
        "<h3>How far it is</h3>\n<p><progress max=\"1\" value=\"{0:.4f}\" aria-label=\"Progress of the "
        "run\"></progress> {1:.0f} % of the time, {2}; the monitor takes {3:.0f} % of the wall time. As of "
        "{4}.</p>\n<p "
        "class=\"js\"><button type=\"button\" id=\"stay\" aria-pressed=\"false\">Do not reload</button> <span "
        "class=\"note\">This page is written again and again while the run goes on, and loads itself again every "
        "{5:.2g} "
        "seconds.</span></p>\n",
        end > 0 ? std::clamp(time / end, 0.0, 1.0) : 0, end > 0 ? 100 * time / end : 0,
        left ? fmt::format("about {:.0f} seconds left", *left) : "the time left is not known yet",
        100 * numberOf(*live, "monitor_share").value_or(0), htmlText(textOf(*live, "written")), page.reloadAfter);
  }
  if (const auto events = s.find("events"); events != s.end() && events->is_array() && !events->empty()) {
    // All of them are in summary.json.
    constexpr std::size_t most = 12;
    html += "<h3>What happened</h3>\n<ul class=\"events\">\n";
    for (std::size_t i = 0; i < std::min(most, events->size()); ++i)
      if ((*events)[i].is_object()) html += fmt::format("<li>{}</li>\n", htmlText(textOf((*events)[i], "text")));
    if (events->size() > most) html += fmt::format("<li>and {} more</li>\n", events->size() - most);
    html += "</ul>\n";
  }
  if (const auto notes = s.find("notes"); notes != s.end() && notes->is_array() && !notes->empty()) {
    html += "<h3>Notes of the run</h3>\n<ul>\n";
    for (const Json& note : *notes)
      if (note.is_string()) html += fmt::format("<li>{}</li>\n", htmlText(note.get<std::string>()));
    html += "</ul>\n";
  }
  return html;
}

/// Rows of a table whose cells of one number are marked as such: these stay on a line, which else would end behind the
/// minus of an exponent.
std::string withNumbersMarked(std::string rows) {
  constexpr std::string_view mark = " class=\"number\"";
  for (const std::string_view cell : {"<td>", "<th scope=\"row\">"})
    for (std::size_t at = rows.find(cell); at != std::string::npos; at = rows.find(cell, at + 1)) {
      const std::size_t text = at + cell.size(), end = rows.find_first_not_of("+-.0123456789e %", text);
      if (end != std::string::npos && end > text && rows[end] == '<') rows.insert(text - 1, mark);
    }
  return rows;
}

/// Who controls the bracket, and for how many of the rows.
std::string controllingTable(const RunHistory& history) {
  struct Share {
    std::size_t rows = 0;
    double first = 0, last = 0, least = 0;
  };
  std::map<std::int32_t, Share> shares;
  const std::vector<double>*time = history.column("time_s"), *safe = history.column("safe_s");
  std::size_t known = 0;
  for (std::size_t i = 0; i < history.rowCount(); ++i) {
    const std::int32_t element = history.controlling[i];
    if (element < 0 || !time || !safe) continue;
    ++known;
    Share& share = shares[element];
    if (share.rows++ == 0) share.first = (*time)[i], share.least = (*safe)[i];
    share.last = (*time)[i];
    share.least = std::min(share.least, (*safe)[i]);
  }
  if (known == 0) return {};
  std::vector<std::pair<std::int32_t, Share>> order(shares.begin(), shares.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second.rows > b.second.rows; });
  constexpr std::size_t most = 8;
  std::string rows;
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i) {
    const auto& [element, share] = order[i];
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{:.1f} %</td><td>{:.5g}</td><td>{:.5g}</td><td>{}</td></tr>\n",
        htmlText(history.nameOf(element)), 100 * static_cast<double>(share.rows) / static_cast<double>(known),
        share.first, share.last, stepRoundedDown(share.least));
  }
  std::string html =
      tableHtml(!history.numbers.empty() ? "Who controls the critical step (numbers of the mesh file)"
                                         : "Who controls the critical step (block:element, counted from 0)",
                {"Element", "Share of the rows", "First at t (s)", "Last at t (s)", "Least safe step then (s)"}, rows);
  if (order.size() > most) html += fmt::format("<p class=\"note\">and {} more elements</p>\n", order.size() - most);
  return html;
}

std::string historySection(const PageContent& page, std::size_t shown) {
  std::string html =
      "<section id=\"history\" aria-labelledby=\"history-title\">\n<h2 id=\"history-title\">Bracket and "
      "energies</h2>\n";
  if (!page.history || page.history->rowCount() == 0)
    return html + "<p>There is no history.csv with a row in it.</p>\n</section>\n";
  html +=
      "<p>Below the safe step a step is proven stable for the state of that moment, above the optimistic step it is "
      "proven unstable, between them nothing is proven.</p>\n";
  const std::vector<double>* safe = page.history->column("safe_s");
  if (!safe || std::none_of(safe->begin(), safe->end(), [](double step) { return std::isfinite(step); }))
    html += fmt::format("<p>{}</p>\n", page.words.noBracket);
  const std::string svg = historySvg(*page.history, page.marks);
  html += fmt::format("<div id=\"history-static\">{}</div>\n<div id=\"history-live\" hidden></div>\n",
                      svg.empty() ? "<p>No row has a step to draw.</p>" : wideHtml("Bracket against time", svg));
  if (!page.marks.empty()) {
    html += "<ol class=\"marks\" aria-label=\"Events marked in the picture\">\n";
    for (const ChartMark& mark : page.marks)
      html += fmt::format("<li>t = {:.6g} s: {}</li>\n", mark.time, htmlText(mark.label));
    html += "</ol>\n";
  }
  if (shown < page.history->rowCount())
    html += fmt::format(
        "<p class=\"note\">history.csv has {} rows. This page holds {} of them: of each bucket those with the least "
        "and "
        "the largest value of each column, so that no spike is lost.</p>\n",
        page.history->rowCount(), shown);
  return html + controllingTable(*page.history) + "</section>\n";
}

/// An element by the file's number, or by its place where the file has none.
std::string cardName(const WorstCard& card) {
  return card.ofFile ? fmt::format("{}", card.id) : fmt::format("{}:{}", card.ref.block, card.ref.element);
}

std::string cardHtml(const PageContent& page, const WorstCard& card, std::size_t place) {
  std::string html = fmt::format(
      "<li class=\"card\"><div class=\"head\"><h4>{}. Element {}</h4>{}</div>\n<dl>\n<dt>block:place</dt><dd>{}:{}"
      "</dd><dt>type</dt><dd>{}</dd><dt>step</dt><dd>{:.4g} s</dd>",
      place, cardName(card), elementSvg(card), card.ref.block, card.ref.element, htmlText(card.type), card.step);
  if (page.keyStep && card.step > 0)
    html += fmt::format("<dt>{} over it</dt><dd>{:.3g}</dd>", page.ofRun ? "run's step" : "step asked about",
                        *page.keyStep / card.step);
  if (!card.shape.empty())
    html += fmt::format(
        "<dt>shape</dt><dd>{}</dd><dt>volume</dt><dd>{:.4g} m³</dd><dt>least height</dt><dd>{:.4g} "
        "m</dd><dt>edges</dt><dd>{:.4g} to {:.4g} m</dd>",
        htmlText(card.shape), card.volume, card.minHeight, card.minEdge, card.maxEdge);
  return html + fmt::format(
                    "</dl>\n<button type=\"button\" class=\"show-me js\" data-element=\"{}\" data-frame=\"{}\" "
                    "aria-label=\"Show element {} in the mesh\">Show me</button></li>\n",
                    card.element, page.keyFrame, cardName(card));
}

std::string cardsHtml(const PageContent& page, const std::vector<WorstCard>& cards, const char* kind,
                      const std::string& heading, const std::string& note) {
  if (cards.empty()) return {};
  std::string html = fmt::format("<h3>{}</h3>\n<p class=\"note\">{}</p>\n<ol class=\"cards {}\">\n", htmlText(heading),
                                 htmlText(note), kind);
  for (std::size_t i = 0; i < cards.size(); ++i) html += cardHtml(page, cards[i], i + 1);
  return html + "</ol>\n";
}

std::string meshSection(const PageContent& page) {
  std::string html = "<section id=\"mesh\" aria-labelledby=\"mesh-title\">\n<h2 id=\"mesh-title\">Mesh</h2>\n";
  if (page.framesShown == 0)
    return html + fmt::format("<p>{}</p>\n</section>\n",
                              page.reloadAfter > 0 ? "There is no frame yet." : page.words.noFrames);
  if (page.framesShown < page.frames)
    html += fmt::format("<p>{} of the run's {} frames are in this page; the others {}.</p>\n", page.framesShown,
                        page.frames, page.words.otherFrames);
  if (page.elements > MeshPack::allElements)
    html +=
        fmt::format("<p>Of {} elements the page holds those on the surface and{} the {} with the smallest steps.</p>\n",
                    page.elements, page.ofRun ? ", of each frame," : "", MeshPack::leastElements);
  html += "<div id=\"mesh-static\">";
  if (!page.picture.empty())
    html += fmt::format(
        "<svg class=\"chart\" viewBox=\"0 0 720 400\" role=\"img\" aria-label=\"The surface {}, coloured by {}\">"
        "<image width=\"720\" height=\"400\" href=\"data:image/png;base64,{}\"/></svg>",
        htmlText(page.where),
        page.stepField.empty() ? "nothing: the frames have no steps of elements" : htmlText(page.stepField),
        base64(page.picture));
  if (!page.stepField.empty() && page.pictureScale.high > 0)
    html += fmt::format(
        "<p class=\"legend\"><span>{:.3g} s</span><span class=\"scale\" aria-hidden=\"true\"></span><span>{:.3g} "
        "s</span></p><p class=\"note\">{} {}; logarithmic, red is small.</p>",
        page.pictureScale.low, page.pictureScale.high, htmlText(page.stepField), htmlText(page.where));
  html += "</div>\n<div id=\"mesh-live\" hidden></div>\n";
  if (page.stepField.empty())
    return html +
           "<p>The frames have no step of elements, so nothing tells which of them are in the way: "
           "output.fields = [\"critical_step\"] in the scene adds it.</p>\n</section>\n";
  html +=
      cardsHtml(page, page.controlling, "controlling", "In the way of the whole body",
                page.ofRun ? "The elements that hold most of the fastest mode: that of the first violation, then those "
                             "that did so longest. Their numbers are those " +
                                 page.where + "."
                           : "The element that holds most of the fastest mode.");
  html +=
      cardsHtml(page, page.worst, "smallest",
                fmt::format("The {} elements with the smallest steps of their own, {}", page.worst.size(), page.where),
                fmt::format("By the field {}; shapes as they are there.", page.stepField));
  return html + "</section>\n";
}

/// What a rule's step means beside a bracket.
std::string evaluated(const RuleStep& rule, const RunAnalysis& analysis) {
  if (!analysis.safe || !analysis.optimistic || !(*analysis.safe > 0)) return "there is no bracket to compare it with";
  // Of a metric that errs to one side, the side says what it is good for.
  if (rule.side == "optimistic")
    return fmt::format("no rule: the critical step is proven to be at most this, {:.3g} times the safe step",
                       rule.step / *analysis.safe);
  if (rule.step > *analysis.optimistic)
    return fmt::format("unsafe: at least {:.3g} times the critical step", rule.step / *analysis.optimistic);
  if (rule.step <= *analysis.safe)
    return fmt::format("stable here, and gives {:.0f} % of the safe step away", 100 * (1 - rule.step / *analysis.safe));
  return "between the proven sides";
}

std::string distributionSection(const PageContent& page) {
  std::string html =
      "<section id=\"distribution\" aria-labelledby=\"distribution-title\">\n<h2 id=\"distribution-title\">Steps of "
      "the "
      "elements, and what the usual rules would have taken</h2>\n";
  if (!page.analysis) return html + fmt::format("<p>{}</p>\n</section>\n", htmlText(page.whyNoAnalysis));
  const RunAnalysis& a = *page.analysis;
  html += fmt::format(
      "<p>The whole body {}: safe {}, optimistic {}{}. A metric's step of the mesh is the least of its elements.</p>\n",
      a.where, safeSeconds(a.safe), optimisticSeconds(a.optimistic),
      page.ofRun || a.taken ? fmt::format(", {} {}", page.ofRun ? "step taken" : "step asked about", seconds(a.taken))
                            : "");
  if (!a.whyNoRules.empty()) return html + fmt::format("<p>{}</p>\n</section>\n", htmlText(a.whyNoRules));
  html +=
      wideHtml("Histograms", distributionSvg(a.distributions, {a.safe.value_or(0), a.optimistic.value_or(0), a.taken}));
  std::string rows;
  for (const RuleStep& rule : a.rules)
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{:.4g}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        htmlText(rule.name), rule.step, rule.side, evaluated(rule, a), htmlText(rule.help));
  return html +
         tableHtml("The mesh's step by metric", {"Metric", "Step (s)", "Side", "As a rule for the step", "What it is"},
                   rows) +
         "</section>\n";
}

/// How springs and contact are part of the table, and what they leave of the step where they ever set it.
std::string contactRoom(const PageContent& page) {
  if (!page.summary.is_object()) return {};
  const auto discrete = page.summary.find("discrete_forces");
  if (discrete == page.summary.end() || !discrete->is_object()) return {};
  std::string html =
      "<p>An element’s own step counts the stiffness of springs and contact at its nodes: where these set the step, "
      "the "
      "elements in the way are those that they act on.</p>\n";
  const auto room = discrete->find("room");
  if (room != discrete->end() && room->is_object())
    html += fmt::format(
        "<p>The elements at rest prove {:.4g} s alone; a penalty of at most {:.4g} N/m at each node leaves {:.0f} % of "
        "it.</p>\n",
        numberOf(*room, "elements_alone").value_or(0), numberOf(*room, "penalty").value_or(0),
        100 * numberOf(*room, "share").value_or(0));
  return html;
}

std::string whatIfSection(const PageContent& page) {
  std::string html =
      "<section id=\"what-if\" aria-labelledby=\"what-if-title\">\n<h2 id=\"what-if-title\">What if the step were "
      "larger?</h2>\n";
  if (!page.analysis) return html + fmt::format("<p>{}</p>\n</section>\n", htmlText(page.whyNoAnalysis));
  const RunAnalysis& a = *page.analysis;
  if (!a.whyNoWhatIf.empty()) return html + fmt::format("<p>{}</p>\n</section>\n", htmlText(a.whyNoWhatIf));
  if (a.countedBy.empty())
    html += fmt::format(
        "<p>Elements that a handler would take {}: without them the others are proven stable at the step, with a "
        "margin of 10 %. Other states may need more. ",
        a.where);
  else
    html += fmt::format(
        "<p>Elements whose own step, the {}, is below the step {}. What handlers would take and gain is left out: "
        "{}. ",
        htmlText(a.countedBy), a.where, htmlText(a.whyNoHandlers));
  html += fmt::format("Badly shaped are needles, wedges, spindles, slivers and caps, {}.</p>\n", a.shapesAt);
  html += contactRoom(page);
  const bool asked = !page.ofRun;
  const auto overSafe = [&](double h) {
    return a.safe && *a.safe > 0 ? fmt::format("{:.3g}", h / *a.safe) : std::string("unknown");
  };
  std::string rows, trials;
  for (const WhatIf& what : a.whatIf) {
    const bool own = a.taken && what.h == *a.taken;
    const std::string name =
        fmt::format("<tr{}><th scope=\"row\">{:.4g}{}</th><td>{}</td>", own ? " class=\"own\"" : "", what.h,
                    !own    ? ""
                    : asked ? " (asked about)"
                            : " (the run's)",
                    overSafe(what.h));
    rows += fmt::format(
        "{}<td>{}</td><td>{:.3g} %</td><td>{}</td></tr>\n", name,
        what.proven ? "none: proven as it is" : fmt::format("{}", what.way.all.size()),
        100 * static_cast<double>(what.way.all.size()) / static_cast<double>(std::max<std::size_t>(1, a.elements)),
        !what.shapesKnown ? "not examined" : fmt::format("{}", what.way.badlyShaped.size()));
    for (const HandlerTrial& trial : what.trials) {
      const std::string mass =
          trial.addedMass ? fmt::format("{:.3g} kg, {:.3g} % of the body's", *trial.addedMass, 100 * trial.addedShare)
                          : "none";
      trials += trial.whyNot.empty() ? fmt::format("{}<td>{}</td><td>{:.3g}</td><td>{}</td></tr>\n", name,
                                                   trial.handler, trial.gain, mass)
                                     : fmt::format("{}<td>{}</td><td colspan=\"2\">{}</td></tr>\n", name, trial.handler,
                                                   htmlText(trial.whyNot));
    }
  }
  html += tableHtml("Elements in the way",
                    {"Step (s)", "Over the safe step", "Elements in the way", "Of all", "Of them badly shaped"}, rows);
  if (trials.empty()) return html + "</section>\n";
  return html +
         tableHtml("What handlers would gain and cost",
                   {"Step (s)", "Over the safe step", "Handler", "Gain", "Mass added"}, trials) +
         "<p class=\"note\">Gain: how much farther the run gets in the same wall time than with the integrator alone "
         "at "
         "the safe step; below 1 the smaller step is cheaper. Measured in a few steps from this state, on the machine "
         "that wrote this page. Mass that is added changes the motion.</p>\n</section>\n";
}

std::string details(const char* summary, const std::string& text) {
  return fmt::format("<details><summary>{}</summary><pre tabindex=\"0\">{}</pre></details>\n", summary, htmlText(text));
}

/// What the page holds of a run's files, and what only they have.
std::string wholeData(const PageContent& page, std::size_t shownRows) {
  std::string items;
  if (page.history)
    items +=
        fmt::format("<li>{}: {} rows, {}</li>\n", page.words.historyFile, page.history->rowCount(),
                    shownRows < page.history->rowCount() ? fmt::format("of which this page holds {}", shownRows)
                                                         : std::string("all of them in this page to the last bit"));
  if (page.frames > 0)
    items += fmt::format(
        "<li>{}: {} {} with every element, {} of them in this page, where positions and fields are rounded to 16 bits "
        "of their range{}</li>\n",
        page.words.frameFiles, page.frames, page.frames == 1 ? "state" : "states", page.framesShown,
        page.elements > MeshPack::allElements ? " and elements inside the body with large steps are left out" : "");
  if (page.summary.is_object()) items += fmt::format("<li>{}: whole in this page</li>\n", page.words.summaryFile);
  return items.empty() ? items : "<p>Where the whole data is:</p>\n<ul>\n" + items + "</ul>\n";
}

PageSection runProvenance(const PageContent& page, std::size_t shownRows) {
  std::string buttons, rows, more;
  const bool thinned = page.history && shownRows < page.history->rowCount();
  if (page.ofRun)
    buttons += saveButton("save-history", thinned ? "The history’s rows in this page (CSV)" : "History (CSV)");
  buttons += saveButton("save-elements", page.ofRun ? "Elements of the frame shown (CSV)" : "Elements (CSV)") +
             saveButton("save-json", "All data of this page (JSON)");
  if (page.summary.is_object()) {
    const Json& s = page.summary;
    rows += provenanceRow(std::string(page.words.writtenBy), "ringwatch " + textOf(s, "version"));
    rows += provenanceRow("scene", textOf(s, "scene_file"));
    rows += provenanceRow(page.ofRun ? "mesh at the end" : "mesh", counts(s));
    if (const auto mass = numberOf(s, "mass")) rows += provenanceRow("mass", fmt::format("{:.6g} kg", *mass));
    rows += provenanceRow("ended", textOf(s, "exit_text"));
    if (const auto status = numberOf(s, "exit_status"))
      rows += provenanceRow("exit status", fmt::format("{:.0f}", *status));
    if (const auto steps = numberOf(s, "steps")) rows += provenanceRow("steps", fmt::format("{:.0f}", *steps));
    if (const auto time = s.find("wall_time"); time != s.end() && time->is_object())
      rows += provenanceRow("wall time",
                            fmt::format("{:.3g} seconds: force {:.3g}, monitor {:.3g}, output {:.3g}",
                                        numberOf(*time, "total").value_or(0), numberOf(*time, "force").value_or(0),
                                        numberOf(*time, "monitor").value_or(0), numberOf(*time, "output").value_or(0)));
    if (const auto from = s.find("provenance"); from != s.end() && from->is_object()) {
      for (const auto& [key, value] : from->items())
        if (value.is_string() && key != "scene_text") rows += provenanceRow(key, value.get<std::string>());
      if (const std::string text = textOf(*from, "scene_text"); !text.empty()) more += details("The scene file", text);
    }
    if (const auto scene = s.find("scene"); scene != s.end())
      more += details("The scene with every default", scene->dump(2, ' ', false, Json::error_handler_t::replace));
  }
  return provenanceSection(buttons, std::string(page.words.elsewhere), rows, wholeData(page, shownRows) + more);
}

Json historyJson(const RunHistory& history, std::size_t allRows, PageData& data) {
  Json columns = Json::array();
  for (const RunHistory::Column& column : history.columns)
    columns.push_back(Json{{"name", column.name},
                           {"head", labelledColumns(column.name)},
                           {"array", data.add(std::span<const double>(column.values))}});
  std::vector<std::string> names;
  std::vector<std::uint8_t> codes;
  for (const std::string& verdict : history.verdicts) {
    const auto found = std::find(names.begin(), names.end(), verdict);
    codes.push_back(static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(found - names.begin(), 255)));
    if (found == names.end()) names.push_back(verdict);
  }
  return Json{
      {"rows", history.rowCount()},    {"allRows", allRows},
      {"columns", std::move(columns)}, {"elements", history.elements},
      {"numbers", history.numbers},    {"controlling", data.add(std::span<const std::int32_t>(history.controlling))},
      {"verdictNames", names},         {"verdicts", data.add(std::span<const std::uint8_t>(codes))}};
}

Json analysisJson(const RunAnalysis& a) {
  Json rules = Json::array(), whatIf = Json::array();
  for (const RuleStep& rule : a.rules)
    rules.push_back({{"metric", rule.name}, {"side", rule.side}, {"step", rule.step}});
  for (const WhatIf& what : a.whatIf) {
    Json trials = Json::array();
    for (const HandlerTrial& trial : what.trials)
      trials.push_back({{"handler", trial.handler},
                        {"gain", trial.whyNot.empty() ? Json(trial.gain) : Json(nullptr)},
                        {"added_mass", trial.addedMass ? Json(*trial.addedMass) : Json(nullptr)},
                        {"why_not", trial.whyNot}});
    whatIf.push_back({{"step", what.h},
                      {"elements", what.way.all.size()},
                      {"badly_shaped", what.way.badlyShaped.size()},
                      {"proven", what.proven},
                      {"shapes_known", what.shapesKnown},
                      {"handlers", std::move(trials)}});
  }
  return Json{{"where", a.where},
              {"rules", rules},
              {"what_if", whatIf},
              {"what_if_counted_by", a.countedBy.empty() ? Json(nullptr) : Json(a.countedBy)},
              {"distribution", distributionJson(a.distributions)}};
}

}  // namespace

void PageContent::takeMesh(MeshPack& pack) {
  mesh = pack.finish();
  worst = pack.worst();
  controlling = pack.controlling();
  picture = pack.picture();
  pictureScale = pack.pictureScale();
  stepField = pack.stepField();
  elements = pack.elementCount();
}

ReportResult writtenPage(const std::string& html, const PageVerdict& verdict, const std::vector<std::string>& notes,
                         const std::filesystem::path& file) {
  ReportResult result;
  result.file = file;
  result.bytes = html.size();
  result.title = verdict.title;
  result.sentence = verdict.leadText();
  result.notes = notes;
  writeFileAtomically(file, html);
  return result;
}

std::string reportPage(PageContent& page) {
  Json history = nullptr;
  std::size_t shown = 0;
  if (page.history && page.history->rowCount() > 0) {
    const std::size_t most = page.history->rowCount() <= rowsOfPage
                                 ? rowsOfPage
                                 : std::min(rowsOfPage, numbersOfPage / page.history->columns.size());
    const RunHistory kept = selected(*page.history, rowsForPicture(*page.history, most));
    shown = kept.rowCount();
    history = historyJson(kept, page.history->rowCount(), page.data);
  }
  Json marks = Json::array();
  for (const ChartMark& mark : page.marks) marks.push_back({{"time", mark.time}, {"label", mark.label}});
  const auto cardsJson = [](const std::vector<WorstCard>& cards) {
    Json json = Json::array();
    for (const WorstCard& card : cards)
      json.push_back({{"block", card.ref.block},
                      {"index", card.ref.element},
                      {"id", card.id},
                      {"type", card.type},
                      {"step", card.step},
                      {"shape", card.shape},
                      {"volume", card.volume},
                      {"min_height", card.minHeight}});
    return json;
  };
  Page whole;
  whole.title = fmt::format("{}: {}", page.name, page.verdict.title);
  whole.heading = page.name;
  whole.reloadAfter = page.reloadAfter;
  if (page.summary.is_object()) {
    whole.subtitle = counts(page.summary);
    const auto scene = page.summary.find("scene");
    if (scene != page.summary.end() && scene->is_object())
      for (const auto& [section, key] : {std::pair{"material", "model"}, {"integrator", "method"}}) {
        const auto table = scene->find(section);
        if (table != scene->end() && table->is_object() && !textOf(*table, key).empty())
          whole.subtitle += (whole.subtitle.empty() ? "" : " · ") + textOf(*table, key);
      }
  }
  whole.sections.push_back(verdictSection(page.verdict, page.notes, eventsOfRun(page)));
  if (page.ofRun) whole.sections.push_back({"history", "Bracket", historySection(page, shown)});
  whole.sections.push_back({"mesh", "Mesh", meshSection(page)});
  whole.sections.push_back({"distribution", "Distribution", distributionSection(page)});
  whole.sections.push_back({"what-if", "What if", whatIfSection(page)});
  whole.sections.push_back(runProvenance(page, shown));
  whole.embedded = {
      {"name", page.name},
      {"stepName", page.ofRun ? "run’s step" : "step asked about"},
      {"verdict",
       {{"title", page.verdict.title}, {"sentence", page.verdict.sentence}, {"remedies", page.verdict.remedies}}},
      {"summary", std::move(page.summary)},
      {"history", std::move(history)},
      {"marks", std::move(marks)},
      {"mesh", std::move(page.mesh)},
      {"keyFrame", page.keyFrame},
      {"worst", cardsJson(page.worst)},
      {"controlling", cardsJson(page.controlling)},
      {"analysis", page.analysis ? analysisJson(*page.analysis) : Json(nullptr)}};
  whole.data = std::move(page.data);
  return pageHtml(whole);
}

PageSection verdictSection(const PageVerdict& verdict, const std::vector<std::string>& notes, const std::string& more) {
  constexpr const char* tones[] = {"good", "unsure", "bad"};
  std::string html = fmt::format(
      "<section id=\"verdict\" aria-labelledby=\"verdict-title\" class=\"{}\">\n<h2 id=\"verdict-title\">{}</h2>\n<p "
      "class=\"lead\">{}</p>\n",
      tones[static_cast<int>(verdict.tone)], htmlText(verdict.title), htmlText(verdict.leadText()));
  if (verdict.lead > 0 && verdict.lead < verdict.sentence.size())
    html += fmt::format("<p>{}</p>\n", htmlText(verdict.sentence.substr(verdict.lead)));
  const auto list = [&html](const char* heading, const std::vector<std::string>& items) {
    if (items.empty()) return;
    html += fmt::format("<h3>{}</h3>\n<ul>\n", heading);
    for (const std::string& item : items) html += fmt::format("<li>{}</li>\n", htmlText(item));
    html += "</ul>\n";
  };
  list("What to do", verdict.remedies);
  list("Notes of this page", notes);
  return {"verdict", "Verdict", html + more + "</section>\n"};
}

std::string tableHtml(const std::string& caption, const std::vector<std::string>& head, const std::string& rows,
                      const std::string& label) {
  std::string html = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table><caption>{}</caption>\n",
      htmlText(label.empty() ? caption : label), htmlText(caption));
  if (!head.empty()) {
    html += "<thead><tr>";
    for (const std::string& name : head) html += fmt::format("<th scope=\"col\">{}</th>", htmlText(name));
    html += "</tr></thead>\n";
  }
  return html + "<tbody>\n" + withNumbersMarked(rows) + "</tbody></table></div>\n";
}

std::string wideHtml(const std::string& name, const std::string& svg) {
  return fmt::format("<div class=\"scroll wide\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</div>",
                     htmlText(name), svg);
}

std::string provenanceRow(const std::string& name, const std::string& value) {
  return value.empty()
             ? std::string()
             : fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", htmlText(name), htmlText(value));
}

std::string saveButton(const char* id, const char* text) {
  return fmt::format("<button type=\"button\" id=\"{}\">{}</button>\n", id, text);
}

PageSection provenanceSection(const std::string& buttons, const std::string& elsewhere, const std::string& rows,
                              const std::string& more) {
  std::string html = fmt::format(
      "<section id=\"provenance\" aria-labelledby=\"provenance-title\">\n<h2 id=\"provenance-title\">Where this comes "
      "from</h2>\n<p class=\"js\">{}</p>\n<noscript><p>This browser runs no scripts, which save the numbers of this "
      "page: "
      "they are also in {}.</p></noscript>\n",
      buttons, elsewhere);
  html += tableHtml("Provenance", {},
                    provenanceRow("page written by", "ringwatch " + std::string(programVersion())) + rows);
  html += more + details("Licences of the libraries in this page", std::string(reportLicences()));
  return {"provenance", "Provenance", html + "</section>\n"};
}

std::string pageHtml(const Page& page) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n",
      policy);
  // With scripts the page reloads itself, so that a reader can keep it from doing so.
  if (page.reloadAfter > 0)
    html += fmt::format("<noscript><meta http-equiv=\"refresh\" content=\"{:.0f}\"></noscript>\n",
                        std::ceil(page.reloadAfter));
  html += fmt::format("<title>{} (ringwatch)</title>\n<style>", htmlText(labelled(page.title)));
  html += reportStyle();
  html += "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#verdict\">Skip to the verdict</a>\n<header>\n";
  html += fmt::format("<h1>{}</h1>\n", htmlText(page.heading));
  if (!page.subtitle.empty()) html += fmt::format("<p class=\"sub\">{}</p>\n", htmlText(page.subtitle));
  html += "<nav aria-label=\"Sections\"><ul>\n";
  for (const PageSection& section : page.sections)
    html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, htmlText(section.link));
  html += "</ul></nav>\n</header>\n<main>\n";
  for (const PageSection& section : page.sections) {
    const std::size_t quoted = std::min(section.html.find("<pre"), section.html.size());
    html += labelled(section.html.substr(0, quoted)) + section.html.substr(quoted);
  }
  html += "</main>\n<script type=\"application/json\" id=\"report\">";
  Json embedded = labelledJson(page.embedded);
  embedded["reloadAfter"] = page.reloadAfter;
  for (const char* unit : {"s", "m", "J"}) embedded["units"][unit] = unitNamed(unit);
  html += scriptJson(embedded);
  html += "</script>\n";
  html += page.data.html();
  html += "<script>";
  html += reportScript();
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace ringwatch
