#include "PatternView.h"

#include "Document.h"
#include "DrawingKeys.h"
#include "MouseStyle.h"
#include "PatternRulers.h"
#include "Selection.h"
#include "SelectionSteps.h"
#include "Units.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QToolTip>

namespace bolster {

namespace {

constexpr double clickReach = 5; ///< pixels

} // namespace

PatternView::PatternView(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_shown(document, selection, problems, ViewColors::of(palette()))
    , m_navigation(m_shown.scene(), selection, *this)
    , m_pan(m_navigation)
    , m_crosshair(m_shown, m_navigation, *this)
    , m_margins(m_shown.scene(), m_navigation, m_aids, *this)
    , m_tools(document, selection, m_shown, m_navigation, m_aids, *this)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(200, 160);
    setAttribute(Qt::WA_OpaquePaintEvent);
    wire();
    m_whole = true;
}

PatternView::~PatternView()
{
    m_whole = false;
    m_shown.disconnect(&m_tools); // a tool that is taken away may take back what it has begun
}

void PatternView::wire()
{
    connect(&m_shown, &ShownPattern::changed, &m_tools, &ToolHost::refresh);
    connect(&m_shown, &ShownPattern::layersChanged, this, [this] { m_aids.setGrid(m_shown.layers().grid); });
    connect(&m_aids, &DrawingAids::changed, &m_tools, &ToolHost::refresh);
    connect(&m_navigation, &PatternNavigation::moved, this, [this] { m_crosshair.place(); });
    connect(&m_navigation, &PatternNavigation::moved, &m_tools, &ToolHost::refresh);
    connect(&m_margins, &PatternMargins::freeRoomChanged, this, &PatternView::freeRoomChanged);
    connect(&m_margins, &PatternMargins::pointerMoved, this, &PatternView::pointerMoved);
    connect(this, &PatternView::pointerMoved, &m_margins, &PatternMargins::showPointer);
    connect(&m_tools, &ToolHost::refreshed, this, &PatternView::refreshed);
    connect(&NumberStyles::instance(), &NumberStyles::changed, &m_tools, &ToolHost::refresh);
    connect(&MouseStyles::instance(), &MouseStyles::changed, &m_tools, &ToolHost::refresh);
    m_tools.speakThrough(*this);
}

void PatternView::refreshed()
{
    setCursor(m_pan.cursor().value_or(m_tools.tool().cursor()));
    m_margins.update();
    update();
}

void PatternView::setMap(const ShownMapPtr& map)
{
    m_shown.setMap(map);
    m_margins.setMap(map);
}

void PatternView::reveal(const CoverPoint& point)
{
    if (const std::optional<Vec2> place = m_shown.placeOf(point))
        m_navigation.reveal(*place);
}

void PatternView::paintEvent(QPaintEvent*)
{
    const ViewColors colors = ViewColors::of(palette());
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    QPainter painter(this);
    m_shown.paint(painter, m_navigation.transform(), small, size());
    paintBackground(painter, m_aids.background(), m_navigation.transform(), colors.dark);
    paintGuides(painter, m_aids.snapSettings().guides, m_navigation.transform(), size(), colors);
    paintArrows(painter, m_arrows, m_navigation.transform(), colors);
    m_tools.tool().paint(painter, colors);
}

void PatternView::showArrows(PatternArrows arrows)
{
    m_arrows = std::move(arrows);
    update();
}

void PatternView::resizeEvent(QResizeEvent* event)
{
    m_margins.place();
    m_navigation.resize(event->oldSize());
    m_crosshair.place();
}

void PatternView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        m_shown.setColors(ViewColors::of(palette()));
    QWidget::changeEvent(event);
}

bool PatternView::event(QEvent* event)
{
    return m_whole ? m_tools.guard([&] { return handle(event); }) : QWidget::event(event);
}

