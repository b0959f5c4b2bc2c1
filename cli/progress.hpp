// SPDX-License-Identifier: MIT
// How far a campaign is, on standard error: a bar on a terminal, a line each 5 s elsewhere.
#pragma once

#include <chrono>

#include "fuzz/campaign.hpp"

namespace cyl {

class ProgressLine {
 public:
  explicit ProgressLine(const CampaignOptions& options);
  ~ProgressLine();  ///< takes the bar away
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const CampaignProgress& progress);

 private:
  CampaignOptions options_;
  bool terminal_;
  std::chrono::milliseconds shown_at_{0};  ///< of the session
};

}  // namespace cyl
