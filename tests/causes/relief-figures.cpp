// How well predicted gains of reliefs say which is best: each is solved, and both orders are compared.
// Usage: bolster_relief_figures DESIGN [LIMIT_PERCENT [COUNT [EDGE_MM]]]
// EDGE_MM: of the triangles of predictions; 0: the design's.
#include "DesignFile.h"
#include "RankCorrelation.h"
#include "Reliefs.h"

#include <cstdio>
#include <cstdlib>

using namespace bolster;

int main(int argc, char** argv)
{
    if (argc < 2)
        return 2;
    const OpenedDesign opened = openDesign(QString::fromLocal8Bit(argv[1]));
    const SolveInput input{opened.design, opened.files};
    ReliefOrder order;
    order.limit = argc > 2 ? std::atof(argv[2]) : 1.5;
    order.solved = 0;
    order.edgeLength = argc > 4 ? std::atof(argv[4]) : 0;
    ReliefList list = proposeReliefs(input, order);
    if (!list.problem.empty()) {
        std::fprintf(stderr, "%s\n", list.problem.english().c_str());
        return 1;
    }
    std::printf("%.1f %% of the area over the limit, %zu reliefs\n", 100 * list.now.area, list.reliefs.size());
    // Spread over all of them: the best ones alone differ too little.
    const std::size_t count = std::min<std::size_t>(argc > 3 ? std::atoi(argv[3]) : 30, list.reliefs.size());
    std::vector<double> predicted, solved;
    for (std::size_t k = 0; k < count; ++k) {
        Relief& relief = list.reliefs[k * list.reliefs.size() / count];
        solveRelief(input, order.limit, list.now, 0, relief);
        std::printf("%-10s %6.2f %%", wordOf(relief.kind), 100 * relief.predicted);
        if (relief.solved) {
            predicted.push_back(relief.predicted);
            solved.push_back(relief.solved->energy);
            std::printf(" solved %6.2f %%, area %6.2f %%", 100 * relief.solved->energy, 100 * relief.solved->area);
        } else {
            std::printf(" no cover                     ");
        }
        std::printf("  %s\n", relief.text.english().c_str());
        std::fflush(stdout);
    }
    std::printf("rank correlation of %zu: %.3f\n", predicted.size(), test::rankCorrelation(predicted, solved));
    return 0;
}
