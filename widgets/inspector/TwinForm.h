// What the inspector shows of mirror twins.
#pragma once

#include "Element.h"

#include <QCoreApplication>

namespace bolster {

class Document;
class PropertyForm;

class TwinForm {
    Q_DECLARE_TR_FUNCTIONS(TwinForm)

public:
    explicit TwinForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, ElementId id) const;

private:
    void addMirroredSewing(PropertyForm& form, ElementId id) const;

    Document& m_document;
};

} // namespace bolster
