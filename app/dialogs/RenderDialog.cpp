#include "RenderDialog.h"

#include "Ask.h"
#include "Jobs.h"
#include "MapLink.h"
#include "SavedViews.h"
#include "Translated.h"
#include "WholeFile.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr QSize roughPreview{320, 240}; // is there at once

/// On a background of squares where it is transparent, as programs for pictures show it.
QPixmap pixmapOf(const PreviewImage& image)
{
    const QImage view(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
    return QPixmap::fromImage(view.copy());
}

} // namespace

RenderDialog::Result RenderDialog::drawn(PictureStudio& studio, const Request& request, const std::stop_token& stop)
{
    Result result{{}, !request.path.empty(), !request.picture.look.refined, {}};
    for (int n = 0; n < request.turntable; ++n) {
        PictureOrder order = request.picture;
        order.turn += 2 * std::numbers::pi * n / request.turntable;
        if (order.options.progress)
            order.options.progress = [&request, n](double share) {
                request.picture.options.progress((n + share) / request.turntable);
            };
        Picture picture = studio.draw(order, stop);
        result.image = std::move(picture.image);
        result.problem = picture.problem;
        if (!result.toFile || result.image.empty())
            break;
        const std::string path = request.turntable > 1 ? numberedPath(request.path, n + 1) : request.path;
        const EncodedPicture encoded = encodePicture(result.image, request.format, request.notes);
        const Message problem = encoded.problem.empty()
                                    ? replaceWholeFile(QString::fromStdString(path), encoded.bytes)
                                    : encoded.problem;
        result.problem = problem.empty() ? std::string() : translated(problem).toStdString();
        if (!result.problem.empty())
            break;
    }
    return result;
}

RenderDialog::RenderDialog(Subject subject, QWidget* parent)
    : QDialog(parent)
    , m_subject(std::move(subject))
    , m_job([studio = std::make_shared<PictureStudio>(
                 PictureStudio::Subject{m_subject.surface, m_subject.design, m_subject.files, m_subject.bake,
                                        m_subject.bakedByNow, MapLink::legend})](
                const Request& request, const std::stop_token& stop) { return drawn(*studio, request, stop); },
            [this](const Result& result) { receive(result); })
{
    build();
    m_pause.setSingleShot(true);
    m_pause.setInterval(60ms);
    connect(&m_pause, &QTimer::timeout, this, &RenderDialog::requestPreview);
    m_pause.start();
}

RenderDialog::~RenderDialog() = default;

void RenderDialog::build()
{
    setWindowTitle(tr("Render"));
    buildChoices();
    auto* right = new QVBoxLayout;
    right->addLayout(buildForm());
    right->addStretch();
    addMessages(*right);

    m_picture = new QLabel(this);
    m_picture->setAccessibleName(tr("Preview"));
    m_picture->setFixedSize(roughPreview * 3 / 2);
    m_picture->setAlignment(Qt::AlignCenter);
    m_picture->setFrameShape(QFrame::StyledPanel);
    m_picture->setText(tr("Drawing \u2026"));
    auto* top = new QHBoxLayout;
    top->addWidget(m_picture);
    top->addLayout(right, 1);
    auto* all = new QVBoxLayout(this);
    all->addLayout(top);
    all->addWidget(buildButtons());

    for (QSpinBox* box : {m_width, m_height})
        connect(box, &QSpinBox::valueChanged, &m_pause, qOverload<>(&QTimer::start));
    for (QComboBox* box : {m_view, m_shown})
        connect(box, &QComboBox::currentIndexChanged, &m_pause, qOverload<>(&QTimer::start));
    for (QCheckBox* box : {m_frames, m_transparent})
        connect(box, &QCheckBox::toggled, &m_pause, qOverload<>(&QTimer::start));
}

