#include "DesignJson.h"

namespace bolster {

ReadDesign readDesign(std::string_view)
{
    return {};
}

std::string writeDesign(const Design&)
{
    return {};
}

} // namespace bolster
