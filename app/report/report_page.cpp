#include <ringwatch/app/report/report_page.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/report/bundle.h>
#include <ringwatch/app/report/json_read.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;
using json_read::numberOf;
using json_read::textOf;

// Nothing may be asked for from anywhere: the browser holds the page to it.
constexpr const char* policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

std::string row(const std::string& name, const std::string& value) {
  return value.empty()
             ? std::string()
             : fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", htmlText(name), htmlText(value));
}

/// A picture that does not get too small to read on a telephone: it can be pushed aside instead.
std::string wide(const char* name, const std::string& svg) {
  return fmt::format("<div class=\"scroll wide\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</div>", name, svg);
}

std::string seconds(const std::optional<double>& value) { return value ? fmt::format("{:.4g} s", *value) : "unknown"; }

std::string counts(const Json& summary) {
  const auto mesh = summary.find("mesh");
  if (mesh == summary.end() || !mesh->is_object()) return {};
  std::string text = fmt::format("{:.0f} nodes", numberOf(*mesh, "nodes").value_or(0));
  if (const auto elements = mesh->find("elements"); elements != mesh->end() && elements->is_object())
    for (const auto& [name, count] : elements->items())
      if (count.is_number()) text += fmt::format(", {:.0f} {}", count.get<double>(), name);
  return text;
}

std::string verdictSection(const PageContent& page) {
  constexpr const char* tones[] = {"good", "unsure", "bad"};
  std::string html = fmt::format(
      "<section id=\"verdict\" aria-labelledby=\"verdict-title\" class=\"{}\">\n<h2 id=\"verdict-title\">{}</h2>\n<p "
      "class=\"lead\">{}</p>\n",
      tones[static_cast<int>(page.verdict.tone)], htmlText(page.verdict.title), htmlText(page.verdict.sentence));
  html += "<h3>What to do</h3>\n<ul>\n";
  for (const std::string& remedy : page.verdict.remedies) html += fmt::format("<li>{}</li>\n", htmlText(remedy));
  html += "</ul>\n";
  if (!page.notes.empty()) {
    html += "<h3>What this page lacks</h3>\n<ul>\n";
    for (const std::string& note : page.notes) html += fmt::format("<li>{}</li>\n", htmlText(note));
    html += "</ul>\n";
  }
  if (!page.summary.is_object()) return html + "</section>\n";
  const Json& s = page.summary;
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
  return html + "</section>\n";
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
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Who controls the critical "
      "step\"><table><caption>Who controls the critical step "
      "(block:element, counted from 0)</caption>\n<thead><tr><th scope=\"col\">Element</th><th scope=\"col\">Share of "
      "the "
      "rows</th><th scope=\"col\">First at t (s)</th><th scope=\"col\">Last at t (s)</th><th scope=\"col\">Least safe "
      "step then (s)</th></tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i) {
    const auto& [element, share] = order[i];
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{:.1f} %</td><td>{:.5g}</td><td>{:.5g}</td><td>{:.4g}</td></tr>\n",
        htmlText(history.elements[element]), 100 * static_cast<double>(share.rows) / static_cast<double>(known),
        share.first, share.last, share.least);
  }
  html += "</tbody></table></div>\n";
  if (order.size() > most) html += fmt::format("<p class=\"note\">and {} more elements</p>\n", order.size() - most);
  return html;
}

