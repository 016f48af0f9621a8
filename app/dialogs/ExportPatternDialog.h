// Asks how a pattern shall be written, and shows what will be on its sheets.
#pragma once

#include "CutCheck.h"
#include "LatestJob.h"
#include "PatternFile.h"
#include "SheetPreview.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace bolster {

class NumberBox;

class ExportPatternDialog : public QDialog {
    Q_OBJECT

public:
    /// `style`: what the pattern is called where the design does not say it.
    ExportPatternDialog(Design design, const QString& style, QWidget* parent = nullptr);

signals:
    /// Something is wrong there and shall be seen: in outline coordinates, mm.
    void placeWanted(bolster::ElementId element, bolster::ElementId patch, const bolster::Vec2& place);

public:
    /// What was chosen.
    PatternOrder order() const;
    /// As it is shown; null while it is made.
    const std::shared_ptr<const CutPattern>& pattern() const { return m_pattern; }

private:
    void build();
    QWidget* buildChoices();
    QWidget* buildLines();
    void buildPieces();
    void changed();
    void preview();
    void showFindings(const std::vector<CutFinding>& findings);

    Design m_design;
    std::string m_style;
    std::shared_ptr<const CutPattern> m_pattern;
    QComboBox* m_format = nullptr;
    QComboBox* m_paper = nullptr;
    QCheckBox* m_landscape = nullptr;
    QCheckBox* m_unfold = nullptr;
    NumberBox* m_allowance = nullptr;
    std::vector<std::pair<QCheckBox*, bool CutLayers::*>> m_layers;
    QListWidget* m_pieces = nullptr;
    SheetPreview* m_preview = nullptr;
    QLabel* m_summary = nullptr;
    QListWidget* m_findings = nullptr;
    QPushButton* m_export = nullptr;
    struct Made {
        std::shared_ptr<const CutPattern> pattern;
        std::vector<CutFinding> findings;
    };
    LatestJob<CutOptions, Made> m_job; ///< last: it uses the others
};

} // namespace bolster
