#include "FixationsLeft.h"

#include "Ask.h"
#include "Background.h"
#include "FrameEdges.h"
#include "Units.h"

#include <QLocale>
#include <QWidget>

#include <cmath>

namespace bolster {

namespace {

constexpr std::size_t mostNamed = 12;

struct FixationsLeft {
    Q_DECLARE_TR_FUNCTIONS(FixationsLeft)

public:
    static QString line(const Design& design, const FixationOff& off)
    {
        const FixationCurve* curve = design.find<FixationCurve>(off.curve);
        const QString name = curve ? QString::fromStdString(curve->name) : QString();
        const QString distance = steadyLengthText(off.distance, off.distance < 10 ? 1 : 0);
        if (off.fromEdge && off.distance < farthestLooked)
            return tr("\u201c%1\u201d: its edge is up to %2 away").arg(name, distance);
        return off.distance < farthestLooked ? tr("\u201c%1\u201d: up to %2").arg(name, distance)
                                             : tr("\u201c%1\u201d: more than %2").arg(name, distance);
    }

    static void tell(QWidget* window, const Design& design, const std::vector<FixationOff>& left)
    {
        QStringList lines;
        for (std::size_t i = 0; i < std::min(left.size(), mostNamed); ++i)
            lines << line(design, left[i]);
        if (left.size() > mostNamed)
            lines << tr("and %n more", nullptr, static_cast<int>(left.size() - mostNamed));
        lines << QString() << tr("They stay where they are. Drag their points onto the frame, or undo the change.");
        bolster::tell(
            window, QMessageBox::Information,
            tr("%n fixation curve(s) no longer lie on the frame.", nullptr, static_cast<int>(left.size())),
            lines.join(u'\n'));
    }
};

PlacedMesh withEdges(PlacedMesh placed)
{
    if (placed.mesh)
        for (FrameEdge& edge : bentEdges(*placed.mesh))
            placed.edges.push_back(std::move(edge.points));
    return placed;
}

} // namespace

void tellFixationsOff(QWidget* window, const Design& design, const PlacedMesh& before, const PlacedMesh& after)
{
    inBackground<std::vector<FixationOff>>([design, before, after] {
        return fixationsOff(design, withEdges(before), withEdges(after));
    }).then(window, [window, design](const std::vector<FixationOff>& left) {
        if (!left.empty())
            FixationsLeft::tell(window, design, left);
    });
}

} // namespace bolster
