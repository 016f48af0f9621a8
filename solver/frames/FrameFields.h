// The force fields of frames and foam, each made once. They live in the frame's own axes (its file's, times the
// scale, mm), so that moving or turning a frame makes nothing new.
#pragma once

#include "Cushion.h"
#include "Foam.h"
#include "ForceField.h"
#include "FrameBodies.h"
#include "Kept.h"

#include <stop_token>

namespace bolster {

using TriangleMeshPtr = std::shared_ptr<const TriangleMesh>;

class FrameFields {
public:
    struct Shape {
        TriangleMeshPtr mesh;
        double scale = 1;
        friend bool operator==(const Shape&, const Shape&) = default;
    };
    struct SolidKey {
        Shape shape;
        std::vector<int> parts; ///< increasing
        double edge = 5;        ///< of the voxels, mm
        friend bool operator==(const SolidKey&, const SolidKey&) = default;
    };
    struct FoamKey {
        Foam::Shape shape = Foam::Shape::Box;
        Vec3 size = Vec3::Zero();
        TriangleMeshPtr mesh;
        Placement placement; ///< in the frame's axes
        double dilation = 0;
        bool cut = false;
        friend bool operator==(const FoamKey&, const FoamKey&) = default;
    };
    struct CushionKey {
        SolidKey frame;
        double dilation = 0;
        Cushion::Distance distance = Cushion::Distance::CityBlock;
        std::vector<FoamKey> foams;
        friend bool operator==(const CushionKey&, const CushionKey&) = default;
    };
    struct ContactKey {
        Shape shape;
        std::vector<int> parts; ///< increasing
        double gap = 0;         ///< mm
        friend bool operator==(const ContactKey&, const ContactKey&) = default;
    };

    /// The bodies of every part, or of none when stopped.
    std::shared_ptr<const FrameParts> parts(const Shape& shape, const std::stop_token& stop = {});
    /// Of those of the key that have a body which is thinner than a voxel: cushioning is likely to have gaps there.
    std::vector<int> thinParts(const SolidKey& key, WorkerPool& pool, const std::stop_token& stop);
    /// Null when stopped.
    std::shared_ptr<const ForceField> cushion(const CushionKey& key, WorkerPool& pool, const std::stop_token& stop);
    /// The way out of these parts, and `gap` further. Null when stopped.
    std::shared_ptr<const ForceField> contact(const ContactKey& key, WorkerPool& pool, const std::stop_token& stop);
    /// Likewise, of the voxels of the contact.
    std::vector<int> thinParts(const ContactKey& key, WorkerPool& pool, const std::stop_token& stop);
    /// Of its voxels, mm.
    double edgeOf(const ContactKey& key, const std::stop_token& stop = {});

    /// Of the grid that a cushion needs, without making it.
    double voxelCount(const CushionKey& key, const std::stop_token& stop);
    void endRound();

private:
    struct Solid {
        Voxels voxels;
        std::vector<int> thin; ///< parts
    };
    struct Contact {
        ForceField field;
        std::vector<int> thin; ///< parts
    };

    std::shared_ptr<const Solid> solid(const SolidKey& key, WorkerPool& pool, const std::stop_token& stop);
    std::shared_ptr<const Contact> contactField(const ContactKey& key, WorkerPool& pool,
                                                const std::stop_token& stop);
    std::vector<int> fill(const SolidKey& key, Voxels& voxels, WorkerPool& pool, const std::stop_token& stop);
    Box3 boxOf(const SolidKey& key, const std::stop_token& stop);

    Kept<Shape, FrameParts> m_parts;
    Kept<SolidKey, Solid> m_solids;
    Kept<CushionKey, ForceField> m_cushions;
    Kept<ContactKey, Contact> m_contacts;
};

/// Whether a body is so thin that voxels of this edge (mm) are likely to miss parts of it, when it is known whether
/// they found any. What is smaller than a few voxels in every direction is no part that anybody would miss.
bool isThin(const FrameBody& body, double edge, std::optional<bool> found);

} // namespace bolster
