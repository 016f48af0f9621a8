// The benchmarks: what is compared with what, and on which mesh.
#pragma once

#include "Race.h"

#include <optional>
#include <string>
#include <vector>

namespace bolster::bench {

enum class Extent {
    Full,  ///< at most five minutes
    Quick, ///< a minute; without the largest meshes
    Smoke  ///< seconds, with tiny meshes: everything runs, the figures say nothing
};

/// One benchmark: Bolster against its peers, on the same mesh with the same held vertices. Times are in ms; where
/// the result is a share or a growth it is the ratio peer / ours.
struct Benchmark {
    struct Published {
        std::string peer;
        double time = 0;
    };

    std::string name;
    std::vector<std::string> peers;
    std::function<std::vector<Lap>()> prepare;         ///< Bolster's lap, then the peers'
    std::optional<Published> published = std::nullopt; ///< a peer that cannot be run here
    bool listed = true;                                ///< one of those that results are compared by
};

std::vector<Benchmark> benchmarks(Extent extent);

/// A line of the results.
struct Row {
    std::string name;
    double ours = 0; ///< ms
    std::optional<std::string> peer;
    double peerTime = 0; ///< ms
    bool listed = true;

    double ratio() const { return peerTime / ours; }
};

/// Runs one benchmark, for a time that depends on the extent. Empty when stopped; throws when a benchmark fails.
std::vector<Row> run(const Benchmark& benchmark, Extent extent, const std::stop_token& stop = {});

} // namespace bolster::bench