void RenderDialog::buildChoices()
{
    m_width = sideBox(1280);
    m_height = sideBox(960);
    m_view = new QComboBox(this);
    m_view->addItem(tr("As in the window"));
    for (const auto& [name, text] :
         {std::pair("three-quarter", tr("Three-quarter")), std::pair("front", tr("Front")),
          std::pair("back", tr("Back")), std::pair("left", tr("Left")), std::pair("right", tr("Right")),
          std::pair("top", tr("Top"))})
        m_view->addItem(text, QString::fromLatin1(name));
    for (const QString& name : SavedViews::names())
        m_view->addItem(name, QStringLiteral("saved"));
    m_samples = new QComboBox(this);
    for (const auto& [samples, text] :
         {std::pair(4, tr("Draft")), std::pair(16, tr("Good")), std::pair(64, tr("Best"))})
        m_samples->addItem(text, samples);
    m_samples->setCurrentIndex(1);
    m_samples->setToolTip(tr("How often each pixel is looked at"));
    m_shown = new QComboBox(this);
    m_shown->setObjectName(QStringLiteral("shown"));
    fillShown();
    m_turntable = new QSpinBox(this);
    m_turntable->setRange(1, 360);
    m_turntable->setSpecialValueText(tr("one picture"));
    m_turntable->setSuffix(tr(" pictures"));
    m_turntable->setToolTip(tr("So many pictures from all around, with numbers in their names"));
    m_frames = new QCheckBox(tr("&Frame and foam"), this);
    m_frames->setObjectName(QStringLiteral("frames"));
    m_frames->setToolTip(tr("In the materials that their properties say"));
    bool any = false;
    m_subject.design.each<Frame>([&](ElementId, const Frame&) { any = true; });
    m_subject.design.each<Foam>([&](ElementId, const Foam&) { any = true; });
    m_frames->setVisible(any);
    m_frames->setChecked(any);
    m_transparent = new QCheckBox(tr("Transparent &background"), this);
    m_transparent->setToolTip(tr("The shadow on the ground is kept"));
}

QSpinBox* RenderDialog::sideBox(int pixels)
{
    auto* box = new QSpinBox(this);
    box->setRange(16, largestPictureSide);
    box->setValue(pixels);
    box->setSuffix(tr(" px"));
    return box;
}

QFormLayout* RenderDialog::buildForm()
{
    auto* size = new QHBoxLayout;
    size->addWidget(m_width);
    size->addWidget(new QLabel(QStringLiteral("\u00d7"), this));
    size->addWidget(m_height);
    auto* form = new QFormLayout;
    auto* sizeLabel = new QLabel(tr("&Size:"), this); // of a layout a form makes no buddy
    sizeLabel->setBuddy(m_width);
    m_width->setAccessibleName(tr("Width"));
    m_height->setAccessibleName(tr("Height"));
    form->addRow(sizeLabel, size);
    form->addRow(tr("&View:"), m_view);
    form->addRow(tr("Sho&w:"), m_shown);
    form->addRow(tr("&Quality:"), m_samples);
    form->addRow(tr("&Around the cover:"), m_turntable);
    form->addRow(QString(), m_frames);
    form->addRow(QString(), m_transparent);
    return form;
}

void RenderDialog::addMessages(QVBoxLayout& layout)
{
    m_message = new QLabel(this);
    m_message->setTextFormat(Qt::RichText);
    m_message->setWordWrap(true);
    m_message->setOpenExternalLinks(true);
    m_message->setTextInteractionFlags(Qt::TextBrowserInteraction);
    m_message->setAccessibleName(tr("What was made"));
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    QSizePolicy kept = m_progress->sizePolicy();
    kept.setRetainSizeWhenHidden(true); // nothing jumps when it appears
    m_progress->setSizePolicy(kept);
    m_progress->hide();
    layout.addWidget(m_message);
    layout.addWidget(m_progress);
}

