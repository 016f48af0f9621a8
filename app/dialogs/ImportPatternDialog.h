// Shows the pieces of a pattern file, and asks what of them is taken and what its numbers mean.
#pragma once

#include "FoundPieces.h"
#include "LatestJob.h"
#include "PatternDesign.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace bolster {

class FoundPiecesView;
class NumberBox;

class ImportPatternDialog : public QDialog {
    Q_OBJECT

public:
    ImportPatternDialog(Drawing drawing, const QString& file, QWidget* parent = nullptr);

    /// What was chosen of it; null while it is looked for.
    const std::shared_ptr<const FoundPattern>& pattern() const { return m_pattern; }
    PatternChoice choice() const;

    void accept() override;

private:
    void build();
    QWidget* buildChoices();
    void rememberUnit();
    void chooseUnit(double unit);
    void changed();
    void showPattern(std::shared_ptr<const FoundPattern> pattern);
    void showPieces();
    void showUnits();
    void showSizes();
    void tellWhatIsOdd();
    void choose();
    std::set<std::size_t> chosen() const;
    QString product() const;
    void addUnit(const QString& name, double size);
    PieceOrder order() const;

    QString m_file; ///< its name
    std::shared_ptr<const Drawing> m_drawing;
    std::shared_ptr<const FoundPattern> m_pattern;
    double m_unitShown = 1; ///< mm: of the pattern that is there
    FoundPiecesView* m_view = nullptr;
    QComboBox* m_unit = nullptr;
    QComboBox* m_size = nullptr;
    QComboBox* m_lines = nullptr;
    NumberBox* m_gap = nullptr;
    QListWidget* m_pieces = nullptr;
    QLabel* m_measures = nullptr;
    QLabel* m_odd = nullptr;
    QPushButton* m_import = nullptr;
    LatestJob<PieceOrder, std::shared_ptr<const FoundPattern>> m_job; ///< last: it uses the others
};

} // namespace bolster
