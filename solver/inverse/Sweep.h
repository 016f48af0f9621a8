// Where a cover varies when what it is made of does.
#pragma once

#include "SolveInput.h"
#include "SurfaceMesh.h"
#include "Tolerances.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace bolster {

/// How far each vertex lies outside of where it should be, mm, along the normal there. `strain`: the largest that
/// 99 % of the cover do not exceed, 1.
struct SweepSample {
    std::uint64_t number = 0;
    std::vector<float> outside;        ///< empty: no cover came to rest
    double rms = 0, p95 = 0, most = 0; ///< mm, of the sizes
    double strain = 0;
};

/// Samples of one design. Not for several threads at once; uses several itself.
class Sweep {
public:
    /// `edgeLength` of the triangles, mm; 0: the design's.
    Sweep(const SolveInput& input, Tolerances tolerances, int threads, const std::stop_token& stop = {},
          double edgeLength = 0);
    ~Sweep();
    Sweep(const Sweep&) = delete;
    Sweep& operator=(const Sweep&) = delete;

    /// Why there is no cover; empty when there is one.
    const Message& problem() const;
    const Tolerances& tolerances() const { return m_tolerances; }
    SurfaceMeshPtr nominal() const { return m_nominal; }

    /// What each tolerance does to each vertex: mm outwards for the whole of its spread upwards, and downwards, in
    /// two columns: cloth that becomes slack does something else than cloth that becomes tight.
    Eigen::MatrixXf linear(const std::function<void(double)>& progress = {}, const std::stop_token& stop = {});
    /// Tolerances of which it found no cover, neither upwards nor downwards, so that they seem to do nothing.
    const std::vector<std::size_t>& unknown() const { return m_unknown; }
    /// Covers at rest of samples `first` .. `first + count - 1`: from the nominal one on the same triangles, or
    /// where that leads to none by themselves. Each follows from its number alone.
    std::vector<SweepSample> solve(std::uint64_t first, int count, const std::stop_token& stop = {});
    /// Covers at rest with these numbers of all tolerances; null where there is none.
    std::vector<SurfaceMeshPtr> covers(const std::vector<Eigen::VectorXd>& numbers,
                                       const std::stop_token& stop = {});

private:
    struct Team;

    void solveAlone(const Design& design, SweepSample& sample, const std::stop_token& stop) const;

    Tolerances m_tolerances;
    Design m_design;
    DesignFiles m_files;
    double m_edgeLength;
    std::unique_ptr<Team> m_team;
    SurfaceMeshPtr m_nominal;
    std::vector<std::size_t> m_unknown;
};

/// Of each vertex the size that 95 % of the samples do not exceed.
struct LinearP95 {
    std::vector<float> map; ///< mm
    double rmsError = 0;    ///< mm: how far its rms over the cover may be from that of all samples there are
};
/// `linear` as of Sweep.
LinearP95 linearP95(const Eigen::MatrixXf& linear, const Tolerances& tolerances, int samples,
                    const std::stop_token& stop = {});
std::vector<float> solvedP95(const std::vector<const SweepSample*>& samples);
/// `linearP95` of many pieces, put right by some that are solved.
struct CorrectedP95 {
    std::vector<float> map; ///< mm, per vertex
    /// How far its rms over the cover may be from that of many solved pieces, mm: by what halves of the solved ones
    /// say by themselves, and batches of the linear ones. Of fewer than 16 that says nothing.
    std::optional<double> rmsError;
};
/// Plus what the solved ones exceed linear covers of the same pieces by (a control variate), so that what is chance
/// in the few does not count.
CorrectedP95 correctedP95(const LinearP95& linearP95, const Eigen::MatrixXf& linear, const Tolerances& tolerances,
                          const std::vector<const SweepSample*>& solved);
/// Between which shares that of many pieces lies, in 95 of 100 cases, when `count` of `all` were counted (Wilson's
/// interval).
std::array<double, 2> shareOfMany(int count, int all);
/// Over all vertices.
double rmsOf(const std::vector<float>& map);

/// How much of the variance of the whole cover comes of each tolerance, as shares.
std::vector<double> influences(const Eigen::MatrixXf& linear, const Tolerances& tolerances,
                               const std::vector<double>& areasOfVertices);

/// How far a sample would be from the nominal cover, if covers were linear.
SweepSample linearSample(const Eigen::MatrixXf& linear, const Tolerances& tolerances, std::uint64_t number);

} // namespace bolster
