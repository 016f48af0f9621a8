// Numbers of elements by the keys of their text form.
#include "NumberField.h"

#include "Design.h"

#include <gtest/gtest.h>

namespace bolster::test {
namespace {

/// The path leads to a number of that value, and another one there changes it as `change` does, and nothing else.
template <class T, class Change>
void expectNumber(const T& value, const std::string& path, double expected, const Change& change)
{
    SCOPED_TRACE(path);
    const ElementPtr element = makeElement(value);
    const std::optional<double> found = numberAt(*element, path);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, expected);
    T changed = value;
    change(changed) = 12.5;
    const ElementPtr other = withNumber(*element, path, 12.5);
    ASSERT_TRUE(other);
    EXPECT_EQ(std::get<T>(*other), changed);
    EXPECT_EQ(std::get<T>(*element), value) << "the element itself stays";
}

template <class T>
void expectNoNumber(const T& value, const std::vector<std::string>& paths)
{
    const ElementPtr element = makeElement(value);
    for (const std::string& path : paths) {
        EXPECT_FALSE(numberAt(*element, path)) << path;
        EXPECT_FALSE(withNumber(*element, path, 1)) << path;
    }
}

TEST(NumberField, FindsTheUsualValuesOfAFabric)
{
    const Fabric fabric;
    expectNumber(fabric, "stiffness", 1, [](Fabric& f) -> double& { return f.stiffness; });
    expectNumber(fabric, "bending_length", 6, [](Fabric& f) -> double& { return f.bendingLength; });
    expectNumber(fabric, "limits.along", 8, [](Fabric& f) -> double& { return f.limits.along; });
    expectNumber(fabric, "limits.shear", 10, [](Fabric& f) -> double& { return f.limits.shear; });
    expectNoNumber(fabric, {"", ".", "limits", "limits.", ".along", "along", "limits.along.0", "name", "color",
                            "Stiffness", "stiffness ", "dilation_mm"});
}

TEST(NumberField, FindsCoordinates)
{
    const Foam foam;
    expectNumber(foam, "size.1", 100, [](Foam& f) -> double& { return f.size.y(); });
    expectNumber(foam, "position.2", 0, [](Foam& f) -> double& { return f.position.z(); });
    expectNumber(foam, "scale", 1, [](Foam& f) -> double& { return f.scale; });
    expectNumber(foam, "dilation_mm", 0, [](Foam& f) -> double& { return f.dilation; });
    expectNoNumber(foam, {"size", "size.3", "size.-1", "size.x", "size.01", "cut", "shape", "cushion"});
}

TEST(NumberField, FindsThoseOfPatchesCushionsAndScans)
{
    const Patch patch;
    expectNumber(patch, "pressure", patch.pressure, [](Patch& p) -> double& { return p.pressure; });
    expectNumber(patch, "position.0", 0, [](Patch& p) -> double& { return p.position.x(); });
    expectNoNumber(patch, {"outline", "outline.0", "outline.points.0.0", "fabric"});
    const Cushion cushion;
    expectNumber(cushion, "dilation_mm", 30, [](Cushion& c) -> double& { return c.dilation; });
    expectNoNumber(cushion, {"enabled", "frame", "patches", "patches.0"});
    const Scan scan;
    expectNumber(scan, "threshold_mm", scan.threshold, [](Scan& s) -> double& { return s.threshold; });
}

/// What may be missing as a whole has numbers only where it is there.
TEST(NumberField, LooksIntoGroupsThatAreThere)
{
    Seam seam;
    expectNumber(seam, "ease_mm", 0, [](Seam& s) -> double& { return s.ease; });
    expectNoNumber(seam, {"a.patch", "trim"});
    const ElementPtr moved = withNumber(*makeElement(seam), "a.from", 0.25);
    ASSERT_TRUE(moved);
    EXPECT_EQ(std::get<Seam>(*moved).a.from, 0.25);
    EXPECT_EQ(std::get<Seam>(*moved).b, seam.b);
    Settings settings;
    expectNumber(settings, "edge_length", settings.edgeLength, [](Settings& s) -> double& { return s.edgeLength; });
    expectNoNumber(settings, {"symmetry", "symmetry.plane.normal.0"});
}

} // namespace
} // namespace bolster::test
