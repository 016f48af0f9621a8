#include "Designer.h"

#include "CoverView.h"
#include "ElementsView.h"
#include "Inspector.h"
#include "PatternView.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QScrollArea>
#include <QTest>
#include <QTimer>
#include <QTreeView>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <cmath>

namespace bolster {

namespace {

QString plain(QString text)
{
    return text.remove(u'&').remove(QStringLiteral("\u2026")).trimmed();
}

QAction* entry(const QWidget& menu, const QString& text)
{
    for (QAction* action : menu.actions())
        if (plain(action->text()) == text || plain(action->text()).startsWith(text + u':'))
            return action;
    return nullptr;
}

/// The row of the tree that shows a text, wherever it is.
QModelIndex rowOf(const QAbstractItemModel& model, const QString& text, const QModelIndex& under = {})
{
    for (int row = 0; row < model.rowCount(under); ++row) {
        const QModelIndex index = model.index(row, 0, under);
        if (index.data().toString() == text)
            return index;
        if (const QModelIndex below = rowOf(model, text, index); below.isValid())
            return below;
    }
    return {};
}

} // namespace

QWidget& Designer::keyboard()
{
    if (QWidget* focused = QApplication::focusWidget())
        return *focused;
    if (QWidget* modal = QApplication::activeModalWidget())
        return *modal;
    return m_window;
}

void Designer::clickOn(QWidget& widget, QPoint at, Qt::KeyboardModifiers modifiers)
{
    ++m_clicks;
    QTest::mouseMove(&widget, at);
    QTest::mouseClick(&widget, Qt::LeftButton, modifiers, at);
    QCoreApplication::processEvents();
}

void Designer::key(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    if (!QApplication::activeWindow()) {
        m_window.activateWindow(); // as a window manager does when a dialog has gone
        EXPECT_TRUE(QTest::qWaitForWindowActive(&m_window));
    }
    QTest::keyClick(&keyboard(), key, modifiers);
    QCoreApplication::processEvents(); // a tool that has done its work ends with the event
}

void Designer::type(const QString& text)
{
    QTest::keyClicks(&keyboard(), text);
}

void Designer::enter(const QString& text)
{
    type(text);
    key(Qt::Key_Return);
}

QPoint Designer::pixel(const Vec2& at)
{
    return m_window.patternView().navigation().transform().toPixels(at).toPoint();
}

void Designer::send(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons,
                    Qt::KeyboardModifiers modifiers)
{
    PatternView& view = m_window.patternView();
    EXPECT_TRUE(view.rect().contains(at)) << "out of sight";
    QMouseEvent event(type, at, view.mapToGlobal(at), button, buttons, modifiers);
    QApplication::sendEvent(&view, &event);
}

void Designer::point(const Vec2& at)
{
    send(QEvent::MouseMove, pixel(at), Qt::NoButton, Qt::NoButton, {});
}

void Designer::click(const Vec2& at, Qt::KeyboardModifiers modifiers)
{
    drag(at, at, modifiers);
}

void Designer::drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers)
{
    ++m_clicks;
    const QPoint start = pixel(from), end = pixel(to);
    send(QEvent::MouseMove, start, Qt::NoButton, Qt::NoButton, modifiers);
    send(QEvent::MouseButtonPress, start, Qt::LeftButton, Qt::LeftButton, modifiers);
    constexpr int steps = 8;
    for (int i = 1; i <= steps && start != end; ++i)
        send(QEvent::MouseMove, start + (end - start) * i / steps, Qt::NoButton, Qt::LeftButton, modifiers);
    send(QEvent::MouseButtonRelease, end, Qt::LeftButton, Qt::NoButton, modifiers);
    m_window.patternView().setFocus(Qt::MouseFocusReason); // as a click from the window system does
    QCoreApplication::processEvents();
}

void Designer::zoom(int notches)
{
    PatternView& view = m_window.patternView();
    const QPoint middle = view.rect().center();
    QWheelEvent wheel(middle, view.mapToGlobal(middle), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &wheel);
    view.setFocus(Qt::MouseFocusReason);
}

void Designer::clickCover(const Vec3& at)
{
    CoverView& view = m_window.coverView();
    const std::optional<Vec2> found = view.navigation().camera().pixel(at);
    ASSERT_TRUE(found);
    const QPoint place(static_cast<int>(std::lround(found->x())), static_cast<int>(std::lround(found->y())));
    clickOn(view, place);
}

void Designer::choose(const QStringList& path)
{
    QWidget* menu = m_window.menuBar();
    for (const QString& text : path) {
        QAction* action = entry(*menu, text);
        ASSERT_TRUE(action) << text.toStdString();
        ASSERT_TRUE(action->isEnabled()) << text.toStdString();
        const QRect place = menu == m_window.menuBar() ? m_window.menuBar()->actionGeometry(action)
                                                       : static_cast<QMenu*>(menu)->actionGeometry(action);
        clickOn(*menu, place.center());
        QMenu* below = action->menu();
        if (!below)
            break;
        ASSERT_TRUE(QTest::qWaitFor([&] { return below->isVisible(); })) << text.toStdString();
        menu = below;
    }
    QCoreApplication::processEvents();
}

