// The OpenGL that the 3D view needs: 3.3, core profile.
#pragma once

#include <QOpenGLFunctions_3_3_Core>
#include <QString>

class QSurfaceFormat;

namespace bolster {

using GlFunctions = QOpenGLFunctions_3_3_Core;

/// Of the current context; null when it is older.
GlFunctions* glFunctions();

/// The format to ask for.
QSurfaceFormat glFormat();

/// Why OpenGL cannot be used here, for the user, or "". Tries a context of its own; never crashes where a widget
/// would (Qt's offscreen platform).
QString glProblem();
/// Whether it is worth trying.
bool promisesGl();
/// Loads what OpenGL comes in, which takes long the first time; on any thread.
void loadGl();

} // namespace bolster
