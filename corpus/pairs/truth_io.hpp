// SPDX-License-Identifier: MIT
// Truths, certificates and answers as JSON. Numbers are written by format_double(). A number that JSON does
// not have is a string.
#pragma once

#include <string>

#include "base/json.hpp"
#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/method_answer.hpp"

namespace cyl {

/// One JSON object, such as {"verdict":"disjoint","direction":[x,y,z],"stage":"filter"}; `distance` may be
/// null. If no double can hold an end of it, the end is a string of decimals, as by format_end().
std::string format_truth(const Truth& truth, const Enclosure* distance = nullptr);
/// The decimals of an end of an enclosure: "6.3e308" and "-6.3e308" of infinite ones, beyond which no signed
/// distance of cylinders of doubles lies.
std::string format_end(double x);
/// The certificate alone, such as {"point":[[0,1e-3],0,"1/3"]}, or {} if there is none. A point in hulls is
/// {"point":[0,1,0],"hulls":["line","space"]}, with the hull of a first.
std::string format_certificate(const Certificate& certificate);
/// {"verdict":"disjoint","distance":0.5,"direction":[x,y,z]}, {"declined":"why"} or
/// {"failed":"crash","reason":"why"}. A number that is not finite becomes the string "nan", "inf" or "-inf".
std::string format_method_answer(const MethodAnswer& answer);

/// The same as values; numbers that are written without a point are integers.
nlohmann::ordered_json truth_to_json(const Truth& truth, const Enclosure* distance = nullptr);
nlohmann::ordered_json answer_to_json(const MethodAnswer& answer);

}  // namespace cyl
