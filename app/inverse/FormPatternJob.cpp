#include "FormPatternJob.h"

#include "MeshImport.h"
#include "SolveFailure.h"

namespace bolster {

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
            mesh = read.mesh;
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
