#include "OutlineFit.h"
#include "CutPattern.h"
#include "DesignJson.h"
#include "TestPaths.h"
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
namespace bolster {
TEST(OutlineFit, Debug)
{
    std::ifstream file(test::samplesFolder() + "/armchair/armchair.json");
    std::stringstream text;
    text << file.rdbuf();
    const Design design = readDesign(text.str()).design;
    for (const CutPiece& piece : cutPattern(design, {}).pieces) {
        if (piece.name != "Outside back")
            continue;
        Contour line;
        line.closed = true;
        for (const LinePoint& p : piece.sew)
            line.points.push_back({p.at});
        const auto found = cornersOf(line);
        const auto fit = fittedCurve(line);
        printf("%s: %zu vertices, fit %d points\n", piece.name.c_str(), line.points.size(), fit->pointCount());
        const std::size_t n = line.points.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 a = line.points[(i + n - 1) % n].at, b = line.points[i].at, c = line.points[(i + 1) % n].at;
            const double turn = std::atan2(cross(b - a, c - b), (b - a).dot(c - b)) * 57.3;
            const double off = fit->closest(b).distance, mid = fit->closest((b + c) / 2).distance;
            if (piece.sew[i].corner || found[i] || off > 0.03 || mid > 0.07)
                printf("   %zu true %d found %d turn %.2f before %.2f after %.2f off %.3f mid %.3f\n", i,
                       piece.sew[i].corner, int(found[i]), turn, (b - a).norm(), (c - b).norm(), off, mid);
        }
    }
}
} // namespace bolster
