// The actions of the clipboard and of the editing operations on patches.
#include "Actions.h"

#include "LayoutEdits.h"

namespace bolster {

void Actions::addPatternEdits()
{
    cut = add(tr("Cu&t"), {}, QKeySequence::Cut);
    copy = add(tr("&Copy"), {}, QKeySequence::Copy);
    paste = add(tr("&Paste"), {}, QKeySequence::Paste);
    duplicate = add(tr("Dupl&icate"), {}, QKeySequence(Qt::CTRL | Qt::Key_D));

    mirrorHorizontally = add(tr("Mirror hori&zontally"), {}, QKeySequence(Qt::CTRL | Qt::Key_M));
    mirrorVertically = add(tr("Mirror &vertically"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M));
    using edits::Alignment;
    for (const auto& [alignment, name] :
         {std::pair(Alignment::Left, tr("&Left edges")), std::pair(Alignment::CentreX, tr("Centres in a &column")),
          std::pair(Alignment::Right, tr("&Right edges")), std::pair(Alignment::Top, tr("&Top edges")),
          std::pair(Alignment::CentreY, tr("Centres in a ro&w")),
          std::pair(Alignment::Bottom, tr("&Bottom edges"))}) {
        align.append(add(name, {}));
        align.back()->setData(static_cast<int>(alignment));
    }
    using edits::Direction;
    for (const auto& [direction, name] : {std::pair(Direction::Horizontal, tr("&Horizontally")),
                                          std::pair(Direction::Vertical, tr("&Vertically"))}) {
        distribute.append(add(name, {}));
        distribute.back()->setData(static_cast<int>(direction));
    }
    arrange = add(tr("Arrange &automatically"), {}, QKeySequence(Qt::CTRL | Qt::Key_R));
    makeCorner = add(tr("Make &corner"), {}, QKeySequence(Qt::CTRL | Qt::Key_K));
    makeSmooth = add(tr("Make s&mooth"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K));
    straighten = add(tr("Strai&ghten"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G));
    edgeLength = add(tr("Edge &length \u2026"), {}, QKeySequence(Qt::Key_L));
    edgeLength->setToolTip(tr("Type the length of the selected edge (%1)")
                               .arg(edgeLength->shortcut().toString(QKeySequence::NativeText)));
    equalLengths = add(tr("Make e&qually long"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E));
    equalLengths->setToolTip(
        tr("Makes the selected edges as long as the first one, or the second side of a seam as long as its first "
           "(%1)")
            .arg(equalLengths->shortcut().toString(QKeySequence::NativeText)));
    mergePatches = add(tr("Merge a&long seam"), {}, QKeySequence(Qt::CTRL | Qt::Key_J));
}

} // namespace bolster
