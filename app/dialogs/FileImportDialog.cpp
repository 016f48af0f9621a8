#include "FileImportDialog.h"

#include "Ask.h"
#include "FramePicture.h"
#include "NumberBox.h"
#include "PartsTree.h"
#include "PlacedFields.h"
#include "SimplifyChoice.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace bolster {

namespace {

/// Of whole millimetres none, of less what says the first two digits.
int decimalsFor(double millimetres)
{
    constexpr int most = 9;
    if (millimetres <= 0 || millimetres >= 10)
        return 0;
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(millimetres))), 0, most);
}

QString figure(double millimetres)
{
    return lengthText(millimetres, decimalsFor(millimetres));
}

QString sizeFigures(const Vec3& size)
{
    QStringList figures;
    for (const double side : size)
        figures << lengthFigure(side, decimalsFor(side));
    return figures.join(QStringLiteral(" \u00d7 ")) + lengthSuffix();
}

} // namespace

FileImportDialog::FileImportDialog(const QString& file, FileContent content, std::optional<Placement> replaced,
                                   const FileFacts& said, QWidget* parent)
    : QDialog(parent)
    , m_content(std::move(content))
    , m_shown(m_content.points())
    , m_picture(new QLabel(this))
    , m_besidePicture(new QHBoxLayout)
    , m_replaced(std::move(replaced))
    , m_saidUnit(said.millimetresPerUnit)
    , m_keep(new QCheckBox(tr("&Keep scale, position and rotation"), this))
    , m_unit(new QComboBox(this))
    , m_factor(new NumberBox(
          {tr(" mm per unit"), placedScale.box.decimals, placedScale.box.least, placedScale.box.most, 1}, this))
    , m_up(new QComboBox(this))
    , m_onFloor(new QCheckBox(tr("&Place it on the floor, in the middle"), this))
    , m_said(new QLabel(saidText(file, said), this))
    , m_size(new QLabel(this))
    , m_hint(new QLabel(this))
    , m_warning(new QLabel(this))
    , m_thinned(new QLabel(this))
{
    setWindowTitle(m_content.cloud ? tr("Import scan") : tr("Import frame"));
    if (m_content.cloud)
        setObjectName(QStringLiteral("file.import-scan")); // F1: a page of its own
    m_unit->addItems(
        {tr("Millimetres"), tr("Centimetres"), tr("Metres"), tr("Inches"), tr("Feet"), tr("Another factor")});
    m_up->addItems({tr("z points up"), tr("y points up"), tr("x points up")});
    QFont large = m_size->font();
    large.setPointSizeF(large.pointSizeF() * 1.25);
    large.setWeight(QFont::DemiBold);
    m_size->setFont(large);
    m_hint->setWordWrap(true);
    m_warning->setWordWrap(true);
    m_warning->setTextFormat(Qt::PlainText);
    m_warning->hide();
    m_thinned->setWordWrap(true);
    m_thinned->setVisible(m_content.cloud && m_content.cloud->thinnedFrom > 0);

    layOut(file);
    connectFields();
    choose(file, said);
    updateSize();
    updatePicture();
}

void FileImportDialog::offerParts(std::vector<PartOutline> tree, const std::vector<std::string>& unwanted)
{
    constexpr int usualHeight = 180, usualWidth = 240; // pixels
    if (!m_content.mesh)
        return;
    takeColors(tree);
    if (m_content.mesh->parts.size() < 2) {
        updatePicture();
        return;
    }
    if (tree.empty())
        for (const TriangleMesh::Part& part : m_content.mesh->parts)
            tree.push_back({part.name, {}, part.triangleCount});
    m_parts = new PartsTree(tree, unwanted, this);
    m_parts->setMinimumSize(usualWidth, usualHeight);
    m_besidePicture->addWidget(m_parts, 1);
    connect(m_parts, &PartsTree::changed, this, &FileImportDialog::updateShown);
    updateShown();
}

