// Anderson's mixing: a step made of the last few plain ones, so that slow directions need few iterations (D. G.
// Anderson 1965, type II; for local and global steps: Peng et al., "Anderson acceleration for geometry
// optimization", 2018).
#pragma once

#include "WorkerPool.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bolster {

class Mixing {
public:
    using Moves = Eigen::Ref<Eigen::Matrix4Xf>; ///< x y z 0, mm

    /// Begins anew.
    void forget();
    /// Puts the step in the place of `share` times these plain moves. Moves that grow much make it forget what was
    /// before. Bit for bit the same on any number of threads.
    void mix(double share, WorkerPool& pool, Moves moves);

    /// It leads nowhere: the plain moves have become large again, or not smaller for long.
    bool lost() const;
    /// How much of the way is left, in lengths of the step that was made last. The error is what the plain moves
    /// would become if they went on; of the directions that are remembered, the slowest says how much that is.
    /// Infinite as long as none is.
    double left() const;

private:
    static constexpr int depth = 5;
    /// Sums of products: of each remembered change of the plain moves with the newest one, and with the moves; the
    /// moves' square.
    using Products = Eigen::Array<double, 2 * depth + 1, 1>;

    void beginAnew();
    Products remember(float share, WorkerPool& pool, Moves moves);
    void makeRoom(Eigen::Index count);
    Eigen::VectorXf shares() const;

    bool m_begun = false;
    int m_known = 0;                                       // changes that are remembered
    int m_next = 0;                                        // where the next one goes
    double m_least = 0, m_best = 0;                        // squares of plain moves: since it began anew, and ever
    double m_better = 0;                                   // the same, when it last became much less
    int m_sinceBetter = 0;                                 // iterations
    double m_square = 0, m_stepSquare = 0;                 // of the plain moves, of the step made of them
    Eigen::Matrix4Xf m_before;                             // plain moves of the iteration before
    Eigen::Matrix4Xf m_step;                               // that was made of them
    std::array<Eigen::Matrix4Xf, depth> m_changes, m_ways; // of plain moves; of the places that they led to
    std::array<double, depth> m_gains{}; // of a step over the change of the plain moves that it made
    Eigen::Matrix<double, depth, depth> m_gram = Eigen::Matrix<double, depth, depth>::Zero();
    Eigen::Matrix<double, depth, 1> m_right = Eigen::Matrix<double, depth, 1>::Zero();
    std::vector<Products> m_sums; // per chunk
};

} // namespace bolster
