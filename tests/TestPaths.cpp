#include "TestPaths.h"

namespace bolster::test {

std::string sourceFolder()
{
    return BOLSTER_SOURCE;
}

std::string samplesFolder()
{
    return BOLSTER_SOURCE "/resources/samples";
}

std::string dataFolder()
{
    return BOLSTER_SOURCE "/tests/data";
}

std::string goldenFolder()
{
    return BOLSTER_SOURCE "/tests/pictures/golden";
}

std::string program()
{
    return BOLSTER_PROGRAM;
}

} // namespace bolster::test
