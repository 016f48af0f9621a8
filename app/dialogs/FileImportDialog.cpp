#include "FileImportDialog.h"

#include "Ask.h"
#include "NumberBox.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// Whole millimetres, of less the first two digits.
QString figure(double millimetres)
{
    constexpr int most = 9;
    if (millimetres <= 0 || millimetres >= 10)
        return decimalText(millimetres, 0, false);
    return decimalText(millimetres, std::clamp(1 - static_cast<int>(std::floor(std::log10(millimetres))), 0, most),
                       false);
}

} // namespace

FileImportDialog::FileImportDialog(const QString& file, FileContent content, std::optional<Placement> replaced,
                                   QWidget* parent)
    : QDialog(parent)
    , m_content(std::move(content))
    , m_replaced(std::move(replaced))
    , m_keep(new QCheckBox(tr("&Keep scale, position and rotation"), this))
    , m_unit(new QComboBox(this))
    , m_factor(new NumberBox({tr(" mm per unit"), 6, 1e-6, 1e6, 1}, this))
    , m_up(new QComboBox(this))
    , m_onFloor(new QCheckBox(tr("&Place it on the floor, in the middle"), this))
    , m_size(new QLabel(this))
    , m_hint(new QLabel(this))
    , m_thinned(new QLabel(this))
{
    setWindowTitle(m_content.cloud ? tr("Import scan") : tr("Import frame"));
    m_unit->addItems({tr("Millimetres"), tr("Centimetres"), tr("Metres"), tr("Inches"), tr("Another factor")});
    m_up->addItems({tr("z points up"), tr("y points up")});
    QFont large = m_size->font();
    large.setPointSizeF(large.pointSizeF() * 1.25);
    large.setWeight(QFont::DemiBold);
    m_size->setFont(large);
    m_hint->setWordWrap(true);
    m_thinned->setWordWrap(true);
    m_thinned->setVisible(m_content.cloud && m_content.cloud->thinnedFrom > 0);

    layOut(file);
    connectFields();
    guess(file);
    updateSize();
}

QString FileImportDialog::aboutText(const QString& file) const
{
    const QLocale locale;
    const QString name = QFileInfo(file).fileName().toHtmlEscaped();
    const QString points = locale.toString(static_cast<qulonglong>(m_content.points().size()));
    if (!m_content.mesh)
        return tr("<b>%1</b><br>%2 points").arg(name, points);
    return tr("<b>%1</b><br>%2 points, %3 triangles")
        .arg(name, points, locale.toString(static_cast<qulonglong>(m_content.mesh->triangles.size())));
}

void FileImportDialog::layOut(const QString& file)
{
    auto* about = new QLabel(aboutText(file), this);
    about->setTextFormat(Qt::RichText);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    m_keep->setVisible(m_replaced.has_value());
    m_keep->setChecked(m_replaced.has_value());
    if (m_replaced)
        form->addRow(m_keep);
    form->addRow(tr("&Unit of the file"), m_unit);
    form->addRow(tr("&Factor"), m_factor);
    form->addRow(tr("A&xes"), m_up);
    form->addRow(QString(), m_onFloor);
    form->addRow(tr("Width, depth, height"), m_size);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Import"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 18, 18, 14);
    layout->setSpacing(14);
    layout->addWidget(about);
    layout->addWidget(m_thinned);
    layout->addLayout(form);
    layout->addWidget(m_hint);
    layout->addStretch();
    layout->addWidget(buttons);
    layout->addStrut(384); // with a minimum width of its own the dialog would not grow with its labels
}

void FileImportDialog::connectFields()
{
    connect(m_keep, &QCheckBox::toggled, this, &FileImportDialog::updateSize);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &FileImportDialog::updateSize);
    connect(m_up, &QComboBox::currentIndexChanged, this, &FileImportDialog::updateSize);
    connect(m_factor, &QDoubleSpinBox::valueChanged, this, &FileImportDialog::updateSize);
    m_factor->setKeyboardTracking(true);
}

