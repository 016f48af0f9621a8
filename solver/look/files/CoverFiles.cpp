#include "CoverFiles.h"

#include "CoverRefiner.h"
#include "CoverSolid.h"
#include "CurvesForCad.h"
#include "FewerFaces.h"
#include "FoamSolid.h"
#include "GlbFile.h"
#include "PageFactsOf.h"
#include "Shells.h"
#include "SolidFile.h"
#include "StepBody.h"
#include "UsdzFile.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

namespace bolster {

namespace {

/// Thrown by what has nobody to tell.
struct Stopped {};

/// Of a body for CAD, where each face is heavy.
constexpr std::size_t mostFaces = 10'000;
constexpr double smallestFoam = 1000; // mm^3: smaller pieces nobody cuts

const Message interruptedMessage{QT_TRANSLATE_NOOP("Message", "interrupted"), {}};

} // namespace

CoverFiles::CoverFiles(ModelSubject subject, CoverFileOptions options)
    : m_subject(std::move(subject))
    , m_options(std::move(options))
{}

CoverFile CoverFiles::make(CoverFormat format, const std::stop_token& stop)
{
    CoverFile file;
    if (!m_subject.surface || m_subject.surface->topology->triangles.empty()) {
        file.problem = {QT_TRANSLATE_NOOP("Message", "there is no cover yet: nothing is sewn or solved"), {}};
        return file;
    }
    try {
        file = made(format, stop);
    } catch (const Stopped&) {
        file = {};
        file.problem = interruptedMessage;
    } catch (const std::bad_alloc&) {
        file = {};
        file.problem = {QT_TRANSLATE_NOOP("Message", "there is not enough memory for this file"), {}};
    } catch (const std::runtime_error& error) { // of OpenSubdiv, OpenImageIO, zlib
        file = {};
        file.problem = {QT_TRANSLATE_NOOP("Message", "the cover cannot be made a file (%1)"), {error.what()}};
    }
    if (stop.stop_requested() && file.problem.empty()) {
        file = {};
        file.problem = interruptedMessage;
    }
    return file;
}

CoverFile CoverFiles::made(CoverFormat format, const std::stop_token& stop)
{
    CoverFile file;
    switch (format) {
    case CoverFormat::Glb:
        file.bytes = glbFile(model(false, stop));
        return file;
    case CoverFormat::Usdz:
        file.bytes = usdzFile(model(false, stop));
        return file;
    case CoverFormat::Obj: {
        ObjFiles obj = objFiles(model(false, stop), m_options.stem);
        file.bytes = std::move(obj.obj);
        file.beside = std::move(obj.beside);
        return file;
    }
    case CoverFormat::Page:
        file.bytes = customerPage(m_options.page, model(true, stop),
                                  pageFacts(m_subject, model(true, stop), m_options.title));
        return file;
    case CoverFormat::Step:
        return curves();
    case CoverFormat::FoamStl:
    case CoverFormat::FoamThreeMf:
    case CoverFormat::FoamStep:
        return foam(format, stop);
    case CoverFormat::Stl:
    case CoverFormat::ThreeMf:
        break;
    }
    return solid(format);
}

const CoverModel& CoverFiles::model(bool small, const std::stop_token& stop)
{
    std::unique_ptr<const CoverModel>& kept = m_models[small ? 1 : 0];
    if (!kept) {
        const PictureKind pictures{small, small ? 512 : 1024};
        CoverModel model = makeCoverModel(m_subject, m_options.frames, pictures, stop);
        if (stop.stop_requested())
            throw Stopped();
        kept = std::make_unique<const CoverModel>(std::move(model));
    }
    return *kept;
}

CoverFile CoverFiles::solid(CoverFormat format) const
{
    CoverFile file;
    const TriangleMesh body = coverSolid(*CoverRefiner().refine(m_subject.surface, 1), m_options.thickness);
    file.bytes = format == CoverFormat::Stl ? stlFile(body) : threeMfFile(body);
    file.notes.push_back({QT_TRANSLATE_NOOP("Message", "the cover is %1 mm thick and has %2 cm\u00b3"),
                          {numberText(m_options.thickness), numberText(enclosedVolume(body) / 1000)}});
    return file;
}

CoverFile CoverFiles::foam(CoverFormat format, const std::stop_token& stop) const
{
    CoverFile file;
    TriangleMesh body = foamSolid(*m_subject.surface, m_subject.design, m_subject.files,
                                  {m_options.foamEdge, m_options.thickness}, stop);
    if (stop.stop_requested())
        throw Stopped();
    const std::size_t crumbs = dropSmallShells(body, smallestFoam);
    if (body.triangles.empty()) {
        file.problem = {QT_TRANSLATE_NOOP("Message", "there is no room for foam between the frame and the cover"),
                        {}};
        return file;
    }
    const double litres = enclosedVolume(body) / 1e6;
    file.notes.push_back({QT_TRANSLATE_NOOP("Message", "the foam has %1 l and weighs %2 kg at %3 kg/m\u00b3"),
                          {numberText(litres), numberText(litres * m_options.foamDensity / 1000),
                           numberText(m_options.foamDensity)}});
    const auto bodies = std::ranges::count_if(shellsOf(body), [](const Shell& shell) { return !shell.isVoid(); });
    if (bodies > 1)
        file.notes.push_back({QT_TRANSLATE_NOOP("Message", "it is in %1 pieces"), {std::to_string(bodies)}});
    if (crumbs == 1)
        file.notes.push_back({QT_TRANSLATE_NOOP("Message", "one piece of less than 1 cm\u00b3 is left out"), {}});
    else if (crumbs > 1)
        file.notes.push_back({QT_TRANSLATE_NOOP("Message", "%1 pieces of less than 1 cm\u00b3 are left out"),
                              {std::to_string(crumbs)}});
    if (format == CoverFormat::FoamStep) {
        const FewerFaces fewer = withFewerFaces(body, mostFaces, stop);
        file.bytes = stepBody(m_options.title, fewer.mesh);
        if (fewer.off > 0)
            file.notes.push_back({QT_TRANSLATE_NOOP("Message", "99 % of its surface is within %1 mm"),
                                  {numberText(std::ceil(100 * fewer.off) / 100)}});
    } else {
        file.bytes = format == CoverFormat::FoamStl ? stlFile(body) : threeMfFile(body);
    }
    return file;
}

CoverFile CoverFiles::curves() const
{
    CoverFile file;
    const std::vector<StepCurves> sets = curvesForCad(m_subject);
    std::size_t count = 0;
    for (const StepCurves& set : sets)
        count += set.curves.size();
    if (count == 0)
        file.problem = {QT_TRANSLATE_NOOP("Message", "there are neither fixation curves nor seams"), {}};
    else
        file.bytes = stepFile(m_options.title, sets);
    return file;
}

} // namespace bolster
