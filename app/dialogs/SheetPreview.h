// What will be on the sheets of a pattern, small.
#pragma once

#include "CutLayers.h"
#include "CutTable.h"
#include "PatternPdf.h"

#include <QWidget>

#include <memory>

namespace bolster {

class SheetPreview : public QWidget {
    Q_OBJECT

public:
    explicit SheetPreview(QWidget* parent = nullptr);

    struct Shown {
        std::shared_ptr<const CutPattern> pattern;
        CutTable table;
        CutLayers layers;
        std::optional<SheetGrid> grid; ///< of formats with pages
    };
    void show(Shown shown);

    QSize sizeHint() const override { return {560, 440}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Shown m_shown;
};

} // namespace bolster
