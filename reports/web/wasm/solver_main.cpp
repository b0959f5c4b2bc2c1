// SPDX-License-Identifier: MIT
// The solver as a WebAssembly module (build.sh). It imports nothing. question() and answers() return
// addresses in its memory. answer() reads the first and writes the second.
#include "reports/web/wasm/answers.hpp"

namespace {
double question_[cyl::question_size], answers_[cyl::answers_size];
}  // namespace

extern "C" {
[[clang::export_name("question")]] double* question() { return question_; }
[[clang::export_name("answers")]] double* answers() { return answers_; }
[[clang::export_name("answer")]] void answer() { cyl::answer_all(question_, answers_); }
}
