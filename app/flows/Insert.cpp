#include "Insert.h"

#include "CushionVoxels.h"
#include "ElementEdits.h"
#include "FramePieces.h"
#include "TriangleTree.h"
#include "Units.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// The selected element of a kind, if there is one.
template <class T>
std::optional<ElementId> selectedOne(const Design& design, const Selection::Elements& selected)
{
    for (const ElementId id : selected)
        if (design.find<T>(id))
            return id;
    return {};
}

std::optional<ElementId> frameFor(const Design& design, const Selection::Elements& selected)
{
    if (const auto chosen = selectedOne<Frame>(design, selected))
        return chosen;
    std::set<ElementId> padded;
    design.each<Cushion>([&](ElementId, const Cushion& cushion) { padded.insert(cushion.frame); });
    std::optional<ElementId> first, bare;
    design.each<Frame>([&](ElementId id, const Frame&) {
        first = first.value_or(id);
        if (!bare && !padded.contains(id))
            bare = id;
    });
    return bare ? bare : first;
}

std::optional<ElementId> cushionFor(const Design& design, const Selection::Elements& selected)
{
    if (const auto chosen = selectedOne<Cushion>(design, selected))
        return chosen;
    if (const auto foam = selectedOne<Foam>(design, selected))
        return design.find<Foam>(*foam)->cushion;
    const auto frame = selectedOne<Frame>(design, selected);
    std::optional<ElementId> first, around;
    design.each<Cushion>([&](ElementId id, const Cushion& cushion) {
        first = first.value_or(id);
        if (!around && frame && cushion.frame == *frame)
            around = id;
    });
    return around ? around : first;
}

/// What the frame shows of its file; null while that is not there.
FrameMeshPtr meshOf(const Design& design, ElementId id, const DesignFiles& files)
{
    const auto file = files.meshes.find(id);
    const Frame* frame = design.find<Frame>(id);
    return file == files.meshes.end() || !frame ? nullptr : shownMesh(file->second, frame->hiddenParts);
}

/// The highest point near the middle, seen from above.
Vec3 top(const std::vector<Vec3>& points)
{
    Box3 box;
    for (const Vec3& p : points)
        box.extend(p);
    if (box.isEmpty())
        return Vec3::Zero();
    const double near = 0.1 * box.sizes().head<2>().maxCoeff();
    Vec3 best = box.center();
    best.z() = box.min().z();
    for (const Vec3& p : points)
        if ((p - box.center()).head<2>().norm() < near)
            best.z() = std::max(best.z(), p.z());
    return best;
}

} // namespace

double guessPadding(const Design& design, const Frame& frame, const TriangleMesh& mesh)
{
    constexpr double usual = 30, least = 3, most = 150; // mm
    std::vector<TriangleTree::Triangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.push_back(
            {frame.placed(mesh.points[a]), frame.placed(mesh.points[b]), frame.placed(mesh.points[c])});
    const TriangleTree tree(triangles);
    std::vector<double> distances;
    design.each<FixationCurve>([&](ElementId, const FixationCurve& fixation) {
        const BSpline3& curve = fixation.curve;
        constexpr int samples = 8;
        for (int i = 0; i < samples && !curve.empty(); ++i) {
            const double t = curve.domainStart() + (curve.domainEnd() - curve.domainStart()) * (i + 0.5) / samples;
            distances.push_back(tree.distance(curve.at(t), most + 1));
        }
    });
    if (distances.empty())
        return usual;
    std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
    const double median = std::round(distances[distances.size() / 2]);
    return median < least || median > most ? usual : median;
}

Edit insertCushion(const Design& design, const Selection::Elements& selected, const DesignFiles& files)
{
    const std::optional<ElementId> id = frameFor(design, selected);
    if (!id)
        return {};
    Cushion cushion;
    cushion.name = QCoreApplication::translate("Insert", "Padding").toStdString();
    cushion.frame = *id;
    if (const FrameMeshPtr mesh = meshOf(design, *id, files)) {
        const Frame& frame = *design.find<Frame>(*id);
        cushion.dilation = guessPadding(design, frame, *mesh);
        cushion.voxel = fittingVoxel(cushion, frame, *mesh);
    }
    return edits::addElement(design, makeElement(std::move(cushion)));
}

QString voxelNote(const Edit& inserted)
{
    const auto* cushion = inserted.empty() ? nullptr : std::get_if<Cushion>(inserted.changes.front().after.get());
    const double usual = Cushion().voxel;
    if (!cushion || cushion->voxel == usual)
        return {};
    return QCoreApplication::translate("Insert", "This frame is large: its smallest detail is set to %1; the usual "
                                                 "%2 would need too much memory.")
        .arg(lengthText(cushion->voxel, 3), lengthText(usual, 3));
}

Edit insertFoam(const Design& design, const Selection::Elements& selected, Foam::Shape shape,
                const SurfaceMeshPtr& surface, const DesignFiles& files)
{
    const std::optional<ElementId> id = cushionFor(design, selected);
    const Cushion* cushion = id ? design.find<Cushion>(*id) : nullptr;
    if (!cushion)
        return {};
    Foam foam;
    foam.name = QCoreApplication::translate("Insert", "Foam").toStdString();
    foam.cushion = *id;
    foam.shape = shape;
    if (surface) {
        foam.position = top(surface->positions);
    } else if (const FrameMeshPtr mesh = meshOf(design, cushion->frame, files)) {
        std::vector<Vec3> points = mesh->points;
        if (const Frame* frame = design.find<Frame>(cushion->frame))
            for (Vec3& p : points)
                p = frame->placed(p);
        foam.position = top(points);
    }
    return edits::addElement(design, makeElement(std::move(foam)));
}

} // namespace bolster
