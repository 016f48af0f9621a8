// Measures the cover against a scan and moves scans onto it, beside the GUI thread.
#pragma once

#include "LatestJob.h"
#include "MakeGhosts.h"
#include "ScanFigures.h"
#include "ShownMap.h"

namespace bolster {

class DesignSession;
struct AlignSubject;
struct ScanMark;
class Selection;

/// Who waits for a scan to be moved. All on the GUI thread, and nothing after stop.request_stop().
struct ScanJob {
    std::stop_source stop{};
    std::function<void(int)> progress{};        ///< wants to know the step
    std::function<void(const Message&)> done{}; ///< gets what there is to say, if anything
};

/// One scan is measured at a time: the selected one, or else the first that is fitted to, or else the first.
class ScanLink : public QObject {
    Q_OBJECT

public:
    ScanLink(DesignSession& session, Selection& selection, QObject* parent = nullptr);
    ~ScanLink() override;

    void setSurface(SurfaceMeshPtr surface);
    /// Null while nothing is measured.
    const ShownMapPtr& map() const { return m_map; }
    /// On the cover, and of the scan, mm.
    const std::vector<std::pair<Vec3, Vec3>>& pairs() const { return m_pairs; }
    const std::map<ElementId, ScanFigures>& figures() const { return m_figures; }

    /// Moves the scan onto the cover from where it is, some centimetres and about twenty degrees off at most.
    void fitPlacement(ElementId scan, const ScanJob& job);
    /// Moves it to where three of its places belong, and from there onto what was clicked: cover, frames, or both.
    /// `false`, and nothing begins, when the places do not fit each other: `job.done` got the reason.
    bool align(ElementId scan, const std::vector<ScanMark>& marks, const ScanJob& job);
    /// Keeps what is near the cover; the distance is that of the scan's threshold.
    void keepAroundCover(ElementId scan);

signals:
    void measured();

private:
    struct Request {
        SurfaceMeshPtr surface;
        ElementId id{};
        Scan scan;
        DesignFiles files;
    };
    struct Result {
        Request request;
        ShownMapPtr map;
        std::vector<std::pair<Vec3, Vec3>> pairs;
        ScanFigures figures;
    };
    /// What the job keeps between two measurements; only its thread uses it.
    struct Bench {
        ScanIndexCache indices;
        WorkerPool pool{1};
    };

    void alignFrom(ElementId id, const Placement& start, AlignSubject subject, const ScanJob& job,
                   const Message& verb, const Message& failure);
    void request();
    void receive(Result result);
    std::optional<ElementId> scanToMeasure() const;
    static Result measure(const Request& request, Bench& bench);

    DesignSession& m_session;
    Selection& m_selection;
    SurfaceMeshPtr m_surface;
    ShownMapPtr m_map;
    std::vector<std::pair<Vec3, Vec3>> m_pairs;
    std::map<ElementId, ScanFigures> m_figures;
    LatestJob<Request, Result> m_job;
};

} // namespace bolster
