#include "FrameEdits.h"

#include "EditHelpers.h"
#include "ElementEdits.h"

namespace bolster::edits {

Edit showFramePieces(const Design& design, ElementId frame, const FrameMeshPtr& mesh,
                     const std::vector<int>& pieces, bool shown)
{
    const Frame* found = design.find<Frame>(frame);
    if (!found || !mesh)
        return {};
    const std::shared_ptr<const FramePieces> all = piecesOf(mesh);
    std::vector<bool> hidden = all->hiddenBy(*mesh, found->hiddenParts);
    for (const int piece : pieces)
        hidden[static_cast<std::size_t>(piece)] = !shown;
    Frame changed = *found;
    changed.hiddenParts = all->namesFor(*mesh, hidden, found->hiddenParts);
    return replaceElement(design, frame, makeElement(std::move(changed)),
                          {shown ? QT_TRANSLATE_NOOP("Message", "Show a part of %1")
                                 : QT_TRANSLATE_NOOP("Message", "Hide a part of %1"),
                           {found->name}});
}

} // namespace bolster::edits
