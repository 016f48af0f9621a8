// Measures the cover against a scan and moves scans onto it, beside the GUI thread.
#pragma once

#include "LatestJob.h"
#include "MakeGhosts.h"
#include "ScanFigures.h"
#include "ScanPlacement.h"
#include "ShownMap.h"

namespace bolster {

class DesignSession;
class Selection;

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

    /// Moves the scan onto the cover. `progress` wants to know the iteration, `done` is called with what went
    /// wrong, or nothing; both on the GUI thread, neither after stop.request_stop().
    void fitPlacement(ElementId scan, std::stop_source stop, const std::function<void(int)>& progress,
                      const std::function<void(const Message&)>& done);
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
