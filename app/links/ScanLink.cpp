#include "ScanLink.h"

#include "Background.h"
#include "DesignSession.h"
#include "ElementEdits.h"
#include "ScanEdits.h"
#include "ScanMeasure.h"
#include "Selection.h"

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

void ScanLink::fitPlacement(ElementId id, std::stop_source stop, const std::function<void(int)>& progress,
                            const std::function<void(const Message&)>& done)
{
    const Scan* found = m_session.document().design().find<Scan>(id);
    if (!found || !m_surface) {
        done({QT_TRANSLATE_NOOP("Message", "There is no cover to place the scan on."), {}});
        return;
    }
    const auto report = [this, progress, stop](int iteration) {
        QMetaObject::invokeMethod(
            this,
            [progress, stop, iteration] {
                if (!stop.stop_requested())
                    progress(iteration);
            },
            Qt::QueuedConnection);
    };
    using Fit = std::optional<PlacementFit>;
    inBackground<Fit>([scan = *found, id, files = m_session.files(), surface = m_surface, stop, report]() -> Fit {
        const auto index = ScanIndexCache().index(id, scan, files);
        return index ? bolster::fitPlacement(*surface, scan, *index, stop.get_token(), report) : Fit();
    }).then(this, [this, id, before = *found, stop, done](const Fit& fit) {
        if (stop.stop_requested())
            return;
        Document& document = m_session.document();
        const Scan* now = document.design().find<Scan>(id);
        if (!fit || !now || static_cast<const Placement&>(*now) != before) {
            done({QT_TRANSLATE_NOOP("Message",
                                    "The scan could not be placed: move it nearer to the cover, or cut away "
                                    "what does not belong to it."),
                  {}});
            return;
        }
        document.cancelGesture();
        document.commit(
            edits::replaceElement(document.design(), id, withPlacement(Element(*now), fit->placement),
                                  {QT_TRANSLATE_NOOP("Message", "Place %1 on the cover"), {now->name}}));
        done({});
    });
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
