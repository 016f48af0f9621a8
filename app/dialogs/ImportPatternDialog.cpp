#include "ImportPatternDialog.h"

#include "Ask.h"
#include "FoundPiecesView.h"
#include "NumberBox.h"
#include "Translated.h"
#include "Units.h"
#include "ViewColors.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bolster {

namespace {

constexpr int unitName = Qt::UserRole + 1; // without its measures
constexpr int mostAtOnce = 2000;           // pieces: the window would stand still with more

/// Of the chosen ones; of all where none is chosen.
Vec2 largestPiece(const FoundPattern& pattern, const std::set<std::size_t>& chosen)
{
    Vec2 largest = Vec2::Zero();
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i)
        if (const Vec2 size = pattern.pieces[i].cut.box().sizes();
            size.prod() > largest.prod() && (chosen.empty() || chosen.contains(i)))
            largest = size;
    return largest;
}

/// "3 x HATCH, 2 x 3DFACE", the first few of them.
QString listed(const std::map<std::string, int>& counts)
{
    constexpr int most = 8;
    QStringList names;
    for (const auto& [name, count] : counts)
        names << QStringLiteral("%1 \u00d7 %2")
                     .arg(QLocale().toString(count),
                          name.empty() ? QStringLiteral("\u2013") : QString::fromStdString(name));
    const QString more = names.size() > most ? QStringLiteral(" \u2026") : QString();
    return names.mid(0, most).join(QStringLiteral(", ")) + more;
}

} // namespace

ImportPatternDialog::ImportPatternDialog(Drawing drawing, const QString& file, QWidget* parent)
    : QDialog(parent)
    , m_file(QFileInfo(file).fileName())
    , m_drawing(std::make_shared<const Drawing>(std::move(drawing)))
    , m_job(
          [drawing = m_drawing](PieceOrder order, const std::stop_token&) -> std::shared_ptr<const FoundPattern> {
              if (!(order.unit > 0))
                  order.unit = guessedUnit(*drawing);
              return std::make_shared<const FoundPattern>(findPieces(*drawing, order));
          },
          [this](std::shared_ptr<const FoundPattern> pattern) { showPattern(std::move(pattern)); })
{
    setWindowTitle(tr("Import pattern"));
    build();
    rememberUnit();
    changed();
}

void ImportPatternDialog::build()
{
    m_view = new FoundPiecesView(this);
    m_odd = new QLabel(this);
    m_odd->setWordWrap(true);
    m_odd->setObjectName(QStringLiteral("odd"));
    auto* left = new QVBoxLayout;
    left->addWidget(m_view, 1);
    left->addWidget(m_odd);

    m_pieces = new QListWidget(this);
    m_pieces->setAccessibleName(tr("Pieces"));
    m_pieces->setObjectName(QStringLiteral("pieces"));
    auto* pieces = new QGroupBox(tr("Pieces"), this);
    (new QVBoxLayout(pieces))->addWidget(m_pieces);
    auto* right = new QVBoxLayout;
    auto* about = new QLabel(QStringLiteral("<b>%1</b>").arg(m_file.toHtmlEscaped()), this);
    about->setTextFormat(Qt::RichText);
    right->addWidget(about);
    right->addWidget(buildChoices());
    right->addWidget(pieces, 1);
    auto* top = new QHBoxLayout;
    top->addLayout(left, 1);
    top->addLayout(right);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_import = buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
    m_import->setDefault(true);
    m_import->setEnabled(false);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_pieces, &QListWidget::itemChanged, this, &ImportPatternDialog::choose);
    connect(m_pieces, &QListWidget::currentRowChanged, this, &ImportPatternDialog::choose);
    connect(m_view, &FoundPiecesView::pressed, m_pieces, [this](int piece) { m_pieces->setCurrentRow(piece); });
    auto* all = new QVBoxLayout(this);
    all->addLayout(top, 1);
    all->addWidget(buttons);
}

