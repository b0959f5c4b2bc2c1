// SPDX-License-Identifier: MIT
// What the documents this project starts from get wrong: one table, from which `daylight errata`,
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

/// How a fault is shown by a pair.
enum class ShownBy : unsigned char {
  alone,  ///< The method put right is right on it, and wrong with this fault alone: seed2017-only-<fault>.
  taken_out,  ///< The printed method is wrong on it, and right without this one: seed2017-without-<fault>.
  none        ///< By no pair: `why` proves that no verdict changes.
};

struct Erratum {
  std::string_view id;  ///< <document>-<fault>, as in the methods' names
  Document document;
  std::string_view place;   ///< section, formula or step
  std::string_view says;    ///< in our words and notation, as all of it
  std::string_view should;  ///< what should stand there
  std::string_view why;     ///< what is wrong with it; where no pair shows it, the proof
  ShownBy shown_by;
  std::optional<literature::Fault> fault{};  ///< none: no program can follow what it says
  std::string_view rate{};                   ///< of wrong answers, by `daylight errata ID --pairs 3000`
  std::string_view test{};                   ///< of formulas that no verdict hangs on: what checks them
};

/// In the order of the documents: those of 2017, those of 2008 and of the book.
std::span<const Erratum> errata();
std::span<const Erratum> errata_2017();
std::span<const Erratum> errata_2008();

/// The id of the case that shows it, in corpus/cases/errata.jsonl.
std::string case_of(const Erratum& erratum);

/// The name of the method that shows it wrong, and of the one that differs by this fault alone and is right.
std::string wrong_method(const Erratum& erratum);
std::string right_method(const Erratum& erratum);

/// Every method with a single fault (`-only-`), every printed one with a single fault taken out
/// (`-without-`), and the other readings of the printed texts. Campaigns ask those that are named.
std::vector<std::unique_ptr<Method>> errata_methods();
std::vector<std::unique_ptr<Method>> errata_2008_methods();
std::vector<std::unique_ptr<Method>> errata_2017_methods();

/// Returns those of errata_methods() that are named by an item of `spec` (as select_methods() takes it) that
/// names nothing in `methods`.
std::vector<std::unique_ptr<Method>> named_errata(const std::vector<std::unique_ptr<Method>>& methods,
                                                  std::string_view spec);

}  // namespace cyl