QDialogButtonBox* RenderDialog::buildButtons()
{
    auto* buttons = new QDialogButtonBox(this);
    m_close = buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole);
    m_render = buttons->addButton(tr("&Render \u2026"), QDialogButtonBox::AcceptRole);
    m_render->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &RenderDialog::reject);
    connect(m_render, &QPushButton::clicked, this, &RenderDialog::choosePath);
    return buttons;
}

void RenderDialog::fillShown()
{
    const auto add = [this](const QString& text, const PictureLook& look) {
        m_shown->addItem(text);
        m_looks.push_back(look);
    };
    const Design& design = m_subject.design;
    PictureLook look;
    look.colourway = design.settings().colourway;
    add(tr("The fabrics as in the window"), look);
    design.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        PictureLook own;
        own.colourway = id;
        add(tr("Colourway %1").arg(QString::fromStdString(colourway.name)), own);
    });
    if (sheetPixels(design, {}) > 0) {
        PictureLook sheet;
        sheet.sheet = true;
        add(tr("All colourways on a sheet"), sheet);
    }
    look.checker = true;
    add(tr("Checker"), look);
    look.checker = false;
    for (const CoverMap::Kind kind :
         {CoverMap::Kind::Strain, CoverMap::Kind::Along, CoverMap::Kind::Across, CoverMap::Kind::Shear,
          CoverMap::Kind::Curvature, CoverMap::Kind::Thickness}) {
        look.map = kind;
        add(tr("Map: %1").arg(MapLink::title(kind)), look);
    }
    if (!m_subject.files.clouds.empty()) {
        look.map = CoverMap::Kind::Deviation;
        add(tr("Map: %1").arg(MapLink::title(CoverMap::Kind::Deviation)), look);
    }
}

const PictureLook& RenderDialog::chosenLook() const
{
    return m_looks.at(static_cast<std::size_t>(m_shown->currentIndex()));
}

RenderDialog::Request RenderDialog::request(QSize size) const
{
    Request asked;
    PictureOrder& picture = asked.picture;
    picture.look = chosenLook();
    picture.look.frames = m_frames->isChecked();
    picture.options.width = size.width();
    picture.options.height = size.height();
    picture.options.transparent = m_transparent->isChecked();
    const QString view = m_view->currentData().toString();
    if (const auto from = pictureDirection(view.toStdString()))
        picture.from = *from;
    else if (const auto saved = SavedViews::find(m_view->currentText()); saved && !view.isEmpty())
        picture.from = RayCamera(*saved);
    else
        picture.from = RayCamera(m_subject.view);
    asked.notes.project = m_subject.title.toStdString();
    asked.notes.view = m_view->currentText().toStdString();
    return asked;
}

/// Why nothing of this size can be drawn, or "".
QString RenderDialog::sizeProblem() const
{
    const Request asked = request({m_width->value(), m_height->value()});
    const std::int64_t pixels = asked.picture.look.sheet ? sheetPixels(m_subject.design, asked.picture.options)
                                                         : std::int64_t{m_width->value()} * m_height->value();
    return pixels <= mostPicturePixels ? QString()
                                       : tr("At most %1 million pixels are drawn; choose a smaller size.")
                                             .arg(mostPicturePixels / 1'000'000);
}

void RenderDialog::requestPreview()
{
    if (m_rendering)
        return;
    const QString problem = sizeProblem();
    m_render->setEnabled(problem.isEmpty());
    m_message->setText(problem);
    m_turntable->setEnabled(!chosenLook().sheet);
    const QSize whole(m_width->value(), m_height->value());
    const auto asLargeAs = [&](QSize space) {
        return request(whole.scaled(space, Qt::KeepAspectRatio).expandedTo({1, 1}));
    };
    const QSize shown = m_picture->contentsRect().size() * devicePixelRatio();
    Request asked = asLargeAs(shown);
    asked.picture.options.samples = 4;
    PictureLook& look = asked.picture.look;
    if (!look.sheet && std::ranges::find(m_seen, look) == m_seen.end()) {
        m_seen.push_back(look);
        asked = asLargeAs(roughPreview);
        asked.picture.look.refined = false;
    }
    m_job.request(std::move(asked), true);
}

