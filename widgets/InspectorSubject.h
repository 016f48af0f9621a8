// Ties the fields of a form to one element: read from the design, written as one edit each.
#pragma once

#include "Document.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "Gesture.h"
#include "PropertyForm.h"

#include <memory>

namespace bolster {

/// Verbs are keys of a Message with the element's name as %1.
template <class T>
class InspectorSubject {
public:
    InspectorSubject(Document& document, ElementId id, PropertyForm& form)
        : m_document(&document)
        , m_id(id)
        , m_form(&form)
    {}

    /// A default one after the element is gone.
    T now() const
    {
        const T* found = m_document->design().template find<T>(m_id);
        return found ? *found : T{};
    }

    void change(const char* verb, const std::function<void(T&)>& set) const
    {
        const Design& design = m_document->design();
        if (!design.template find<T>(m_id))
            return;
        T value = now();
        set(value);
        m_document->commit(edits::replaceElement(design, m_id, makeElement(std::move(value)),
                                                 {verb, {displayName(design, m_id).toStdString()}}));
    }

    void name(const QString& label) const
    {
        m_form->addText(
            label, [s = *this] { return QString::fromStdString(s.now().name); },
            [s = *this](const QString& text) {
                s.m_document->commit(
                    edits::renameElement(s.m_document->design(), s.m_id, text.trimmed().toStdString()));
            });
    }

    void number(const QString& label, const NumberBox::Range& range, double T::*member, const char* verb) const
    {
        m_form->addNumber(
            label, range, [s = *this, member] { return s.now().*member; },
            [s = *this, member, verb](double value) { s.change(verb, [&](T& t) { t.*member = value; }); });
    }

    /// A number with a slider from `low` to `high` that shows its value while it is dragged, as one edit.
    void slider(const QString& label, const NumberBox::Range& range, double low, double high, double T::*member,
                const char* verb) const
    {
        const auto gesture = std::make_shared<std::unique_ptr<Gesture>>();
        const auto preview = [s = *this, gesture, member, verb](double value) {
            if (!*gesture || !(*gesture)->active())
                *gesture = std::make_unique<Gesture>(*s.m_document);
            const Design& start = (*gesture)->start();
            T changed = s.now();
            changed.*member = value;
            (*gesture)->update(edits::replaceElement(start, s.m_id, makeElement(std::move(changed)),
                                                     {verb, {displayName(start, s.m_id).toStdString()}}));
        };
        const auto finish = [gesture] {
            if (const std::unique_ptr<Gesture> finished = std::move(*gesture))
                finished->commit();
        };
        m_form->addSlider(
            label, range, low, high, [s = *this, member] { return s.now().*member; },
            [s = *this, member, verb](double value) { s.change(verb, [&](T& t) { t.*member = value; }); }, preview,
            finish);
    }

    /// A row of numbers that `at` finds in the element.
    void numbers(const QString& label, const NumberBox::Range& range, int count,
                 const std::function<double&(T&, int)>& at, const char* verb) const
    {
        m_form->addNumbers(
            label, range, count,
            [s = *this, at](int i) {
                T value = s.now();
                return at(value, i);
            },
            [s = *this, at, verb](int i, double number) { s.change(verb, [&](T& t) { at(t, i) = number; }); });
    }

    void check(const QString& label, bool T::*member, const char* verb) const
    {
        m_form->addCheck(
            label, [s = *this, member] { return s.now().*member; },
            [s = *this, member, verb](bool value) { s.change(verb, [&](T& t) { t.*member = value; }); });
    }

    template <class E>
    void choice(const QString& label, const QStringList& names, E T::*member, const char* verb) const
    {
        m_form->addChoice(
            label, names, [s = *this, member] { return static_cast<int>(s.now().*member); },
            [s = *this, member, verb](int value) {
                s.change(verb, [&](T& t) { t.*member = static_cast<E>(value); });
            });
    }

    void info(const QString& label, const std::function<QString(const Design&, const T&)>& text) const
    {
        m_form->addInfo(label, [s = *this, text] { return text(s.m_document->design(), s.now()); });
    }

private:
    Document* m_document;
    ElementId m_id;
    PropertyForm* m_form;
};

} // namespace bolster