/// The unit by the kind of file if that has one, else by the size; the axes by the kind of file.
void FileImportDialog::guess(const QString& file)
{
    const FileUnit unit =
        unitOf(QFileInfo(file).suffix()).value_or(guessUnit(m_content.boundingBox(), largestSize()));
    m_unit->setCurrentIndex(static_cast<int>(unit));
    if (unit == FileUnit::Custom)
        m_factor->display(guessFactor(m_content.boundingBox()));
    m_up->setCurrentIndex(static_cast<int>(guessUpAxis(QFileInfo(file).suffix())));
}

/// What nobody could see is imported only on purpose.
void FileImportDialog::accept()
{
    const Box3 box = placedBox(m_content.points(), placement());
    if (m_keep->isChecked() || isPlausible(box)) {
        QDialog::accept();
        return;
    }
    const QString size = lengthText(box.isEmpty() ? 0 : box.sizes().maxCoeff(), 6);
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Bolster"),
                        tr("It would be %1 large. Import it like that?").arg(size), QMessageBox::Cancel, this);
    question->setInformativeText(tr("Another unit or factor makes it as large as it is meant."));
    const QPushButton* import = question->addButton(tr("&Import"), QMessageBox::AcceptRole);
    question->setDefaultButton(QMessageBox::Cancel);
    openQuestion(question, [this, import](const QAbstractButton* pressed) {
        if (pressed == import)
            QDialog::accept();
    });
}

void FileImportDialog::setUnit(FileUnit unit)
{
    m_unit->setCurrentIndex(static_cast<int>(unit));
}

void FileImportDialog::setUpAxis(UpAxis up)
{
    m_up->setCurrentIndex(static_cast<int>(up));
}

Placement FileImportDialog::placement() const
{
    if (m_keep->isChecked())
        return *m_replaced;
    Placement placement;
    placement.scale = m_factor->value();
    placement.rotation = rotationFor(static_cast<UpAxis>(m_up->currentIndex()));
    if (m_onFloor->isChecked()) {
        const Box3 box = placedBox(m_content.points(), placement);
        placement.position = -Vec3(box.center().x(), box.center().y(), box.min().z());
    }
    return placement;
}

void FileImportDialog::showThinning()
{
    if (!m_content.cloud || m_content.cloud->thinnedFrom == 0)
        return;
    m_thinned->setText(
        tr("The file has %1 points. That is more than are needed to fit a cover, so they were thinned "
           "out to one every %2 mm.")
            .arg(QLocale().toString(static_cast<qulonglong>(m_content.cloud->thinnedFrom)),
                 decimalText(m_content.cloud->spacing * placement().scale, 2, false)));
}

double FileImportDialog::largestSize() const
{
    return m_content.cloud ? largestScan : largestFurniture;
}

void FileImportDialog::updateSize()
{
    const auto unit = static_cast<FileUnit>(m_unit->currentIndex());
    const bool keep = m_keep->isChecked();
    for (QWidget* field : std::initializer_list<QWidget*>{m_unit, m_up, m_onFloor})
        field->setEnabled(!keep);
    m_factor->setEnabled(!keep && unit == FileUnit::Custom);
    if (unit != FileUnit::Custom)
        m_factor->display(millimetresPer(unit));
    const Vec3 size = placedBox(m_content.points(), placement()).sizes();
    m_size->setText(tr("%1 \u00d7 %2 \u00d7 %3 mm").arg(figure(size.x()), figure(size.y()), figure(size.z())));
    showThinning();
    const bool odd = size.maxCoeff() < 200 || size.maxCoeff() > 1.5 * largestSize();
    m_hint->setText(odd ? tr("That is unusual for a piece of furniture: check the unit.") : QString());
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, ViewColors::of(colors).error);
    m_hint->setPalette(colors);
}

} // namespace bolster
