#include "BenchReport.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <thread>

namespace bolster::bench {

namespace {

struct Cells {
    std::string name, ours, peer, peerTime, ratio;
};

std::string number(double value)
{
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), value < 1 ? "%.3f" : value < 100 ? "%.2f" : "%.0f", value);
    return text.data();
}

Cells cells(const Row& row)
{
    Cells cells{row.name, number(row.ours), "", "", ""};
    if (row.peer)
        cells = {row.name, number(row.ours), *row.peer, number(row.peerTime), number(row.ratio())};
    return cells;
}

std::string line(const Cells& cells)
{
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(), "%-19s %10s  %-27s %10s %8s", cells.name.c_str(), cells.ours.c_str(),
                  cells.peer.c_str(), cells.peerTime.c_str(), cells.ratio.c_str());
    return text.data();
}

/// What stands behind the colon in the first line of a file of /proc that begins with the key.
std::string fromProc(const std::string& file, const std::string& key)
{
    std::ifstream stream("/proc/" + file);
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with(key))
            return line.substr(std::min(line.size(), line.find_first_not_of(" \t", line.find(':') + 1)));
    return "unknown";
}

std::string machine()
{
    const double kilobytes = std::atof(fromProc("meminfo", "MemTotal").c_str());
    std::ostringstream text;
    text << fromProc("cpuinfo", "model name") << ", " << std::thread::hardware_concurrency() << " cores, cache "
         << fromProc("cpuinfo", "cache size") << ", " << number(kilobytes / (1024 * 1024)) << " GB of memory; "
#if defined(__clang__)
         << "Clang "
#elif defined(__GNUC__)
         << "GCC "
#endif
         << __VERSION__;
    return text.str();
}

const char* const explanation = R"(# Performance

The result of `bolster bench --markdown docs/performance.md`, on a machine with nothing else to do.

**How it is measured.** All in one run, times in milliseconds, medians. Contestants have the same triangles and the same
held vertices, are factored beforehand, and run in turns (A B A B ...) for some milliseconds each, so that a busy machine
hits all alike; `ratio` is peer / ours. Everything is compiled with the same options (-O3); Bolster has two threads and
chooses its vector instructions at run time, the peers have one thread. `iteration_...` is on a square whose clamped ends
are bent. CGAL's Surface_mesh_deformation solves with its default, Eigen's SparseLU, and where it says so with
UMFPACK without iterative refinement, the fastest that its matrix admits: that is not symmetric, so it has no Cholesky
factor. `converge_bend_11k` is a strip bent by turning one clamped end, from flat until the estimated distance to the method's own limit is below
1e-4 of the size D; for CGAL it is the number of iterations, counted beforehand, times the time of one. `solve_...` is
L and L^T of L1, in the order of the factor: Bolster with four right-hand sides in single precision, the others with the
three that are needed in double precision. CHOLMOD keeps the best of AMD, METIS and nested dissection; Eigen uses AMD.
`table1_...` are iterations on a car seat with the paper's numbers of vertices. `setup_11k` is what lies between the
triangles and the first iteration. `drag_...`, `release_...` and `rest_...` go through the solver's thread like
the workbench's drags: the time until the surface for the newest pattern is there (on fewer triangles where the design has many),
from the release until where the drag has led is there on new triangles, and from the release until the cover is at rest. `cold_...` solve a sample from nothing to rest, with edges of so many mm; "one level" does so on its own
triangles alone and with momentum all the way.
`floor_fraction_45k` compares a solve with two reads of an array of the factor's size by the same threads: the ratio is
the share of the solve that cannot be avoided. The ratio of `growth_...` is that of the times of an iteration on meshes
of four times as many vertices.
)";

} // namespace

std::string tableHead()
{
    return line({"name", "ours ms", "peer", "peer ms", "ratio"});
}

std::string tableLine(const Row& row)
{
    return line(cells(row));
}

std::string markdown(const std::vector<Row>& rows)
{
    std::ostringstream text;
    text << explanation << "\nMachine: " << machine()
         << ".\n\n| name | ours, ms | peer | peer, ms | ratio |\n|---|---:|---|---:|---:|\n";
    for (const Row& row : rows) {
        const Cells c = cells(row);
        text << "| `" << c.name << "` | " << c.ours << " | " << c.peer << " | " << c.peerTime << " | " << c.ratio
             << " |\n";
    }
    return text.str();
}

} // namespace bolster::bench
