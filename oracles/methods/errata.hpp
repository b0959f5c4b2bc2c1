// SPDX-License-Identifier: MIT
// The errata of the documents that this project starts from, as far as a program can follow the text.
// solver/literature/errata.md describes them. The methods with a single fault are made from this table.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "oracles/methods/method.hpp"
#include "solver/literature/document.hpp"

namespace cyl {

enum class Document : unsigned char { text_2017, text_2008, book };

struct Erratum {
  std::string_view id;  ///< <document>-<fault>, as in the names of the methods and the headings of errata.md
  literature::Fault fault;

  Document document() const {
    if (id.starts_with("2017")) return Document::text_2017;
    return id.starts_with("2008") ? Document::text_2008 : Document::book;
  }
};

/// In the order of errata.md.
std::span<const Erratum> errata();

/// The mended texts (`-mended`), the texts with a single fault (`-only-`), the printed texts with a single
/// fault taken out (`-without-`), and other readings of these. A campaign asks them only if it names them.
std::vector<std::unique_ptr<Method>> errata_methods();
std::vector<std::unique_ptr<Method>> errata_2008_methods();
std::vector<std::unique_ptr<Method>> errata_2017_methods();

/// Returns the methods of errata_methods() that an item of `spec` names (in the syntax of select_methods()),
/// unless the item names a method in `methods`.
std::vector<std::unique_ptr<Method>> named_errata(const std::vector<std::unique_ptr<Method>>& methods,
                                                  std::string_view spec);

}  // namespace cyl
