// Thousands of damaged designs: none may crash or hang, and what can be read is written and read back equal.
#include "DesignCheck.h"
#include "DesignJson.h"

#include "DesignFuzz.h"
#include "Random.h"
#include "TestData.h"

namespace bolster {
namespace {

std::string damaged(std::string text, test::Random& random)
{
    static constexpr const char* fragments[] = {"1e999", "-0",
                                                "null",  "\"id\": 2",
                                                "[]",    "{}",
                                                "[[[[",  "1e7",
                                                "\\u00", "true",
                                                "\xC3",  "-1e-400",
                                                "2",     "\"knots\": [0,1,2,3,4], ",
                                                "0.5,",  "}",
                                                ", ",    "\"",
                                                "1e308", "9007199254740993"};
    const auto place = [&] { return static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()))); };
    for (int count = random.whole(1, 3); count > 0; --count) {
        switch (random.whole(0, 5)) {
        case 0:
            text.erase(place(), static_cast<std::size_t>(random.whole(1, 30)));
            break;
        case 1:
            text.insert(place(), fragments[random.whole(0, std::size(fragments) - 1)]);
            break;
        case 2: {
            // A digit for a digit leaves the text readable and its numbers wrong.
            const std::size_t digit = text.find_first_of("0123456789", place());
            if (digit != std::string::npos)
                text[digit] = static_cast<char>('0' + random.whole(0, 9));
            break;
        }
        case 3:
            text.insert(place(), text.substr(place(), static_cast<std::size_t>(random.whole(1, 60))));
            break;
        case 4: {
            const std::size_t value = text.find(": ", place());
            const std::size_t end = value == std::string::npos ? value : text.find_first_of(",}", value);
            if (end != std::string::npos)
                text.replace(value + 2, end - value - 2, fragments[random.whole(0, std::size(fragments) - 1)]);
            break;
        }
        default:
            if (const std::size_t byte = place(); byte < text.size())
                text[byte] = static_cast<char>(random.whole(0, 255));
        }
    }
    return text;
}

TEST(DesignFuzz, DamagedDesignsAreReadWrittenAndCheckedWithoutHarm)
{
    test::Random random(2024);
    const std::string small = writeDesign(
        readDesign(R"({"format": "bolster-design", "version": 1, "settings": {"colourway": 15, "symmetry": {"plane":
      {"normal": [1, 0, 1]}, "axis": {"point": [5, 0]}}}, "elements": [
      {"id": 1, "kind": "fabric", "name": "Leather", "poisson": 0.2, "color": "#123456",
       "look": {"kind": "image", "scale_mm": 90, "relief": 0, "file": "w.png"}, "limits": {"shear": 3}},
      {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "position": [10, 20], "grain": 45,
       "outline": {"degree": 3, "closed": true, "corners": [0, 3], "points": [[0,0],[50,-9],[99,0],[99,60],[50,70],[0,60]]}},
      {"id": 3, "kind": "fixation_curve", "name": "Rail", "curve": {"degree": 2, "closed": false,
       "knots": [0, 0, 0, 1.5, 3, 3, 3], "points": [[0,0,0],[50,0,20],[80,0,20],[99,0,0]]}},
      {"id": 4, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 3, "curve": 3, "curve_from": 0.5, "curve_to": 2},
      {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 3, "to": 4}, "b": {"patch": 2, "from": 5, "to": 0},
       "continuity": "G1", "reversed": false, "trim": {"stitch": "twin", "piping_radius_mm": 3, "piping_fabric": 1}},
      {"id": 7, "kind": "frame", "name": "F", "file": "f.obj", "rotation": [0.6, 0.8, 0, 0], "contact": true,
       "material": {"kind": "wood", "color": "#7a5a33"}},
      {"id": 8, "kind": "handle_curve", "name": "H", "patch": 2, "match": "parameter", "curve": {"degree": 1,
       "closed": false, "points": [[20,20],[60,20]]}, "target": {"degree": 1, "closed": false, "points": [[20,20,9],[60,20,9]]}},
      {"id": 9, "kind": "fancy_seam", "name": "S", "patch": 2, "width": 8, "depth": -2, "profile": "welt",
       "curve": {"degree": 1, "closed": false, "points": [[20,40],[60,40]]}},
      {"id": 10, "kind": "cushion", "name": "C", "frame": 7, "parts": ["A"], "patches": [2], "voxel_mm": 4},
      {"id": 11, "kind": "foam", "name": "W", "cushion": 10, "shape": "sphere", "size": [1, 2, 3], "cut": true},
      {"id": 12, "kind": "scan", "name": "S", "file": "s.ply", "threshold_mm": 40, "enabled": false, "target": "point",
       "cuts": [{"planes": [[0, 0, 1, 5]]}, {"planes": [[1, 0, 0, 9], [-1, 0, 0, 9]], "keep": true}]},
      {"id": 13, "kind": "patch", "name": "Twin", "fabric": 1, "position": [-10, 20], "twin": {"of": 2, "released": [4]},
       "outline": {"degree": 3, "closed": true, "corners": [0, 3],
        "points": [[0,0],[-50,-9],[-99,0],[-99,60],[-50,75],[0,60]]}},
      {"id": 14, "kind": "fixation_curve", "name": "Twin", "twin": {"of": 3}, "curve": {"degree": 2, "closed": false,
       "knots": [0, 0, 0, 1.5, 3, 3, 3], "points": [[0,0,0],[-50,0,20],[-80,0,20],[-99,0,0]]}},
      {"id": 15, "kind": "colourway", "name": "W", "fabrics": [{"patch": 2, "fabric": 1}, {"patch": 13, "fabric": 1}]},
      {"id": 16, "kind": "outline_trim", "patch": 13, "from": 0, "to": 1, "trim": {"thread": "#123456", "valley": false}}]})")
            .design);
    const std::string large = test::designText("car-seat-tied");
    int readable = 0;
    for (int i = 0; i < 4000; ++i) {
        const std::string text = damaged(i % 20 == 0 ? large : small, random);
        SCOPED_TRACE(testing::Message() << "text " << i << ": " << text);
        readable += test::fuzzDesign(text);
        if (testing::Test::HasFailure())
            return;
    }
    EXPECT_GT(readable, 400);
    EXPECT_LT(readable, 3800);
}

} // namespace
} // namespace bolster
