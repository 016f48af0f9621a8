#include "FirstCover.h"

namespace bolster {

namespace {

const QString size = QStringLiteral("450 x 450"); // of both sides, mm

void drawSides(Designer& designer, const Stop& stop)
{
    designer.pressButton(QStringLiteral("Rectangle"));
    designer.click({-220, 40});
    designer.type(size);
    stop(QStringLiteral("rectangle"));
    designer.key(Qt::Key_Return);
    stop(QStringLiteral("next"));
    designer.followLink(QStringLiteral("next-step"));
    designer.click({-220, -480});
    designer.enter(size);
}

/// As if the lower one were folded under the upper one.
void sewEdges(Designer& designer, const Stop& stop)
{
    designer.followLink(QStringLiteral("next-step"));
    designer.click({0, 40});
    designer.point({0, -30});
    stop(QStringLiteral("sew"));
    designer.click({0, -30});
    designer.sew({-220, 250}, {-220, -250});
    designer.sew({230, 250}, {230, -250});
    designer.sew({0, 490}, {0, -480});
    designer.key(Qt::Key_Escape);
    stop(QStringLiteral("sewn"));
}

} // namespace

void sewFirstCover(Designer& designer, const Stop& stop)
{
    stop(QStringLiteral("start"));
    drawSides(designer, stop);
    sewEdges(designer, stop);
    designer.followLink(QStringLiteral("next-step"));
    designer.setField(QStringLiteral("Pressure"), QStringLiteral("1"));
    stop(QStringLiteral("cushion"));
}

} // namespace bolster
