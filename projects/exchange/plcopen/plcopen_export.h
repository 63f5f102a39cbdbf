// A project as PLCopen XML: version 0200 with the additions of CODESYS, or 0201 for Beremiz and OpenPLC; what the
// format has no place for is in the report. Function, any thread.
#pragma once
#include "projects/exchange/plcopen/xml_writer.h"
#include "projects/model/project.h"
#include "runtime/base/result.h"

namespace plc::exchange {

/// The element at the end of a project that says what a STRING is.
inline constexpr const char* kStringEncodingData = "stepwise/stringencoding";

struct ExportOptions {
    Edition edition = Edition::Codesys0200;
    std::string time = "2000-01-01T00:00:00"; // of creation, as the header says it
};
struct Exported {
    std::string text;
    Report report;
};
/// Sources with errors of syntax are refused; the error names the first.
[[nodiscard]] Result<Exported> exportPlcopen(const projects::Project& project, const ExportOptions& options);

} // namespace plc::exchange
