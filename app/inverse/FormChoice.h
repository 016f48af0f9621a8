// The scans of the design and files, to choose what a cover is held against.
#pragma once

#include "FitForm.h"

#include <QComboBox>

#include <functional>

namespace bolster {

class DesignSession;

class FormChoice : public QComboBox {
    Q_OBJECT

public:
    /// `fileTitle`: of the dialog that asks for a file. `none`: how it is said that there is none; empty: there
    /// must be one.
    FormChoice(DesignSession& session, QString fileTitle, const QString& none = {}, QWidget* parent = nullptr);

    /// Whether the design has scans.
    bool hasScans() const { return m_scans > 0; }
    /// Empty when none is chosen, or its file is not read.
    FitForm form() const;
    /// To be chosen again, if it is there then.
    struct Chosen {
        ElementId scan = noElement;
        QString file;
    };
    Chosen chosen() const;
    void choose(const Chosen& chosen);
    /// When "A file ..." is chosen, but none yet: asks for it, goes on with `then` when there is one, and returns
    /// true.
    bool asksForFile(const std::function<void()>& then);

signals:
    void fileChosen();

private:
    void fill(const QString& none);
    void chooseFile(const std::function<void()>& then = {});
    void take(const QString& file);

    DesignSession& m_session;
    QString m_fileTitle;
    int m_before = 0; ///< what was chosen
    int m_scans = 0;
};

} // namespace bolster
