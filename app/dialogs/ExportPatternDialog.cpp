#include "ExportPatternDialog.h"

#include "AllowanceFields.h"
#include "CutLabelWords.h"
#include "DescribedField.h"
#include "NumberBox.h"
#include "Units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

namespace {

const QString formatKey = QStringLiteral("export-pattern/format");
const QString paperKey = QStringLiteral("export-pattern/paper");
const QString landscapeKey = QStringLiteral("export-pattern/landscape");
const QString unfoldKey = QStringLiteral("export-pattern/two-pieces");

} // namespace

ExportPatternDialog::ExportPatternDialog(Design design, const QString& style, std::function<QImage()> takePicture,
                                         QWidget* parent)
    : QDialog(parent)
    , m_design(std::move(design))
    , m_style(style.toStdString())
    , m_takePicture(std::move(takePicture))
    , m_layout([design = m_design](const LayoutOrder& order,
                                   const std::stop_token& stop) { return laidOut(design, order, stop); },
               [this](const Layout& layout) { show(layout); })
    , m_job(
          [design = m_design](const CutOptions& options, const std::stop_token& stop) {
              const auto pattern = std::make_shared<const CutPattern>(cutPattern(design, options, stop));
              return Cut{pattern, checkCutting(design, *pattern, stop)};
          },
          [this](const Cut& cut) {
              m_pattern = cut.pattern;
              m_findings->setVisible(!cut.findings.empty());
              m_findings->setFindings(m_design, cut.findings);
              preview();
          })
{
    setWindowTitle(tr("Export pattern"));
    build();
    changed();
}

void ExportPatternDialog::build()
{
    auto* right = new QVBoxLayout;
    right->addWidget(buildChoices());
    right->addWidget(buildLines());
    buildPieces();
    auto* pieces = new QGroupBox(tr("Pieces"), this);
    (new QVBoxLayout(pieces))->addWidget(m_pieces);
    right->addWidget(pieces, 1);
    auto* top = new QHBoxLayout;
    top->addWidget(buildPreview(), 1);
    top->addLayout(right);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_export = buttons->addButton(tr("&Export \u2026"), QDialogButtonBox::AcceptRole);
    m_export->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* all = new QVBoxLayout(this);
    all->addLayout(top, 1);
    all->addWidget(buttons);
    chooseAsBefore();
}

void ExportPatternDialog::chooseAsBefore()
{
    const QSettings settings;
    const int format = settings.value(formatKey, 0).toInt();
    m_format->setCurrentIndex(std::clamp(format, 0, m_format->count() - 1));
    if (const int paper = m_paper->findData(settings.value(paperKey)); paper >= 0)
        m_paper->setCurrentIndex(paper);
    m_landscape->setChecked(settings.value(landscapeKey, false).toBool());
    m_unfold->setChecked(settings.value(unfoldKey, false).toBool());
}

void ExportPatternDialog::accept()
{
    if (takeTyped(*this))
        QDialog::accept();
}

void ExportPatternDialog::done(int result)
{
    QSettings settings;
    settings.setValue(formatKey, m_format->currentIndex());
    settings.setValue(paperKey, m_paper->currentData());
    settings.setValue(landscapeKey, m_landscape->isChecked());
    settings.setValue(unfoldKey, m_unfold->isChecked());
    QDialog::done(result);
}

QWidget* ExportPatternDialog::buildPreview()
{
    auto* left = new QWidget(this);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins({});
    m_preview = new SheetPreview(left);
    m_pages = new PagesView(left);
    m_shown = new QStackedWidget(left);
    m_shown->addWidget(m_preview);
    m_shown->addWidget(m_pages);
    m_summary = new QLabel(left);
    m_summary->setWordWrap(true);
    m_findings = new CutFindingsList(left);
    m_findings->setToolTip(tr("A double click leaves this window and shows where it is; the whole list is in the "
                              "panel \"Check before cutting\"."));
    m_findings->setMaximumHeight(110);
    m_findings->hide();
    connect(m_findings, &CutFindingsList::chosen, this, [this](const CutFinding& finding) {
        reject(); // it lies over the place, and nothing could be mended there
        emit placeWanted(finding.problem.element, finding.patch, finding.place);
    });
    column->addWidget(m_shown, 1);
    column->addWidget(m_summary);
    column->addWidget(m_findings);
    return left;
}

