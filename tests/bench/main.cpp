// The benchmarks in Google Benchmark's hands: one for each contestant, with its filters, repetitions and
// statistics.
#include "Benchmarks.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace bolster::bench {
namespace {

/// Contestants of a benchmark that was prepared last: the meshes of all at once would need too much memory.
class Prepared {
public:
    const Lap& lap(const Benchmark& benchmark, std::size_t contestant)
    {
        if (m_name != benchmark.name) {
            m_laps.clear();
            m_laps = benchmark.prepare();
            m_name = benchmark.name;
        }
        return m_laps[contestant];
    }

private:
    std::string m_name;
    std::vector<Lap> m_laps;
};

void registerContestants(const Benchmark& benchmark, const std::shared_ptr<Prepared>& prepared)
{
    for (std::size_t k = 0; k <= benchmark.peers.size(); ++k) {
        const std::string name = benchmark.name + "/" + (k == 0 ? "Bolster" : benchmark.peers[k - 1]);
        const auto measure = [benchmark, prepared, k](::benchmark::State& state) {
            const Lap& lap = prepared->lap(benchmark, k);
            for ([[maybe_unused]] auto unused : state)
                state.SetIterationTime(lap() / 1000);
        };
        ::benchmark::RegisterBenchmark(name.c_str(), measure)->UseManualTime()->Unit(::benchmark::kMillisecond);
    }
}

} // namespace
} // namespace bolster::bench

int main(int argc, char** argv)
{
    using namespace bolster::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    const auto prepared = std::make_shared<Prepared>();
    for (const Benchmark& benchmark : benchmarks(Extent::Full))
        registerContestants(benchmark, prepared);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
