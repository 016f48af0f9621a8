// The designs in tests/data.
#pragma once

#include "DesignJson.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace bolster::test {

inline std::string readText(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file.good()) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

inline std::string designText(const std::string& name)
{
    return readText(test::dataFolder() + "/designs/" + name + ".json");
}

/// The design of a text that must be free of problems.
inline Design soundDesign(const std::string& text)
{
    const ReadDesign read = readDesign(text);
    EXPECT_TRUE(read.readable);
    for (const Problem& problem : read.problems)
        ADD_FAILURE() << problem.english();
    return read.design;
}

inline constexpr const char* designNames[] = {"armchair", "car-seat", "car-seat-tied"};

} // namespace bolster::test
