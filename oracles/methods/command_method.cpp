// SPDX-License-Identifier: MIT
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "base/process/line_program.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/methods/guest_protocol.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

constexpr LineProgram::Cap answer_cap{call_cpu_cap, 20 * call_cpu_cap};  // as any call of a foreign method

/// Until the first answer: interpreters and engines start slowly.
constexpr LineProgram::Cap start_cap{milliseconds(10'000), milliseconds(20'000)};
/// Likewise for the first start of all: nothing is in the machine's memory yet.
constexpr LineProgram::Cap first_start_cap{milliseconds(30'000), milliseconds(60'000)};

/// One apart, the plainest there is.
const Pair easy{{Vector3(0, 0, 0), Vector3(0, 0, 1), 1, 2}, {Vector3(3, 0, 0), Vector3(0, 0, 1), 1, 2}};

MethodAnswer failed(Failure failure, const std::string& reason) {
  MethodAnswer answer;
  answer.status = Status::failed;
  answer.failure = failure;
  answer.set_reason(reason);
  return answer;
}

MethodAnswer answer_of(const GuestAnswer& said) {
  if (!said.verdict && !said.declined) return failed(Failure::reported, said.reason);
  MethodAnswer answer;
  if (said.declined) {
    answer.set_reason(said.reason);
    return answer;
  }
  answer.status = Status::answered;
  answer.verdict = *said.verdict;
  answer.has_distance = said.distance.has_value();
  answer.distance = said.distance.value_or(0);
  const bool meet = answer.verdict == Verdict::intersecting || answer.verdict == Verdict::touching;
  if (said.point && (meet || !said.direction)) {
    answer.witness = CertificateKind::point;
    for (std::size_t i = 0; i < 3; ++i)
      answer.head[i] = (*said.point)[i], answer.tail[i] = (*said.point)[i + 3];
  } else if (said.direction) {
    answer.set_direction(Vector3((*said.direction)[0], (*said.direction)[1], (*said.direction)[2]));
  }
  return answer;
}

/// Returns those of its words that are files: `mine.py` of "python3 -u mine.py --fast".
std::vector<std::string> files_of(const Guest& guest) {
  std::vector<std::string> files;
  std::istringstream words(guest.what);
  for (std::string word; words >> word;) {
    const std::filesystem::path file = std::filesystem::path(guest.folder) / word;
    std::error_code fault;
    if (std::filesystem::is_regular_file(file, fault)) files.push_back(file.string());
  }
  return files;
}

/// Returns the stem of the first word that looks like a file of source ("mine" of "python3 -u mine.py
/// --fast"), else of the first word.
std::string name_after(const std::string& command) {
  std::string first;
  for (std::size_t at = 0; at < command.size();) {
    const std::size_t begin = std::min(command.find_first_not_of(' ', at), command.size());
    at = std::min(command.find(' ', begin), command.size());
    const std::filesystem::path word = command.substr(begin, at - begin);
    if (word.has_extension()) return word.stem();
    if (first.empty()) first = word.stem();
  }
  return first;
}

class CommandMethod final : public Method {
 public:
  explicit CommandMethod(const Guest& guest) : guest_(guest) {
    const MethodAnswer answer = exchange(easy, first_start_cap);
    if (answer.status == Status::failed)
      throw std::runtime_error(std::string("asked about an easy pair, it failed: ") + answer.reason);
    introduced_ = true;
    program_.reset();  // workers start their own
    if (guest_.name.empty()) guest_.name = hello_.name.empty() ? name_after(guest.what) : hello_.name;
    if (hello_.version.empty()) hello_.version = "unversioned";
    if (const auto files = files_of(guest); !files.empty())
      hello_.version.append(" (").append(fingerprint(files)).append(")");
    if (hello_.claim_source.empty()) hello_.claim_source = "none made";
  }

  std::string_view name() const override { return guest_.name; }
  std::string_view version() const override { return hello_.version; }
  Claim claim() const override { return {hello_.relative, hello_.absolute, hello_.claim_source}; }
  bool guest() const override { return true; }

  MethodAnswer ask(const Pair& pair) override {
    if (const auto invalid = decline_invalid(pair)) return *invalid;
    return exchange(pair, start_cap);
  }

  /// Its time holds the way there and back through the pipe.
  Call prepare_all(std::span<const Pair> pairs) override {
    return [this, pairs = std::vector(pairs.begin(), pairs.end())](std::size_t i) {
      const MethodAnswer answer = ask(pairs[i]);
      return answer.status == Status::answered ? answer.verdict : Verdict::undecided;
    };
  }

 private:
  MethodAnswer exchange(const Pair& pair, const LineProgram::Cap& cap_to_start) {
    if (program_ && !program_->ours()) program_.reset();
    const bool starts = !program_;
    if (starts) program_ = std::make_unique<LineProgram>(guest_.what, guest_.folder);
    const MethodAnswer answer = read_answer(format_pair(pair) + '\n', starts ? &cap_to_start : nullptr);
    if (answer.status == Status::failed && answer.failure != Failure::reported) program_.reset();
    return answer;
  }

  MethodAnswer read_answer(const std::string& question, const LineProgram::Cap* start) {
    if (!start && program_->has_answered_more())
      return failed(Failure::malformed, "said more than one line to a question");
    const LineProgram::Cap& cap = start ? *start : answer_cap;
    std::string line;
    LineProgram::Read read = program_->exchange(question, line, cap);
    GuestLine said;
    if (read == LineProgram::Read::line) said = parse_guest_line(line);
    if (start && said.hello) {
      if (!introduced_) hello_ = *said.hello;
      read = program_->exchange({}, line, cap);
      if (read == LineProgram::Read::line) said = parse_guest_line(line);
    }
    switch (read) {
      case LineProgram::Read::ended:
        return failed(Failure::crash, program_->death());
      case LineProgram::Read::late:
        return failed(Failure::hang, "no answer within " + std::to_string(cap.cpu.count()) +
                                         " ms of CPU time or " + std::to_string(cap.wall.count()) +
                                         " ms in all");
      case LineProgram::Read::too_long:
        return failed(Failure::malformed,
                      "a line of more than " + std::to_string(program_line_cap) + " bytes");
      case LineProgram::Read::line:
        break;
    }
    if (said.hello) return failed(Failure::malformed, "a second hello");
    return said.answer ? answer_of(*said.answer) : failed(Failure::malformed, said.error);
  }

  Guest guest_;
  GuestHello hello_;
  bool introduced_ = false;  ///< what it says of itself when started again changes nothing
  std::unique_ptr<LineProgram> program_;
};

}  // namespace

std::unique_ptr<Method> open_command(const Guest& guest) { return std::make_unique<CommandMethod>(guest); }

}  // namespace cyl
