#include "PreparedSheet.h"

#include "DesignCheck.h"
#include "Stopwatch.h"

#include <algorithm>
#include <set>

namespace bolster {

void TriangulationCache::triangulate(const std::vector<OutlineSampling::Outline>& outlines, double edgeLength,
                                     WorkerPool& pool, const std::stop_token& stop)
{
    std::vector<Entry*> changed;
    for (const OutlineSampling::Outline& outline : outlines) {
        std::vector<InnerLine> lines;
        for (const OutlineSampling::Line& line : outline.lines)
            lines.push_back(line.shape);
        Entry& entry = m_entries[outline.patch];
        if (entry.edgeLength == edgeLength && entry.boundary == outline.points && entry.lines == lines)
            continue;
        entry = {outline.points, std::move(lines), 0, {}};
        changed.push_back(&entry);
    }
    // The longest outlines first, so that no thread waits for one that was begun last.
    std::ranges::stable_sort(changed, std::ranges::greater(), [](const Entry* e) { return e->boundary.size(); });
    pool.forTasks(static_cast<int>(changed.size()), [&](int k) {
        if (stop.stop_requested())
            return;
        changed[k]->mesh = triangulatePatch(changed[k]->boundary, edgeLength, changed[k]->lines);
        changed[k]->edgeLength = edgeLength; // only now, in case that there was no memory
    });
}

void TriangulationCache::forgetOthers(const OutlineSampling& sampling)
{
    std::set<ElementId> used;
    for (const auto& outline : sampling.outlines)
        used.insert(outline.patch);
    std::erase_if(m_entries, [&](const auto& entry) { return !used.contains(entry.first); });
}

namespace {

/// Patches that the samples cut so short that their polygon crosses itself.
Problems triangulateAll(const Design& design, const OutlineSampling& sampling, TriangulationCache& cache,
                        std::vector<PatchMesh>& meshes, WorkerPool& pool, const std::stop_token& stop)
{
    Problems problems;
    cache.triangulate(sampling.outlines, design.settings().edgeLength, pool, stop);
    for (const auto& outline : sampling.outlines) {
        if (stop.stop_requested())
            break;
        meshes.push_back(cache.mesh(outline.patch));
        if (!meshes.back().triangles.empty())
            continue;
        for (const OutlineSampling::Line& line : outline.lines)
            if (problems.empty() || problems.back().element != line.element)
                problems.push_back({line.element,
                                    elementLabel(line.element, *design.element(line.element)),
                                    "curve",
                                    {QT_TRANSLATE_NOOP("Message", "the patch cannot be triangulated along it with "
                                                                  "edges of %1 mm. Choose a smaller edge length."),
                                     {numberText(design.settings().edgeLength)}},
                                    Severity::Error});
        if (outline.lines.empty())
            problems.push_back(
                {outline.patch,
                 elementLabel(outline.patch, *design.element(outline.patch)),
                 "outline",
                 {QT_TRANSLATE_NOOP("Message", "the patch is too narrow somewhere for edges of %1 mm. "
                                               "Choose a smaller edge length."),
                  {numberText(design.settings().edgeLength)}},
                 Severity::Error});
    }
    return problems;
}

/// Leaves out what the problems name. False when that changed nothing.
bool leaveOut(PreparedSheet& sheet, const Problems& problems)
{
    const std::size_t before = sheet.design.elements().size();
    sheet.errors.insert(sheet.errors.end(), problems.begin(), problems.end());
    Problems leftOut;
    sheet.design = usablePart(sheet.design, problems, &leftOut);
    sheet.leftOut.insert(sheet.leftOut.end(), leftOut.begin(), leftOut.end());
    return sheet.design.elements().size() < before;
}

} // namespace

SolveInput withEdgeLength(const SolveInput& input, double length)
{
    Settings settings = input.design.settings();
    settings.edgeLength = length;
    return {input.design.with({{}, {{settingsId, input.design.element(settingsId), makeElement(settings)}}}),
            input.files};
}

std::optional<PreparedSheet> prepareSheet(const SolveInput& input, TriangulationCache& cache)
{
    WorkerPool alone(1);
    return prepareSheet(input, cache, alone);
}

std::optional<PreparedSheet> prepareSheet(const SolveInput& input, TriangulationCache& cache, WorkerPool& pool,
                                          const std::stop_token& stop)
{
    PreparedSheet sheet;
    sheet.files = input.files;
    const Problems problems = checkDesign(input.design);
    std::copy_if(problems.begin(), problems.end(), std::back_inserter(sheet.errors),
                 [](const Problem& p) { return p.severity == Severity::Error; });
    std::copy_if(problems.begin(), problems.end(), std::back_inserter(sheet.warnings),
                 [](const Problem& p) { return p.severity == Severity::Warning; });
    sheet.design = usablePart(input.design, problems, &sheet.leftOut);

    Stopwatch watch;
    std::vector<PatchMesh> meshes;
    for (;;) {
        if (stop.stop_requested())
            return std::nullopt;
        sheet.sampling = sampleOutlines(sheet.design);
        if (!sheet.sampling.problems.empty()) {
            if (!leaveOut(sheet, sheet.sampling.problems))
                return sheet;
            continue;
        }
        meshes.clear();
        const Problems narrow = triangulateAll(sheet.design, sheet.sampling, cache, meshes, pool, stop);
        if (stop.stop_requested())
            return std::nullopt;
        if (narrow.empty() || !leaveOut(sheet, narrow))
            break;
    }
    cache.forgetOthers(sheet.sampling);
    sheet.triangulateTime = watch.restart();
    sheet.mesh = buildSewnMesh(sheet.design, sheet.sampling, meshes, pool);
    sheet.assembleTime = watch.elapsed();
    return sheet;
}

} // namespace bolster
