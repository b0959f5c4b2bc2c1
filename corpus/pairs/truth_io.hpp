// SPDX-License-Identifier: MIT
// Truths, certificates and answers as JSON. Numbers are written as format_double() has them; what is no
// number of JSON is a string.
#pragma once

#include <string>

#include "base/json.hpp"
#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/method_answer.hpp"

namespace cyl {

/// One JSON object: {"verdict":"disjoint","direction":[x,y,z],"stage":"filter"} and so on; `distance` may be
/// null. An end of it that no double reaches is a string of decimals, as format_end() has them.
std::string format_truth(const Truth& truth, const Enclosure* distance = nullptr);
/// The decimals of an end of an enclosure: "6.3e308" and "-6.3e308" of infinite ones, beyond which no signed
/// distance of cylinders of doubles lies.
std::string format_end(double x);
/// The certificate alone, e.g. {"point":[[0,1e-3],0,"1/3"]}; {} where there is none. Of a point in hulls:
/// {"point":[0,1,0],"hulls":["line","space"]}, the hull of a first.
std::string format_certificate(const Certificate& certificate);
/// {"verdict":"disjoint","distance":0.5,"direction":[x,y,z]}, {"declined":"why"} or
/// {"failed":"crash","reason":"why"}. A number that is not finite becomes the string "nan", "inf" or "-inf".
std::string format_method_answer(const MethodAnswer& answer);

/// The same as values; numbers that are written without a point are integers.
nlohmann::ordered_json truth_to_json(const Truth& truth, const Enclosure* distance = nullptr);
nlohmann::ordered_json answer_to_json(const MethodAnswer& answer);

}  // namespace cyl
