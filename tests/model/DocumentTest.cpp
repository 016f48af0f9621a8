#include "Document.h"
#include "Gesture.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <random>

namespace bolster {
namespace {

Edit setFabric(const Design& design, int id, const std::string& name)
{
    return {{"Name it", {}}, {{ElementId{id}, design.element(ElementId{id}), makeElement(Fabric{.name = name})}}};
}

Edit remove(const Design& design, int id)
{
    return {{"Remove", {}}, {{ElementId{id}, design.element(ElementId{id}), nullptr}}};
}

Edit setEdgeLength(const Design& design, double length)
{
    return {{"Edge length", {}}, {{settingsId, design.element(settingsId), makeElement(Settings{length})}}};
}

std::string nameOf(const Document& document, int id)
{
    const Fabric* fabric = document.design().find<Fabric>(ElementId{id});
    return fabric ? fabric->name : "none";
}

/// Compares by content alone, so that it does not share shortcuts with the code under test.
ChangeSet slowDifferences(const Design& a, const Design& b)
{
    ChangeSet ids;
    const auto compare = [&](ElementId id) {
        const ElementPtr x = a.element(id);
        const ElementPtr y = b.element(id);
        if ((x == nullptr) != (y == nullptr) || (x && !(*x == *y)))
            ids.insert(id);
    };
    compare(settingsId);
    for (int i = 0; i < 20; ++i)
        compare(ElementId{i});
    return ids;
}

/// Checks every signal of a document against the design that was seen before.
class Witness {
public:
    explicit Witness(Document& document)
        : m_document(document)
        , m_seen(document.design())
    {
        QObject::connect(&document, &Document::changed, [this](const ChangeSet& ids) {
            EXPECT_FALSE(ids.empty());
            EXPECT_EQ(ids, slowDifferences(m_seen, m_document.design()));
            EXPECT_GT(m_document.revision(), m_revision);
            m_revision = m_document.revision();
            m_seen = m_document.design();
            ++m_count;
        });
        QObject::connect(&document, &Document::dirtyChanged, [this](bool dirty) {
            EXPECT_NE(dirty, m_dirty);
            m_dirty = dirty;
        });
    }

    int count() const { return m_count; }

    /// Nothing changed without a signal, and the design is what its history says.
    void check()
    {
        EXPECT_EQ(slowDifferences(m_seen, m_document.design()), ChangeSet{});
        EXPECT_EQ(m_document.dirty(), m_dirty);
        EXPECT_EQ(slowDifferences(m_document.committed(), replay()), ChangeSet{});
        if (!m_document.gestureRunning()) {
            EXPECT_TRUE(m_document.design() == m_document.committed());
        }
    }

    void setRoot(const Design& root) { m_root = root; }

private:
    Design replay() const
    {
        Design design = m_root;
        const History& history = m_document.history();
        for (const NodeId id : history.pathTo(history.current()))
            design = design.with(history.node(id).edit);
        return design;
    }

