// SPDX-License-Identifier: MIT
#include "reports/stability.hpp"

#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "corpus/store.hpp"
#include "reports/backward.hpp"
#include "reports/builds.hpp"
#include "reports/charts.hpp"
#include "reports/paths.hpp"

namespace cyl {

void write_stability(const std::filesystem::path& run, std::span<const std::unique_ptr<Method>> methods,
                     const std::filesystem::path& builds) {
  std::vector<WrongVerdict> wrong = wrong_verdicts(methods);
  std::vector<WrongVerdict> found = wrong_verdicts(RunStore::open(run).findings());
  wrong.insert(wrong.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
  set_charts(run, {{"paths", paths_json(path_stability(methods))},
                   {"backward", backward_json(backward_errors(wrong))},
                   {"builds", builds_json(builds)}});
}

}  // namespace cyl
