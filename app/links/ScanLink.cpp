#include "ScanLink.h"

#include "Background.h"
#include "DesignSession.h"
#include "ElementEdits.h"
#include "ScanAlign.h"
#include "ScanAlignTool.h"
#include "ScanEdits.h"
#include "ScanMeasure.h"
#include "Selection.h"

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
    map->unit = QStringLiteral(" mm");
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

/// `compute(scan, report, stop)` runs beside the windows; what it finds is one edit, unless the scan was moved
/// meanwhile.
template <class Fit, class Compute>
void ScanLink::moveInBackground(ElementId id, const ScanJob& job, const Compute& compute, const Message& failure,
                                Message (*verb)(const Scan& scan, const Fit& fit))
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
    inBackground<std::optional<Fit>>([before, compute, report, stop = job.stop] {
        return compute(before, report, stop.get_token());
    }).then(this, [this, id, before, job, failure, verb](const std::optional<Fit>& fit) {
        if (job.stop.stop_requested())
            return;
        Document& document = m_session.document();
        const Scan* now = document.design().find<Scan>(id);
        if (!fit || !now || static_cast<const Placement&>(*now) != before) {
            job.done(failure);
            return;
        }
        const Message done = verb(*now, *fit);
        document.cancelGesture();
        document.commit(
            edits::replaceElement(document.design(), id, withPlacement(Element(*now), fit->placement), done));
        job.done(done);
    });
}

void ScanLink::fitPlacement(ElementId id, const ScanJob& job)
{
    if (!m_session.document().design().find<Scan>(id) || !m_surface) {
        job.done({QT_TRANSLATE_NOOP("Message", "There is no cover to place the scan on."), {}});
        return;
    }
    const auto compute = [id, files = m_session.files(),
                          surface = m_surface](const Scan& scan, const std::function<void(int)>& report,
                                               const std::stop_token& stop) {
        const auto index = ScanIndexCache().index(id, scan, files, stop);
        return index ? bolster::fitPlacement(*surface, scan, *index, stop, report) : std::nullopt;
    };
    moveInBackground<PlacementFit>(
        id, job, compute,
        {QT_TRANSLATE_NOOP("Message", "The scan could not be placed: move it nearer to the cover, or cut away "
                                      "what does not belong to it."),
         {}},
        [](const Scan& scan, const PlacementFit&) -> Message {
            return {QT_TRANSLATE_NOOP("Message", "Place %1 on the cover"), {scan.name}};
        });
}

namespace {

/// What was clicked: the cover, frames, or both.
AlignTarget targetOf(const std::vector<ScanMark>& marks, const Design& design, const DesignFiles& files,
                     const SurfaceMeshPtr& surface)
{
    AlignTarget target;
    std::set<ElementId> frames;
    bool cover = false;
    for (const ScanMark& mark : marks) {
        if (mark.onFrame)
            frames.insert(mark.frame);
        cover = cover || !mark.onFrame;
    }
    if (cover && surface)
        target.add(surface->positions, surface->topology->triangles);
    for (const ElementId id : frames) {
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

Message alignVerb(const Scan& scan, const ScanAlignment& found)
{
    return {QT_TRANSLATE_NOOP("Message", "Align %1: %2 mm rms, %3 % of its points matched"),
            {scan.name, numberText(found.rms, 2), numberText(100 * found.matched, 2)}};
}

} // namespace

void ScanLink::align(ElementId id, const std::vector<ScanMark>& marks, const ScanJob& job)
{
    const Scan* const scan = m_session.document().design().find<Scan>(id);
    std::vector<ScanPair> pairs;
    for (const ScanMark& mark : marks)
        pairs.push_back({mark.onScan, mark.onTarget});
    const std::optional<Placement> start = scan ? placementByPairs(pairs, *scan) : std::nullopt;
    if (!start) {
        job.done({QT_TRANSLATE_NOOP("Message", "The three places lie on a line: choose some that do not."), {}});
        return;
    }
    constexpr double mostMismatch = 0.25;
    if (pairResidual(pairs, *start) > mostMismatch * spreadOf(pairs)) {
        job.done(
            {QT_TRANSLATE_NOOP("Message", "The places are not as far from each other on the scan as where they "
                                          "belong: check the scale of the scan, and which is which."),
             {}});
        return;
    }
    const auto compute = [id, marks, start = *start, files = m_session.files(), surface = m_surface,
                          design = m_session.document().design()](const Scan& aligned,
                                                                  const std::function<void(int)>& report,
                                                                  const std::stop_token& stop) {
        const auto index = ScanIndexCache().index(id, aligned, files, stop);
        return index ? alignScan(targetOf(marks, design, files, surface), *index, start, stop, report)
                     : std::nullopt;
    };
    moveInBackground<ScanAlignment>(
        id, job, compute,
        {QT_TRANSLATE_NOOP("Message", "The scan could not be aligned: there are not enough of its points where it "
                                      "would stand. Click other places, or bring back what is cut away of it."),
         {}},
        alignVerb);
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
