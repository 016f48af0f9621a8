#include "FormPatternJob.h"

#include "FileGuess.h"
#include "FormTree.h"
#include "MeshImport.h"
#include "RestingSolve.h"
#include "SolveFailure.h"
#include "ThinForm.h"

#include <QFileInfo>

#include <algorithm>

namespace bolster {

namespace {

/// Whether that is a form of what stands there: about as large, and in its place.
bool liesThere(const Box3& box, const Box3& there)
{
    constexpr double alike = 3; // times as large or small
    if (box.isEmpty() || there.isEmpty())
        return false;
    const Vec3 half = there.sizes() / 2;
    const double ratio = box.sizes().maxCoeff() / there.sizes().maxCoeff();
    return Box3(there.min() - half, there.max() + half).contains(box.center()) && ratio < alike &&
           1 / ratio < alike;
}

/// Upright and in mm, as the import of frames proposes it; as it lies, if it lies in the design.
Placement proposedPlacement(const FileFacts& said, const Box3& box, const QString& file, const Box3& there)
{
    const QString ending = QFileInfo(file).suffix();
    if (!said.up && !said.millimetresPerUnit && liesThere(box, there))
        return {};
    const FileUnit unit = proposedUnit(said, ending, box, largestFurniture);
    Placement placement;
    placement.scale =
        unit == FileUnit::Custom ? said.millimetresPerUnit.value_or(guessFactor(box)) : millimetresPer(unit);
    placement.rotation = rotationFor(said.up.value_or(guessUpAxis(ending)));
    return placement;
}

} // namespace

FormPatternJob::FileState FormPatternJob::stateOf(const QString& path)
{
    return {path, QFileInfo(path).lastModified()};
}

Message FormPatternJob::read(const QString& path, const Box3& there, const std::stop_token& stop)
{
    const FileState state = stateOf(path);
    if (m_form.mesh && m_form.state == state &&
        m_form.placement == proposedPlacement(m_form.said, m_form.box, path, there))
        return {};
    m_form = {};
    ImportedMesh read = importMesh(path, {stop, {}, {}}, true);
    if (!read.mesh)
        return read.problem;
    m_edges = {state, std::move(read.edges)};
    const Box3 box = read.mesh->boundingBox();
    const Placement placement = proposedPlacement(read.said, box, path, there);
    auto placed = std::make_shared<TriangleMesh>(*read.mesh);
    for (Vec3& point : placed->points)
        point = placement.placed(point);
    m_form = {state, std::move(placed), placement, std::move(read.warning), read.said, box};
    return {};
}

/// Of a frame's file, whose mesh the design has already.
Message FormPatternJob::readEdges(const QString& path, const std::stop_token& stop)
{
    const FileState state = stateOf(path);
    if (m_edges.state == state)
        return {};
    m_edges = {};
    ImportedEdges read = importFrameEdges(path, {stop, {}, {}});
    if (read.problem.empty() && !stop.stop_requested())
        m_edges = {state, std::move(read.edges)};
    return read.problem;
}

void FormPatternJob::addEdges(FormCuts& cuts, const std::optional<Frame>& frame) const
{
    for (const FrameEdge& edge : m_edges.edges) {
        if (frame && std::ranges::count(frame->hiddenParts, edge.part) > 0)
            continue;
        std::vector<Vec3>& row = cuts.edges.emplace_back(edge.points);
        for (Vec3& point : row)
            point = frame ? frame->placed(point) : m_form.placement.placed(point);
    }
}

/// That takes its time: it is done once for each form. Null when stopped.
std::shared_ptr<const TriangleMesh>
FormPatternJob::withFewTriangles(const std::shared_ptr<const TriangleMesh>& mesh, const FormCuts& cuts,
                                 std::vector<Message>& notes, const std::stop_token& stop)
{
    if (mesh->triangles.size() <= mostFormTriangles)
        return mesh;
    if (m_thinned.of != mesh || m_thinned.rows != cuts.edges.size()) {
        std::optional<ThinnedForm> thinned = thinForm(*mesh, cuts.edges, mostFormTriangles, stop);
        if (!thinned)
            return nullptr;
        m_thinned = {mesh, cuts.edges.size(), std::make_shared<TriangleMesh>(std::move(thinned->mesh)),
                     std::move(thinned->notes)};
    }
    notes = m_thinned.notes;
    return m_thinned.mesh;
}

Form FormPatternJob::cutAndDivided(const std::shared_ptr<const TriangleMesh>& mesh, const FormCuts& cuts,
                                   const FormWanted& wanted, const std::stop_token& stop)
{
    constexpr std::size_t mostKept = 4;
    const FormPatternOrder& order = wanted.order;
    const auto known = std::ranges::find_if(m_divided, [&](const Divided& one) {
        return one.of == mesh && one.cuts == cuts && one.fabric == order.fabric &&
               one.edgeLength == order.edgeLength;
    });
    if (known != m_divided.end())
        return known->form;
    Form form = divided(cutForm(*mesh, cuts, stop), order, stop, wanted.progress);
    if (stop.stop_requested())
        return form;
    if (m_divided.size() == mostKept)
        m_divided.erase(m_divided.begin());
    m_divided.push_back({mesh, cuts, order.fabric, order.edgeLength, form});
    return form;
}

FormMade FormPatternJob::make(const FormWanted& wanted, const std::stop_token& stop)
{
    FormMade made;
    made.number = wanted.number;
    made.draft = wanted.draft;
    try {
        std::shared_ptr<const TriangleMesh> mesh = wanted.mesh;
        if (!mesh) {
            made.problem = read(wanted.file, wanted.there, stop);
            mesh = m_form.mesh;
            if (mesh)
                made.size = mesh->boundingBox().sizes();
        }
        if (!mesh)
            return made;
        FormCuts cuts = wanted.cuts;
        cuts.divides = wanted.divide && !wanted.draft;
        if (!wanted.cadFile.isEmpty()) {
            made.problem = readEdges(wanted.cadFile, stop);
            if (!made.problem.empty() || stop.stop_requested())
                return made;
            addEdges(cuts, wanted.frame);
        }
        std::vector<Message> notes;
        mesh = withFewTriangles(mesh, cuts, notes, stop);
        if (!mesh)
            return made;
        made.form = cuts.divides ? cutAndDivided(mesh, cuts, wanted, stop)
                                 : cutForm(*mesh, cuts, stop, wanted.draft ? m_draft.get() : nullptr);
        if (!cuts.divides && !wanted.draft)
            made.form = withoutClosedSlits(made.form, wanted.order, stop);
        made.form.notes.insert(made.form.notes.begin(), notes.begin(), notes.end());
        made.problem = made.form.problem;
        if (!wanted.mesh && !m_form.warning.empty())
            made.form.notes.push_back(m_form.warning);
        if (!made.problem.empty() || stop.stop_requested())
            return made;
        FlattenOrder order = wanted.draft ? draftFlattening : FlattenOrder{};
        order.poisson = wanted.order.fabric.poisson;
        made.flat = flatten(made.form, order, stop);
        if (!stop.stop_requested())
            made.pattern = formPattern(made.form, made.flat, wanted.order, stop);
        if (!wanted.draft && !stop.stop_requested() && !made.pattern.isEmpty())
            if (Message narrow = tooNarrowForEdges(made.pattern.design, stop); !narrow.empty())
                made.pattern.advice.push_back(std::move(narrow));
    } catch (const std::exception& error) {
        made.problem = failureMessage(error);
    }
    return made;
}

namespace {

/// How far a cover lies from a form at most, mm.
double distanceFrom(const Form& form, const SurfaceMesh& cover, const std::stop_token& stop)
{
    std::vector<FormTree::Triangle> triangles;
    for (const FormPiece& piece : form.pieces)
        for (const auto& [a, b, c] : piece.triangles)
            triangles.push_back(
                {form.points[piece.points[a]], form.points[piece.points[b]], form.points[piece.points[c]]});
    const FormTree tree(std::move(triangles), stop);
    double most = 0;
    for (std::size_t v = 0; v < cover.positions.size() && !stop.stop_requested(); ++v)
        most = std::max(most, (tree.nearestTo(cover.positions[v]).at - cover.positions[v]).norm());
    return most;
}

} // namespace

FormCover coverOfForm(const FormCoverWanted& wanted, const std::stop_token& stop)
{
    FormCover cover{wanted.number, false, {}, 0};
    try {
        const SolveResult solved = solveResting(wanted.input, {.lenient = true}, stop);
        cover.atRest = solved.status == SolveResult::Status::Solved;
        if (!cover.atRest || stop.stop_requested())
            return cover;
        cover.beside = distanceFrom(wanted.of->form, *solved.surface, stop);
        FrameDistance frames;
        for (CoverFinding& finding :
             coverFindings(*solved.surface, wanted.input.design, wanted.input.files, frames))
            if (finding.kind == CoverFinding::Kind::OverLimit || finding.kind == CoverFinding::Kind::Folds)
                cover.findings.push_back(std::move(finding));
    } catch (const std::exception&) { // such as of memory: then it has no rest that is known
        cover.atRest = false;
    }
    return cover;
}

} // namespace bolster