bool PatternView::handle(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto& help = static_cast<const QHelpEvent&>(*event);
        if (tool() == PatternToolKind::Select) // the others write beside the pointer themselves
            QToolTip::showText(help.globalPos(), m_shown.toolTip(hit(help.pos())), this);
        return true;
    }
    if (event->type() == QEvent::NativeGesture) {
        const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture)
            m_navigation.setTransform(m_navigation.transform().zoomed(gesture.position(), 1 + gesture.value()));
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        // Space and the arrows are ours even where a window gives them another meaning.
        const auto* pressed = static_cast<QKeyEvent*>(event);
        const int key = pressed->key();
        if (isDigitKey(key) && (pressed->modifiers() & Qt::ControlModifier)) // a shortcut: nobody types that
            return QWidget::event(event);
        if (key == Qt::Key_Space || (key >= Qt::Key_Left && key <= Qt::Key_Down) || m_tools.tool().wants(key))
            event->accept();
    }
    if (event->type() == QEvent::KeyPress)
        if (const std::optional<bool> used = tabPressed(static_cast<const QKeyEvent&>(*event)))
            return *used;
    return QWidget::event(event);
}

/// Tab is for the tool, or walks through the pattern while patches are selected; F6 leads out of the view. Nothing:
/// another key, or nowhere to walk to.
std::optional<bool> PatternView::tabPressed(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Tab) {
        m_document.finishGesture();
        if (m_tools.tool().wants(Qt::Key_Tab))
            return m_tools.tool().keyPress(event);
    }
    if (tool() != PatternToolKind::Select || m_document.gestureRunning())
        return std::nullopt;
    const bool back = event.key() == Qt::Key_Backtab;
    const bool plain = (event.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
    if (plain && (back || event.key() == Qt::Key_Tab) && selectNext(m_document.design(), m_selection, !back))
        return true;
    return std::nullopt;
}

PatternPointer PatternView::pointerOf(const QMouseEvent& event) const
{
    return {event.position(), m_navigation.transform().toLayout(event.position()), event.modifiers()};
}

void PatternView::mousePressEvent(QMouseEvent* event)
{
    if (m_pan.press(*event)) {
        m_tools.refresh();
    } else if (event->button() == Qt::LeftButton) {
        m_pressedAt = event->position();
        m_tools.tool().press(pointerOf(*event));
    } else if (event->button() == Qt::RightButton && !m_pan.running()) {
        m_tools.selectForMenu(event->position());
    }
}

void PatternView::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    if (!m_pan.running())
        m_tools.menu(*event);
}

void PatternView::mouseMoveEvent(QMouseEvent* event)
{
    if (m_pan.running())
        m_pan.move(*event); // the point of a patch stays
    else
        emit patchPointed(m_tools.move(pointerOf(*event)));
    emit pointerMoved(m_navigation.transform().toLayout(event->position()));
}

void PatternView::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_pan.running()) {
        m_pan.release();
        m_tools.refresh();
    } else if (event->button() == Qt::LeftButton) {
        m_tools.tool().release(pointerOf(*event));
        const bool click = (event->position() - m_pressedAt).manhattanLength() < clickReach;
        const auto point = m_shown.pointOf(hit(event->position()), m_navigation.transform(), event->position());
        if (point && click && tool() == PatternToolKind::Select)
            emit patchClicked(*point);
    }
}

void PatternView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        m_tools.tool().doubleClick(pointerOf(*event));
}

void PatternView::wheelEvent(QWheelEvent* event)
{
    const WheelMove move = moveOf(*event);
    const PatternTransform& now = m_navigation.transform();
    if (move.notches != 0)
        m_navigation.setTransform(now.zoomed(event->position(), PatternNavigation::closer(move.notches)));
    else if (!move.pan.isNull())
        m_navigation.setTransform(now.panned(move.pan));
    event->accept();
}

void PatternView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && !m_tools.tool().wants(Qt::Key_Space)) {
        m_pan.setSpace(true);
        m_tools.refresh();
    } else if (event->key() == Qt::Key_Home) {
        m_navigation.fitAll();
    } else if (event->key() == Qt::Key_Escape) {
        m_tools.tool().escape();
    } else if (!m_tools.tool().keyPress(*event)) {
        QWidget::keyPressEvent(event);
    }
}

void PatternView::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_pan.setSpace(false);
        m_tools.refresh();
    } else if (!m_tools.tool().keyRelease(*event)) {
        QWidget::keyReleaseEvent(event);
    }
}

void PatternView::leaveEvent(QEvent*)
{
    m_tools.tool().leave();
    emit pointerMoved(std::nullopt);
    emit patchPointed(std::nullopt);
}

void PatternView::focusOutEvent(QFocusEvent* event)
{
    m_pan.setSpace(false);
    m_tools.tool().leave();
    QWidget::focusOutEvent(event);
}

} // namespace bolster
