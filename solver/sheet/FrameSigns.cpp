#include "FrameSigns.h"

#include <atomic>
#include <utility>

namespace bolster {

namespace {

bool agree(const SewnMesh& mesh, WorkerPool& pool, const Eigen::Matrix4Xd& frames)
{
    std::atomic<bool> all = true;
    pool.forChunks(mesh.vertexCount(), [&](int, int begin, int end) {
        for (int v = begin; v < end; ++v)
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k)
                if (mesh.ring[k].vertex > v && frames.col(v).dot(frames.col(mesh.ring[k].vertex)) < 0)
                    all.store(false, std::memory_order_relaxed);
    });
    return all;
}

} // namespace

std::vector<int> alignSigns(const SewnMesh& mesh, WorkerPool& pool, Eigen::Matrix4Xd& frames)
{
    std::vector<int> flipped;
    if (agree(mesh, pool, frames))
        return flipped;
    // From the last vertex of each patch: it lies inside, where rings are whole.
    std::vector<char> reached(mesh.vertexCount(), 0);
    std::vector<int> front;
    for (const SewnMesh::Part& part : mesh.parts) {
        front.assign(1, part.firstVertex + part.vertexCount - 1);
        reached[front.front()] = 1;
        for (std::size_t i = 0; i < front.size(); ++i) {
            const int v = front[i];
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
                const int neighbour = mesh.ring[k].vertex;
                if (std::exchange(reached[neighbour], 1))
                    continue;
                if (frames.col(v).dot(frames.col(neighbour)) < 0) {
                    frames.col(neighbour) *= -1;
                    flipped.push_back(neighbour);
                }
                front.push_back(neighbour);
            }
        }
    }
    return flipped;
}

} // namespace bolster
