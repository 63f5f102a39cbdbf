// Reads a picture of a panel from a file that anybody may have made: within the project unless it says otherwise, and
// within bounds of size, pixels and work, whatever the file claims. Functions, main thread (pixmaps).
#pragma once
#include "runtime/base/result.h"

#include <QPixmap>
#include <QString>

namespace plc::hmi {

/// Where pictures are looked for.
struct PictureFolder {
    QString path;          // the project's folder
    bool mayLeave = false; // the project allows pictures outside it
};

/// `wanted`: how large it will be drawn; a vector picture is drawn in that size, a larger raster is reduced.
[[nodiscard]] Result<QPixmap> loadPicture(const PictureFolder& folder, const QString& file, const QSizeF& wanted);

} // namespace plc::hmi
