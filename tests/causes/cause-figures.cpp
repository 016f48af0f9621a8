// How often the right cause is named first: causes are injected one after the other into pieces whose scans have
// noise and holes. Usage: bolster_cause_figures DESIGN [COUNT [EDGE_MM [BUILT_MM]]]
// EDGE_MM: of the triangles of the covers that explain, BUILT_MM: of those that are scanned; 0: the design's. When
// they are not the same the scan of a sound piece, with noise and holes of its own, is there, too.
#include "BuiltScan.h"
#include "DesignFile.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

using namespace bolster;

namespace {

struct Count {
    int right = 0, exactly = 0, tried = 0;
};

void print(const char* name, const Count& count)
{
    std::printf("%-9s %3d of %3d found, %3d of them exactly\n", name, count.right, count.tried, count.exactly);
}

/// mm, over the whole cover, along the normals.
double changeOf(const SurfaceMesh& nominal, const SurfaceMesh& built)
{
    double squares = 0;
    for (std::size_t v = 0; v < nominal.positions.size(); ++v)
        squares += std::pow(nominal.normals[v].cast<double>().dot(built.positions[v] - nominal.positions[v]), 2);
    return std::sqrt(squares / static_cast<double>(nominal.positions.size()));
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2)
        return 2;
    const int count = argc > 2 ? std::atoi(argv[2]) : 50;
    const OpenedDesign opened = openDesign(QString::fromLocal8Bit(argv[1]));
    ExplainOrder order;
    order.edgeLength = argc > 3 ? std::atof(argv[3]) : 0;
    CauseFinder finder({opened.design, opened.files}, order);
    if (!finder.nominal()) {
        std::fprintf(stderr, "%s\n", finder.problem().english().c_str());
        return 1;
    }
    const Design design = withoutTwins(opened.design);
    WarmCover cover({design, opened.files}, {.edgeLength = argc > 4 ? std::atof(argv[4]) : order.edgeLength});
    const SurfaceMeshPtr sound = cover.surface();
    const FitTarget soundScan =
        argc > 4 ? test::scanOf(*sound, 5, 1, 4U * static_cast<unsigned>(count)) : FitTarget{};
    std::map<Cause::Kind, Count> counts;
    Count all;
    for (unsigned seed = 0; all.tried < count && seed < 4U * static_cast<unsigned>(count); ++seed) {
        const test::Injected truth = test::injected(finder.causes(), seed);
        const Cause& cause = finder.causes()[truth.cause];
        Count& kind = counts[cause.kind];
        if (!cover.follow(withCause(design, cause, truth.values))) {
            std::printf("%3u %s: no cover\n", seed, cause.name.c_str());
            continue;
        }
        const SurfaceMeshPtr built = cover.surface();
        const double change = changeOf(*sound, *built);
        const Explanations found = finder.explain(test::scanOf(*built, 5, 1, seed), soundScan);
        const bool right = test::isFound(found, truth.cause);
        const bool exactly = right && found.ranked.front().cause == truth.cause;
        const Explanation& first = found.ranked.front();
        std::printf(
            "%3u %-8s %s = %.1f, changes %.2f mm: %s, %s = %.1f+-%.1f, %.0f %%, log evidence %.1f, noise %.2f\n",
            seed, wordOf(cause.kind), cause.name.c_str(), truth.values[0], change,
            exactly ? "right"
            : right ? "alike"
                    : "WRONG",
            finder.causes()[first.cause].name.c_str(), first.values[0], first.spreads[0], 100 * first.share,
            first.evidence, found.noise);
        std::fflush(stdout);
        for (Count* one : {&kind, &all}) {
            ++one->tried;
            one->right += right ? 1 : 0;
            one->exactly += exactly ? 1 : 0;
        }
    }
    for (const auto& [kind, one] : counts)
        print(wordOf(kind), one);
    print("all", all);
    return 0;
}
