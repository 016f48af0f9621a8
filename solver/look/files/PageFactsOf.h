// What a customer's page says of a cover.
#pragma once

#include "CustomerPage.h"
#include "MakeCoverModel.h"

namespace bolster {

/// Seams by the patches that they join, longest first; those of no length are left out.
PageFacts pageFacts(const ModelSubject& subject, const CoverModel& model, const std::string& title);

} // namespace bolster
