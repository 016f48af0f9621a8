#include "FormPatternJob.h"

#include "FileGuess.h"
#include "MeshImport.h"
#include "SolveFailure.h"

#include <QFileInfo>

namespace bolster {

namespace {

/// In mm and upright, as the import of frames proposes it.
std::shared_ptr<const TriangleMesh> asFurniture(const ImportedMesh& read, const QString& file)
{
    const QString ending = QFileInfo(file).suffix();
    const Box3 box = read.mesh->boundingBox();
    const FileUnit unit = proposedUnit(read.said, ending, box, largestFurniture);
    Placement placement;
    placement.scale =
        unit == FileUnit::Custom ? read.said.millimetresPerUnit.value_or(guessFactor(box)) : millimetresPer(unit);
    placement.rotation = rotationFor(read.said.up.value_or(guessUpAxis(ending)));
    auto placed = std::make_shared<TriangleMesh>(*read.mesh);
    for (Vec3& point : placed->points)
        point = placement.placed(point);
    return placed;
}

} // namespace

FormMade patternOfForm(const FormWanted& wanted, FormDraft& draft, const std::stop_token& stop)
{
    FormMade made;
    made.number = wanted.number;
    made.draft = wanted.draft;
    try {
        std::shared_ptr<const TriangleMesh> mesh = wanted.mesh;
        if (!mesh) {
            const ImportedMesh read = importMesh(wanted.file, {stop, {}, {}});
            made.problem = read.problem;
            mesh = read.mesh ? asFurniture(read, wanted.file) : nullptr;
            if (mesh)
                made.size = mesh->boundingBox().sizes();
        }
        if (!mesh)
            return made;
        made.form = cutForm(*mesh, wanted.cuts, stop, wanted.draft ? &draft : nullptr);
        made.problem = made.form.problem;
        if (!made.problem.empty() || stop.stop_requested())
            return made;
        FlattenOrder order = wanted.draft ? draftFlattening : FlattenOrder{};
        order.poisson = wanted.order.fabric.poisson;
        made.flat = flatten(made.form, order, stop);
        if (!stop.stop_requested())
            made.pattern = formPattern(made.form, made.flat, wanted.order);
    } catch (const std::exception& error) {
        made.problem = failureMessage(error);
    }
    return made;
}

} // namespace bolster
