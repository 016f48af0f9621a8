#include "ColourwayWindow.h"

#include "ColourwayEdits.h"
#include "CoverView.h"
#include "ElementText.h"
#include "FabricLink.h"
#include "VersionPane.h"

#include <QComboBox>
#include <QShortcut>
#include <QSplitter>
#include <QVBoxLayout>

namespace bolster {

ColourwayWindow::ColourwayWindow(Document& document, const DesignFiles& files, FabricLink& link, SolverLink& solver,
                                 QWidget* parent)
    : QWidget(parent, Qt::Window)
    , m_document(document)
    , m_files(files)
    , m_link(link)
{
    setWindowTitle(tr("Compare colourways"));
    setAttribute(Qt::WA_DeleteOnClose); // what it shows is large
    connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
    auto* panes = new QSplitter(Qt::Horizontal);
    for (Side& side : m_sides) {
        side = {new QComboBox, new VersionPane};
        side.pane->showForLooks();
        side.pane->follow(solver);
        auto* part = new QWidget;
        auto* layout = new QVBoxLayout(part);
        layout->setContentsMargins(6, 6, 6, 6);
        side.choice->setToolTip(tr("The colourway that is shown below"));
        layout->addWidget(side.choice);
        layout->addWidget(side.pane, 1);
        panes->addWidget(part);
        connect(side.choice, &QComboBox::activated, this, [this, &side] { display(side); });
    }
    // What is compared is looked at from one place.
    for (const int i : {0, 1}) {
        CoverView& other = pane(1 - i).coverView();
        connect(&pane(i).coverView().navigation(), &CoverNavigation::moved, this,
                [this, &other](const Camera& camera) {
                    if (std::exchange(m_following, true))
                        return;
                    other.navigation().setCamera(camera);
                    m_following = false;
                });
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(panes);
    resize(1200, 760);
    connect(&link, &FabricLink::changed, this, [this] {
        for (const Side& side : m_sides)
            side.pane->setFabrics(m_link.maps());
    });
    connect(&document, &Document::historyChanged, this, [this] {
        if (isVisible())
            refill();
    });
}

void ColourwayWindow::compare()
{
    refill();
    const ElementId shown = m_document.design().settings().colourway;
    choice(0).setCurrentIndex(0);
    const int other = choice(1).findData(static_cast<int>(shown));
    choice(1).setCurrentIndex(other > 0 ? other : choice(1).count() > 1 ? 1 : 0);
    for (const Side& side : m_sides)
        display(side);
}

void ColourwayWindow::refill()
{
    const Design& design = m_document.committed();
    for (const Side& side : m_sides) {
        const QVariant before = side.choice->currentData();
        side.choice->clear();
        side.choice->addItem(tr("As made"), static_cast<int>(noElement));
        design.each<Colourway>([&](ElementId id, const Colourway&) {
            side.choice->addItem(displayName(design, id), static_cast<int>(id));
        });
        side.choice->setCurrentIndex(std::max(0, side.choice->findData(before)));
        if (isVisible())
            display(side);
    }
}

void ColourwayWindow::display(const Side& side)
{
    const Design& design = m_document.committed();
    const auto colourway = static_cast<ElementId>(side.choice->currentData().toInt());
    side.pane->setVersion(side.choice->currentText(), design.with(edits::showColourway(design, colourway)),
                          m_files);
    side.pane->setFabrics(m_link.maps());
}

} // namespace bolster
