#include "CloudBuilder.h"
#include "CloudReaders.h"
#include "TextScanner.h"

namespace bolster {

PointCloud readXyz(const FileBytes& bytes)
{
    TextScanner text(bytes);
    CloudBuilder cloud(bytes);
    bool first = true;
    while (text.nextLine()) {
        const double x = text.number();
        const std::string_view second = text.word();
        if (std::exchange(first, false) && second.empty())
            continue; // some programs begin with the number of points
        const double y = text.number(second);
        cloud.addPoint({x, y, text.number()}, text.place());
    }
    return cloud.finish();
}

} // namespace bolster
