// SPDX-License-Identifier: MIT
// Truths, certificates and answers as JSON. Numbers are written as format_double() has them.
#pragma once

#include <string>

#include "base/json.hpp"
#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/method_answer.hpp"

namespace cyl {

/// One JSON object: {"verdict":"disjoint","direction":[x,y,z],"stage":"filter"} and so on; `distance` may be
/// null.
std::string format_truth(const Truth& truth, const Enclosure* distance = nullptr);
/// The certificate alone, e.g. {"point":[[0,1e-3],0,"1/3"]}; {} where there is none.
std::string format_certificate(const Certificate& certificate);
/// {"verdict":"disjoint","distance":0.5,"direction":[x,y,z]}, {"declined":"why"} or
/// {"failed":"crash","reason":"why"}. A number that is not finite becomes the string "nan", "inf" or "-inf".
std::string format_method_answer(const MethodAnswer& answer);

/// The same as values; numbers that are written without a point are integers.
nlohmann::ordered_json truth_to_json(const Truth& truth, const Enclosure* distance = nullptr);
nlohmann::ordered_json answer_to_json(const MethodAnswer& answer);

}  // namespace cyl
