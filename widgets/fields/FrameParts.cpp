#include "FrameParts.h"

#include "CushionVoxels.h"
#include "FrameEdits.h"
#include "FramePieces.h"
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
    std::vector<int> pieces; ///< that the line stands for
    bool below = false;
};

const FramePiece& pieceOf(const FramePieces& pieces, int piece)
{
    return pieces.pieces[static_cast<std::size_t>(piece)];
}

QString partTitle(const std::string& name)
{
    return name.empty() ? FrameParts::tr("Mesh") : QString::fromStdString(name);
}

/// Width, depth and height of these pieces in the room.
QString placedSize(const Frame& frame, const FramePieces& pieces, const std::vector<int>& chosen)
{
    Box3 placed;
    for (const int piece : chosen)
        for (int corner = 0; corner < 8; ++corner)
            placed.extend(frame.placed(pieceOf(pieces, piece).box.corner(static_cast<Box3::CornerType>(corner))));
    const Vec3 sizes = placed.sizes();
    return sizesText({sizes.x(), sizes.y(), sizes.z()});
}

std::vector<PartLine> linesOf(const FramePieces& pieces)
{
    std::vector<PartLine> lines;
    const auto count = static_cast<int>(pieces.pieces.size());
    for (int i = 0, end = 0; i < count; i = end) {
        PartLine whole;
        for (; end < count && pieceOf(pieces, end).part == pieceOf(pieces, i).part; ++end)
            whole.pieces.push_back(end);
        lines.push_back(whole);
        if (whole.pieces.size() > 1)
            for (const int piece : whole.pieces)
                lines.push_back({{piece}, true});
    }
    return lines;
}

/// A part that a cushion may take, by its name.
struct CushionPart {
    std::string name;
    std::vector<int> pieces; ///< that the frame shows of it; none: it has no such part
};

/// What the solver sees of the frame. Parts of the same name are one to it.
std::vector<CushionPart> shownParts(const Frame& frame, const TriangleMesh& mesh, const FramePieces& pieces)
{
    std::vector<CushionPart> parts;
    const std::vector<bool> gone = pieces.hiddenBy(mesh, frame.hiddenParts);
    for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
        const std::string& name = mesh.parts[pieces.pieces[i].part].name;
        if (gone[i])
            continue;
        if (const auto same = std::ranges::find(parts, name, &CushionPart::name); same != parts.end())
            same->pieces.push_back(static_cast<int>(i));
        else
            parts.push_back({name, {static_cast<int>(i)}});
    }
    return parts;
}

/// Those, and names that cushions have and the frame has not, so that they can be given up; none when there is
/// nothing to choose from.
std::vector<CushionPart> partsToTake(const Design& design, const std::vector<ElementId>& cushions,
                                     const Frame& frame, const TriangleMesh& mesh, const FramePieces& pieces)
{
    std::vector<CushionPart> parts = shownParts(frame, mesh, pieces);
    bool chosen = parts.size() > 1;
    for (const ElementId id : cushions)
        for (const std::string& name : design.find<Cushion>(id)->parts) {
            chosen = true;
            if (std::ranges::find(parts, name, &CushionPart::name) == parts.end())
                parts.push_back({name, {}});
        }
    return chosen ? parts : std::vector<CushionPart>();
}

bool takes(const Cushion& cushion, const std::string& part)
{
    return std::ranges::find(cushion.parts, part) != cushion.parts.end();
}

} // namespace

