// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace cyl {

/// Returns the JSON that a filled template holds, read by other code than wrote it; empty after a failure.
inline std::string page_data(const std::string& page) {
  const std::string before = "id=\"report-data\">";
  const std::size_t at = page.find(before) + before.size(), end = page.find('<', at);
  EXPECT_EQ(page.substr(end, 9), "</script>") << "the data ends its own element";
  std::string bytes, text(std::size_t{1} << 22, ' ');
  unsigned bits = 0, known = 0;
  for (std::size_t i = at; i < end && page[i] != '='; ++i) {
    const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6 | static_cast<unsigned>(digits.find(page[i]));
    if ((known += 6) < 8) continue;
    known -= 8;
    bytes += static_cast<char>(bits >> known);
  }
  uLongf size = text.size();
  const int result = uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  EXPECT_EQ(result, Z_OK);
  return text.substr(0, result == Z_OK ? size : 0);
}

}  // namespace cyl
