#include "ReadGuarded.h"

#include "FileRefused.h"
#include "WholeFile.h"

#include <QFileInfo>

#include <new>

namespace bolster {
namespace {

constexpr std::int64_t largestFile = 2'000'000'000;

/// "armchair.obj:17", "seat.stl (byte 84)"
std::string placeText(const std::string& file, const FilePlace& place)
{
    switch (place.unit) {
    case FilePlace::Unit::Line:
        return file + ":" + std::to_string(place.number);
    case FilePlace::Unit::Byte:
        return file + " (byte " + std::to_string(place.number) + ")";
    case FilePlace::Unit::File:
        break;
    }
    return file;
}

} // namespace

Message readGuarded(const QString& path, const std::function<void(std::string_view bytes)>& read)
{
    const WholeFile file = readWholeFile(path, largestFile);
    if (!file.problem.empty())
        return file.problem;
    const std::string name = QFileInfo(path).fileName().toStdString();
    try {
        read(file.bytes);
        return {};
    } catch (const FileRefused& refused) {
        std::vector<std::string> args = {placeText(name, refused.place)};
        args.insert(args.end(), refused.args.begin(), refused.args.end());
        return {refused.sentence, std::move(args)};
    } catch (const std::bad_alloc&) {
        return {QT_TRANSLATE_NOOP("Message", "%1: there is not enough memory for this mesh"), {name}};
    }
}

} // namespace bolster