    Document& m_document;
    Design m_root;
    Design m_seen;
    std::uint64_t m_revision = 0;
    bool m_dirty = false;
    int m_count = 0;
};

/// Who compares versions or takes parts from one relies on it.
TEST(Document, AnIdStandsForOneThingInAllBranches)
{
    Document document;
    const ElementId first = document.design().nextId();
    document.commit({{"Add", {}}, {{first, nullptr, makeElement(Fabric{.name = "Red"})}}});
    document.undo();
    EXPECT_FALSE(document.design().element(first));
    const ElementId second = document.design().nextId();
    EXPECT_GT(second, first);
    {
        Gesture gesture(document);
        EXPECT_EQ(document.design().nextId(), second);
    }
    document.commit({{"Add", {}}, {{second, nullptr, makeElement(Fabric{.name = "Blue"})}}});
    EXPECT_GT(document.committed().nextId(), second);
    document.spendIds(ElementId{100});
    EXPECT_EQ(document.design().nextId(), ElementId{101});
    document.reset(Design());
    EXPECT_EQ(document.design().nextId(), first);
}

TEST(Document, CommitsAndUndoes)
{
    Document document;
    Witness witness(document);
    document.commit(setFabric(document.design(), 1, "Leather"));
    document.commit(setFabric(document.design(), 1, "Wool"));
    EXPECT_EQ(nameOf(document, 1), "Wool");
    document.undo();
    EXPECT_EQ(nameOf(document, 1), "Leather");
    document.undo();
    EXPECT_EQ(nameOf(document, 1), "none");
    document.undo(); // nothing left
    document.redo();
    document.redo();
    document.redo();
    EXPECT_EQ(nameOf(document, 1), "Wool");
    EXPECT_EQ(witness.count(), 6);
    witness.check();
}

TEST(Document, KeepsTheBranchThatWasUndone)
{
    Document document;
    document.commit(setFabric(document.design(), 1, "Leather"));
    const NodeId leather = document.history().current();
    document.undo();
    document.commit(setFabric(document.design(), 1, "Wool"));
    EXPECT_EQ(document.history().node(0).children.size(), 2u);
    document.jumpTo(leather);
    EXPECT_EQ(nameOf(document, 1), "Leather");
    document.undo();
    document.redo(); // follows the child visited last
    EXPECT_EQ(nameOf(document, 1), "Leather");
}

TEST(Document, IgnoresWhatChangesNothing)
{
    Document document;
    document.commit(setFabric(document.design(), 1, "Leather"));
    Witness witness(document);
    document.commit(Edit());
    document.commit(setFabric(document.design(), 1, "Leather"));
    document.jumpTo(document.history().current());
    document.jumpTo(-1);
    document.jumpTo(99);
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_EQ(witness.count(), 0);
}

TEST(Document, UndoIsExactEvenWhenTheEditWasComputedFromAnotherDesign)
{
    Document document;
    document.commit(setFabric(document.design(), 1, "Leather"));
    const Edit stale = setFabric(Design(), 1, "Wool"); // says that there was nothing before
    document.commit(stale);
    document.undo();
    EXPECT_EQ(nameOf(document, 1), "Leather");
}

TEST(Document, IsDirtyWhileItsFileDoesNotHoldAllThatItsHistoryHolds)
{
    Document document;
    Witness witness(document);
    const auto expect = [&](bool dirty, const UnsavedWork& unsaved) {
        EXPECT_EQ(document.dirty(), dirty);
        EXPECT_EQ(document.unsavedWork(), unsaved);
        EXPECT_EQ(document.hasUnsavedWork(), unsaved.any());
        witness.check();
    };
    expect(false, {});
    document.commit(setFabric(document.design(), 1, "Leather"));
    expect(true, {.edits = 1, .another = true});
    document.markSaved();
    expect(false, {});
    document.undo();
    expect(true, {}); // nothing was made, but the file shows something else
    document.commit(setFabric(document.design(), 1, "Wool"));
    expect(true, {.edits = 1});
    document.jumpTo(1);
    expect(true, {.edits = 1, .elsewhere = 1}); // the branch is in no file
    const HistoryMark before = document.mark();
    document.nameVersion(2, "Cheaper");
    document.setHeld({before, false}); // a save that took a while
    expect(true, {.names = true});
    document.nameVersion(2, "");
    expect(false, {});
    document.nameBranch(2, "Wool");
    expect(true, {.names = true});
    document.markSaved();
    expect(false, {});
    document.reset(Design());
    expect(false, {});
    EXPECT_EQ(document.history().count(), 1);
}

TEST(Document, ATextHoldsTheDesignAndTheWayToItButNoBranchesOrNames)
{
    Document document;
    for (const char* name : {"Leather", "Wool", "Felt"})
        document.commit(setFabric(document.design(), 1, name));
    const auto save = [&] { document.setHeld({{document.history().current(), 1, {}}, true}); };
    save();
    EXPECT_FALSE(document.dirty());
    EXPECT_FALSE(document.hasUnsavedWork());
    document.undo();
    EXPECT_TRUE(document.dirty());
    EXPECT_EQ(document.unsavedWork(), UnsavedWork{.another = true});
    document.commit(setFabric(document.design(), 1, "Linen"));
    save();
    EXPECT_FALSE(document.dirty()) << "saving it once more would not help";
    EXPECT_EQ(document.unsavedWork(), (UnsavedWork{.edits = 1, .elsewhere = 1}));
    document.nameVersion(1, "First");
    EXPECT_FALSE(document.dirty());
    EXPECT_TRUE(document.unsavedWork().names);
}

TEST(Document, CanBeChangedFromItsOwnSignal)
{
    Document document;
    QObject::connect(&document, &Document::changed, [&](const ChangeSet& ids) {
        if (ids.contains(ElementId{1}))
            document.commit(setFabric(document.design(), 2, "Lining"));
    });
    document.commit(setFabric(document.design(), 1, "Leather"));
    EXPECT_EQ(nameOf(document, 2), "Lining");
    EXPECT_EQ(document.history().count(), 3);
}

TEST(Gesture, ShowsPreviewsAndCommitsOneEdit)
{
    Document document;
    Witness witness(document);
    {
        Gesture gesture(document);
        for (const char* name : {"L", "Le", "Leather"})
            gesture.update(setFabric(gesture.start(), 1, name));
        EXPECT_EQ(nameOf(document, 1), "Leather");
        EXPECT_EQ(document.committed().find<Fabric>(ElementId{1}), nullptr);
        EXPECT_EQ(document.history().count(), 1);
        EXPECT_FALSE(document.dirty());
        gesture.commit();
        EXPECT_FALSE(gesture.active());
    }
    EXPECT_EQ(nameOf(document, 1), "Leather");
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_EQ(witness.count(), 3); // the commit itself changes nothing that is shown
    document.undo();
    EXPECT_EQ(nameOf(document, 1), "none");
}

TEST(Gesture, EveryPreviewStartsFromThePress)
{
    Document document;
    Gesture gesture(document);
    gesture.update(setFabric(gesture.start(), 1, "Leather"));
    gesture.update(setFabric(gesture.start(), 2, "Wool"));
    EXPECT_EQ(nameOf(document, 1), "none");
    EXPECT_EQ(nameOf(document, 2), "Wool");
}

TEST(Gesture, IsTakenBackByDestructionAndByEverythingElse)
{
    Document document;
    document.commit(setFabric(document.design(), 1, "Leather"));
    {
        Gesture gesture(document);
        gesture.update(setFabric(gesture.start(), 1, "Wool"));
    }
    EXPECT_EQ(nameOf(document, 1), "Leather");

    const std::vector<std::function<void()>> others = {
        [&] { document.cancelGesture(); }, [&] { document.undo(); },
        [&] { document.redo(); },          [&] { document.commit(setFabric(document.design(), 3, "Lining")); },
        [&] { document.jumpTo(0); },       [&] { document.reset(Design()); },
        [&] { Gesture second(document); },
    };
    for (const auto& other : others) {
        Gesture gesture(document);
        gesture.update(setFabric(gesture.start(), 2, "Preview"));
        const NodeId count = document.history().count();
        other();
        EXPECT_FALSE(gesture.active());
        EXPECT_FALSE(document.gestureRunning());
        gesture.update(setFabric(gesture.start(), 2, "Late"));
        gesture.commit();
        EXPECT_EQ(nameOf(document, 2), "none");
        EXPECT_LE(document.history().count(), count + 1);
    }
}

TEST(Gesture, CommitsNothingWhenThePreviewReturnedToTheStart)
{
    Document document;
    document.commit(setFabric(document.design(), 1, "Leather"));
    Gesture gesture(document);
    gesture.update(setFabric(gesture.start(), 1, "Wool"));
    gesture.update(setFabric(gesture.start(), 1, "Leather"));
    gesture.commit();
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_EQ(nameOf(document, 1), "Leather");

    Gesture unmoved(document);
    unmoved.commit();
    EXPECT_EQ(document.history().count(), 2);
}

TEST(Gesture, ItsEndIsSaidOnceHoweverItEnds)
{
    Document document;
    document.commit(setFabric(document.design(), 1, "a"));
    int ends = 0;
    QObject::connect(&document, &Document::gestureEnded, [&] {
        ++ends;
        EXPECT_FALSE(document.gestureRunning());
        EXPECT_EQ(document.design(), document.committed());
    });
    const auto endsOf = [&](const auto& use) {
        ends = 0;
        Gesture gesture(document);
        use(gesture);
        return ends;
    };
    const auto rename = [&](Gesture& gesture) { gesture.update(setFabric(gesture.start(), 1, "b")); };
    EXPECT_EQ(endsOf([&](Gesture& gesture) { rename(gesture), gesture.commit(); }), 1);
    EXPECT_EQ(endsOf([&](Gesture& gesture) { rename(gesture), gesture.cancel(); }), 1);
    EXPECT_EQ(endsOf([](Gesture& gesture) { gesture.commit(); }), 1) << "changed nothing";
    EXPECT_EQ(endsOf([](Gesture& gesture) { gesture.letGo(), gesture.takeUp(), gesture.cancel(); }), 1);
    EXPECT_EQ(endsOf([&](Gesture& gesture) { rename(gesture), document.undo(); }), 1);
    EXPECT_EQ(endsOf([&](Gesture& gesture) { rename(gesture), gesture.letGo(), document.finishGesture(); }), 1);
    EXPECT_EQ(endsOf([&](Gesture& gesture) { rename(gesture), document.reset({}); }), 1);
    EXPECT_EQ(endsOf([&](Gesture&) {}), 0) << "still running";
    EXPECT_EQ(ends, 1) << "destroyed";
    document.commit(setFabric(document.design(), 1, "c"));
    EXPECT_EQ(ends, 1) << "no gesture, no end";
}

TEST(Gesture, SurvivesItsDocument)
{
    auto document = std::make_unique<Document>();
    Gesture gesture(*document);
    document.reset();
    EXPECT_FALSE(gesture.active());
    gesture.update({});
    gesture.commit();
}

/// A few random changes, some of them without effect.
Edit randomEdit(const Design& design, std::mt19937& random)
{
    Edit edit{{"Random", {}}, {}};
    for (int changes = static_cast<int>(random() % 3) + 1; changes > 0; --changes) {
        const int id = static_cast<int>(random() % 8);
        const Edit one = id == 0             ? setEdgeLength(design, 5.0 + random() % 3)
                         : random() % 4 == 0 ? remove(design, id)
                                             : setFabric(design, id, std::string(1, "abc"[random() % 3]));
        edit.changes.insert(edit.changes.end(), one.changes.begin(), one.changes.end());
    }
    return edit;
}

TEST(Document, EqualsItsReplayAfterAnySequence)
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Document document;
        Witness witness(document);
        std::unique_ptr<Gesture> gesture;
        for (int step = 0; step < 250 && !::testing::Test::HasFailure(); ++step) {
            SCOPED_TRACE(step);
            switch (random() % 13) {
            case 0:
            case 1:
                document.commit(randomEdit(document.design(), random));
                break;
            case 2:
            case 3:
                document.undo();
                break;
            case 4:
                document.redo();
                break;
            case 5:
                document.jumpTo(static_cast<NodeId>(random() % static_cast<unsigned>(document.history().count())));
                break;
            case 6:
                gesture.reset();
                gesture = std::make_unique<Gesture>(document);
                break;
            case 7:
            case 8:
            case 9:
                if (gesture)
                    gesture->update(randomEdit(gesture->start(), random));
                break;
            case 10:
                if (gesture)
                    gesture->commit();
                break;
            case 11:
                gesture.reset();
                break;
            case 12:
                if (random() % 20 == 0) {
                    const Design root = document.committed();
                    document.reset(root);
                    witness.setRoot(root);
                } else {
                    document.markSaved();
                }
                break;
            }
            witness.check();
        }
    }
}

TEST(History, EveryNodeIsReachedFromEveryOther)
{
    std::mt19937 random(7);
    Document document;
    std::vector<Design> states = {document.design()};
    for (int i = 0; i < 60; ++i) {
        document.jumpTo(static_cast<NodeId>(random() % states.size()));
        document.commit(setFabric(document.design(), static_cast<int>(random() % 5) + 1, std::to_string(i)));
        states.push_back(document.design());
    }
    ASSERT_EQ(document.history().count(), static_cast<NodeId>(states.size()));
    for (int i = 0; i < 500; ++i) {
        const auto node = random() % states.size();
        document.jumpTo(static_cast<NodeId>(node));
        EXPECT_EQ(slowDifferences(document.design(), states[node]), ChangeSet{});
    }
}

} // namespace
} // namespace bolster
