#include "RenderDialog.h"

#include "BakeFabric.h"
#include "PictureScene.h"
#include "PictureView.h"
#include "SavedViews.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr QSize previewSize{320, 240};
constexpr int mostPixels = 64'000'000;
constexpr int longestSide = 16384;
constexpr int checkerShown = -1; // beside ids of colourways and kinds of maps

PreviewView viewOf(const Camera& camera)
{
    PreviewView view;
    view.target = camera.target;
    view.distance = camera.distance;
    view.azimuth = camera.azimuth;
    view.elevation = camera.elevation;
    view.fieldOfView = camera.fieldOfView;
    view.perspective = camera.perspective;
    return view;
}

/// On a background of squares where it is transparent, as programs for pictures show it.
QPixmap pixmapOf(const PreviewImage& image)
{
    const QImage view(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
    return QPixmap::fromImage(view.copy());
}

} // namespace

/// Lives on the job's thread and keeps what the next picture can use again.
class RenderDialog::Studio {
public:
    explicit Studio(const Subject& subject)
        : m_subject(subject)
    {}

    Result draw(const Request& request, const std::stop_token& stop)
    {
        if (!m_renderer || m_look != request.look) {
            if (!m_cover && !request.look.rough)
                m_cover = refinedForPicture(m_subject.surface);
            m_renderer.emplace(scene(request.look));
            m_look = request.look;
        }
        Result result{
            m_renderer->render(request.view, request.options, stop), !request.path.empty(), request.look.rough, {}};
        if (result.toFile && !result.image.empty())
            result.problem = writePicture(result.image, request.format, request.path, request.notes);
        return result;
    }

private:
    PreviewScene scene(const Look& look)
    {
        const auto& [surface, design, files, maps, title, view] = m_subject;
        if (look.map)
            return sceneWithMap(surface, m_cover, coverMap(*look.map, *surface, design, files));
        if (look.checker)
            return sceneWithChecker(surface, m_cover, design, look.colourway);
        return sceneInFabrics(surface, m_cover, design, look.colourway, [&](ElementId id, const Fabric& fabric) {
            FabricMapsPtr& baked = m_baked[id];
            if (const auto found = maps.find(id); found != maps.end())
                baked = found->second;
            if (!baked && !look.rough)
                baked = bakeFabric(fabric);
            return baked;
        });
    }

    Subject m_subject;
    CoverMeshPtr m_cover;
    std::map<ElementId, FabricMapsPtr> m_baked;
    std::optional<Look> m_look;
    std::optional<PreviewRenderer> m_renderer;
};

RenderDialog::RenderDialog(Subject subject, QWidget* parent)
    : QDialog(parent)
    , m_subject(std::move(subject))
    , m_job([studio = std::make_shared<Studio>(m_subject)](
                const Request& request, const std::stop_token& stop) { return studio->draw(request, stop); },
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
    const auto side = [this](int value) {
        auto* box = new QSpinBox(this);
        box->setRange(16, longestSide);
        box->setValue(value);
        box->setSuffix(tr(" px"));
        connect(box, &QSpinBox::valueChanged, &m_pause, qOverload<>(&QTimer::start));
        return box;
    };
    m_width = side(1280);
    m_height = side(960);
    auto* size = new QHBoxLayout;
    size->addWidget(m_width);
    size->addWidget(new QLabel(QStringLiteral("\u00d7"), this));
    size->addWidget(m_height);

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
    fillShown();
    m_transparent = new QCheckBox(tr("Transparent &background"), this);
    m_transparent->setToolTip(tr("The shadow on the ground is kept"));

    auto* form = new QFormLayout;
    auto* sizeLabel = new QLabel(tr("&Size:"), this); // of a layout a form makes no buddy
    sizeLabel->setBuddy(m_width);
    form->addRow(sizeLabel, size);
    form->addRow(tr("&View:"), m_view);
    form->addRow(tr("Sho&w:"), m_shown);
    form->addRow(tr("&Quality:"), m_samples);
    form->addRow(QString(), m_transparent);
    m_message = new QLabel(this);
    m_message->setWordWrap(true);
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    QSizePolicy kept = m_progress->sizePolicy();
    kept.setRetainSizeWhenHidden(true); // nothing jumps when it appears
    m_progress->setSizePolicy(kept);
    m_progress->hide();
    auto* right = new QVBoxLayout;
    right->addLayout(form);
    right->addStretch();
    right->addWidget(m_message);
    right->addWidget(m_progress);

    m_picture = new QLabel(this);
    m_picture->setFixedSize(previewSize * 3 / 2);
    m_picture->setAlignment(Qt::AlignCenter);
    m_picture->setFrameShape(QFrame::StyledPanel);
    m_picture->setText(tr("Drawing \u2026"));
    auto* top = new QHBoxLayout;
    top->addWidget(m_picture);
    top->addLayout(right, 1);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_render = buttons->addButton(tr("&Render \u2026"), QDialogButtonBox::AcceptRole);
    m_render->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &RenderDialog::reject);
    connect(m_render, &QPushButton::clicked, this, &RenderDialog::choosePathAndRender);
    auto* all = new QVBoxLayout(this);
    all->addLayout(top);
    all->addWidget(buttons);

    for (QComboBox* box : {m_view, m_shown})
        connect(box, &QComboBox::currentIndexChanged, &m_pause, qOverload<>(&QTimer::start));
    connect(m_transparent, &QCheckBox::toggled, &m_pause, qOverload<>(&QTimer::start));
}