std::string historySection(const PageContent& page, std::size_t shown) {
  std::string html =
      "<section id=\"history\" aria-labelledby=\"history-title\">\n<h2 id=\"history-title\">Bracket and "
      "energies</h2>\n";
  if (!page.history || page.history->rowCount() == 0)
    return html + "<p>The folder has no history.csv with a row in it.</p>\n</section>\n";
  html +=
      "<p>Below the safe step a step is proven stable for the state of that moment, above the optimistic step it is "
      "proven unstable, between them nothing is proven.</p>\n";
  const std::vector<double>* safe = page.history->column("safe_s");
  if (!safe || std::none_of(safe->begin(), safe->end(), [](double step) { return std::isfinite(step); }))
    html +=
        "<p>This run kept no bracket (monitor.mode is threshold or metric): its history has the step and, where the "
        "monitor proved it, the verdict.</p>\n";
  const std::string svg = historySvg(*page.history, page.marks);
  html += fmt::format("<div id=\"history-static\">{}</div>\n<div id=\"history-live\" hidden></div>\n",
                      svg.empty() ? "<p>No row has a step to draw.</p>" : wide("Bracket against time", svg));
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

std::string cardHtml(const PageContent& page, const WorstCard& card, std::size_t place) {
  std::string html = fmt::format(
      "<li class=\"card\"><div class=\"head\"><h4>{}. Element {}:{}</h4>{}</div>\n<dl>\n<dt>number in the "
      "mesh</dt><dd>{}</dd><dt>type</dt><dd>{}</dd>"
      "<dt>step</dt><dd>{:.4g} s</dd>",
      place, card.ref.block, card.ref.element, elementSvg(card), card.id, htmlText(card.type), card.step);
  if (page.keyStep && card.step > 0)
    html += fmt::format("<dt>run's step over it</dt><dd>{:.3g}</dd>", *page.keyStep / card.step);
  if (!card.shape.empty())
    html += fmt::format(
        "<dt>shape</dt><dd>{}</dd><dt>volume</dt><dd>{:.4g} m³</dd><dt>least height</dt><dd>{:.4g} "
        "m</dd><dt>edges</dt><dd>{:.4g} to {:.4g} m</dd>",
        htmlText(card.shape), card.volume, card.minHeight, card.minEdge, card.maxEdge);
  return html + fmt::format(
                    "</dl>\n<button type=\"button\" class=\"show-me js\" data-element=\"{}\" data-frame=\"{}\" "
                    "aria-label=\"Show element {}:{} in the mesh\">Show me</button></li>\n",
                    card.element, page.keyFrame, card.ref.block, card.ref.element);
}

std::string meshSection(const PageContent& page) {
  std::string html = "<section id=\"mesh\" aria-labelledby=\"mesh-title\">\n<h2 id=\"mesh-title\">Mesh</h2>\n";
  if (page.framesShown == 0)
    return html +
           "<p>The folder has no frames that can be read. A run writes them when its scene has output.every.</p>\n"
           "</section>\n";
  if (page.framesShown < page.frames)
    html += fmt::format("<p>{} of the run's {} frames are in this page; the others lie beside it for ParaView.</p>\n",
                        page.framesShown, page.frames);
  if (page.elements > MeshPack::allElements)
    html += fmt::format(
        "<p>Of {} elements the page holds those on the surface and, of each frame, the {} with the smallest "
        "steps.</p>\n",
        page.elements, MeshPack::leastElements);
  html += "<div id=\"mesh-static\">";
  if (!page.picture.empty())
    html += fmt::format(
        "<svg class=\"chart\" viewBox=\"0 0 720 400\" role=\"img\" aria-label=\"The surface at t = {:.6g} s, coloured "
        "by {}\">"
        "<image width=\"720\" height=\"400\" href=\"data:image/png;base64,{}\"/></svg>",
        page.keyTime,
        page.stepField.empty() ? "nothing: the frames have no steps of elements" : htmlText(page.stepField),
        base64(page.picture));
  if (!page.stepField.empty() && page.pictureScale.largest > 0)
    html += fmt::format(
        "<p class=\"legend\"><span>{:.3g} s</span><span class=\"scale\" aria-hidden=\"true\"></span><span>{:.3g} "
        "s</span></p><p class=\"note\">{} at t = {:.6g} s, frame {}; logarithmic, red is small.</p>",
        page.pictureScale.least, page.pictureScale.largest, htmlText(page.stepField), page.keyTime, page.keyFrame);
  html += "</div>\n<div id=\"mesh-live\" hidden></div>\n";
  if (page.stepField.empty())
    return html +
           "<p>The frames have no step of elements, so nothing tells which of them are in the way: "
           "output.fields = [\"critical_step\"] in the scene adds it.</p>\n</section>\n";
  if (page.worst.empty()) return html + "</section>\n";
  html += fmt::format(
      "<h3>The {} elements with the smallest steps, frame {}, t = {:.6g} s</h3>\n<p class=\"note\">By the field {}; "
      "shapes "
      "as deformed there.</p>\n<ol class=\"cards\">\n",
      page.worst.size(), page.keyFrame, page.keyTime, htmlText(page.stepField));
  for (std::size_t i = 0; i < page.worst.size(); ++i) html += cardHtml(page, page.worst[i], i + 1);
  return html + "</ol>\n</section>\n";
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
      "<p>The whole body in the first frame, t = {:.6g} s: safe {}, optimistic {}, step taken {}. A metric's step of "
      "the mesh is the "
      "least of its elements.</p>\n",
      a.time, seconds(a.safe), seconds(a.optimistic), seconds(a.taken));
  if (!a.whyNoRules.empty()) return html + fmt::format("<p>{}</p>\n</section>\n", htmlText(a.whyNoRules));
  html += wide("Histograms", distributionSvg(a.distributions, {a.safe.value_or(0), a.optimistic.value_or(0), a.taken}));
  html +=
      "\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Steps of the mesh by "
      "metric\"><table><caption>The mesh's step by metric</caption>\n"
      "<thead><tr><th scope=\"col\">Metric</th><th scope=\"col\">Step (s)</th><th scope=\"col\">Side</th><th "
      "scope=\"col\">As a rule for the step</th><th scope=\"col\">What it is</th></tr></thead>\n<tbody>\n";
  for (const RuleStep& rule : a.rules)
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{:.4g}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        htmlText(rule.name), rule.step, rule.side, evaluated(rule, a), htmlText(rule.help));
  return html + "</tbody></table></div>\n</section>\n";
}

