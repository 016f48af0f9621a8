// Every colourway of a design from every view: the pictures of a folder, of which those that are missing are drawn.
#pragma once

#include "Design.h"
#include "JobFolder.h"
#include "RenderOrder.h"

namespace bolster::cli {

class PictureSeries {
public:
    struct Piece {
        ElementId colourway{}; ///< noElement: the design's own
        const NamedView* view = nullptr;
        QString path;
    };

    /// A design without colourways has one, as it is; so has a map, which covers all. `order` must outlive it.
    PictureSeries(const RenderOrder& order, const Design& design, const DesignFiles& files);

    /// Makes the folder, or says why not.
    Message open() const { return m_folder.open(); }
    static bool isThere(const Piece& piece);
    /// Those of the share that are not there yet.
    std::vector<Piece> missing(const JobShare& share) const;

private:
    JobFolder m_folder;
    std::vector<Piece> m_pieces;
};

} // namespace bolster::cli
