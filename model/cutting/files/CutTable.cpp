#include "CutTable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double gap = 20;        // mm
constexpr double tableBorder = 5; // mm: a cut line on the tableBorder of a sheet could not be seen

} // namespace

double uprightAngle(const CutPiece& piece)
{
    const Vec2 grain = piece.grain.to - piece.grain.from;
    return grain.norm() > 0 ? std::numbers::pi / 2 - std::atan2(grain.y(), grain.x()) : 0;
}

Box2 turnedBox(const CutPiece& piece, double angle)
{
    const Eigen::Rotation2Dd turn(angle);
    Box2 box;
    for (const std::vector<LinePoint>* line : {&piece.cut, &piece.sew})
        for (const LinePoint& point : *line)
            box.extend(turn * point.at);
    return box;
}

CutTable arranged(const CutPattern& pattern, double width)
{
    struct Waiting {
        std::size_t piece;
        double angle;
        Box2 box;
    };
    std::vector<Waiting> waiting;
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const CutPiece& piece = pattern.pieces[i];
        const double angle = uprightAngle(piece);
        if (const Box2 box = turnedBox(piece, angle); !box.isEmpty())
            waiting.push_back({i, angle, box});
    }
    std::ranges::stable_sort(waiting, std::ranges::greater(), [](const Waiting& w) { return w.box.sizes().y(); });
    CutTable table;
    double x = tableBorder, y = tableBorder, height = 0;
    bool backwards = false; // a pen comes back in the next row
    std::size_t rowStart = 0;
    const auto endRow = [&] {
        if (backwards)
            std::reverse(table.pieces.begin() + static_cast<std::ptrdiff_t>(rowStart), table.pieces.end());
        backwards = !backwards;
        rowStart = table.pieces.size();
        y += height + gap;
        x = tableBorder;
        height = 0;
    };
    for (const Waiting& next : waiting) {
        const Vec2 size = next.box.sizes();
        if (x > tableBorder && x + size.x() + tableBorder > width)
            endRow();
        table.pieces.push_back({next.piece, next.angle, Vec2(x, y) - next.box.min()});
        x += size.x();
        height = std::max(height, size.y());
        table.size = table.size.cwiseMax(Vec2(x + tableBorder, y + height + tableBorder));
        x += gap;
    }
    endRow();
    return table;
}

} // namespace bolster
