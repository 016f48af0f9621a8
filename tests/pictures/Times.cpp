// What it takes to show a cover and to take its picture, in milliseconds:
//   bolster_picture_times DESIGN
#include "BakeFabric.h"
#include "CoverRefiner.h"
#include "DesignFile.h"
#include "PictureStudio.h"
#include "RestingSolve.h"
#include "SeamRelief.h"
#include "SeamTrims.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cstdio>
#include <functional>

namespace {

using namespace bolster;

/// The median of some, or the only one.
double milliseconds(int times, const std::function<void()>& what)
{
    std::vector<double> all;
    for (int i = 0; i < times; ++i) {
        Stopwatch watch;
        what();
        all.push_back(watch.elapsed());
    }
    std::ranges::sort(all);
    return all[all.size() / 2];
}

void print(const char* what, double time)
{
    std::printf("%-52s %9.1f ms\n", what, time);
}

PictureOrder order(int width, int height, int samples, bool refined)
{
    PictureOrder order;
    order.from = *pictureDirection("three-quarter");
    order.look.refined = refined;
    order.options.width = width;
    order.options.height = height;
    order.options.samples = samples;
    return order;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "Usage: bolster_picture_times DESIGN\n");
        return 2;
    }
    const OpenedDesign opened = openDesign(QString::fromLocal8Bit(argv[1]));
    SurfaceMeshPtr surface;
    print("solving", milliseconds(1, [&] { surface = solveResting({opened.design, opened.files}, {}).surface; }));
    if (!surface) {
        std::fprintf(stderr, "%s cannot be solved.\n", argv[1]);
        return 1;
    }
    std::printf("%u vertices\n", surface->topology->vertexCount());

    CoverRefiner refiner;
    CoverMeshPtr cover;
    print("refining by two levels, first mesh", milliseconds(1, [&] { cover = refiner.refine(surface, 2); }));
    print("refining by two levels, each further mesh",
          milliseconds(21, [&] { cover = refiner.refine(surface, 2); }));
    print("relief of the seams", milliseconds(3, [&] { seamRelief(opened.design, *cover->topology); }));
    SeamTrims trims;
    print("stitches and piping, first mesh", milliseconds(1, [&] { trims.make(opened.design, *cover); }));
    print("stitches and piping, each further mesh", milliseconds(21, [&] { trims.make(opened.design, *cover); }));

    const FabricBaker bake = [](ElementId, const Fabric& fabric) { return bakeFabric(fabric); };
    const auto studio = [&] {
        return PictureStudio({surface, opened.design, opened.files, bake, nullptr, nullptr});
    };
    PictureStudio preview = studio(), picture = studio();
    const auto draw = [](PictureStudio& in, const PictureOrder& what) { in.draw(what, {}); };
    print("first preview, 320 x 240", milliseconds(1, [&] { draw(preview, order(320, 240, 4, false)); }));
    print("next preview", milliseconds(1, [&] { draw(preview, order(320, 240, 4, false)); }));
    print("picture, 1280 x 960, 16 samples, fabrics baked",
          milliseconds(1, [&] { draw(picture, order(1280, 960, 16, true)); }));
    print("the same from elsewhere", milliseconds(1, [&] { draw(picture, order(1280, 960, 16, true)); }));
    return 0;
}