void FileImportDialog::takeColors(const std::vector<PartOutline>& tree)
{
    constexpr std::uint32_t without = 0xb8b0a5;
    std::map<std::string, std::uint32_t> known;
    for (const PartOutline& part : tree)
        if (part.color && part.triangles > 0)
            known.emplace(part.name, *part.color);
    if (known.empty())
        return;
    for (const TriangleMesh::Part& part : m_content.mesh->parts) {
        const auto color = known.find(part.name);
        m_colors.push_back(color != known.end() ? color->second : without);
    }
}

std::vector<std::string> FileImportDialog::unwantedParts() const
{
    return m_parts ? m_parts->unwanted() : std::vector<std::string>();
}

std::optional<std::size_t> FileImportDialog::wantedTriangles() const
{
    return m_simplify ? m_simplify->wanted() : std::nullopt;
}

/// Of each part of the mesh.
std::vector<bool> FileImportDialog::wantedParts() const
{
    const std::vector<std::string> names = unwantedParts();
    const std::set<std::string> unwanted(names.begin(), names.end()); // there may be 100,000
    std::vector<bool> wanted;
    for (const TriangleMesh::Part& part : m_content.mesh->parts)
        wanted.push_back(!unwanted.contains(part.name));
    return wanted;
}

/// Parts that are not wanted are not measured, either.
void FileImportDialog::updateShown()
{
    const TriangleMesh& mesh = *m_content.mesh;
    const std::vector<bool> wanted = wantedParts();
    std::vector<bool> used(mesh.points.size());
    for (std::size_t part = 0; part < wanted.size(); ++part)
        if (wanted[part])
            for (std::uint32_t i = 0; i < mesh.parts[part].triangleCount; ++i)
                for (const std::uint32_t corner : mesh.triangles[mesh.parts[part].firstTriangle + i])
                    used[corner] = true;
    m_shown.clear();
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i])
            m_shown.push_back(mesh.points[i]);
    updateSize();
    updatePicture();
}

void FileImportDialog::updatePicture()
{
    constexpr QSize pictureSize(220, 180);
    if (!m_content)
        return;
    const double fine = devicePixelRatioF();
    QImage picture = m_content.mesh ? framePicture(*m_content.mesh, wantedParts(), placement().rotation,
                                                   fine * pictureSize, m_colors)
                                    : scanPicture(*m_content.cloud, placement().rotation, fine * pictureSize);
    picture.setDevicePixelRatio(fine);
    m_picture->setPixmap(QPixmap::fromImage(picture));
}

QString FileImportDialog::aboutText(const QString& file) const
{
    const QLocale locale;
    const QString name = QFileInfo(file).fileName().toHtmlEscaped();
    const QString points = locale.toString(static_cast<qulonglong>(m_content.points().size()));
    if (!m_content.mesh)
        return tr("<b>%1</b><br>%2 points").arg(name, points);
    return tr("<b>%1</b><br>%2 points, %Ln triangles", nullptr, static_cast<int>(m_content.mesh->triangles.size()))
        .arg(name, points);
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
    form->addRow(QString(), m_said);
    form->addRow(QString(), m_onFloor);
    form->addRow(tr("Width, depth, height"), m_size);
    if (m_content.mesh && m_content.mesh->triangles.size() >= SimplifyChoice::fewest) {
        m_simplify = new SimplifyChoice(m_content.mesh->triangles.size(), this);
        form->addRow(QString(), m_simplify);
    }

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Import"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 18, 18, 14);
    layout->setSpacing(14);
    layout->addWidget(about);
    layout->addWidget(m_warning);
    layout->addWidget(m_thinned);
    m_picture->setAlignment(Qt::AlignCenter);
    m_besidePicture->setSpacing(14);
    m_besidePicture->addWidget(m_picture);
    layout->addLayout(m_besidePicture, 1);
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
    connect(m_unit, &QComboBox::activated, this, [this] {
        m_unitIsGuess = false;
        sayGuesses();
    });
    connect(m_up, &QComboBox::activated, this, [this] {
        m_axesAreGuess = false;
        sayGuesses();
    });
    connect(m_up, &QComboBox::currentIndexChanged, this, &FileImportDialog::updateSize);
    connect(m_up, &QComboBox::currentIndexChanged, this, &FileImportDialog::updatePicture);
    connect(m_keep, &QCheckBox::toggled, this, &FileImportDialog::updatePicture);
    connect(m_factor, &QDoubleSpinBox::valueChanged, this, &FileImportDialog::updateSize);
    m_factor->setKeyboardTracking(true);
}

