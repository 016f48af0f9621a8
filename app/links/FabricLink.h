// Bakes the fabrics of the design beside the GUI thread, reads their pictures, and draws how they look.
#pragma once

#include "Design.h"
#include "FabricCache.h"
#include "FabricPictures.h"
#include "PictureScene.h"
#include "Problem.h"

#include <QColor>
#include <QObject>

#include <map>
#include <memory>
#include <set>
#include <stop_token>

namespace bolster {

class DesignSession;

/// One fabric after the other, those that are shown first. What was baked is shown until its successor is there.
/// Nothing is baked before somebody can see it: baking loads libraries for as long as the rest of a start takes.
class FabricLink : public QObject {
    Q_OBJECT

public:
    explicit FabricLink(DesignSession& session, QObject* parent = nullptr);
    ~FabricLink() override;

    /// From now on they can be seen.
    void begin();
    bool begun() const { return m_begun; }
    /// By fabric; those that are baked by now.
    std::map<ElementId, FabricMapsPtr> maps() const;
    /// For pictures, on any thread: what is baked by now, the rest on demand.
    FabricBaker baker() const;
    /// The same without the rest.
    FabricBaker bakedByNow() const;
    /// What a fabric looks like from far away; of those whose maps are up to date.
    std::map<ElementId, QColor> colors() const;
    /// Of those that are drawn by now; until a changed one is baked, as it was.
    std::map<ElementId, FabricPictures> pictures() const;
    /// Everything is baked as it is now.
    bool upToDate() const;
    /// Pictures that could not be read, and why.
    Problems problems() const;

    /// A fabric that is in no design, on a cushion. Blocks: not for the GUI thread.
    static QImage previewOf(const Fabric& fabric, int pixels);

signals:
    void changed();

private:
    /// What one job makes.
    struct Baked {
        Fabric fabric;
        QString path; ///< of its picture; "" without one
        ImagePixelsPtr image;
        Message problem;
        FabricMapsPtr maps;
        QColor color;
        FabricPictures pictures;
    };

    void designChanged(const std::set<ElementId>& ids);
    void bakeNext();
    bool stale(ElementId id) const;
    std::optional<ElementId> nextStale() const;
    QString picturePath(const Fabric& fabric) const;
    /// With pictures of so many pixels a side, or without any.
    static Baked bake(const Fabric& fabric, const QString& path, ImagePixelsPtr image, FabricCache& cache,
                      const std::stop_token& stop, int pixels = 0);

    DesignSession& m_session;
    std::shared_ptr<FabricCache> m_cache = std::make_shared<FabricCache>(); ///< a running job has it, too
    std::map<ElementId, Baked> m_baked;
    std::stop_source m_stop;
    bool m_begun = false;
    bool m_busy = false;
};

} // namespace bolster