void RenderDialog::receive(const Result& result)
{
    if (result.image.empty())
        return;
    if (!result.toFile) {
        QPixmap picture = pixmapOf(result.image)
                              .scaled(m_picture->contentsRect().size() * devicePixelRatio(), Qt::KeepAspectRatio,
                                      Qt::SmoothTransformation);
        picture.setDevicePixelRatio(devicePixelRatio());
        m_picture->setPixmap(picture);
        emit previewed();
        if (result.rough && !m_rendering)
            requestPreview();
        return;
    }
    setRendering(false);
    const QString problem = QString::fromStdString(result.problem);
    m_message->setText(problem.isEmpty() ? whereItIs()
                                         : tr("The picture cannot be written: %1").arg(problem.toHtmlEscaped()));
    emit rendered(problem);
}

QString RenderDialog::whereItIs() const
{
    const QString folder = QFileInfo(m_written).absolutePath();
    return tr("The picture is written: %1").arg(QDir::toNativeSeparators(m_written).toHtmlEscaped()) +
           QStringLiteral("<br><a href=\"%1\">%2</a>")
               .arg(QString::fromUtf8(QUrl::fromLocalFile(folder).toEncoded()).toHtmlEscaped(),
                    tr("Open its folder"));
}

void RenderDialog::choosePath()
{
    askWhereToWrite(this, tr("Render to"), m_subject.proposal,
                    tr("PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)"),
                    {QStringLiteral("png"), QStringLiteral("tif"), QStringLiteral("tiff"), QStringLiteral("exr")},
                    [this](const QString& path) {
                        m_subject.proposal = path;
                        renderTo(path);
                    });
}

void RenderDialog::renderTo(const QString& path)
{
    const std::string file = path.toStdString();
    const auto format = pictureFormat(file);
    if (!format) {
        m_message->setText(tr("The name must end in .png, .tif or .exr."));
        emit rendered(m_message->text());
        return;
    }
    Request asked = request({m_width->value(), m_height->value()});
    asked.path = file;
    asked.format = *format;
    if (!asked.picture.look.sheet)
        asked.turntable = m_turntable->value();
    m_written =
        QFileInfo(asked.turntable > 1 ? QString::fromStdString(numberedPath(file, 1)) : path).absoluteFilePath();
    asked.picture.options.samples = m_samples->currentData().toInt();
    asked.picture.options.light = needsLight(*format);
    asked.picture.options.progress = [this](double share) {
        QMetaObject::invokeMethod(
            m_progress,
            [this, share] {
                m_progress->setValue(static_cast<int>(std::lround(100 * share)));
                if (m_running)
                    m_running->report(share);
            },
            Qt::QueuedConnection);
    };
    setRendering(true);
    m_running = std::make_unique<RunningJob>(tr("Drawing %1 \u2026").arg(QFileInfo(m_written).fileName()), [this] {
        if (m_rendering)
            reject();
    });
    m_job.request(std::move(asked), true);
}

void RenderDialog::setRendering(bool rendering)
{
    m_rendering = rendering;
    if (!rendering)
        m_running.reset();
    m_progress->setValue(0);
    m_progress->setVisible(rendering);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_width, m_height, m_view, m_samples, m_shown,
                                                           m_turntable, m_frames, m_transparent, m_render})
        widget->setEnabled(!rendering);
    m_close->setText(rendering ? tr("&Cancel") : tr("&Close"));
    if (rendering)
        m_message->setText(tr("Drawing \u2026"));
}

void RenderDialog::reject()
{
    if (!m_rendering) {
        QDialog::reject();
        return;
    }
    m_job.cancel();
    setRendering(false);
    m_message->setText(tr("Cancelled; nothing was written."));
    emit rendered(m_message->text());
}

} // namespace bolster
