// SPDX-License-Identifier: MIT
#include "reports/run/stability.hpp"

#include <iterator>
#include <vector>

#include "base/json.hpp"
#include "bench/stability/backward.hpp"
#include "bench/stability/builds.hpp"
#include "bench/stability/paths.hpp"
#include "reports/run/charts.hpp"

namespace cyl {

void write_stability(RunData& run, std::span<const std::unique_ptr<Method>> methods,
                     const std::filesystem::path& builds) {
  std::vector<WrongVerdict> wrong = wrong_verdicts(methods);
  std::vector<WrongVerdict> found = wrong_verdicts(run.findings);
  wrong.insert(wrong.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
  set_charts(run, {{"paths", paths_json(path_stability(methods))},
                   {"backward", backward_json(backward_errors(wrong))},
                   {"builds", builds_json(builds)}});
}

}  // namespace cyl
