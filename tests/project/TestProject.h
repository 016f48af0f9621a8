// A small design with something of everything, edits by chance, and how long the loops run.
#pragma once

#include "../model/TestFiles.h"

#include "CurveEdits.h"
#include "DesignJson.h"
#include "Document.h"
#include "ElementEdits.h"
#include "Journal.h"
#include "PatchEdits.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>
#include <cstdlib>

#include <random>

namespace bolster::test {

/// The figure of this loop: `inCi`, or what the environment variable says (tests/soak).
inline int rounds(const char* variable, int inCi)
{
    const char* const text = std::getenv(variable);
    return text ? std::atoi(text) : inCi;
}

/// In memory where there is such a folder, for files that need not survive anything.
inline QString quickFolder()
{
    const QStorageInfo memory("/dev/shm");
    const bool usable = memory.isValid() && !memory.isReadOnly() && memory.bytesAvailable() > 50'000'000;
    return (usable ? QString("/dev/shm") : QDir::tempPath()) + "/bolster-XXXXXX";
}

inline const char* const projectText =
    R"({"format": "bolster-design", "version": 1, "unit": "mm", "settings": {"edge_length": 25}, "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather \"thick\"", "bending_length": 30.000000000000004},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "outline": {"degree": 1, "closed": true,
   "points": [[0, 0], [300, 0], [300, 300], [0.1, 300]]}},
  {"id": 3, "kind": "patch", "name": "Rücken", "fabric": 1, "position": [400, -0.0], "outline": {"degree": 3,
   "closed": true, "points": [[0, 0], [300, 0], [300, 300], [0, 300], [-20, 150]]}},
  {"id": 4, "kind": "fixation_curve", "name": "Front rail", "curve": {"degree": 1, "closed": false,
   "points": [[0, 0, 0], [300, 0, 1e-7]]}},
  {"id": 5, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 4},
  {"id": 6, "kind": "frame", "name": "Chair", "file": "chair.obj"},
  {"id": 7, "kind": "no such kind", "what": [1, 2, {"a": null}]},
  {"id": 7, "kind": "fabric", "name": "Same number"},
  {"id": 9, "kind": "scan", "name": "Room", "file": "scans/room.xyz"}]})";

inline Design smallDesign()
{
    return readDesign(projectText).design;
}

/// Does what a designer might, by chance.
class Hands {
public:
    explicit Hands(unsigned seed)
        : m_random(seed)
    {}

    int pick(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    double somewhere() { return std::uniform_real_distribution<double>(-20, 20)(m_random); }

    Edit edit(const Design& design)
    {
        const std::vector point = {pick(2)};
        std::vector<ElementId> ids;
        for (const auto& entry : design.elements())
            ids.push_back(entry.first);
        const ElementId any =
            ids.empty() ? noElement : ids[static_cast<std::size_t>(pick(static_cast<int>(ids.size())))];
        switch (pick(10)) {
        case 0:
            return edits::changeSettings(design, {10.0 + pick(5)});
        case 1:
            return edits::renameElement(design, any, std::string("Name ") + static_cast<char>('A' + pick(3)));
        case 2:
            return pick(3) == 0 ? edits::addElement(design, makeElement(Fabric{.name = "Wool"})) : Edit{};
        case 3:
            return pick(3) == 0 && ids.size() > 6 ? edits::removeElements(design, std::vector{ids.back()}) : Edit{};
        case 4:
            return edits::moveCurvePoints(design, ElementId{4}, point, {somewhere(), 0, somewhere()});
        default:
            return edits::movePatchPoints(design, ElementId{2 + pick(2)}, point, {somewhere(), somewhere()});
        }
    }

    /// An edit, or undo, redo or a jump.
    void step(Document& document)
    {
        switch (pick(8)) {
        case 0:
            document.undo();
            break;
        case 1:
            document.redo();
            break;
        case 2:
            document.jumpTo(static_cast<NodeId>(pick(document.history().count())));
            break;
        default:
            document.commit(edit(document.design()));
        }
    }

private:
    std::mt19937 m_random;
};

/// Everything that a history says.
inline std::string historyText(const History& history, bool withTimes = true)
{
    std::string text = std::to_string(history.current());
    for (NodeId id = 0; id < history.count(); ++id) {
        const History::Node& node = history.node(id);
        text += '\n';
        for (const qint64 number : {qint64{id}, qint64{node.parent}, qint64{node.lastVisitedChild},
                                    withTimes ? node.time.toMSecsSinceEpoch() : 0})
            text += std::to_string(number) + ' ';
        text += node.edit.verb.english() + ' ' + node.name;
        if (!node.branch.empty())
            text += " [" + node.branch + ']';
        for (const NodeId child : node.children)
            text += ' ' + std::to_string(child);
    }
    return text;
}

inline void expectFine(const Message& problem)
{
    EXPECT_EQ(problem.english(), "");
}

} // namespace bolster::test
