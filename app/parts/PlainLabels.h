// What is in a label is what stands there, unless the label says that it is rich text.
#pragma once

class QCoreApplication;

namespace bolster {

/// Names come from strangers' files. Qt takes text that looks like HTML for HTML, opens the files that it names and
/// waits for them. So labels, those of message boxes and tool tips too, take text as it is; whoever wants links or
/// bold words sets Qt::RichText and escapes what comes from elsewhere. Does nothing the second time.
void keepLabelsPlain(QCoreApplication& application);

} // namespace bolster
