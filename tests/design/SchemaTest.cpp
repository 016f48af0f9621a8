// The schema that is committed is the one that the descriptions give.
#include "DesignSchema.h"
#include "FieldTables.h"
#include "TestPaths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace bolster {
namespace {

/// BOLSTER_WRITE_SCHEMA=1 writes it anew after a description has changed.
TEST(DesignSchema, IsTheCommittedOne)
{
    const std::string path = test::sourceFolder() + "/docs/design.schema.json";
    if (std::getenv("BOLSTER_WRITE_SCHEMA"))
        std::ofstream(path) << designSchema();
    std::ostringstream committed;
    committed << std::ifstream(path).rdbuf();
    EXPECT_EQ(committed.str(), designSchema())
        << "run this test with BOLSTER_WRITE_SCHEMA=1 and look at what differs";
}

/// BOLSTER_WRITE_TABLES=1 writes them anew.
TEST(FieldTables, AreTheCommittedOnes)
{
    const std::string path = test::sourceFolder() + "/docs/design-json.md";
    std::ostringstream committed;
    committed << std::ifstream(path).rdbuf();
    if (std::getenv("BOLSTER_WRITE_TABLES"))
        std::ofstream(path) << withFieldTables(committed.str());
    else
        EXPECT_EQ(committed.str(), withFieldTables(committed.str()))
            << "run this test with BOLSTER_WRITE_TABLES=1 and look at what differs";
    const auto schema = nlohmann::json::parse(designSchema());
    for (const std::string kind : schema["properties"]["elements"]["items"]["properties"]["kind"]["enum"])
        EXPECT_NE(committed.str().find("<!-- fields of " + kind + " -->"), std::string::npos) << kind;
}

TEST(DesignSchema, SaysLimitsDefaultsAndWords)
{
    const auto schema = nlohmann::json::parse(designSchema());
    const auto& fabric = schema["$defs"]["fabric"]["properties"];
    EXPECT_EQ(fabric["poisson"]["minimum"], -0.5);
    EXPECT_EQ(fabric["poisson"]["maximum"], 0.5);
    EXPECT_EQ(fabric["poisson"]["default"], 0.3);
    EXPECT_EQ(fabric["look"]["properties"]["kind"]["enum"].size(), 7U);
    EXPECT_FALSE(fabric["look"]["properties"]["roughness"].contains("default")) << "depends on the kind";
    EXPECT_EQ(schema["$defs"]["seam"]["properties"]["reversed"]["default"], true);
    const auto& required = schema["$defs"]["patch"]["required"];
    EXPECT_NE(std::ranges::find(required, "outline"), required.end());
    EXPECT_EQ(std::ranges::find(required, "pressure"), required.end());
    EXPECT_EQ(schema["properties"]["settings"]["properties"]["edge_length"]["exclusiveMinimum"], 0);
}

} // namespace
} // namespace bolster