QWidget* ExportPatternDialog::buildChoices()
{
    m_format = new QComboBox(this);
    m_format->setObjectName(QStringLiteral("format"));
    m_format->addItems({tr("PDF \u2013 to print and put together"), tr("DXF AAMA \u2013 for cutters"),
                        tr("DXF ASTM \u2013 for cutters"), tr("DXF, plain lines"), tr("DXF, plain curves (R2000)"),
                        tr("SVG \u2013 1:1"), tr("HPGL \u2013 for plotters"), tr("Sewing sheet (PDF)")});
    m_paper = new QComboBox(this);
    m_paper->setObjectName(QStringLiteral("paper"));
    for (const QString& name : paperNames())
        m_paper->addItem(name, name);
    for (const int width : {600, 900, 1400, 1800})
        m_paper->addItem(tr("Roll, %1 mm wide").arg(width), QStringLiteral("roll:%1").arg(width));
    m_landscape = new QCheckBox(tr("&Landscape"), this);
    m_unfold = new QCheckBox(tr("Mirrored pairs as &two pieces"), this);
    const CutAllowance usual;
    m_allowance = new NumberBox(describedField(usual, &usual.width).range(), this);
    m_allowance->setObjectName(QStringLiteral("allowance"));
    const auto& said = m_design.settings().cutting.allowance;
    m_allowance->display(said.value_or(usual).width);
    m_allowance->setEnabled(!said);
    m_allowance->setToolTip(said ? tr("The design says it; it is changed in its properties.")
                                 : tr("Of patches and edges that have none of their own."));

    auto* group = new QGroupBox(tr("File"), this);
    auto* form = new QFormLayout(group);
    form->addRow(tr("&Format"), m_format);
    form->addRow(tr("&Paper"), m_paper);
    form->addRow(QString(), m_landscape);
    form->addRow(tr("Seam &allowance"), m_allowance);
    form->addRow(QString(), m_unfold);
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportPatternDialog::preview);
    connect(m_paper, &QComboBox::currentIndexChanged, this, &ExportPatternDialog::preview);
    connect(m_landscape, &QCheckBox::toggled, this, &ExportPatternDialog::preview);
    connect(m_unfold, &QCheckBox::toggled, this, &ExportPatternDialog::changed);
    connect(m_allowance, &NumberBox::entered, this, &ExportPatternDialog::changed);
    return group;
}

QWidget* ExportPatternDialog::buildLines()
{
    m_lines = new QGroupBox(tr("Lines"), this);
    auto* grid = new QGridLayout(m_lines);
    const std::pair<QString, bool CutLayers::*> lines[] = {
        {tr("C&ut lines"), &CutLayers::cut},    {tr("Sewing li&nes"), &CutLayers::sew},
        {tr("Notc&hes"), &CutLayers::notches},  {tr("&Grain lines"), &CutLayers::grain},
        {tr("La&bels"), &CutLayers::labels},    {tr("&Internal lines"), &CutLayers::internal},
        {tr("&Drill holes"), &CutLayers::holes}};
    int place = 0;
    for (const auto& [text, layer] : lines) {
        auto* box = new QCheckBox(text, this);
        box->setChecked(true);
        connect(box, &QCheckBox::toggled, this, &ExportPatternDialog::preview);
        grid->addWidget(box, place / 2, place % 2);
        m_layers.emplace_back(box, layer);
        ++place;
    }
    return m_lines;
}

void ExportPatternDialog::buildPieces()
{
    m_pieces = new QListWidget(this);
    m_pieces->setAccessibleName(tr("Pieces"));
    m_design.each<Patch>([this](ElementId id, const Patch& patch) {
        auto* item = new QListWidgetItem(QString::fromStdString(patch.name), m_pieces);
        item->setData(Qt::UserRole, static_cast<qlonglong>(number(id)));
        item->setCheckState(Qt::Checked);
    });
    connect(m_pieces, &QListWidget::itemChanged, this, &ExportPatternDialog::changed);
}