/// What the file does not say: the unit by the kind of file if that has one, else by the size; the axes by the
/// kind.
void FileImportDialog::choose(const QString& file, const FileFacts& said)
{
    const FileUnit unit = proposedUnit(said, QFileInfo(file).suffix(), m_content.boundingBox(), largestSize());
    m_unitIsGuess = !said.millimetresPerUnit && !unitOf(QFileInfo(file).suffix());
    m_axesAreGuess = !said.up;
    m_unit->setCurrentIndex(static_cast<int>(unit));
    if (unit == FileUnit::Custom)
        m_factor->display(said.millimetresPerUnit.value_or(guessFactor(m_content.boundingBox())));
    m_up->setCurrentIndex(static_cast<int>(said.up.value_or(guessUpAxis(QFileInfo(file).suffix()))));
}

/// What the user has chosen is no guess any more.
void FileImportDialog::sayGuesses()
{
    if (m_unitIsGuess && m_axesAreGuess)
        return;
    m_said->setText(m_unitIsGuess    ? tr("The unit is guessed: look at the size.")
                    : m_axesAreGuess ? tr("The axes are guessed: look at the picture.")
                                     : QString());
}

QString FileImportDialog::saidText(const QString& file, const FileFacts& said) const
{
    const bool unit = said.millimetresPerUnit || unitOf(QFileInfo(file).suffix());
    if (unit && said.up)
        return tr("The file says its unit and its axes.");
    if (unit)
        return tr("The file says its unit; the axes are guessed.");
    return said.up ? tr("The file says its axes; the unit is guessed.")
                   : tr("Unit and axes are guessed: look at the picture and the size.");
}

/// What nobody could see is imported only on purpose.
void FileImportDialog::accept()
{
    if (!takeTyped(*this))
        return;
    const Box3 box = placedBox(m_shown, placement());
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

void FileImportDialog::warn(const QString& text)
{
    m_warning->setText(text);
    m_warning->setVisible(!text.isEmpty());
}

double FileImportDialog::largestWith(double scale) const
{
    Placement placement;
    placement.scale = scale;
    const Box3 box = placedBox(m_shown, placement);
    return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

namespace {

/// Nobody changes a frame that much.
bool isAnother(double size, double before)
{
    constexpr double most = 3;
    return before > 0 && size > 0 && (size > most * before || before > most * size);
}

} // namespace

void FileImportDialog::replaces(double largest)
{
    m_oldSize = largest;
    if (m_replaced && m_saidUnit && isAnother(largestWith(m_replaced->scale), largest) &&
        !isAnother(largestWith(*m_saidUnit), largest)) {
        m_replaced->scale = *m_saidUnit;
        m_keep->setText(tr("&Keep position and rotation"));
    }
    updateSize();
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
        const Box3 box = placedBox(m_shown, placement);
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
           "out to one every %2.")
            .arg(QLocale().toString(static_cast<qulonglong>(m_content.cloud->thinnedFrom)),
                 lengthText(m_content.cloud->spacing * placement().scale, 2)));
}

double FileImportDialog::largestSize() const
{
    return m_content.cloud ? largestScan : largestFurniture;
}

QString FileImportDialog::oddity(double largest) const
{
    if (isAnother(largest, m_oldSize))
        return tr("It was %1 large and becomes %2: check the unit.").arg(figure(m_oldSize), figure(largest));
    const bool odd = largest < 200 || largest > 1.5 * largestSize();
    return odd && m_oldSize == 0 ? tr("That is unusual for a piece of furniture: check the unit.") : QString();
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
    const Box3 box = placedBox(m_shown, placement());
    const Vec3 size = box.isEmpty() ? Vec3::Zero().eval() : box.sizes().eval();
    m_size->setText(sizeFigures(size));
    showThinning();
    m_hint->setText(oddity(size.maxCoeff()));
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, ViewColors::of(colors).error);
    m_hint->setPalette(colors);
}

} // namespace bolster
