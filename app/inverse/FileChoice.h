// A list of things, to choose one of them or a file.
#pragma once

#include <QComboBox>

#include <functional>

namespace bolster {

class DesignSession;

/// Whoever makes it adds the things, then the entry for files.
class FileChoice : public QComboBox {
    Q_OBJECT

public:
    /// Of the dialog that asks for a file: `filter` is what it shows.
    FileChoice(DesignSession& session, QString title, QString filter, QWidget* parent = nullptr);

    /// "A file ..."
    void addFiles();
    /// The one that is chosen; empty when it is something else.
    QString file() const;
    /// Chosen files stay in the list, above the entry for another one.
    void chooseFile(const QString& file);
    void chooseRow(int row);
    /// When "A file ..." is chosen, but none yet: asks for it, goes on with `then` when there is one, and returns
    /// true.
    bool asksForFile(const std::function<void()>& then);

signals:
    void fileChosen();
    /// By the user: a file or something else.
    void chosenAnew();

protected:
    DesignSession& session() const { return m_session; }

private:
    bool isOnFiles() const;
    void ask(const std::function<void()>& then = {});

    DesignSession& m_session;
    QString m_title, m_filter;
    int m_before = -1; ///< what was chosen
};

} // namespace bolster
