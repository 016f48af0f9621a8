// The way from an empty design to a cover, one step at a time.
#pragma once

#include "Design.h"

#include <QLabel>

namespace bolster {

class Document;
class PatternView;

enum class FirstStep {
    None,    ///< nothing drawn yet, or the cover has a shape
    Another, ///< a patch has nothing to be sewn to
    Sew,
    Shape,  ///< nothing holds or fills what is sewn
    Fix,    ///< there is a frame, and nothing on it to which the cover could be fixed
    Attach, ///< there is such a curve
};

/// What a design that is being begun lacks most.
FirstStep firstStep(const Design& design);

/// One line at the bottom of the pattern view; it lies over the view while nothing is being drawn.
class NextStep : public QLabel {
    Q_OBJECT

public:
    NextStep(Document& document, PatternView& over);

signals:
    void drawWanted();
    void sewWanted();
    void selectAllWanted();
    void fixationWanted();
    void attachWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void place();
    void follow(const QString& link);

    Document& m_document;
    PatternView& m_over;
};

} // namespace bolster
