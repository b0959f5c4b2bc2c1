// SPDX-License-Identifier: MIT
#include "cli/manual.hpp"

#include <fmt/format.h>

namespace cyl {
namespace {

/// Returns text for troff: escapes backslashes and hyphens, and no line begins as a macro does.
std::string troff(const std::string& text) {
  std::string out;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    begins = c == '\n';
    if (c == '\\' || c == '-') out += '\\';
    if (c == '\\')
      out += 'e';
    else
      out += c;
  }
  return out;
}

std::string option_entry(const OptionText& o) {
  const std::string standard = o.standard.empty() ? "" : " (default: " + o.standard + ')';
  return fmt::format(".TP\n.B {}{}\n{}\n", troff(o.name),
                     o.value.empty() ? "" : " \\fI" + troff(o.value) + "\\fR", troff(o.help + standard));
}

}  // namespace

std::string man_page(const ProgramText& p) {
  std::string page = fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", "DAYLIGHT",
                                 troff(p.version), troff(p.name), troff(p.summary));
  page += fmt::format(".SH SYNOPSIS\n.B {}\n.I COMMAND\n.RI [ OPTION ]...\n", troff(p.name));
  for (const CommandText& c : p.commands) {
    page += fmt::format(".SH {}\n{}\n", troff(p.name + ' ' + c.name), troff(c.summary));
    for (const OptionText& o : c.options) page += option_entry(o);
    page += fmt::format(".PP\n.nf\n{}\n.fi\n", troff(c.footer));
  }
  return page + fmt::format(".SH EXIT STATUS\n.nf\n{}\n.fi\n", troff(p.footer));
}

std::string bash_completion(const ProgramText& p) {
  std::string commands, cases;
  for (const CommandText& c : p.commands) {
    commands += (commands.empty() ? "" : " ") + c.name;
    std::string options = "--help";
    for (const OptionText& o : c.options)
      if (o.name.starts_with('-')) options += ' ' + o.name;
    cases += fmt::format("    {}) options='{}' ;;\n", c.name, options);
  }
  return fmt::format(R"(# bash completion for {0}
_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} options=
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{1} --help --version' -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{2}  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _{0} {0}
)",
                     p.name, commands, cases);
}

}  // namespace cyl
