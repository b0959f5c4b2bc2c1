// SPDX-License-Identifier: MIT
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "base/process/line_program.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/methods/guest_protocol.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

constexpr LineProgram::Cap answer_cap{call_cpu_cap, 20 * call_cpu_cap};  // as in any call of a foreign method

/// The cap until the first answer. Interpreters and engines start slowly.
constexpr LineProgram::Cap start_cap{milliseconds(10'000), milliseconds(20'000)};
/// The cap for the first start of all, when nothing is in the machine's memory yet.
constexpr LineProgram::Cap first_start_cap{milliseconds(30'000), milliseconds(60'000)};

/// Returns a simple pair of solids of that kind, which are disjoint.
Pair easy_pair(SolidKind kind) {
  const bool sharp = kind == SolidKind::cylinder || kind == SolidKind::box;
  Solid solid{.radius = 1, .height = 2, .rounding = sharp ? 0.0 : 1.0};
  if (kind == SolidKind::box || kind == SolidKind::rounded_box)
    solid = {.rounding = solid.rounding, .shape = Shape::box, .edges = {2, 2, 2}};
  if (kind == SolidKind::sphere) solid.height = 0;
  if (kind == SolidKind::sphere || kind == SolidKind::capsule) solid.radius = 0;
  Pair pair{solid, solid};
  pair.b.center.x() = 5;
  return pair;
}

/// Returns the words of its command that are files: `mine.py` of "python3 -u mine.py --fast".
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