void FrameParts::addShown(PropertyForm& form, ElementId id) const
{
    const FrameMeshPtr mesh = fileOf(m_sources.files, id);
    const Frame* frame = m_document.design().find<Frame>(id);
    if (!mesh || !frame)
        return;
    const std::shared_ptr<const FramePieces> pieces = piecesOf(mesh);
    if (pieces->pieces.size() < 2)
        return; // to hide it all is what hiding the frame is for
    const std::vector<PartLine> lines = linesOf(*pieces);
    std::vector<PropertyForm::Check> checks;
    int below = 0;
    for (const PartLine& line : lines) {
        below = line.below ? below : 0;
        const QString part = partTitle(mesh->parts[pieceOf(*pieces, line.pieces.front()).part].name);
        const auto size = [this, id, pieces, of = line.pieces] {
            const Frame* now = m_document.design().find<Frame>(id); // not a copy for each of many pieces
            return now ? placedSize(*now, *pieces, of) : QString();
        };
        if (line.below)
            checks.push_back(
                {[size, number = ++below] { return tr("Piece %1: %2").arg(number).arg(size()); }, true});
        else if (line.pieces.size() > 1)
            checks.push_back({[part, count = static_cast<int>(line.pieces.size())] {
                return tr("%1: %n piece(s)", nullptr, count).arg(part);
            }});
        else
            checks.push_back({[part, size] { return tr("%1: %2").arg(part, size()); }});
    }
    const InspectorSubject<Frame> subject(m_document, {id}, form);
    const auto hidden = [subject, mesh, pieces] { return pieces->hiddenBy(*mesh, subject.now().hiddenParts); };
    const auto read = [hidden, lines] {
        const std::vector<bool> gone = hidden();
        std::vector<Qt::CheckState> states;
        for (const PartLine& line : lines) {
            const auto shown = std::ranges::count_if(
                line.pieces, [&](int piece) { return !gone[static_cast<std::size_t>(piece)]; });
            states.push_back(shown == 0                         ? Qt::Unchecked
                             : shown == std::ssize(line.pieces) ? Qt::Checked
                                                                : Qt::PartiallyChecked);
        }
        return states;
    };
    const auto write = [this, id, mesh, lines](int at, bool shown) {
        m_document.commit(edits::showFramePieces(m_document.design(), id, mesh,
                                                 lines[static_cast<std::size_t>(at)].pieces, shown));
    };
    const auto pointed = [this, id, lines](int at) {
        m_wishes.pointAtPieces(id, at < 0 ? std::vector<int>() : lines[static_cast<std::size_t>(at)].pieces);
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

void FrameParts::addPadded(PropertyForm& form, const std::vector<ElementId>& ids) const
{
    const InspectorSubject<Cushion> cushion(m_document, ids, form);
    const Design& design = m_document.design();
    const std::optional<ElementId> id = cushion.shared([](const Cushion& c) { return c.frame; });
    const Frame* frame = id ? design.find<Frame>(*id) : nullptr;
    const FrameMeshPtr mesh = frame ? fileOf(m_sources.files, *id) : nullptr;
    if (!mesh)
        return;
    const std::shared_ptr<const FramePieces> pieces = piecesOf(mesh);
    const std::vector<CushionPart> parts = partsToTake(design, ids, *frame, *mesh, *pieces);
    if (parts.empty())
        return;
    std::vector<PropertyForm::Check> checks;
    for (const CushionPart& part : parts)
        checks.push_back({[this, part, pieces, frameId = *id] {
            const Frame* now = part.pieces.empty() ? nullptr : m_document.design().find<Frame>(frameId);
            return now ? tr("%1: %2").arg(partTitle(part.name), placedSize(*now, *pieces, part.pieces))
                       : tr("%1: not in this frame").arg(partTitle(part.name));
        }});
    const auto read = [cushion, parts] {
        std::vector<Qt::CheckState> states;
        for (const CushionPart& part : parts) {
            const std::optional<bool> taken = cushion.shared([&](const Cushion& c) { return takes(c, part.name); });
            states.push_back(!taken ? Qt::PartiallyChecked : *taken ? Qt::Checked : Qt::Unchecked);
        }
        return states;
    };
    const auto write = [cushion, parts](int at, bool taken) {
        const std::string& name = parts[static_cast<std::size_t>(at)].name;
        cushion.change(QT_TRANSLATE_NOOP("Message", "Change the parts of %1"), [&](Cushion& c) {
            std::erase(c.parts, name);
            if (taken)
                c.parts.push_back(name);
        });
    };
    form.addChecks(tr("Padded parts"), checks, read, write, [this, frame = *id, parts](int at) {
        m_wishes.pointAtPieces(frame, at < 0 ? std::vector<int>() : parts[static_cast<std::size_t>(at)].pieces);
    });
    form.addNote([cushion] {
        return cushion.shared([](const Cushion& c) { return c.parts.empty(); }) == true
                   ? tr("Without a mark, those parts are padded that the cover is fixed to.")
                   : QString();
    });
}

void FrameParts::addVoxelNote(PropertyForm& form, ElementId id) const
{
    const auto finest = [this, id] {
        const Cushion* cushion = m_document.design().find<Cushion>(id);
        const Frame* frame = cushion ? m_document.design().find<Frame>(cushion->frame) : nullptr;
        const FrameMeshPtr mesh =
            frame ? shownMesh(fileOf(m_sources.files, cushion->frame), frame->hiddenParts) : nullptr;
        return mesh ? fittingVoxel(*cushion, *frame, *mesh) : 0.0;
    };
    form.addNote(
        [finest] {
            const double least = finest();
            return least > Cushion().voxel
                       ? tr("This frame is large: the smallest detail can be %1 here.").arg(lengthText(least))
                       : QString();
        },
        [this, id, finest] {
            const Cushion* cushion = m_document.design().find<Cushion>(id);
            return cushion && cushion->voxel < finest() ? PropertyForm::Tone::Warning : PropertyForm::Tone::Muted;
        });
}

} // namespace bolster
