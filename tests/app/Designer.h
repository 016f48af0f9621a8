// The hands of a designer: everything is done with the pointer and the keys, nothing by calling the program.
#pragma once

#include "MainWindow.h"

#include <QMouseEvent>
#include <QStringList>

namespace bolster {

/// Lengths are millimetres, in the layout of the pattern or in space. What is not there fails the test that asks.
class Designer {
public:
    explicit Designer(MainWindow& window)
        : m_window(window)
    {}

    /// The keyboard belongs to what has the focus, as on a desk.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
    void type(const QString& text);
    /// Types it and presses Enter.
    void enter(const QString& text);

    /// In the pattern.
    void point(const Vec2& at);
    void click(const Vec2& at, Qt::KeyboardModifiers modifiers = {});
    void drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers = {});
    /// The wheel over the middle of the pattern; positive comes closer.
    void zoom(int notches);
    /// In the 3D view.
    void clickCover(const Vec3& at);

    /// By the words of a menu and its entries, without "&" and dots.
    void choose(const QStringList& path);
    /// A button of the window that shows this text.
    void pressButton(const QString& text);
    /// The only link of a text in the window, by the name of its widget.
    void followLink(const QString& widget);
    /// In the list of elements; with Ctrl several.
    void pick(const QString& name, Qt::KeyboardModifiers modifiers = {});
    /// A field of the properties by its label; of several in a row the one at `place`.
    void setField(const QString& label, const QString& text, int place = 0);
    /// The name of what is selected, with F2.
    void rename(const QString& name);

    /// A rectangle with typed width and height, up and to the right of `corner`.
    void drawRectangle(const Vec2& corner, const QString& size);
    /// With the sew tool: a click on each of two edges.
    void sew(const Vec2& a, const Vec2& b);
    /// A fixation curve through typed places, in straight pieces.
    void typeFixation(const QStringList& places, bool closed);
    /// The next file dialog gets this path, the dialog after it its default button.
    void answerFileDialog(const QString& path);
    /// The next file dialog gets this path, and no dialog follows.
    void chooseFile(const QString& path);

    /// How often a button of the mouse was pressed so far.
    int clicks() const { return m_clicks; }

private:
    static void answerDialogs(const QString& path, bool anotherFollows);
    QWidget& keyboard();
    void clickOn(QWidget& widget, QPoint at, Qt::KeyboardModifiers modifiers = {});
    QPoint pixel(const Vec2& at);
    void send(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons,
              Qt::KeyboardModifiers modifiers);

    MainWindow& m_window;
    int m_clicks = 0;
};

} // namespace bolster