QWidget* ImportPatternDialog::buildChoices()
{
    m_unit = new QComboBox(this);
    m_unit->setObjectName(QStringLiteral("unit"));
    m_unit->setSizeAdjustPolicy(QComboBox::AdjustToContents); // with the measures that come later
    addUnit(tr("Millimetres"), 1);
    addUnit(tr("Centimetres"), 10);
    addUnit(tr("Inches"), 25.4);
    addUnit(tr("Metres"), 1000);
    if (m_drawing->usualUnit) {
        addUnit(tr("Pixels (1/96 inch)"), 25.4 / 96);
        addUnit(tr("Points (1/72 inch)"), 25.4 / 72);
    }
    m_measures = new QLabel(this);
    m_measures->setObjectName(QStringLiteral("measures"));
    QFont large = m_measures->font();
    large.setWeight(QFont::DemiBold);
    m_measures->setFont(large);
    m_size = new QComboBox(this);
    m_size->setObjectName(QStringLiteral("size"));
    m_lines = new QComboBox(this);
    m_lines->setObjectName(QStringLiteral("lines"));
    m_lines->addItems({tr("Sewing lines, with allowances"), tr("Cut lines, without allowance")});
    m_lines->setToolTip(tr("What the outlines of patches become where the file has both lines."));
    m_gap = new NumberBox({millimetreSuffix, 2, 0, 1000, 1}, this);
    m_gap->setObjectName(QStringLiteral("gap"));
    m_gap->setToolTip(tr("Outlines whose ends are no farther apart are closed by a straight line."));

    auto* group = new QGroupBox(tr("File"), this);
    auto* form = new QFormLayout(group);
    form->addRow(tr("&Unit of the file"), m_unit);
    form->addRow(tr("Largest piece"), m_measures);
    form->addRow(tr("&Size"), m_size);
    form->addRow(tr("&Outlines"), m_lines);
    form->addRow(tr("&Close gaps up to"), m_gap);
    connect(m_unit, &QComboBox::activated, this, &ImportPatternDialog::changed);
    connect(m_size, &QComboBox::activated, this, &ImportPatternDialog::changed);
    connect(m_gap, &NumberBox::entered, this, &ImportPatternDialog::changed);
    return group;
}

/// Programs mean different things by "METRIC": what was chosen for the same program before is right again.
QString ImportPatternDialog::product() const
{
    for (const std::string& words : m_drawing->texts)
        if (words.starts_with("Product:") || words.starts_with("PRODUCT:"))
            return QString::fromStdString(words.substr(8)).trimmed().left(80).replace(u'/', u'-');
    return {};
}

/// Until something is chosen it is guessed, with the pieces.
void ImportPatternDialog::rememberUnit()
{
    m_unit->setCurrentIndex(-1);
    if (const QString program = product(); !m_drawing->unit && !program.isEmpty())
        if (const double unit = QSettings().value(QStringLiteral("import/unit/") + program).toDouble(); unit > 0)
            chooseUnit(unit);
}

void ImportPatternDialog::chooseUnit(double unit)
{
    int index = 0;
    while (index < m_unit->count() && std::abs(m_unit->itemData(index).toDouble() - unit) > 1e-6 * unit)
        ++index;
    if (index == m_unit->count())
        addUnit(tr("%1 mm").arg(numberLocale().toString(unit)), unit);
    m_unit->setCurrentIndex(index);
}

void ImportPatternDialog::addUnit(const QString& name, double size)
{
    m_unit->addItem(name, size);
    m_unit->setItemData(m_unit->count() - 1, name, unitName);
}

PieceOrder ImportPatternDialog::order() const
{
    return {m_unit->currentData().toDouble(), m_size->currentText().toStdString(), m_gap->value()};
}

void ImportPatternDialog::changed()
{
    m_import->setEnabled(false);
    m_job.request(order());
}

void ImportPatternDialog::showPattern(std::shared_ptr<const FoundPattern> pattern)
{
    m_pattern = std::move(pattern);
    m_unitShown = m_pattern->unit;
    if (m_unit->currentIndex() < 0)
        chooseUnit(m_unitShown);
    showSizes();
    showPieces();
    tellWhatIsOdd();
    choose();
}

void ImportPatternDialog::showSizes()
{
    if (m_size->count() > 0 || m_pattern->sizes.empty()) {
        m_size->setEnabled(m_size->count() > 1);
        return;
    }
    for (const std::string& size : m_pattern->sizes)
        m_size->addItem(QString::fromStdString(size));
    m_size->setCurrentText(QString::fromStdString(m_pattern->sampleSize));
    m_size->setEnabled(m_size->count() > 1);
}

/// Each unit with the measures that it would give.
void ImportPatternDialog::showUnits()
{
    const Vec2 size = largestPiece(*m_pattern, chosen());
    const auto measures = [&](double unit) {
        const Vec2 now = size * (unit / m_unitShown);
        return sizeText(now.x(), now.y());
    };
    for (int i = 0; i < m_unit->count(); ++i) {
        const QString name = m_unit->itemData(i, unitName).toString();
        m_unit->setItemText(
            i, size.maxCoeff() > 0 ? tr("%1: %2").arg(name, measures(m_unit->itemData(i).toDouble())) : name);
    }
    m_measures->setText(measures(m_unitShown));
    const bool odd = size.maxCoeff() > 0 && (size.maxCoeff() < 100 || size.maxCoeff() > 5000);
    QPalette colors = palette();
    if (odd)
        colors.setColor(QPalette::WindowText, ViewColors::of(colors).error);
    m_measures->setPalette(colors);
}

