#include "Stretch.h"

namespace bolster {

double unwrappedEnd(double from, double to, double domainStart, double domainEnd)
{
    return to > from ? to : to + (domainEnd - domainStart);
}

} // namespace bolster