/// Data: a Look, as a list of colourway, checker, map.
void RenderDialog::fillShown()
{
    const Design& design = m_subject.design;
    const auto shown = QVariant::fromValue(qlonglong(design.settings().colourway));
    m_shown->addItem(tr("The fabrics as in the window"), QVariantList{shown, false, checkerShown});
    design.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        m_shown->addItem(tr("Colourway %1").arg(QString::fromStdString(colourway.name)),
                         QVariantList{QVariant::fromValue(qlonglong(id)), false, checkerShown});
    });
    m_shown->addItem(tr("Checker"), QVariantList{shown, true, checkerShown});
    for (const auto& [kind, text] : {std::pair(CoverMap::Kind::Strain, tr("Map: largest strain")),
                                     std::pair(CoverMap::Kind::Along, tr("Map: strain along the grain")),
                                     std::pair(CoverMap::Kind::Across, tr("Map: strain across the grain")),
                                     std::pair(CoverMap::Kind::Shear, tr("Map: shear")),
                                     std::pair(CoverMap::Kind::Curvature, tr("Map: mean curvature")),
                                     std::pair(CoverMap::Kind::Thickness, tr("Map: distance to the frame"))})
        m_shown->addItem(text, QVariantList{shown, false, static_cast<int>(kind)});
}

RenderDialog::Request RenderDialog::request(QSize size) const
{
    Request asked;
    const QVariantList look = m_shown->currentData().toList();
    asked.look.colourway = static_cast<ElementId>(look.at(0).toLongLong());
    asked.look.checker = look.at(1).toBool();
    if (const int map = look.at(2).toInt(); map >= 0)
        asked.look.map = static_cast<CoverMap::Kind>(map);
    asked.options.width = size.width();
    asked.options.height = size.height();
    asked.options.transparent = m_transparent->isChecked();
    asked.view = viewOf(m_subject.view);
    const QString view = m_view->currentData().toString();
    if (const auto from = pictureDirection(view.toStdString())) {
        PreviewScene scene; // of which only the box counts
        scene.surface = m_subject.surface;
        asked.view = pictureView(scene, *from, static_cast<double>(size.width()) / size.height());
    } else if (const auto saved = SavedViews::find(m_view->currentText()); saved && !view.isEmpty()) {
        asked.view = viewOf(*saved);
    }
    asked.notes.project = m_subject.title.toStdString();
    asked.notes.view = m_view->currentText().toStdString();
    return asked;
}

void RenderDialog::requestPreview()
{
    if (m_rendering)
        return;
    const bool tooLarge = static_cast<qint64>(m_width->value()) * m_height->value() > mostPixels;
    m_render->setEnabled(!tooLarge);
    m_message->setText(
        tooLarge ? tr("At most %1 million pixels are drawn; choose a smaller size.").arg(mostPixels / 1'000'000)
                 : QString());
    const QSize whole(m_width->value(), m_height->value());
    const QSize size = whole.scaled(previewSize, Qt::KeepAspectRatio).expandedTo({1, 1});
    Request asked = request(size);
    asked.options.samples = 4;
    if (std::ranges::find(m_seen, asked.look) == m_seen.end()) {
        m_seen.push_back(asked.look);
        asked.look.rough = true;
    }
    m_job.request(std::move(asked), true);
}

void RenderDialog::receive(const Result& result)
{
    if (result.image.empty())
        return;
    if (!result.toFile) {
        m_picture->setPixmap(
            pixmapOf(result.image)
                .scaled(m_picture->contentsRect().size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
        emit previewed();
        if (result.rough && !m_rendering)
            requestPreview();
        return;
    }
    setRendering(false);
    const QString problem = QString::fromStdString(result.problem);
    m_message->setText(problem.isEmpty() ? tr("The picture is written.")
                                         : tr("The picture cannot be written: %1").arg(problem));
    emit rendered(problem);
}

void RenderDialog::choosePathAndRender()
{
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Render to"), m_subject.title + QStringLiteral(".png"),
        tr("PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)"));
    if (!path.isEmpty())
        renderTo(path);
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
    asked.options.samples = m_samples->currentData().toInt();
    asked.options.light = needsLight(*format);
    asked.options.progress = [this](double share) {
        QMetaObject::invokeMethod(
            m_progress, [bar = m_progress, share] { bar->setValue(static_cast<int>(std::lround(100 * share))); },
            Qt::QueuedConnection);
    };
    setRendering(true);
    m_job.request(std::move(asked), true);
}

void RenderDialog::setRendering(bool rendering)
{
    m_rendering = rendering;
    m_progress->setValue(0);
    m_progress->setVisible(rendering);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_width, m_height, m_view, m_samples, m_shown, m_transparent, m_render})
        widget->setEnabled(!rendering);
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
