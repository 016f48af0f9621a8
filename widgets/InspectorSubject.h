// Ties the fields of a form to one element: read from the design, written as one edit each.
#pragma once

#include "Document.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "Gesture.h"
#include "PropertyForm.h"
#include "SelectionEdits.h"

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace bolster {

/// One element or several of one kind, which are changed together. Verbs are keys of a Message with the element's
/// name or "3 patches" as %1.
template <class T>
class InspectorSubject {
public:
    using Ids = std::vector<ElementId>; ///< at least one

    InspectorSubject(Document& document, Ids ids, PropertyForm& form)
        : m_document(&document)
        , m_ids(std::move(ids))
        , m_form(&form)
    {}

    bool several() const { return m_ids.size() > 1; }
    /// The first one; a default one after it is gone.
    T now() const
    {
        const T* found = m_document->design().template find<T>(m_ids.front());
        return found ? *found : T{};
    }

    /// What `read` says of each of them, or nothing where they differ.
    template <class Read>
    auto shared(Read read) const -> std::optional<std::decay_t<std::invoke_result_t<Read, const T&>>>
    {
        std::optional<std::decay_t<std::invoke_result_t<Read, const T&>>> all;
        for (const ElementId id : m_ids) {
            const T* found = m_document->design().template find<T>(id);
            if (!found)
                continue;
            auto value = read(*found);
            if (all && !(*all == value))
                return std::nullopt;
            all = std::move(value);
        }
        return all ? all : std::optional(std::decay_t<std::invoke_result_t<Read, const T&>>(read(T{})));
    }

    void change(const char* verb, const std::function<void(T&)>& set) const
    {
        m_document->commit(changed(m_document->design(), verb, set));
    }

    /// Names are each element's own.
    void name(const QString& label) const
    {
        if (several())
            return;
        m_form->addText(
            label, [s = *this] { return QString::fromStdString(s.now().name); },
            [s = *this](const QString& text) {
                s.m_document->commit(
                    edits::renameElement(s.m_document->design(), s.m_ids.front(), text.trimmed().toStdString()));
            });
    }

    void number(const QString& label, const NumberBox::Range& range, double T::*member, const char* verb) const
    {
        m_form->addNumber(
            label, range, [s = *this, member] { return s.shared([&](const T& t) { return t.*member; }); },
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
            (*gesture)->update(s.changed((*gesture)->start(), verb, [&](T& t) { t.*member = value; }));
        };
        const auto finish = [gesture] {
            if (const std::unique_ptr<Gesture> finished = std::move(*gesture))
                finished->commit();
        };
        m_form->addSlider(
            label, range, low, high,
            [s = *this, member] { return s.shared([&](const T& t) { return t.*member; }); },
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
                return s.shared([&](const T& t) {
                    T value = t;
                    return at(value, i);
                });
            },
            [s = *this, at, verb](int i, double number) { s.change(verb, [&](T& t) { at(t, i) = number; }); });
    }

    void check(const QString& label, bool T::*member, const char* verb) const
    {
        m_form->addCheck(
            label, [s = *this, member] { return s.shared([&](const T& t) { return t.*member; }); },
            [s = *this, member, verb](bool value) { s.change(verb, [&](T& t) { t.*member = value; }); });
    }

    template <class E>
    void choice(const QString& label, const QStringList& names, E T::*member, const char* verb) const
    {
        m_form->addChoice(
            label, names,
            [s = *this, member] {
                return s.shared([&](const T& t) { return static_cast<int>(t.*member); }).value_or(-1);
            },
            [s = *this, member, verb](int value) {
                s.change(verb, [&](T& t) { t.*member = static_cast<E>(value); });
            });
    }

    void info(const QString& label, const std::function<QString(const Design&, const T&)>& text) const
    {
        m_form->addInfo(label, [s = *this, text] {
            const Design& design = s.m_document->design();
            return s.shared([&](const T& t) { return text(design, t); }).value_or(variesText());
        });
    }

private:
    /// One edit for all of them.
    Edit changed(const Design& start, const char* verb, const std::function<void(T&)>& set) const
    {
        EditChain chain(start);
        for (const ElementId id : m_ids) {
            const T* found = start.template find<T>(id);
            if (!found)
                continue;
            T value = *found;
            set(value);
            chain.add(edits::replaceElement(start, id, makeElement(std::move(value)),
                                            {verb, {displayName(start, id).toStdString()}}));
        }
        return chain.result({verb, {countedText(start, m_ids).toStdString()}});
    }

    Document* m_document;
    Ids m_ids;
    PropertyForm* m_form;
};

} // namespace bolster
