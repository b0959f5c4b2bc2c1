// SPDX-License-Identifier: MIT
// The commands of the one executable, one file each: add_<command> describes the command to the program. A
// wrong argument throws UsageError, and a file with other content InputError. A fault of the harness throws
// any other std::exception. daylight_main.cpp prints the text and returns exit code 64, 65 or 1.
#pragma once

#include "base/exit_code.hpp"

namespace cyl {

class Program;

void add_ask(Program& program);
void add_bench(Program& program);
void add_campaign(Program& program);
void add_chart(Program& program);
void add_check(Program& program);
void add_export(Program& program);
void add_families(Program& program);
void add_vectors(Program& program);
void add_fuzz(Program& program);
void add_gate(Program& program);
void add_judge(Program& program);
void add_merge(Program& program);
void add_replay(Program& program);
void add_scene(Program& program);
void add_triage(Program& program);
void add_worst(Program& program);

}  // namespace cyl