std::string whatIfSection(const PageContent& page) {
  std::string html =
      "<section id=\"what-if\" aria-labelledby=\"what-if-title\">\n<h2 id=\"what-if-title\">What if the step were "
      "larger?</h2>\n";
  if (!page.analysis) return html + fmt::format("<p>{}</p>\n</section>\n", htmlText(page.whyNoAnalysis));
  const RunAnalysis& a = *page.analysis;
  if (!a.whyNoWhatIf.empty()) return html + fmt::format("<p>{}</p>\n</section>\n", htmlText(a.whyNoWhatIf));
  html +=
      "<p>Elements that a handler would take in the first frame: without them the others are proven stable at the "
      "step, with a margin of 10 %. Later states may need more. What a handler costs, and the mass that mass scaling "
      "would add, is not computed here.</p>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Elements in the way by "
      "step\"><table><caption>Elements in the way</caption>\n<thead><tr><th "
      "scope=\"col\">Step (s)</th><th scope=\"col\">Over the safe step</th><th scope=\"col\">Elements in the "
      "way</th><th "
      "scope=\"col\">Of all</th></tr></thead>\n<tbody>\n";
  for (const WhatIf& what : a.whatIf) {
    const bool own = a.taken && what.h == *a.taken;
    html += fmt::format(
        "<tr{}><th scope=\"row\">{:.4g}{}</th><td>{:.3g}</td><td>{}</td><td>{:.3g} %</td></tr>\n",
        own ? " class=\"own\"" : "", what.h, own ? " (the run's)" : "", what.h / *a.safe,
        what.proven ? "none: proven as it is" : fmt::format("{}", what.elements),
        100 * static_cast<double>(what.elements) / static_cast<double>(std::max<std::size_t>(1, a.elements)));
  }
  return html + "</tbody></table></div>\n</section>\n";
}

std::string provenanceSection(const PageContent& page) {
  std::string html =
      "<section id=\"provenance\" aria-labelledby=\"provenance-title\">\n<h2 id=\"provenance-title\">Where this comes "
      "from</h2>\n<p class=\"js\"><button type=\"button\" id=\"save-history\">History (CSV)</button> <button "
      "type=\"button\" id=\"save-elements\">Elements of the frame shown (CSV)</button> <button type=\"button\" "
      "id=\"save-json\">All data (JSON)</button></p>\n<noscript><p>This browser runs no scripts: the numbers lie "
      "beside "
      "this page in history.csv, summary.json and frames/.</p></noscript>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Provenance\"><table><caption>Provenance</caption>\n<tbody>\n";
  html += row("page written by", "ringwatch " + std::string(programVersion()));
  if (page.summary.is_object()) {
    const Json& s = page.summary;
    html += row("run by", "ringwatch " + textOf(s, "version"));
    html += row("scene", textOf(s, "scene_file"));
    html += row("mesh at the end", counts(s));
    if (const auto mass = numberOf(s, "mass")) html += row("mass", fmt::format("{:.6g} kg", *mass));
    html += row("ended", textOf(s, "exit_text"));
    if (const auto status = numberOf(s, "exit_status")) html += row("exit status", fmt::format("{:.0f}", *status));
    if (const auto steps = numberOf(s, "steps")) html += row("steps", fmt::format("{:.0f}", *steps));
    if (const auto time = s.find("wall_time"); time != s.end() && time->is_object())
      html +=
          row("wall time", fmt::format("{:.3g} s: force {:.3g} s, monitor {:.3g} s, output {:.3g} s",
                                       numberOf(*time, "total").value_or(0), numberOf(*time, "force").value_or(0),
                                       numberOf(*time, "monitor").value_or(0), numberOf(*time, "output").value_or(0)));
    if (const auto from = s.find("provenance"); from != s.end() && from->is_object())
      for (const auto& [key, value] : from->items())
        if (value.is_string() && key != "scene_text") html += row(key, value.get<std::string>());
  }
  html += "</tbody></table></div>\n";
  if (page.summary.is_object()) {
    if (const auto from = page.summary.find("provenance"); from != page.summary.end() && from->is_object())
      if (const std::string text = textOf(*from, "scene_text"); !text.empty())
        html += fmt::format("<details><summary>The scene file</summary><pre tabindex=\"0\">{}</pre></details>\n",
                            htmlText(text));
    if (const auto scene = page.summary.find("scene"); scene != page.summary.end())
      html += fmt::format(
          "<details><summary>The scene with every default</summary><pre tabindex=\"0\">{}</pre></details>\n",
          htmlText(scene->dump(2, ' ', false, Json::error_handler_t::replace)));
  }
  return html + fmt::format(
                    "<details><summary>Licences of the libraries in this page</summary><pre "
                    "tabindex=\"0\">{}</pre></details>\n</section>\n",
                    htmlText(reportLicences()));
}

