// The scans of the design and files, to choose what a cover is held against.
#pragma once

#include "FileChoice.h"
#include "FitForm.h"

namespace bolster {

class FormChoice : public FileChoice {
    Q_OBJECT

public:
    /// `fileTitle`: of the dialog that asks for a file. `none`: how it is said that there is none; empty: there
    /// must be one.
    FormChoice(DesignSession& session, const QString& fileTitle, const QString& none = {},
               QWidget* parent = nullptr);

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

private:
    void fill(const QString& none);

    int m_scans = 0;
};

} // namespace bolster
