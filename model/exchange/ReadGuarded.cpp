#include "ReadGuarded.h"

#include "DiskFile.h"

#include <QFileInfo>

#include <new>

namespace bolster {
namespace {

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

ImportWatch warning(ImportWatch watch, const QString& path, Message& odd)
{
    watch.warn = [name = QFileInfo(path).fileName().toStdString(), &odd](const char* sentence,
                                                                         const std::string& figure) {
        odd = {sentence, {name}};
        if (!figure.empty())
            odd.args.push_back(figure);
    };
    return watch;
}

Message readGuarded(const QString& path, std::int64_t largest, const ImportWatch& watch,
                    const std::function<void(const FileBytes& bytes)>& read)
{
    Message problem;
    const auto file = DiskFile::open(path, largest, problem);
    if (!file)
        return problem;
    const auto readDisk = [&file](std::uint64_t at, char* to, std::size_t count) {
        return file->read(at, to, count) == static_cast<std::int64_t>(count);
    };
    const std::string name = QFileInfo(path).fileName().toStdString();
    try {
        read(FileBytes(readDisk, file->size(), watch));
        return {};
    } catch (const FileRefused& refused) {
        std::vector<std::string> args = {placeText(name, refused.place)};
        args.insert(args.end(), refused.args.begin(), refused.args.end());
        return {refused.sentence, std::move(args)};
    } catch (const ImportStopped&) {
        return {};
    } catch (const std::bad_alloc&) {
        return {QT_TRANSLATE_NOOP("Message", "%1: there is not enough memory for this file"), {name}};
    }
}

} // namespace bolster
