#include "ScanLink.h"

#include "Background.h"
#include "DesignSession.h"
#include "ElementEdits.h"
#include "ScanAlign.h"
#include "ScanAlignTool.h"
#include "ScanEdits.h"
#include "ScanMeasure.h"
#include "Selection.h"
#include "Units.h"

#include <cmath>
#include <set>

namespace bolster {

ScanLink::ScanLink(DesignSession& session, Selection& selection, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_selection(selection)
    , m_job([bench = std::make_shared<Bench>()](const Request& asked,
                                                const std::stop_token&) { return measure(asked, *bench); },
            [this](Result result) { receive(std::move(result)); })
{
    connect(&session.document(), &Document::changed, this, &ScanLink::request);
    connect(&session, &DesignSession::filesChanged, this, &ScanLink::request);
    connect(&session, &DesignSession::opened, this, &ScanLink::request);
    connect(&selection, &Selection::changed, this, &ScanLink::request);
}

ScanLink::~ScanLink() = default;

void ScanLink::setSurface(SurfaceMeshPtr surface)
{
    m_surface = std::move(surface);
    request();
}

std::optional<ElementId> ScanLink::scanToMeasure() const
{
    std::optional<ElementId> found;
    int best = 0;
    m_session.document().design().each<Scan>([&](ElementId id, const Scan& scan) {
        const int rank = m_selection.contains(id) ? 3 : scan.enabled ? 2 : 1;
        if (rank > best && m_session.files().clouds.contains(id)) {
            best = rank;
            found = id;
        }
    });
    return found;
}

void ScanLink::request()
{
    const std::optional<ElementId> id = scanToMeasure();
    if (id && m_surface) {
        m_job.request({m_surface, *id, *m_session.document().design().find<Scan>(*id), m_session.files()});
        return;
    }
    m_job.cancel();
    if (!m_map && m_figures.empty())
        return;
    m_map.reset();
    m_pairs.clear();
    m_figures.clear();
    emit measured();
}

ScanLink::Result ScanLink::measure(const Request& request, Bench& bench)
{
    Result result{request, nullptr, {}, {}};
    const auto index = bench.indices.index(request.id, request.scan, request.files);
    if (!index || index->empty())
        return result;
    const ScanDeviation deviation = measureScan(*request.surface, request.scan, index, bench.pool);
    result.figures = deviation.figures;
    for (const auto& [vertex, point] : deviation.pairs)
        result.pairs.emplace_back(request.surface->positions[vertex], point);
    auto map = std::make_shared<ShownMap>();
    map->topology = request.surface->topology;
    map->values = deviation.ofVertex;
    map->limit = ShownMap::usualLimit(deviation.figures.p95);
    map->title = tr("Deviation from %1").arg(QString::fromStdString(request.scan.name));
    map->below = tr("inside");
    map->above = tr("outside");
    map->unit = millimetreSuffix;
    result.map = std::move(map);
    return result;
}

void ScanLink::receive(Result result)
{
    if (!m_session.document().design().find<Scan>(result.request.id) || !m_surface)
        return; // gone meanwhile
    m_map = std::move(result.map);
    m_pairs = std::move(result.pairs);
    std::erase_if(m_figures, [this](const auto& known) {
        return !m_session.document().design().template find<Scan>(known.first);
    });
    m_figures[result.request.id] = result.figures;
    emit measured();
}

/// What a scan is aligned with.
struct AlignSubject {
    std::set<ElementId> frames;
    bool cover = false;
};

namespace {

AlignSubject subjectOf(const std::vector<ScanMark>& marks)
{
    AlignSubject subject;
    for (const ScanMark& mark : marks) {
        if (mark.onFrame)
            subject.frames.insert(mark.frame);
        subject.cover = subject.cover || !mark.onFrame;
    }
    return subject;
}

AlignTarget targetOf(const AlignSubject& subject, const Design& design, const DesignFiles& files,
                     const SurfaceMeshPtr& surface)
{
    AlignTarget target;
    if (subject.cover && surface)
        target.add(surface->positions, surface->topology->triangles);
    for (const ElementId id : subject.frames) {
        const Frame* const frame = design.find<Frame>(id);
        const auto mesh = files.meshes.find(id);
        if (frame && mesh != files.meshes.end())
            target.add(mesh->second->points, mesh->second->triangles, *frame);
    }
    target.build();
    return target;
}

/// How far the places that were clicked are from their middle, mm: root mean square.
double spreadOf(const std::vector<ScanPair>& pairs)
{
    Vec3 middle = Vec3::Zero();
    for (const ScanPair& pair : pairs)
        middle += pair.onTarget / static_cast<double>(pairs.size());
    double squares = 0;
    for (const ScanPair& pair : pairs)
        squares += (pair.onTarget - middle).squaredNorm() / static_cast<double>(pairs.size());
    return std::sqrt(squares);
}

/// The verb says what was done with which scan; `args` begins with its name.
Message withResidual(Message verb, const ScanAlignment& found)
{
    verb.args.push_back(numberText(found.rms, 2));
    verb.args.push_back(numberText(100 * found.matched, 2));
    return verb;
}

} // namespace

/// Beside the windows; what it finds is one edit, unless the scan was moved meanwhile.
void ScanLink::alignFrom(ElementId id, const Placement& start, AlignSubject subject, const ScanJob& job,
                         const Message& verb, const Message& failure)
{
    const Scan before = *m_session.document().design().find<Scan>(id);
    const auto report = [this, job](int step) {
        QMetaObject::invokeMethod(
            this,
            [job, step] {
                if (!job.stop.stop_requested())
                    job.progress(step);
            },
            Qt::QueuedConnection);
    };
    inBackground<std::optional<ScanAlignment>>([id, start, before, subject = std::move(subject), report,
                                                files = m_session.files(), surface = m_surface,
                                                design = m_session.document().design(),
                                                stop = job.stop]() -> std::optional<ScanAlignment> {
        const auto index = ScanIndexCache().index(id, before, files, stop.get_token());
        if (!index)
            return std::nullopt;
        return alignScan(targetOf(subject, design, files, surface), *index, start, stop.get_token(), report);
    }).then(this, [this, id, before, job, verb, failure](const std::optional<ScanAlignment>& found) {
        if (job.stop.stop_requested())
            return;
        Document& document = m_session.document();
        const Scan* now = document.design().find<Scan>(id);
        if (!found || !now || static_cast<const Placement&>(*now) != before) {
            job.done(failure);
            return;
        }
        const Message done = withResidual(verb, *found);
        document.cancelGesture();
        document.commit(
            edits::replaceElement(document.design(), id, withPlacement(Element(*now), found->placement), done));
        job.done(done);
    });
}

void ScanLink::fitPlacement(ElementId id, const ScanJob& job)
{
    const Scan* const scan = m_session.document().design().find<Scan>(id);
    if (!scan || !m_surface) {
        job.done({QT_TRANSLATE_NOOP("Message", "There is no cover to place the scan on."), {}});
        return;
    }
    if (scan->enabled) { // the cover has come to it: wherever it lies, it lies on the cover
        job.done(
            {QT_TRANSLATE_NOOP("Message", "The cover is pulled to the scan where it lies now: switch \"Fit the "
                                          "cover to it\" off, place it, and switch that on again."),
             {}});
        return;
    }
    alignFrom(
        id, *scan, {{}, true}, job,
        {QT_TRANSLATE_NOOP("Message", "Place on the cover to %2 mm rms: %1 (%3 % of its points matched)"),
         {scan->name}},
        {QT_TRANSLATE_NOOP("Message", "The scan could not be placed: it is too far from the cover. Align it by "
                                      "three places, or cut away what does not belong to it."),
         {}});
}

bool ScanLink::align(ElementId id, const std::vector<ScanMark>& marks, const ScanJob& job)
{
    const Scan* const scan = m_session.document().design().find<Scan>(id);
    std::vector<ScanPair> pairs;
    for (const ScanMark& mark : marks)
        pairs.push_back({mark.onScan, mark.onTarget});
    const std::optional<Placement> start = scan ? placementByPairs(pairs, *scan) : std::nullopt;
    if (!start) {
        job.done({QT_TRANSLATE_NOOP("Message", "The three places lie on a line: choose some that do not."), {}});
        return false;
    }
    constexpr double mostMismatch = 0.25;
    if (pairResidual(pairs, *start) > mostMismatch * spreadOf(pairs)) {
        job.done(
            {QT_TRANSLATE_NOOP("Message", "The places are not as far from each other on the scan as where they "
                                          "belong: check the scale of the scan, and which is which."),
             {}});
        return false;
    }
    alignFrom(
        id, *start, subjectOf(marks), job,
        {QT_TRANSLATE_NOOP("Message", "Align to %2 mm rms: %1 (%3 % of its points matched)"), {scan->name}},
        {QT_TRANSLATE_NOOP("Message", "The scan could not be aligned: there are not enough of its points where "
                                      "it would stand. Click other places, or bring back what is cut away of "
                                      "it."),
         {}});
    return true;
}

void ScanLink::keepAroundCover(ElementId id)
{
    const Scan* scan = m_session.document().design().find<Scan>(id);
    if (!scan || !m_surface)
        return;
    Box3 box = m_surface->boundingBox();
    box.min().array() -= scan->threshold;
    box.max().array() += scan->threshold;
    const Design& design = m_session.document().design();
    m_session.document().commit(edits::addCut(design, id, edits::boxCut(*scan, box, true)));
}

} // namespace bolster
