// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzz_engine.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "base/process/process.hpp"
#include "fuzz/guided/record.hpp"
#include "fuzz/guided/visited.hpp"
#include "oracles/trial/bucket.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Deaths of a worker one after the other that no input explains, before it is the harness that fails.
constexpr unsigned unexplained_cap = 3;

/// Exit code of an engine that could not be run.
constexpr int cannot_run_code = 127;

/// Returns the number after `word` where that stands last; 0: nowhere.
std::size_t last_number(std::string_view text, std::string_view word) {
  const std::size_t at = text.rfind(word);
  std::size_t number = 0;
  if (at != text.npos) std::from_chars(text.data() + at + word.size(), text.data() + text.size(), number);
  return number;
}

}  // namespace

std::string text_of(const fs::path& file, std::uintmax_t from) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(from));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string reason_in(const std::string& log) {
  for (const std::string_view word : {"SUMMARY: ", "ERROR: "}) {
    const std::size_t at = log.rfind(word);
    if (at != log.npos) return log.substr(at, log.find('\n', at) - at);
  }
  return "no reason given";
}

std::unique_ptr<Child> run_engine(const std::vector<std::string>& command, const std::string& log,
                                  const std::string& findings) {
  return std::make_unique<Child>(
      [&]() -> std::string {
        try {
          redirect_streams("/dev/null", log);
          unsetenv("DAYLIGHT_FUZZ_ABORT");
          if (findings.empty())
            unsetenv("DAYLIGHT_FUZZ_OUT");
          else
            setenv("DAYLIGHT_FUZZ_OUT", findings.c_str(), 1);
          become_program(command);
        } catch (const std::exception& error) {
          fmt::print(stderr, "cannot run {}\n", error.what());
          _exit(cannot_run_code);
        }
      },
      ChildOptions{.own_group = true});
}

Engine::Engine(const FuzzOptions& options, unsigned number)
    : options_(options), number_(number), folder_(fs::path(options.out) / fmt::format("worker-{}", number)) {
  fs::remove_all(folder_);
  fs::create_directories(corpus());
  fs::create_directories(folder_ / "died");
  for (const fs::path& file : files_in(fs::path(options.out) / "corpus"))
    fs::copy_file(file, corpus() / file.filename());
  // The engine ends where no input of its corpus runs any tested code; this one is no pair.
  if (fs::is_empty(corpus()))
    std::ofstream(corpus() / "zeros", std::ios::binary) << std::string(record_size, '\0');
  start();
}

void Engine::look() {
  progress_.executions = read_visited(folder_ / "visited").executions;
  progress_.cpu_seconds = earlier_cpu_seconds_ + cpu_seconds();
  std::string news = text_of(log(), log_read_);
  news.resize(news.rfind('\n') + 1);  // the rest of a line comes later
  log_read_ += news.size();
  const std::size_t started = news.find("INITED");
  if (progress_.first_features == 0 && started != news.npos)
    progress_.first_features = last_number(news.substr(0, news.find('\n', started)), " ft: ");
  progress_.features = std::max(progress_.features, last_number(news, " ft: "));
}

std::optional<Case> Engine::replace_dead() {
  if (!process_->advance()) return std::nullopt;
  look();
  const int status = process_->status();
  const std::string how = how_it_ended(status), text = text_of(log());
  std::optional<Case> found;
  for (const fs::path& file : files_in(folder_ / "died")) {
    const std::string bytes = text_of(file), name = file.filename().string();
    if (name.starts_with("slow-unit-") || bytes.size() != record_size || !known_deaths_.insert(name).second)
      continue;
    Case c;
    Record record;
    std::copy(bytes.begin(), bytes.end(), record.begin());
    c.pair = decode_record(record);
    c.source = options_.target;
    c.note = fmt::format("{}/{}: {}", options_.target, name.substr(0, name.find('-')), reason_in(text));
    c.id = letter_hash(c.note);
    found = c;
  }
  unexplained_ = found ? 0 : unexplained_ + 1;
  if (unexplained_ == unexplained_cap || status >> 8 == cannot_run_code)
    throw std::runtime_error(fmt::format("worker {} ended with {}; {} has: {}", number_, how, log(),
                                         text.substr(text.size() - std::min<std::size_t>(text.size(), 300))));
  earlier_cpu_seconds_ += cpu_seconds();
  ++progress_.deaths;
  start();
  return found;
}

double Engine::cpu_seconds() {
  process_->advance();
  return std::chrono::duration<double>(process_->cpu_time()).count();
}

void Engine::start() {
  const std::uint64_t seed =  // not 0, which asks for a random one
      1 + (options_.seed + number_ * 1000003 + progress_.deaths * 10007) % 0x7fffffff;
  process_ =
      run_engine({options_.program, corpus(), fmt::format("-seed={}", seed),
                  fmt::format("-max_len={}", record_size), "-len_control=0", "-reduce_inputs=0",
                  fmt::format("-reload={}", 1 + options_.exchange_interval.count() / 1000), "-timeout=25",
                  "-print_pcs=0", "-entropic=0", fmt::format("-artifact_prefix={}/died/", folder_.string())},
                 log(), findings());
}

}  // namespace cyl
