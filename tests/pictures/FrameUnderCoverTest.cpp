// The foam of the samples does not stick out of their covers.
#include "DesignFile.h"
#include "FrameSkin.h"
#include "PictureScene.h"
#include "RestingSolve.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster {
namespace {

using Vec3f = Eigen::Vector3f;

TriangleRays raysAt(const FrameSkin& skin)
{
    std::vector<Vec3f> points;
    std::vector<TriangleRays::Triangle> triangles;
    for (const FrameSkin::Corner& corner : skin.corners) {
        if (points.size() % 3 == 0)
            triangles.push_back({static_cast<std::uint32_t>(points.size()),
                                 static_cast<std::uint32_t>(points.size() + 1),
                                 static_cast<std::uint32_t>(points.size() + 2)});
        points.push_back(corner.position);
    }
    TriangleRays rays;
    rays.build(std::move(points), std::move(triangles));
    return rays;
}

TriangleRays raysAt(const SurfaceMesh& cover)
{
    std::vector<Vec3f> points;
    for (const Vec3& p : cover.positions)
        points.emplace_back(p.cast<float>());
    TriangleRays rays;
    rays.build(std::move(points), cover.topology->triangles);
    return rays;
}

/// How many of the lines of sight that meet the outside of the cover meet the frame shortly before.
struct Sights {
    int cover = 0;
    int spoilt = 0;
};

Sights sightsOf(const SurfaceMesh& cover, const FrameSkin& skin, float from)
{
    constexpr float before = 60; // mm
    const TriangleRays onCover = raysAt(cover), onFrame = raysAt(skin);
    Eigen::AlignedBox3f box;
    for (const Vec3& p : cover.positions)
        box.extend(p.cast<float>());
    const float radius = box.diagonal().norm() / 2;
    Sights sights;
    for (int turn = 0; turn < 12; ++turn)
        for (const double lift : {0.1, 0.6, 1.2}) {
            const double angle = turn * std::numbers::pi / 6;
            const Vec3f away(static_cast<float>(std::cos(lift) * std::sin(angle)),
                             static_cast<float>(-std::cos(lift) * std::cos(angle)),
                             static_cast<float>(std::sin(lift)));
            const Vec3f right = Vec3f::UnitZ().cross(away).normalized(), up = away.cross(right);
            constexpr int across = 150;
            for (int i = 0; i < across * across; ++i) {
                const auto at = [&](int k) { return radius * (2 * (static_cast<float>(k) + 0.5F) / across - 1); };
                const Vec3f eye = box.center() + 2 * radius * away + at(i % across) * right + at(i / across) * up;
                const auto seen = onCover.first(eye, -away);
                if (!seen || (eye - seen->distance * away).z() < from)
                    continue;
                const auto& t = cover.topology->triangles[seen->triangle];
                const Vec3 &a = cover.positions[t[0]], &b = cover.positions[t[1]], &c = cover.positions[t[2]];
                if ((b - a).cross(c - a).dot(away.cast<double>()) <= 0)
                    continue;
                ++sights.cover;
                const auto frame = onFrame.first(eye, -away);
                if (frame && frame->distance < seen->distance && frame->distance > seen->distance - before)
                    ++sights.spoilt;
            }
        }
    return sights;
}

/// Below `from`, mm, there are gaps in the cover in which the frame is seen rightly.
struct CoveredSample {
    const char* name;
    float from;
};

class FrameUnderCover : public testing::TestWithParam<CoveredSample> {};

TEST_P(FrameUnderCover, DoesNotStandOutOfIt)
{
    const OpenedDesign opened =
        openDesign(QString::fromStdString(test::samplesFolder() + "/" + GetParam().name + ".json"));
    const SolveResult solved = solveResting({opened.design, opened.files}, {});
    ASSERT_TRUE(solved.surface);
    for (const Scene::FrameLook& frame : framesForPicture(opened.design, opened.files, solved.surface.get())) {
        const Sights sights = sightsOf(*solved.surface, *frame.skin, GetParam().from);
        EXPECT_GT(sights.cover, 1000);
        EXPECT_LE(sights.spoilt, sights.cover / 5000) << "of " << sights.cover;
    }
}

constexpr float nowhere = -1e6F;
INSTANTIATE_TEST_SUITE_P(Samples, FrameUnderCover,
                         testing::Values(CoveredSample{"armchair/armchair", 300},
                                         CoveredSample{"armchair-scan/armchair-scan", 300},
                                         CoveredSample{"car-seat/car-seat", nowhere},
                                         CoveredSample{"car-seat/car-seat-g1", nowhere},
                                         CoveredSample{"car-seat-cushioned/car-seat-cushioned", nowhere}));

} // namespace
} // namespace bolster
