// What the inspector says of a frame's mesh: its parts, and how fine voxels can be.
#include "CushionVoxels.h"
#include "FramePieces.h"
#include "InspectorForms.h"
#include "InspectorSubject.h"
#include "Units.h"

#include <algorithm>

namespace bolster {

namespace {

FrameMeshPtr fileOf(const DesignFiles& files, ElementId frame)
{
    const auto found = files.meshes.find(frame);
    return found == files.meshes.end() ? nullptr : found->second;
}

/// The lines of the list: a part alone, or a part and the pieces of it.
struct PartLine {
    std::vector<std::size_t> pieces; ///< that the line stands for
    bool below = false;
};

std::vector<PartLine> linesOf(const FramePieces& pieces)
{
    std::vector<PartLine> lines;
    for (std::size_t i = 0, end = 0; i < pieces.pieces.size(); i = end) {
        PartLine whole;
        for (; end < pieces.pieces.size() && pieces.pieces[end].part == pieces.pieces[i].part; ++end)
            whole.pieces.push_back(end);
        lines.push_back(whole);
        if (whole.pieces.size() > 1)
            for (const std::size_t piece : whole.pieces)
                lines.push_back({{piece}, true});
    }
    return lines;
}

} // namespace

void InspectorForms::addFrameParts(PropertyForm& form, ElementId id) const
{
    const FrameMeshPtr mesh = fileOf(m_files, id);
    const Frame* frame = m_document.design().find<Frame>(id);
    if (!mesh || !frame)
        return;
    const std::shared_ptr<const FramePieces> pieces = piecesOf(mesh);
    if (pieces->pieces.size() < 2)
        return; // to hide it all is what hiding the frame is for
    const std::vector<PartLine> lines = linesOf(*pieces);
    const auto size = [&](const FramePiece& piece) {
        Box3 placed; // width, depth and height are those of the room
        for (int corner = 0; corner < 8; ++corner)
            placed.extend(frame->placed(piece.box.corner(static_cast<Box3::CornerType>(corner))));
        const Vec3 sizes = placed.sizes();
        return tr("%1 \u00d7 %2 \u00d7 %3 mm")
            .arg(decimalText(sizes.x(), 0, false), decimalText(sizes.y(), 0, false),
                 decimalText(sizes.z(), 0, false));
    };
    std::vector<PropertyForm::Check> checks;
    int below = 0;
    for (const PartLine& line : lines) {
        below = line.below ? below : 0;
        const FramePiece& first = pieces->pieces[line.pieces.front()];
        const std::string& name = mesh->parts[first.part].name;
        const QString part = name.empty() ? tr("Mesh") : QString::fromStdString(name);
        if (line.below)
            checks.push_back({tr("Piece %1: %2").arg(++below).arg(size(first)), true});
        else if (line.pieces.size() > 1)
            checks.push_back({tr("%1: %n piece(s)", nullptr, static_cast<int>(line.pieces.size())).arg(part)});
        else
            checks.push_back({tr("%1: %2").arg(part, size(first))});
    }
    const InspectorSubject<Frame> subject(m_document, {id}, form);
    const auto hidden = [subject, mesh, pieces] { return pieces->hiddenBy(*mesh, subject.now().hiddenParts); };
    const auto read = [hidden, lines] {
        const std::vector<bool> gone = hidden();
        std::vector<Qt::CheckState> states;
        for (const PartLine& line : lines) {
            const auto shown = std::ranges::count_if(line.pieces, [&](std::size_t piece) { return !gone[piece]; });
            states.push_back(shown == 0                         ? Qt::Unchecked
                             : shown == std::ssize(line.pieces) ? Qt::Checked
                                                                : Qt::PartiallyChecked);
        }
        return states;
    };
    const auto write = [subject, hidden, mesh, pieces, lines](int at, bool shown) {
        std::vector<bool> gone = hidden();
        for (const std::size_t piece : lines[static_cast<std::size_t>(at)].pieces)
            gone[piece] = !shown;
        subject.change(shown ? QT_TRANSLATE_NOOP("Message", "Show a part of %1")
                             : QT_TRANSLATE_NOOP("Message", "Hide a part of %1"),
                       [&](Frame& f) { f.hiddenParts = pieces->namesFor(*mesh, gone, f.hiddenParts); });
    };
    const auto pointed = [this, id, lines](int at) {
        const bool one = at >= 0 && lines[static_cast<std::size_t>(at)].pieces.size() == 1;
        m_pointAtPiece(id, one ? static_cast<int>(lines[static_cast<std::size_t>(at)].pieces.front()) : -1);
    };
    form.addChecks(tr("Parts"), checks, read, write, pointed);
    form.addButton(tr("Show a&ll parts"), [subject] {
        if (!subject.now().hiddenParts.empty())
            subject.change(QT_TRANSLATE_NOOP("Message", "Show all parts of %1"),
                           [](Frame& f) { f.hiddenParts.clear(); });
    });
    form.addNote([] {
        return tr("Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor "
                  "cushioning nor contact knows them.");
    });
}

void InspectorForms::addVoxelNote(PropertyForm& form, ElementId id) const
{
    const auto finest = [this, id] {
        const Cushion* cushion = m_document.design().find<Cushion>(id);
        const Frame* frame = cushion ? m_document.design().find<Frame>(cushion->frame) : nullptr;
        const FrameMeshPtr mesh = frame ? shownMesh(fileOf(m_files, cushion->frame), frame->hiddenParts) : nullptr;
        return mesh ? fittingVoxel(*cushion, *frame, *mesh) : 0.0;
    };
    form.addNote(
        [finest] {
            const double least = finest();
            return least > Cushion().voxel ? tr("This frame is large: of voxels below %1 there would be too many.")
                                                 .arg(lengthText(least))
                                           : QString();
        },
        [this, id, finest] {
            const Cushion* cushion = m_document.design().find<Cushion>(id);
            return cushion && cushion->voxel < finest() ? PropertyForm::Tone::Warning : PropertyForm::Tone::Muted;
        });
}

} // namespace bolster
