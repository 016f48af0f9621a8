// A main window with helpers for tests that use it like a person: by pointer and keys.
#pragma once

#include "Background.h"
#include "Banner.h"
#include "Commands.h"
#include "CoverMap.h"
#include "Docks.h"
#include "MainWindow.h"
#include "PatternView.h"
#include "TestPaths.h"
#include "WatchedApplication.h"

#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace bolster {

class WindowTest : public testing::Test {
protected:
    void SetUp() override
    {
        window.resize(1400, 900);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        takeKeyboard();
    }

    /// Shortcuts and focus need an active window; who closed the one before may still be asked to take it over, so
    /// that asking once is not enough.
    void takeKeyboard() { takeKeyboard(window); }
    static void takeKeyboard(QWidget& by)
    {
        for (int tries = 0; tries < 30 && !by.isActiveWindow(); ++tries) {
            by.raise();
            by.activateWindow();
            (void)QTest::qWaitFor([&] { return by.isActiveWindow(); }, 1000);
        }
        ASSERT_TRUE(by.isActiveWindow()) << "no keyboard: is there a window manager?";
    }

    void TearDown() override
    {
        window.document().markSaved(); // no question on the way out
        window.close();
    }

    static QString sample(const QString& name)
    {
        return QString::fromStdString(test::samplesFolder() + "/%1/%1.json").arg(name);
    }

    bool open(const QString& path)
    {
        bool opened = false;
        const auto connection =
            QObject::connect(&window.session(), &DesignSession::opened, &window, [&] { opened = true; });
        window.open(path);
        const bool done = QTest::qWaitFor([&] { return opened; }, 120000);
        QObject::disconnect(connection);
        takeKeyboard(); // from the progress that was shown if opening took its time
        return done;
    }

    /// The surface of the present design has settled.
    bool waitUntilSolved(int mostMs = 120000)
    {
        return QTest::qWaitFor(
            [&] {
                return window.solver().upToDate() && window.solver().surface() &&
                       window.solver().status().state == SolverStatus::State::Settled;
            },
            mostMs);
    }

    /// It is the resting surface, which depends on nothing but the design.
    bool waitUntilAtRest(int mostMs = 120000)
    {
        return QTest::qWaitFor([&] { return window.solver().upToDate() && window.solver().status().resting; },
                               mostMs);
    }

    /// What was begun beside the windows is done, and they know of it.
    void waitForBackground()
    {
        backgroundPool().waitForDone();
        QCoreApplication::processEvents();
    }

    /// The window is painted anew, as between two steps of a hand that drags.
    void waitForPicture()
    {
        const int before = application().pictures();
        window.update();
        EXPECT_TRUE(QTest::qWaitFor([&] { return application().pictures() > before; }, 20000));
    }

    QAction* map(CoverMap::Kind kind)
    {
        static const std::map<CoverMap::Kind, const char*> ids{
            {CoverMap::Kind::Along, "map.along"},         {CoverMap::Kind::Across, "map.across"},
            {CoverMap::Kind::Shear, "map.shear"},         {CoverMap::Kind::Curvature, "map.curvature"},
            {CoverMap::Kind::Thickness, "map.thickness"}, {CoverMap::Kind::Strain, "map.strain"}};
        return window.command(ids.at(kind));
    }

    std::uint64_t meshRevision() { return window.solver().surface() ? window.solver().surface()->revision : 0; }

    /// Where a point of the layout is in the pattern view.
    QPoint patternPixel(const Vec2& layout)
    {
        return window.patternView().navigation().transform().toPixels(layout).toPoint();
    }

    QPoint patternPixel(ElementId patch, int point)
    {
        const Patch& found = *window.document().design().find<Patch>(patch);
        return patternPixel(toLayout(found, found.outline.points()[static_cast<std::size_t>(point)]));
    }

    static void move(QWidget& view, QPoint to, Qt::MouseButtons buttons)
    {
        // QTest::mouseMove sends no pressed buttons.
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, buttons, Qt::NoModifier);
        QApplication::sendEvent(&view, &event);
    }

    static void press(QWidget& view, QPoint at) { QTest::mousePress(&view, Qt::LeftButton, {}, at); }
    static void release(QWidget& view, QPoint at) { QTest::mouseRelease(&view, Qt::LeftButton, {}, at); }

    /// Presses the button of the next message box that has it.
    void answer(QMessageBox::StandardButton button)
    {
        whenABoxHas([button](QMessageBox& box) { return box.button(button); });
    }
    /// The same by a part of what is written on it.
    void pressInBox(const QString& text)
    {
        whenABoxHas([text](QMessageBox& box) -> QAbstractButton* {
            for (QAbstractButton* button : box.buttons())
                if (button->text().remove('&').contains(text))
                    return button;
            return nullptr;
        });
    }

    void whenABoxHas(const std::function<QAbstractButton*(QMessageBox&)>& find)
    {
        auto* timer = new QTimer(&window); // not longer than what it uses
        QObject::connect(timer, &QTimer::timeout, timer, [this, timer, find] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            QAbstractButton* button = box ? find(*box) : nullptr;
            if (!button)
                return;
            timer->stop();
            timer->deleteLater();
            ++answered;
            button->click(); // the pointer would miss it before the box has its size
        });
        timer->start(20);
    }

    WatchedApplication& application() { return *static_cast<WatchedApplication*>(qApp); }

    int answered = 0; ///< message boxes
    MainWindow window;
};

} // namespace bolster
