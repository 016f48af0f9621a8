// Designs that tests of patterns begin with.
#pragma once

#include "DesignJson.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace bolster::test {

/// Of resources/samples, without its files.
inline Design sampleDesign(const std::string& name)
{
    std::ifstream file(samplesFolder() + "/" + name + "/" + name + ".json");
    std::stringstream text;
    text << file.rdbuf();
    const ReadDesign read = readDesign(text.str());
    EXPECT_TRUE(read.readable) << name;
    return read.design;
}

} // namespace bolster::test
