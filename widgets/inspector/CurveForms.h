// What the inspector shows of curves: on the frame, and drawn in patches.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class FixationCurveForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(FixationCurveForm)

public:
    explicit FixationCurveForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

class HandleCurveForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(HandleCurveForm)

public:
    explicit HandleCurveForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

class FancySeamForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(FancySeamForm)

public:
    explicit FancySeamForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

class MeasurementForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(MeasurementForm)

public:
    MeasurementForm(Document& document, const FormSources& sources)
        : m_document(document)
        , m_sources(sources)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
    const FormSources& m_sources;
};

class InternalLineForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(InternalLineForm)

public:
    explicit InternalLineForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

} // namespace bolster