PatternOrder ExportPatternDialog::order() const
{
    PatternOrder order;
    order.format = static_cast<PatternFormat>(m_format->currentIndex());
    order.paper = paperSize(m_paper->currentData().toString()).value_or(PaperSize());
    order.landscape = m_landscape->isChecked();
    for (const auto& [box, layer] : m_layers)
        order.layers.*layer = box->isChecked();
    order.cutting.allowance = m_allowance->value();
    order.cutting.unfold = m_unfold->isChecked();
    order.cutting.style = m_style;
    order.cutting.words = cutLabelWords();
    std::set<ElementId> chosen;
    for (int row = 0; row < m_pieces->count(); ++row)
        if (m_pieces->item(row)->checkState() == Qt::Checked)
            chosen.insert(static_cast<ElementId>(m_pieces->item(row)->data(Qt::UserRole).toLongLong()));
    order.cutting.only = std::move(chosen);
    return order;
}

/// Other pieces, not only other sheets.
void ExportPatternDialog::changed()
{
    m_pattern = nullptr;
    m_export->setEnabled(false);
    m_layout.cancel();
    m_job.request(order().cutting, true);
}

void ExportPatternDialog::preview()
{
    const PatternOrder order = this->order();
    const bool isSewing = order.format == PatternFormat::SewingSheet, sheets = hasSheets(order.format);
    m_paper->setEnabled(sheets || isSewing || order.format == PatternFormat::Hpgl);
    m_landscape->setEnabled(sheets && !order.paper.roll);
    m_lines->setEnabled(!isSewing);
    m_export->setEnabled(false);
    if (!m_pattern)
        return;
    if (isSewing && !m_picture)
        m_picture = m_takePicture();
    m_layout.request({m_pattern, order, picture()}, true);
}

ExportPatternDialog::Layout ExportPatternDialog::laidOut(const Design& design, const LayoutOrder& wanted,
                                                         const std::stop_token& stop)
{
    constexpr int pageWidth = 1000, mostPages = 20; // pixels; more than these nobody looks at here
    const PatternOrder& order = wanted.order;
    Layout layout{order, nullptr, {}, 0};
    SheetPlan plan;
    if (hasSheets(order.format))
        plan = planSheets(*wanted.pattern, {order.paper, order.landscape, order.layers}, stop);
    else if (order.format == PatternFormat::SewingSheet)
        layout.pages =
            sewingPages(design, order, wanted.picture, pageWidth, mostPages, layout.allPages, {stop, {}});
    else
        plan.table =
            arranged(*wanted.pattern, order.format == PatternFormat::Hpgl ? tableWidth(order.paper, order.landscape)
                                                                          : usualTableWidth);
    layout.plan = std::make_shared<const SheetPlan>(std::move(plan));
    return layout;
}

QString ExportPatternDialog::summary(const Layout& layout) const
{
    QString said;
    if (layout.order.format == PatternFormat::SewingSheet) {
        said = tr("%n pages", nullptr, layout.allPages);
        if (const int shown = static_cast<int>(layout.pages.size()); shown < layout.allPages)
            said += QStringLiteral(" \u2013 ") + tr("the first %1 are shown").arg(shown);
    } else {
        const Vec2 size = layout.plan->table.size;
        said = tr("%n pieces on %1", nullptr, static_cast<int>(m_pattern->pieces.size()))
                   .arg(sizeText(size.x(), size.y()));
    }
    if (layout.plan->tooMany())
        said += QStringLiteral(" \u2013 ") + tr("too many sheets: is its unit right?");
    else if (hasSheets(layout.order.format))
        said += QStringLiteral(", ") + tr("%n pages", nullptr, layout.plan->pages());
    if (!m_pattern->leftOut.empty())
        said += QStringLiteral(" \u2013 ") + tr("%n patches are left out: their outlines cross themselves", nullptr,
                                                static_cast<int>(m_pattern->leftOut.size()));
    return said;
}

void ExportPatternDialog::show(const Layout& layout)
{
    if (!m_pattern) // other pieces are on their way
        return;
    if (layout.order.format == PatternFormat::SewingSheet) {
        m_pages->showPages(layout.pages, tr("There is nothing to cut."));
        m_shown->setCurrentWidget(m_pages);
    } else {
        m_preview->show({m_pattern, layout.plan, layout.order.layers});
        m_shown->setCurrentWidget(m_preview);
    }
    m_summary->setText(summary(layout));
    m_summary->setMinimumHeight(
        m_summary->heightForWidth(m_summary->width())); // letters of another font may be taller
    m_export->setEnabled(!layout.plan->tooMany() && !m_pattern->pieces.empty());
}

} // namespace bolster