/// Returns the stem of the first word that looks like a source file ("mine" of "python3 -u mine.py --fast"),
/// else of the first word.
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
    const MethodAnswer answer = start(first_start_cap);
    if (answer.status == Status::failed)
      throw std::runtime_error(std::string("asked about an easy pair, it failed: ") + answer.reason);
    introduced_ = true;
    if (guest_.name.empty()) guest_.name = hello_.name.empty() ? name_after(guest.what) : hello_.name;
    set_name({guest_.name});
    if (hello_.version.empty()) hello_.version = "unversioned";
    auto files = files_of(guest);
    const auto folder = files.empty() ? "" : std::filesystem::path(files[0]).parent_path();
    for (const std::string& file : hello_.upstream.files) files.push_back((folder / file).string());
    if (!files.empty()) hello_.version.append(" (").append(fingerprint(files)).append(")");
    hello_.upstream.files = std::move(files);
    if (hello_.claim_source.empty()) hello_.claim_source = "none made";
  }

  std::string_view version() const override { return hello_.version; }
  Claim claim() const override {
    if (guest_.claim) return {*guest_.claim, 0, "--claim"};
    return {hello_.relative, hello_.absolute, hello_.claim_source};
  }
  bool guest() const override { return true; }
  bool program() const override { return true; }
  const Upstream& upstream() const { return hello_.upstream; }
  using Method::supports;
  bool supports(SolidKind kind) const override { return hello_.supports[static_cast<std::size_t>(kind)]; }
  const SizeRange* sizes() const override { return &hello_.sizes; }

  Pair modelled(const Pair& pair) const override {
    return {with_rounded_rims(pair.a, hello_.rounded_rims), with_rounded_rims(pair.b, hello_.rounded_rims)};
  }

  MethodAnswer answer(const Pair& pair) override {
    if (const auto invalid = decline_invalid(pair)) return *invalid;
    return exchange(pair);
  }

  bool is_out_of_process() const override { return true; }
  std::chrono::nanoseconds cpu_time() const override {
    return earlier_ + (program_ ? program_->cpu_time() : std::chrono::nanoseconds(0));
  }

  // Many lines are under way. If one is not answered, the pair at fault is not known for sure. So the next
  // pair is passed alone to a new program, and its answer counts.
  std::size_t ask_many(std::span<const Pair> pairs, std::span<MethodAnswer> answers) override {
    if (pairs.size() == 1 || !program_ || !program_->ours() || program_->has_answered_more()) {
      answers[0] = ask(pairs[0]);
      return 1;
    }
    std::size_t done = 0;
    std::vector<std::size_t> sent;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!supports(pairs[i])) {
        answers[i] = decline(pairs[i]);
        continue;
      }
      if (const auto invalid = decline_invalid(pairs[i])) {
        answers[i] = *invalid;
        continue;
      }
      program_->send(format_pair(pairs[i]) + '\n');
      sent.push_back(i);
    }
    for (; done < sent.size(); ++done) {
      MethodAnswer& answer = answers[sent[done]];
      answer = of_pair(pairs[sent[done]], read_answer(answer_cap));
      if (broke(answer)) break;
    }
    const bool more = done == sent.size() && program_->has_answered_more();
    if (done == sent.size() && !more) return pairs.size();
    end_program();
    const std::size_t at = sent[more ? 0 : done];
    const MethodAnswer failed =
        more ? failed_answer(Failure::malformed, "said more than one line to a question") : answers[at];
    const MethodAnswer alone = exchange(pairs[at]);
    answers[at] = broke(alone) ? alone : failed;  // if it is not the pair's fault, the caller asks again
    return at + 1;
  }

  /// Its time includes the way through the pipe and back.
  Call prepare_all(std::span<const Pair> pairs) override {
    return [this, pairs = std::vector(pairs.begin(), pairs.end())](std::size_t i) {
      const MethodAnswer answer = ask(pairs[i]);
      return answer.status == Status::answered ? answer.verdict : Verdict::undecided;
    };
  }

 private:
  /// A common point of rounded solids is ignored, because it need not be a point of their cores.
  static MethodAnswer of_pair(const Pair& pair, MethodAnswer answer) {
    if (is_rounded(pair) && answer.witness == CertificateKind::point) answer.witness = CertificateKind::none;
    return answer;
  }

  /// Returns whether the program can no longer be used.
  static bool broke(const MethodAnswer& answer) {
    return answer.failure == Failure::crash || answer.failure == Failure::hang ||
           answer.failure == Failure::malformed;
  }

  void end_program() {
    if (program_) earlier_ += program_->cpu_time();
    program_.reset();
  }

  /// Returns a pair of a shape that it supports, cylinders if it does.
  Pair easy() const {
    for (const SolidKind kind : {SolidKind::cylinder, SolidKind::capsule, SolidKind::sphere,
                                 SolidKind::rounded, SolidKind::box, SolidKind::rounded_box})
      if (supports(kind)) return easy_pair(kind);
    return easy_pair(SolidKind::cylinder);
  }

  /// Starts the program and asks about an easy pair, so that the time to get ready counts for no pair. A
  /// program without a hello waits for a question, so the first one comes before the hello. If the hello does
  /// not list its shape, the program is started again and asked about another.
  MethodAnswer start(const LineProgram::Cap& cap) {
    const Pair pair = easy();
    program_ = std::make_unique<LineProgram>(guest_.what, guest_.folder);
    program_->send(format_pair(pair) + '\n');
    const MethodAnswer answer = read_answer(cap, &pair);
    if (!supports_kinds(pair) && supports_kinds(easy())) {
      end_program();
      return start(cap);
    }
    if (broke(answer)) end_program();
    return answer;
  }

  MethodAnswer exchange(const Pair& pair) {
    if (program_ && !program_->ours()) program_.reset();
    if (!program_) {
      const MethodAnswer ready = start(start_cap);
      if (broke(ready))
        return failed_answer(ready.failure,
                             std::string("started, asked about an easy pair: ") + ready.reason);
    }
    const bool more = program_->has_answered_more();
    program_->send(format_pair(pair) + '\n');
    const MethodAnswer answer =
        more ? failed_answer(Failure::malformed, "said more than one line to a question")
             : read_answer(answer_cap);
    if (broke(answer)) end_program();
    return of_pair(pair, answer);
  }

  /// `first` is the pair of a new start, which the program may greet. Otherwise null.
  MethodAnswer read_answer(const LineProgram::Cap& cap, const Pair* first = nullptr) {
    std::string line;
    LineProgram::Read read = program_->receive(line, cap);
    GuestLine said;
    if (read == LineProgram::Read::line) said = parse_guest_line(line);
    if (first && said.hello) {
      if (!introduced_) hello_ = *said.hello;
      introduced_ = true;
      if (!supports_kinds(*first)) return decline(*first);
      read = program_->receive(line, cap);
      if (read == LineProgram::Read::line) said = parse_guest_line(line);
    }
    switch (read) {
      case LineProgram::Read::ended:
        return failed_answer(Failure::crash, program_->death());
      case LineProgram::Read::over_cpu_cap:
        return failed_answer(Failure::hang,
                             "no answer within " + std::to_string(cap.cpu.count()) + " ms of CPU time");
      case LineProgram::Read::over_wall_cap:
        return failed_answer(Failure::hang, "no answer within " + std::to_string(cap.wall.count()) + " ms");
      case LineProgram::Read::too_long:
        return failed_answer(Failure::malformed,
                             "a line of more than " + std::to_string(program_line_cap) + " bytes");
      case LineProgram::Read::line:
        break;
    }
    if (said.hello) return failed_answer(Failure::malformed, "a second hello");
    return said.answer ? method_answer(*said.answer, hello_.depth_at_most)
                       : failed_answer(Failure::malformed, said.error);
  }

  Guest guest_;
  GuestHello hello_;
  bool introduced_ = false;  ///< a later hello of a new start changes nothing
  std::unique_ptr<LineProgram> program_;
  std::chrono::nanoseconds earlier_{0};  ///< of programs that have ended
};

}  // namespace

OpenedGuest open_command(const Guest& guest) {
  auto method = std::make_unique<CommandMethod>(guest);
  Guest named = guest;
  named.name = method->name();
  named.upstream = method->upstream();
  return {std::move(named), std::move(method)};
}

}  // namespace cyl
