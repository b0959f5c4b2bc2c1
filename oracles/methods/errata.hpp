// SPDX-License-Identifier: MIT
// What is to be said of the documents that this project starts from: one table, from which `daylight errata`,
// solver/literature/errata.md and the methods with a single fault are made.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/methods/method.hpp"
#include "solver/literature/document.hpp"

namespace cyl {

enum class Document : unsigned char { text_2017, text_2008, book };
std::string_view title_of(Document document);

/// What a row is. A row that changes no verdict is a gap or a remark.
enum class ErratumKind : unsigned char {
  error,     ///< A program that does what is written gives wrong verdicts.
  gap,       ///< A gap in the argument: a reason does not hold as written, or a case is left out.
  rounding,  ///< Right in exact arithmetic; in doubles digits are lost.
  trap,      ///< Right as written, and easily carried on wrongly.
  remark     ///< A slip of the pen, or advice.
};
std::string_view to_string(ErratumKind kind);

/// How a fault is shown by a pair.
enum class ShownBy : unsigned char {
  alone,      ///< The mended text is right on it, and wrong with this fault alone: seed2017-only-<fault>.
  taken_out,  ///< The printed method is wrong on it, and right without this one: seed2017-without-<fault>.
  none        ///< By no pair: `why` proves that no verdict changes.
};

struct Erratum {
  std::string_view id;  ///< <document>-<fault>, as in the methods' names
  Document document;
  ErratumKind kind;
  std::string_view place;   ///< section, formula or step
  std::string_view says;    ///< in our words and notation, as all of it
  std::string_view should;  ///< what should stand there
  std::string_view why;     ///< what is wrong with it; where no pair shows it, the proof
  ShownBy shown_by;
  std::optional<literature::Fault> fault{};  ///< none: no program can follow what it says
  std::string_view rate{};                   ///< of wrong answers, by `daylight errata ID --pairs 3000`
  std::string_view numbers{};                ///< what both versions compute on the pair
  std::string_view test{};                   ///< what checks it, if no pair does
};

/// In the order of the documents: those of 2017, those of 2008 and of the book.
std::span<const Erratum> errata();
std::span<const Erratum> errata_2017();
std::span<const Erratum> errata_2008();

/// The id of the case that shows it, in corpus/cases/errata.jsonl.
std::string case_of(const Erratum& erratum);

/// The name of the method that shows it wrong, and of the one that differs by this fault alone and is right:
/// both are literal, and nothing of ours repairs what the fault does.
std::string wrong_method(const Erratum& erratum);
std::string right_method(const Erratum& erratum);

/// The mended texts (`-mended`), those with a single fault (`-only-`), the printed ones with a single fault
/// taken out (`-without-`), and other readings of these. Campaigns ask those that are named.
std::vector<std::unique_ptr<Method>> errata_methods();
std::vector<std::unique_ptr<Method>> errata_2008_methods();
std::vector<std::unique_ptr<Method>> errata_2017_methods();

/// Returns those of errata_methods() that are named by an item of `spec` (as select_methods() takes it) that
/// names nothing in `methods`.
std::vector<std::unique_ptr<Method>> named_errata(const std::vector<std::unique_ptr<Method>>& methods,
                                                  std::string_view spec);

}  // namespace cyl
