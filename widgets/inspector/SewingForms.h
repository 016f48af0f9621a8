// What the inspector shows of what lies on outlines: seams, fixations and trimmed edges.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class SeamForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(SeamForm)

public:
    explicit SeamForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

class FixationSeamForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(FixationSeamForm)

public:
    explicit FixationSeamForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    void addCurveChoice(PropertyForm& form, const Ids& ids) const;

    Document& m_document;
};

class OutlineTrimForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(OutlineTrimForm)

public:
    explicit OutlineTrimForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

} // namespace bolster
