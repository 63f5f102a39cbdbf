// The question when a file was changed by another program and here: compare and merge, load it, or keep what is here.
// GUI thread.
#pragma once
#include <QString>

#include <optional>
#include <string>

class QWidget;

namespace plc::app {

enum class DiskChoice : uint8_t { KeepHere, LoadFromDisk, Merged };
struct DiskAnswer {
    DiskChoice choice = DiskChoice::KeepHere;
    std::string merged; // the text to go on with
};

[[nodiscard]] DiskAnswer askAboutDiskChange(const QString& file, const std::string& here, const std::string& onDisk,
                                            QWidget* parent);

} // namespace plc::app
