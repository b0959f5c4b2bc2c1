// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files.hpp"
#include "base/json.hpp"
#include "base/source_tree.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/methods/errata.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/web/page_template.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;
using Methods = std::vector<std::unique_ptr<Method>>;

constexpr const char* engines_file = "docs/results/engines.jsonl";

/// The recorded answer of an engine that this build does not have.
struct Recorded {
  std::string method, version, date;
  Claim claim;
  MethodAnswer answer;
};

struct Example {
  std::string_view group;  ///< of the examples on the page
  Case known;
  std::optional<Recorded> recorded{};
  std::vector<std::string> errata{};  ///< methods that are asked about this example only
};

/// Returns the cases whose pairs other programs got wrong.
std::vector<Example> cases_of_corpus() {
  std::vector<Example> all;
  for (Case& c : read_case_folder(in_source_tree("corpus/cases"))) {
    const std::string_view group = c.file.ends_with("/reported.jsonl")  ? "reported"
                                   : c.file.ends_with("/rounded.jsonl") ? "rounded"
                                                                        : "";
    if (!group.empty()) all.push_back({group, std::move(c)});
  }
  return all;
}

std::vector<Example> cases_of_errata() {
  std::vector<Example> all;
  const std::vector<Case> cases = read_case_folder(in_source_tree("corpus/cases"));
  for (const Erratum& e : errata()) {
    if (e.shown_by == ShownBy::none) continue;
    for (const Case& c : cases)
      if (c.id == case_of(e)) all.push_back({"errata", c, {}, {wrong_method(e), right_method(e)}});
  }
  return all;
}

Recorded recorded_of(const json& engine) {
  Recorded said;
  engine.at("name").get_to(said.method);
  engine.at("package").get_to(said.version);
  engine.at("date").get_to(said.date);
  engine.at("claim").at("relative").get_to(said.claim.relative);
  engine.at("claim").at("absolute").get_to(said.claim.absolute);
  said.answer.status = Status::answered;
  said.answer.verdict = from_word<Verdict>(engine.at("worst").at("said").get<std::string>()).value();
  return said;
}

/// Returns the worst pair of each npm engine, with the recorded answer.
std::vector<Example> worst_of_engines() {
  std::ifstream in(in_source_tree(engines_file));
  if (!in) throw std::runtime_error(fmt::format("cannot read {}", engines_file));
  std::vector<Example> all;
  for (std::string line; std::getline(in, line);) {
    const json engine = parse_ordered_json(line);
    if (engine.at("worst").is_null()) continue;
    const Recorded said = recorded_of(engine);
    Case c = parse_case(engine.at("worst").at("pair").dump(), 1).value.value();
    c.id = "worst-of-" + said.method;
    c.source = fmt::format("the worst wrong verdict of {} in {}", said.version, engines_file);
    all.push_back({"engines", std::move(c), said});
  }
  return all;
}

/// Whether the method is a collision library. NLopt is an optimizer.
bool is_engine(const Method& method) { return method.foreign() && !method.name().starts_with("nlopt"); }

/// Returns the engines and the methods that the errata name.
Methods asked_methods(std::span<const Example> examples) {
  Methods methods = all_methods();
  std::erase_if(methods, [](const auto& method) { return !is_engine(*method); });
  for (const auto make : {literature_2008_methods, literature_2017_methods, errata_methods})
    for (auto& method : make()) {
      const auto names_it = [&](const Example& e) {
        return std::ranges::count(e.errata, method->name()) > 0;
      };
      if (std::ranges::any_of(examples, names_it)) methods.push_back(std::move(method));
    }
  return methods;
}

json said_json(std::string_view method, std::string_view version, const MethodAnswer& answer,
               const std::optional<Finding>& wrong) {
  json said = {{"method", method}, {"version", version}};
  said.update(answer_to_json(answer));
  if (wrong) said["wrong"] = {{"kind", to_string(wrong->kind)}, {"severity", to_string(wrong->severity)}};
  return said;
}

json example_json(const Example& example, const Methods& methods, Trial& trial) {
  json answers = json::array();
  if (const auto& said = example.recorded) {
    answers.push_back(
        said_json(said->method, said->version, said->answer, compare(trial, said->claim, said->answer)));
    answers.back()["recorded"] = said->date;
  }
  for (std::size_t i = 0; i < methods.size(); ++i)
    if (is_engine(*methods[i]) || std::ranges::count(example.errata, methods[i]->name()) > 0)
      answers.push_back(
          said_json(methods[i]->name(), methods[i]->version(), trial.answers[i], trial.findings[i]));
  const Case& c = example.known;
  return {{"group", example.group},       {"id", c.id},
          {"source", c.source},           {"note", c.note},
          {"pair", pair_to_json(c.pair)}, {"truth", truth_to_json(trial.truth, &trial.distance)},
          {"answers", std::move(answers)}};
}

std::string play_json() {
  std::vector<Example> examples = cases_of_corpus();
  for (auto more : {worst_of_engines, cases_of_errata})
    for (Example& example : more()) examples.push_back(std::move(example));
  const Methods methods = asked_methods(examples);
  std::vector<Pair> pairs;
  for (const Example& example : examples) pairs.push_back(example.known.pair);
  std::vector<Trial> trials = try_methods(methods, pairs, {});
  json all = {{"examples", json::array()}};
  for (std::size_t i = 0; i < examples.size(); ++i)
    all["examples"].push_back(example_json(examples[i], methods, trials[i]));
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

void add_play(Program& program) {
  Command command = program.command("Understand", "play",
                                    "Writes a page to try pairs: verdict, distance and proof as you drag");
  auto out = std::make_shared<std::string>("play.html");
  command.section("Output");
  command.option("--out FILE", *out, "the page: one file that needs no network").writable();
  command.examples(
      "  daylight play\n"
      "  daylight play --out play.html",
      "The solver runs in the page, compiled to WebAssembly. Its answers are those of this program.\n"
      "The examples are pairs that libraries, engines or printed methods get wrong. The command asks\n"
      "the libraries of this build about them.");
  command.run([out] {
    write_file(*out, fill_template(play_json(), PageSolver::included));
    fmt::print("{}\n", *out);
    return exit_pass;
  });
}

}  // namespace cyl
