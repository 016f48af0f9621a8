// The tool with which a view works: how it begins, what it says, how it fails and ends.
#pragma once

#include "ViewTool.h"

#include <QObject>
#include <QPoint>
#include <QWidget>

#include <functional>
#include <memory>

namespace bolster {

class ToolHost : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it.
    ToolHost(Document& document, QWidget& view);

    /// What can be done now, for the status bar.
    virtual QString prompt() const = 0;
    /// Prompt, cursor or what the tool draws has changed: `refreshed`.
    virtual void refresh() = 0;
    /// Handles an event. What is thrown then is said; the design is again what it was before the gesture.
    bool guard(const std::function<bool()>& handle);
    /// The last step of what the tool has begun; false when nothing has.
    bool takeBack();
    /// By the right button or the menu key, in the view.
    void askForMenu(const QPoint& global, bool onSomething);

signals:
    void kindChanged();
    void promptChanged(const QString& prompt);
    void refreshed();
    void contextMenuWanted(const QPoint& global, bool onSomething);
    /// Instead, while a tool has begun something.
    void toolMenuWanted(const QPoint& global, const bolster::ToolKeys& keys);
    /// What a tool could not do, in the user's words.
    void failed(const QString& message);

protected:
    virtual ViewTool& current() = 0;
    /// The same kind of tool, begun anew.
    virtual void restart() = 0;
    void announce();

    Document& m_document;
    QWidget& m_view;

private:
    QString m_prompt; ///< announced last
};

/// With kinds of tools, of which `Select` is where one begins and comes back to.
template <class Kind, class Tool, class Context>
class ToolHostOf : public ToolHost, protected Context {
public:
    using Make = std::unique_ptr<Tool> (*)(Kind, Context&);

    ToolHostOf(Document& document, Selection& selection, QWidget& view, Make make)
        : ToolHost(document, view)
        , m_selection(selection)
        , m_make(make)
        , m_tool(make(m_kind, *this))
    {}

    Kind kind() const { return m_kind; }
    Tool& tool() const { return *m_tool; }
    void setTool(Kind kind)
    {
        if (kind == m_kind)
            return;
        m_tool->leave();
        m_kind = kind;
        restart();
        if (kind != Kind::Select)
            m_view.setFocus();
        emit kindChanged();
        refresh();
    }

    /// What the host says is said by the view.
    template <class View>
    void speakThrough(View& view)
    {
        connect(this, &ToolHost::kindChanged, &view, [this, &view] { emit view.toolChanged(m_kind); });
        connect(this, &ToolHost::promptChanged, &view, &View::promptChanged);
        connect(this, &ToolHost::contextMenuWanted, &view, &View::contextMenuWanted);
        connect(this, &ToolHost::toolMenuWanted, &view, &View::toolMenuWanted);
        connect(this, &ToolHost::failed, &view, &View::failed);
    }

    QString prompt() const override { return m_tool->prompt(); }
    void refresh() override { announce(); }

protected:
    /// One that `make` does not know, of the kind that is set.
    void replaceTool(std::unique_ptr<Tool> tool)
    {
        m_tool = std::move(tool);
        refresh();
    }

    Document& document() override { return m_document; }
    Selection& selection() override { return m_selection; }
    void report(const QString& problem) override { emit failed(problem); }
    void endTool() override
    {
        const auto back = [this, ended = m_tool.get()] {
            if (m_tool.get() == ended) // else another one has been begun meanwhile
                setTool(Kind::Select);
        };
        QMetaObject::invokeMethod(this, back, Qt::QueuedConnection);
    }
    ViewTool& current() override { return *m_tool; }
    void restart() override { m_tool = m_make(m_kind, *this); }

    Selection& m_selection;

private:
    Make m_make;
    Kind m_kind = Kind::Select;
    std::unique_ptr<Tool> m_tool;
};

} // namespace bolster
