// What the File menu does, by what it is about.
#pragma once

#include "ExportFlow.h"
#include "ImportFlow.h"
#include "LeftWork.h"
#include "OpenFlow.h"
#include "Rescue.h"
#include "SaveFlow.h"

namespace bolster {

struct FileFlows {
    FileFlows(DesignSession& session, QWidget* window, Banner& banner)
        : talk(session, window)
        , saving(session, talk, banner)
        , rescue(talk, saving)
        , left(session, {talk, saving, rescue, banner})
        , opening(session, {talk, saving, left, rescue, banner})
        , imports(session, talk)
        , exports(session, talk)
    {}

    FileTalk talk;
    SaveFlow saving;
    Rescue rescue;
    LeftWork left;
    OpenFlow opening;
    ImportFlow imports;
    ExportFlow exports;
};

} // namespace bolster
