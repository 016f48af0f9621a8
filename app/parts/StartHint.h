// What a new design shows in place of a pattern: ways to begin, and to go on.
#pragma once

#include <QWidget>

class QBoxLayout;
class QVBoxLayout;

namespace bolster {

class Document;
class PatternView;

/// Lies over the pattern view as long as there are no patches.
class StartHint : public QWidget {
    Q_OBJECT

public:
    StartHint(Document& document, PatternView& over);
    /// Out of the way of who draws.
    void setDrawing(bool drawing);
    /// The start page lies over it, and its keys are not wanted.
    void setCovered(bool covered);

signals:
    void rectangleWanted();
    void outlineWanted();
    void frameWanted();
    void openWanted();
    /// A sample, or what was open lately.
    void fileWanted(const QString& path);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void addBeginning(QBoxLayout& layout);
    void fillLists();
    void addRecent(QVBoxLayout& layout, const QStringList& files);
    void addSamples(QVBoxLayout& layout, qsizetype most);
    QString muted() const;
    void place();

    Document& m_document;
    PatternView& m_over;
    QWidget* m_lists = nullptr; ///< made anew each time this is shown
    bool m_drawing = false;
    bool m_covered = false;
};

} // namespace bolster
