// What a new design shows in place of a pattern: ways to begin.
#pragma once

#include <QWidget>

class QBoxLayout;

namespace bolster {

class Document;

/// Lies over the pattern view as long as there are no patches.
class StartHint : public QWidget {
    Q_OBJECT

public:
    StartHint(Document& document, QWidget* over);
    /// Out of the way of who draws.
    void setDrawing(bool drawing);

signals:
    void rectangleWanted();
    void outlineWanted();
    void frameWanted();
    void openWanted();
    void sampleWanted(const QString& path);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void addBeginning(QBoxLayout& layout);
    void place();

    Document& m_document;
    QWidget* m_over;
    bool m_drawing = false;
};

} // namespace bolster