void Designer::pressButton(const QString& text)
{
    for (auto* button : m_window.findChildren<QAbstractButton*>())
        if (plain(button->text()) == text && button->isVisible()) {
            clickOn(*button, button->rect().center());
            return;
        }
    ADD_FAILURE() << "no button " << text.toStdString();
}

void Designer::followLink(const QString& widget)
{
    auto* label = m_window.findChild<QLabel*>(widget);
    ASSERT_TRUE(label && label->isVisible()) << widget.toStdString();
    constexpr int step = 4; // pixels
    for (int y = 0; y < label->height(); y += step)
        for (int x = 0; x < label->width(); x += step) {
            QMouseEvent move(QEvent::MouseMove, QPoint(x, y), label->mapToGlobal(QPoint(x, y)), Qt::NoButton,
                             Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(label, &move);
            if (label->cursor().shape() != Qt::PointingHandCursor)
                continue;
            clickOn(*label, {x + step, y + step});
            return;
        }
    ADD_FAILURE() << "no link in " << label->text().toStdString();
}

void Designer::pick(const QString& name, Qt::KeyboardModifiers modifiers)
{
    QTreeView& tree = m_window.findChild<ElementsView*>()->tree();
    const QModelIndex row = rowOf(*tree.model(), name);
    ASSERT_TRUE(row.isValid()) << name.toStdString();
    tree.scrollTo(row);
    clickOn(*tree.viewport(), tree.visualRect(row).center(), modifiers);
}

/// Labels stand beside their fields or above them.
static QWidget* fieldOf(const Inspector& inspector, const QString& label)
{
    for (const QLabel* shown : inspector.findChildren<QLabel*>())
        if (shown->buddy() && plain(shown->text()) == label)
            return shown->buddy();
    for (auto* form : inspector.findChildren<QFormLayout*>())
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            const auto* shown = item ? qobject_cast<QLabel*>(item->widget()) : nullptr;
            if (shown && plain(shown->text()) == label)
                return form->itemAt(row, QFormLayout::FieldRole)->widget();
        }
    return nullptr;
}

void Designer::setField(const QString& label, const QString& text, int place)
{
    QWidget* field = fieldOf(m_window.inspector(), label);
    ASSERT_TRUE(field) << "no field " << label.toStdString();
    QList<QLineEdit*> edits = field->findChildren<QLineEdit*>();
    if (auto* self = qobject_cast<QLineEdit*>(field))
        edits = {self};
    ASSERT_GT(edits.size(), place) << label.toStdString();
    QLineEdit* edit = edits[place];
    for (QWidget* up = edit; up; up = up->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(up))
            area->ensureWidgetVisible(edit); // as the wheel does
    clickOn(*edit, edit->rect().center());
    key(Qt::Key_A, Qt::ControlModifier);
    enter(text);
}

void Designer::rename(const QString& name)
{
    key(Qt::Key_F2);
    const QPointer<QLineEdit> editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(editor);
    key(Qt::Key_A, Qt::ControlModifier);
    enter(name);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !editor || !editor->isVisible(); }));
}

void Designer::drawRectangle(const Vec2& corner, const QString& size)
{
    key(Qt::Key_R, Qt::ShiftModifier);
    click(corner);
    enter(size);
}

void Designer::sew(const Vec2& a, const Vec2& b)
{
    click(a);
    click(b);
}

void Designer::typeFixation(const QStringList& places, bool closed)
{
    key(Qt::Key_F, Qt::ShiftModifier);
    key(Qt::Key_B);
    for (const QString& place : places)
        enter(place);
    key(closed ? Qt::Key_C : Qt::Key_Return);
}

void Designer::answerFileDialog(const QString& path)
{
    answerDialogs(path, true);
}

void Designer::chooseFile(const QString& path)
{
    answerDialogs(path, false);
}

void Designer::answerDialogs(const QString& path, bool anotherFollows)
{
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, path, anotherFollows] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        QWidget* focused = QApplication::focusWidget();
        if (!dialog || !dialog->isVisible() || !focused || !dialog->isAncestorOf(focused))
            return;
        if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
            QTest::keyClicks(files->findChild<QLineEdit*>(), path);
            if (!anotherFollows) {
                timer->stop();
                timer->deleteLater();
            }
            QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
            return;
        }
        timer->stop();
        timer->deleteLater();
        QTest::keyClick(focused, Qt::Key_Return);
    });
    timer->start(50);
}

} // namespace bolster
