#include "hmi/view/paint/picture_file.h"

#include "hmi/view/paint/svg_limits.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QPainter>
#include <QSvgRenderer>

#include <zlib.h>

namespace plc::hmi {

namespace {

constexpr qint64 kMegabyte = 1 << 20, kLargestFile = 32 * kMegabyte, kLargestSvg = 16 * kMegabyte;
constexpr qint64 kMostPixels = 32'000'000;
constexpr int kLargestSide = 4096; // of what is kept to be drawn

Error refuse(const QString& file, Message message) { return {std::move(message), toUtf8(file)}; }

bool isInside(const QString& folder, const QString& path) {
    const QString root = QFileInfo(folder).canonicalFilePath();
    return !root.isEmpty() && path.startsWith(root + u'/');
}

Result<QByteArray> readPicture(const PictureFolder& folder, const QString& file) {
    const std::string name = toUtf8(file);
    const QFileInfo info(QDir(folder.path).filePath(file));
    if (!folder.mayLeave && info.exists() && !isInside(folder.path, info.canonicalFilePath()))
        return refuse(file, errors::PictureOutside(name, Verbatim("picturesOutside"), Verbatim("hmi")));
    if (!info.exists()) return refuse(file, errors::FileMissing(name));
    if (!info.isFile()) return refuse(file, errors::NotAPicture(name)); // opening a pipe would wait for its writer
    if (info.size() > kLargestFile) return refuse(file, errors::PictureFileTooLarge(name, kLargestFile / kMegabyte));
    QFile in(info.filePath());
    if (!in.open(QIODevice::ReadOnly)) return refuse(file, errors::NotAPicture(name));
    return in.read(kLargestFile);
}

/// What gzip has packed, as far as the limit and one byte more; nothing if it is not whole.
QByteArray unpacked(const QByteArray& packed, qint64 limit) {
    z_stream stream{};
    if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) return {};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data())); // zlib does not write there
    stream.avail_in = static_cast<uInt>(packed.size());
    QByteArray out;
    int state = Z_OK;
    while (state == Z_OK && out.size() <= limit) {
        const qsizetype before = out.size(), piece = 64 * 1024;
        out.resize(before + piece);
        stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
        stream.avail_out = static_cast<uInt>(piece);
        state = inflate(&stream, Z_NO_FLUSH);
        out.resize(before + piece - static_cast<qsizetype>(stream.avail_out));
    }
    inflateEnd(&stream);
    if (state != Z_STREAM_END && out.size() <= limit) return {};
    return out;
}

Result<QPixmap> drawSvg(const QByteArray& svg, const QString& file, const QSizeF& wanted) {
    if (Message complaint = svgComplaint(svg, file); !complaint.isEmpty()) return refuse(file, std::move(complaint));
    QSvgRenderer renderer(svg);
    if (!renderer.isValid()) return refuse(file, errors::NotAPicture(toUtf8(file)));
    const QSizeF natural = renderer.defaultSize();
    const QSizeF size = natural.isEmpty() ? wanted : natural.scaled(wanted, Qt::KeepAspectRatioByExpanding);
    QPixmap picture(size.toSize().boundedTo(QSize(kLargestSide, kLargestSide)).expandedTo(QSize(1, 1)));
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    renderer.render(&painter);
    return picture;
}

Result<QPixmap> readRaster(QByteArray bytes, const QString& file) {
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer);
    const std::string name = toUtf8(file);
    if (!reader.canRead() || reader.format().startsWith("svg")) return refuse(file, errors::NotAPicture(name));
    const QSize size = reader.size();
    if (qint64(size.width()) * size.height() > kMostPixels)
        return refuse(file, errors::PictureTooManyPixels(name, size.width(), size.height(), kMostPixels / 1'000'000));
    reader.setAutoTransform(true);
    if (size.width() > kLargestSide || size.height() > kLargestSide)
        reader.setScaledSize(size.scaled(kLargestSide, kLargestSide, Qt::KeepAspectRatio));
    const QImage image = reader.read();
    if (image.isNull()) return refuse(file, errors::NotAPicture(name));
    return QPixmap::fromImage(image);
}

} // namespace

Result<QPixmap> loadPicture(const PictureFolder& folder, const QString& file, const QSizeF& wanted) {
    Result<QByteArray> bytes = readPicture(folder, file);
    if (!bytes) return bytes.error();
    QByteArray content = std::move(*bytes);
    const bool isPacked = content.startsWith("\x1F\x8B");
    if (isPacked) content = unpacked(content, kLargestSvg);
    const bool isSvg =
        isPacked || file.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive) || content.trimmed().startsWith('<');
    if (!isSvg) return readRaster(std::move(content), file);
    if (content.size() > kLargestSvg)
        return refuse(file, isPacked ? errors::PictureUnpacksTooLarge(toUtf8(file), kLargestSvg / kMegabyte)
                                     : errors::PictureFileTooLarge(toUtf8(file), kLargestSvg / kMegabyte));
    return drawSvg(content, file, wanted);
}

} // namespace plc::hmi
