#include "TruthForms.h"

#include "DesignJson.h"
#include "MeshImport.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace bolster::test {

namespace {

/// PLY has no groups: how many faces each has, in the order of the file.
using Groups = std::vector<std::pair<const char*, std::uint32_t>>;

const Groups armchairGroups{{"Seat", 11050},        {"Front", 4646},         {"Side right", 2432},
                            {"Inside back", 10117}, {"Outside back", 12633}, {"Top band", 5173},
                            {"Side left", 2352}};
const Groups carSeatGroups{{"Cushion insert", 4916},
                           {"Cushion bolster right", 2123},
                           {"Cushion bolster left", 2123},
                           {"Cushion side right", 2733},
                           {"Cushion side left", 2942},
                           {"Cushion front", 2122},
                           {"Cushion rear", 1642},
                           {"Back insert", 5723},
                           {"Back bolster right", 2390},
                           {"Back bolster left", 2393},
                           {"Back side right", 3066},
                           {"Back side left", 2903},
                           {"Back top", 1412},
                           {"Back bottom", 1439}};

TriangleMesh truth(const std::string& file, const Groups& groups)
{
    const ImportedMesh read = importMesh(QString::fromStdString(dataFolder() + "/truth/" + file));
    EXPECT_TRUE(read.mesh) << read.problem.english();
    TriangleMesh mesh = *read.mesh;
    mesh.parts.clear();
    std::uint32_t first = 0;
    for (const auto& [name, count] : groups) {
        mesh.parts.push_back({name, first, count});
        first += count;
    }
    EXPECT_EQ(first, mesh.triangles.size());
    return mesh;
}

} // namespace

TriangleMesh armchairForm()
{
    return truth("armchair-truth.ply", armchairGroups);
}

TriangleMesh carSeatForm()
{
    return truth("car-seat-truth.ply", carSeatGroups);
}

Design designIn(const std::string& path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    const ReadDesign read = readDesign(text.str());
    EXPECT_TRUE(read.readable) << path;
    return read.design;
}

} // namespace bolster::test
