// Asks how a pattern shall be written, and shows what will be on its sheets.
#pragma once

#include "CutFindingsList.h"
#include "LatestJob.h"
#include "PagesView.h"
#include "PatternFile.h"
#include "SheetPreview.h"

#include <QDialog>

#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace bolster {

class NumberBox;

class ExportPatternDialog : public QDialog {
    Q_OBJECT

public:
    /// `style`: what the pattern is called where the design does not say it. `takePicture`: of the cover, for the
    /// sewing sheet; called when that is first chosen (of large designs it takes a while), may return a null image.
    ExportPatternDialog(Design design, const QString& style, std::function<QImage()> takePicture,
                        QWidget* parent = nullptr);

signals:
    /// Something is wrong there and shall be seen: in outline coordinates, mm.
    void placeWanted(bolster::ElementId element, bolster::ElementId patch, const bolster::Vec2& place);

public:
    /// What was chosen.
    PatternOrder order() const;
    /// As it is shown; null while it is made.
    const std::shared_ptr<const CutPattern>& pattern() const { return m_pattern; }
    /// As the sewing sheet shows it; null as long as nobody wanted one.
    QImage picture() const { return m_picture.value_or(QImage()); }
    /// What is typed and cannot be taken stops it.
    void accept() override;
    /// Keeps what was chosen for the next time.
    void done(int result) override;

private:
    struct Cut {
        std::shared_ptr<const CutPattern> pattern;
        std::vector<CutFinding> findings;
    };
    struct LayoutOrder {
        std::shared_ptr<const CutPattern> pattern;
        PatternOrder order;
        QImage picture;
    };
    struct Layout {
        PatternOrder order;
        std::shared_ptr<const SheetPlan> plan; ///< of formats without pages the table alone
        std::vector<QImage> pages;             ///< the first ones of the sewing sheet
        int allPages = 0;
    };
    static Layout laidOut(const Design& design, const LayoutOrder& order, const std::stop_token& stop);

    void build();
    QWidget* buildPreview();
    QWidget* buildChoices();
    QWidget* buildLines();
    void buildPieces();
    void chooseAsBefore();
    void changed();
    void preview();
    void show(const Layout& layout);
    QString summary(const Layout& layout) const;

    Design m_design;
    std::string m_style;
    std::function<QImage()> m_takePicture;
    std::optional<QImage> m_picture;
    std::shared_ptr<const CutPattern> m_pattern;
    QComboBox* m_format = nullptr;
    QComboBox* m_paper = nullptr;
    QCheckBox* m_landscape = nullptr;
    QCheckBox* m_unfold = nullptr;
    NumberBox* m_allowance = nullptr;
    QGroupBox* m_lines = nullptr;
    std::vector<std::pair<QCheckBox*, bool CutLayers::*>> m_layers;
    QListWidget* m_pieces = nullptr;
    QStackedWidget* m_shown = nullptr; ///< the preview or the pages
    SheetPreview* m_preview = nullptr;
    PagesView* m_pages = nullptr;
    QLabel* m_summary = nullptr;
    CutFindingsList* m_findings = nullptr;
    QPushButton* m_export = nullptr;
    LatestJob<LayoutOrder, Layout> m_layout; ///< after all that they use
    LatestJob<CutOptions, Cut> m_job;
};

} // namespace bolster
