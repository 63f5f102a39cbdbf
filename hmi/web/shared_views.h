// What browsers that look at the same thing share: the recordings of a panel's elements, made once a frame by whichever
// of them comes first. Owned by the PaintStore; main thread.
#pragma once
#include <QByteArray>
#include <QHash>
#include <QRectF>
#include <QString>

#include <memory>
#include <vector>

namespace plc::hmi::web {

/// Commands one after another; `ends` says where each one ends.
struct Recording {
    QByteArray bytes;
    std::vector<uint32_t> ends;
    QString words; // texts in it, for screen readers
    QByteArrayView command(size_t index) const {
        const uint32_t begin = index == 0 ? 0 : ends[index - 1];
        return QByteArrayView(bytes).sliced(begin, ends[index] - begin);
    }
};

/// One element as it looks now. The same recording is the same look.
struct Piece {
    std::shared_ptr<const Recording> recording;
    QRectF bounds;
    bool isShown = false;
};

struct SharedView {
    qint64 at = -1; // the frame that it is of
    std::vector<Piece> pieces;
    QString state; // of the controller, in words
    bool isBad = false;
};

/// By everything that decides how it looks: panel, language, theme …; never of somebody who has touched it.
using SharedViews = QHash<QString, SharedView>;

} // namespace plc::hmi::web
