#include "BendConvergence.h"

#include "Stopwatch.h"

namespace bolster::bench {

namespace {

constexpr double tolerance = 1e-4;

/// `move` makes an iteration and returns the largest move, relative to D.
template <class Move>
int iterationsUntilConverged(const Move& move)
{
    constexpr int most = 20'000;
    Convergence convergence(tolerance);
    int iterations = 1;
    while (!convergence.add(move()) && iterations < most)
        ++iterations;
    return iterations;
}

} // namespace

Lap convergenceOf(const std::shared_ptr<Rig>& rig)
{
    rig->startFlat();
    const int iterations = iterationsUntilConverged([&] { return rig->iterate(); });
    return [rig, iterations] {
        const Stopwatch watch;
        rig->startFlat();
        for (int i = 0; i < iterations; ++i)
            rig->iterate();
        return watch.elapsed();
    };
}

Lap convergenceOf(const HeldSurface& surface, CgalPeer::Energy energy)
{
    const auto peer = std::make_shared<CgalPeer>(surface, energy);
    Eigen::Matrix3Xd before = surface.rest;
    const int iterations = iterationsUntilConverged([&] {
        peer->iterate(1);
        const Eigen::Matrix3Xd now = peer->positions();
        const double move = (now - before).colwise().norm().maxCoeff() / surface.diameter;
        before = now;
        return move;
    });
    return [lap = repeated([peer] { peer->iterate(1); }), iterations] { return iterations * lap(); };
}

} // namespace bolster::bench