void ImportPatternDialog::showPieces()
{
    const QSignalBlocker quiet(m_pieces);
    const bool tooMany = std::ssize(m_pattern->pieces) > mostAtOnce;
    std::set<QString> unchecked;
    std::vector<bool> byRow; // of so many, names tell nothing
    for (int row = 0; row < m_pieces->count(); ++row) {
        byRow.push_back(m_pieces->item(row)->checkState() == Qt::Unchecked);
        if (byRow.back())
            unchecked.insert(m_pieces->item(row)->data(Qt::UserRole).toString());
    }
    const auto isUnchecked = [&](std::size_t row, const QString& name) {
        if (!tooMany)
            return unchecked.contains(name);
        return byRow.size() == m_pattern->pieces.size() ? byRow[row] : row >= mostAtOnce;
    };
    m_pieces->clear();
    for (const FoundPiece& piece : m_pattern->pieces) {
        const QString name = QString::fromStdString(piece.name);
        const Vec2 size = piece.cut.box().sizes();
        QString text = tr("%1 \u2013 %2").arg(name, sizeText(size.x(), size.y()));
        if (piece.pair)
            text += tr(", %n pairs", nullptr, static_cast<int>(piece.quantity));
        else if (piece.quantity > 1)
            text += tr(", %n times", nullptr, static_cast<int>(piece.quantity));
        auto* item = new QListWidgetItem(text, m_pieces);
        item->setData(Qt::UserRole, name);
        item->setCheckState(isUnchecked(static_cast<std::size_t>(m_pieces->count() - 1), name) ? Qt::Unchecked
                                                                                               : Qt::Checked);
    }
}

/// Nothing is left out silently.
void ImportPatternDialog::tellWhatIsOdd()
{
    QStringList lines;
    if (std::ssize(m_pattern->pieces) > mostAtOnce)
        lines << tr("%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.")
                     .arg(m_file, QLocale().toString(m_pattern->pieces.size()), QLocale().toString(mostAtOnce));
    if (!m_pattern->open.empty()) {
        double gap = 0;
        for (const Contour& line : m_pattern->open)
            gap = std::max(gap, line.gap);
        lines << tr("%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are "
                    "outlines.",
                    nullptr, static_cast<int>(m_pattern->open.size()))
                     .arg(steadyLengthText(gap, gap < 10 ? 2 : 0));
    }
    if (m_pattern->doubled > 0)
        lines << tr("%n lines lay twice on themselves and are taken once.", nullptr, m_pattern->doubled);
    for (const Message& note : m_drawing->notes)
        lines << asSentence(translated(note));
    if (!m_drawing->unknown.empty())
        lines << tr("Not read: %1").arg(listed(m_drawing->unknown));
    if (!m_pattern->outside.empty())
        lines << tr("In no piece and left out, by layer: %1").arg(listed(m_pattern->outside));
    if (!m_pattern->ignored.empty())
        lines << tr("Marks of grading, stripes or nothing that is known, left out by layer: %1")
                     .arg(listed(m_pattern->ignored));
    if (!m_drawing->unit && !m_pattern->pieces.empty())
        lines << tr("The file does not say its unit for certain: look at the measures.");
    m_odd->setText(lines.join(u'\n'));
    m_odd->setVisible(!lines.isEmpty());
}

std::set<std::size_t> ImportPatternDialog::chosen() const
{
    std::set<std::size_t> found;
    for (int row = 0; row < m_pieces->count(); ++row)
        if (m_pieces->item(row)->checkState() == Qt::Checked)
            found.insert(static_cast<std::size_t>(row));
    return found;
}

void ImportPatternDialog::choose()
{
    if (m_pattern)
        showUnits();
    m_view->show(m_pattern, chosen(), m_pieces->currentRow());
    const bool sews = m_pattern && std::ranges::any_of(m_pattern->pieces, [](const FoundPiece& piece) {
                          return piece.sew.has_value();
                      });
    m_lines->setEnabled(sews);
    const std::set<std::size_t> taken = chosen();
    m_import->setEnabled(m_pattern && !taken.empty() && std::ssize(taken) <= mostAtOnce);
}

PatternChoice ImportPatternDialog::choice() const
{
    return {m_lines->currentIndex() == 1 ? PatternLines::Cut : PatternLines::Sew, chosen()};
}

void ImportPatternDialog::accept()
{
    if (!takeTyped(*this))
        return;
    if (const QString program = product(); !program.isEmpty())
        QSettings().setValue(QStringLiteral("import/unit/") + program, m_unit->currentData().toDouble());
    QDialog::accept();
}

} // namespace bolster
