// What the inspector shows of seam allowances, notches, corners of the cut line and drill holes.
#pragma once

#include "ElementForm.h"
#include "InspectorSubject.h"

#include <QCoreApplication>

namespace bolster {

/// Allowance, corners, quantity, nap ... of patches.
class PieceCuttingSection {
    Q_DECLARE_TR_FUNCTIONS(PieceCuttingSection)

public:
    static void add(PropertyForm& form, const InspectorSubject<Patch>& patch);
};

/// The design's allowance and automatic notches.
class DesignCuttingSection {
    Q_DECLARE_TR_FUNCTIONS(DesignCuttingSection)

public:
    static void add(PropertyForm& form, const InspectorSubject<Settings>& settings);
};

class EdgeAllowanceForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(EdgeAllowanceForm)

public:
    explicit EdgeAllowanceForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

class CutCornerForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(CutCornerForm)

public:
    explicit CutCornerForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

class NotchForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(NotchForm)

public:
    explicit NotchForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    void addDistance(PropertyForm& form, const Ids& ids) const;

    Document& m_document;
};

class DrillHoleForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(DrillHoleForm)

public:
    explicit DrillHoleForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

} // namespace bolster
