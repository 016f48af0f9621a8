// Ties the fields of a form to one element: read from the design, written as one edit each.
#pragma once

#include "DescribedField.h"
#include "Document.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "Gesture.h"
#include "PropertyForm.h"
#include "SelectionEdits.h"

#include <QCoreApplication>

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
    const Design& design() const { return m_document->design(); }
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
    void name() const
    {
        if (several())
            return;
        m_form->addText(
            QCoreApplication::translate("Field", nameField.label),
            [s = *this] { return QString::fromStdString(s.now().name); },
            [s = *this](const QString& text) {
                s.m_document->commit(
                    edits::renameElement(s.m_document->design(), s.m_ids.front(), text.trimmed().toStdString()));
            });
    }

    template <class... Members>
    static DescribedField fieldAt(Members... path)
    {
        const T probe{};
        return describedField(probe, &at(probe, path...));
    }

    /// The field at the end of the path of members, as its kind describes it.
    template <class... Members>
    void field(Members... path) const
    {
        labelledField(fieldAt(path...).label(), path...);
    }

    /// The same under another label.
    template <class... Members>
    void labelledField(const QString& label, Members... path) const
    {
        row(
            label, fieldAt(path...), [path...](auto& t) -> auto& { return at(t, path...); });
    }

    /// A choice among all elements that a field may refer to, after one for none of them where that has a name.
    template <class... Members>
    void reference(const QString& none, Members... path) const
    {
        const DescribedField said = fieldAt(path...);
        referenceRow(
            said.label(), said, none, [path...](auto& t) -> auto& { return at(t, path...); });
    }

    /// A colour; `title`, of the dialog, says what is coloured.
    template <class... Members>
    void colorField(const QString& title, Members... path) const
    {
        const DescribedField said = fieldAt(path...);
        colorRow(
            said.label(), title,
            [s = *this, path...] { return s.shared([&](const T& t) { return at(t, path...); }); },
            [s = *this, verb = said.field.verb, path...](const std::string& value) {
                s.change(verb, [&](T& t) { at(t, path...) = value; });
            });
    }

    /// Whether there is a row for such a field.
    template <class Form, class Value>
    static constexpr bool hasRow =
        std::is_same_v<Form, Number> || std::is_same_v<Form, Flag> || std::is_same_v<Form, Words> ||
        std::is_same_v<Form, Coordinates> || std::is_same_v<Form, Color> || std::is_same_v<Form, FileName> ||
        std::is_same_v<Value, ElementId>;

    /// A field by a function that finds it in an element: a number, with a slider where it has one, a mark, a
    /// choice, a row of numbers, a colour, or the name of a file.
    template <class At>
    void row(const QString& label, const DescribedField& said, At at) const
    {
        using Value = ValueAt<At>;
        const auto read = [s = *this, at] { return s.shared([&](const T& t) { return at(t); }); };
        const auto write = [s = *this, verb = said.field.verb, at](const Value& value) {
            s.change(verb, [&](T& t) { at(t) = value; });
        };
        if constexpr (std::is_same_v<Value, bool>)
            m_form->addCheck(label, read, write);
        else if constexpr (std::is_enum_v<Value> && !std::is_same_v<Value, ElementId>)
            choiceRow(label, said.choices(), read, write);
        else if constexpr (std::is_same_v<Value, ElementId>)
            referenceRow(label, said, said.field.presence == Presence::Required ? QString() : said.noneText(), at);
        else if constexpr (std::is_same_v<Value, std::string>)
            colorOrFileRow(label, said, read, write);
        else if constexpr (!std::is_same_v<Value, double>)
            coordinates(label, said, at);
        else if (said.hasSlider())
            slider(label, said, read, write, at);
        else
            m_form->addNumber(label, said.range(), read, write);
        explain(said);
    }

    template <class At>
    void textRow(const DescribedField& said, At at) const
    {
        m_form->addText(
            said.label(),
            [s = *this, at] { return s.shared([&](const T& t) { return QString::fromStdString(at(t)); }); },
            [s = *this, verb = said.field.verb, at](const QString& text) {
                s.change(verb, [&](T& t) { at(t) = text.toStdString(); });
            });
    }

    /// A number without its unit.
    template <class... Members>
    void unitless(Members... path) const
    {
        const DescribedField said = fieldAt(path...);
        NumberBox::Range range = said.range();
        range.unit.clear();
        m_form->addNumber(
            said.label(), range,
            [s = *this, path...] { return s.shared([&](const T& t) { return at(t, path...); }); },
            [s = *this, verb = said.field.verb, path...](double value) {
                s.change(verb, [&](T& t) { at(t, path...) = value; });
            });
    }

    /// A choice among all but the last one.
    template <class Enum, class... Members>
    void choiceBut(Enum last, Members... path) const
    {
        const DescribedField said = fieldAt(path...);
        m_form->addChoice(
            said.label(), said.choices().first(static_cast<qsizetype>(last)),
            [s = *this, path...] {
                const auto shared = s.shared([&](const T& t) { return at(t, path...); });
                return shared ? static_cast<int>(*shared) : -1;
            },
            [s = *this, verb = said.field.verb, path...](int chosen) {
                s.change(verb, [&](T& t) { at(t, path...) = static_cast<Enum>(chosen); });
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
    static const T& at(const T& value) { return value; }
    static T& at(T& value) { return value; }
    template <class Value, class Member, class... Rest>
    static auto& at(Value& value, Member member, Rest... rest)
    {
        if constexpr (sizeof...(rest) == 0)
            return value.*member;
        else
            return at(value.*member, rest...);
    }

    void explain(const DescribedField& said) const
    {
        m_form->nameRow(QStringLiteral("field.") + QString::fromUtf8(said.field.key));
        if (const QString tip = said.tip(); !tip.isEmpty())
            m_form->explain(tip);
    }

    template <class At>
    using ValueAt = std::decay_t<std::invoke_result_t<At, const T&>>;

    template <class Read, class Write>
    void choiceRow(const QString& label, const QStringList& choices, const Read& read, const Write& write) const
    {
        using Value = typename std::invoke_result_t<Read>::value_type;
        m_form->addChoice(
            label, choices,
            [read] {
                const std::optional<Value> shared = read();
                return shared ? static_cast<int>(*shared) : -1;
            },
            [write](int chosen) { write(static_cast<Value>(chosen)); });
    }

    template <class At>
    void referenceRow(const QString& label, const DescribedField& said, const QString& none, At at) const
    {
        const auto [ids, names] = elementsToChoose(m_document->design(), said.refersTo, none);
        m_form->addChoice(
            label, names,
            [s = *this, at, ids = ids] { return placeOf(ids, s.shared([&](const T& t) { return at(t); })); },
            [s = *this, at, ids = ids, verb = said.field.verb](int chosen) {
                s.change(verb, [&](T& t) { at(t) = ids[static_cast<std::size_t>(chosen)]; });
            });
    }

    template <class Read, class Write>
    void colorOrFileRow(const QString& label, const DescribedField& said, const Read& read,
                        const Write& write) const
    {
        if (said.file) {
            m_form->addInfo(label, [read] {
                const std::optional<std::string> shared = read();
                return shared ? QString::fromStdString(*shared) : variesText();
            });
            return;
        }
        colorRow(label, label, read, write);
    }

    template <class Read, class Write>
    void colorRow(const QString& label, const QString& title, const Read& read, const Write& write) const
    {
        m_form->addColor(
            label, title,
            [read]() -> std::optional<QColor> {
                const std::optional<std::string> shared = read();
                return shared ? std::optional(QColor(QString::fromStdString(*shared))) : std::nullopt;
            },
            [write](const QColor& color) { write(color.name().toStdString()); });
    }

    /// It shows its value while it is dragged, as one edit.
    template <class Read, class Write, class At>
    void slider(const QString& label, const DescribedField& said, const Read& read, const Write& write, At at) const
    {
        const auto gesture = std::make_shared<std::unique_ptr<Gesture>>();
        const auto preview = [s = *this, gesture, verb = said.field.verb, at](double value) {
            if (!*gesture || !(*gesture)->active())
                *gesture = std::make_unique<Gesture>(*s.m_document);
            (*gesture)->update(s.changed((*gesture)->start(), verb, [&](T& t) { at(t) = value; }));
        };
        const auto finish = [gesture] {
            if (const std::unique_ptr<Gesture> finished = std::move(*gesture))
                finished->commit();
        };
        const NumberBoxing& box = said.number->box;
        m_form->addSlider(label, said.range(), box.sliderLeast, box.sliderMost, read, write, preview, finish);
    }

    template <class At>
    void coordinates(const QString& label, const DescribedField& said, At at) const
    {
        m_form->addNumbers(
            label, said.range(), static_cast<int>(ValueAt<At>::RowsAtCompileTime),
            [s = *this, at](int i) { return s.shared([&](const T& t) { return at(t)[i]; }); },
            [s = *this, verb = said.field.verb, at](int i, double number) {
                s.change(verb, [&](T& t) { at(t)[i] = number; });
            });
    }

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
        return chain.result({verb, {countedWords(start, m_ids)}});
    }

    Document* m_document;
    Ids m_ids;
    PropertyForm* m_form;
};

} // namespace bolster