Json historyJson(const RunHistory& history, std::size_t allRows, PageData& data) {
  Json columns = Json::array();
  for (const RunHistory::Column& column : history.columns)
    columns.push_back(Json{{"name", column.name}, {"array", data.add(std::span<const double>(column.values))}});
  std::vector<std::string> names;
  std::vector<std::uint8_t> codes;
  for (const std::string& verdict : history.verdicts) {
    const auto found = std::find(names.begin(), names.end(), verdict);
    codes.push_back(static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(found - names.begin(), 255)));
    if (found == names.end()) names.push_back(verdict);
  }
  return Json{{"rows", history.rowCount()},
              {"allRows", allRows},
              {"columns", std::move(columns)},
              {"elements", history.elements},
              {"controlling", data.add(std::span<const std::int32_t>(history.controlling))},
              {"verdictNames", names},
              {"verdicts", data.add(std::span<const std::uint8_t>(codes))}};
}

Json analysisJson(const RunAnalysis& a) {
  Json rules = Json::array(), whatIf = Json::array();
  for (const RuleStep& rule : a.rules)
    rules.push_back({{"metric", rule.name}, {"side", rule.side}, {"step", rule.step}});
  for (const WhatIf& what : a.whatIf)
    whatIf.push_back({{"step", what.h}, {"elements", what.elements}, {"proven", what.proven}});
  return Json{
      {"time", a.time}, {"rules", rules}, {"what_if", whatIf}, {"distribution", distributionJson(a.distributions)}};
}

}  // namespace

std::string reportPage(PageContent page) {
  Json history = nullptr;
  std::size_t shown = 0;
  if (page.history && page.history->rowCount() > 0) {
    const RunHistory kept = selected(*page.history, rowsForPicture(*page.history, rowsOfPage));
    shown = kept.rowCount();
    history = historyJson(kept, page.history->rowCount(), page.data);
  }
  Json marks = Json::array(), worst = Json::array();
  for (const ChartMark& mark : page.marks) marks.push_back({{"time", mark.time}, {"label", mark.label}});
  for (const WorstCard& card : page.worst)
    worst.push_back({{"block", card.ref.block},
                     {"index", card.ref.element},
                     {"id", card.id},
                     {"type", card.type},
                     {"step", card.step},
                     {"shape", card.shape},
                     {"volume", card.volume},
                     {"min_height", card.minHeight}});
  Json embedded{
      {"name", page.name},
      {"verdict",
       {{"title", page.verdict.title}, {"sentence", page.verdict.sentence}, {"remedies", page.verdict.remedies}}},
      {"summary", page.summary},
      {"history", std::move(history)},
      {"marks", std::move(marks)},
      {"mesh", page.mesh},
      {"keyFrame", page.keyFrame},
      {"worst", std::move(worst)},
      {"analysis", page.analysis ? analysisJson(*page.analysis) : Json(nullptr)}};

  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}: {} (ringwatch)</title>\n<style>",
      policy, htmlText(page.name), htmlText(page.verdict.title));
  html += reportStyle();
  html += "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#verdict\">Skip to the verdict</a>\n<header>\n";
  html += fmt::format("<h1>{}</h1>\n", htmlText(page.name));
  if (page.summary.is_object()) {
    std::string line = counts(page.summary);
    const auto scene = page.summary.find("scene");
    if (scene != page.summary.end() && scene->is_object())
      for (const auto& [section, key] : {std::pair{"material", "model"}, {"integrator", "method"}}) {
        const auto table = scene->find(section);
        if (table != scene->end() && table->is_object() && !textOf(*table, key).empty())
          line += (line.empty() ? "" : " · ") + textOf(*table, key);
      }
    html += fmt::format("<p class=\"sub\">{}</p>\n", htmlText(line));
  }
  html += "<nav aria-label=\"Sections\"><ul>\n";
  for (const auto& [id, name] : {std::pair{"verdict", "Verdict"},
                                 {"history", "Bracket"},
                                 {"mesh", "Mesh"},
                                 {"distribution", "Distribution"},
                                 {"what-if", "What if"},
                                 {"provenance", "Provenance"}})
    html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, name);
  html += "</ul></nav>\n</header>\n<main>\n";
  html += verdictSection(page) + historySection(page, shown) + meshSection(page) + distributionSection(page) +
          whatIfSection(page) + provenanceSection(page);
  html += "</main>\n<script type=\"application/json\" id=\"report\">";
  html += scriptJson(embedded);
  html += "</script>\n";
  html += page.data.html();
  html += "<script>";
  html += reportScript();
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace ringwatch
