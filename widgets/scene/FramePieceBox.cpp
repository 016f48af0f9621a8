#include "FramePieceBox.h"

#include "Design.h"
#include "FramePieces.h"

namespace bolster {

void FramePieceBox::addTo(ViewScene& scene, const Design& design, const DesignFiles& files) const
{
    const auto* placed = design.find<Frame>(frame);
    const auto file = files.meshes.find(frame);
    if (!placed || file == files.meshes.end() || !file->second)
        return;
    const std::vector<FramePiece>& all = piecesOf(file->second)->pieces;
    Box3 box;
    for (const int piece : pieces)
        if (piece >= 0 && piece < std::ssize(all))
            box.extend(all[static_cast<std::size_t>(piece)].box);
    if (box.isEmpty())
        return;
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
            const int other = corner | 1 << axis;
            if (other == corner)
                continue;
            const auto at = [&](int k) {
                const auto place = static_cast<Box3::CornerType>(k);
                return Eigen::Vector3f(placed->placed(box.corner(place)).cast<float>());
            };
            scene.lines.push_back({{at(corner), at(other)}, scene.colors.accent, 2, 0.9F, 0.8F});
        }
}

} // namespace bolster
