// IEC 61131-10:2019, the standard that PLCopen XML became, as Sysmac Studio, GX Works3, PLCnext Engineer and others
// write it. A file of it is read by making the same project in PLCopen XML, which the reader of that format takes from
// there. Functions; any thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

inline constexpr const char* kStandardNamespace = "www.iec.ch/public/TC65SC65BWG7TF10";

/// A whole project, or a single unit as Bachmann stores it.
[[nodiscard]] bool isStandardXml(const XmlFile& file);
/// Elements that PLCopen XML does not have are reported.
[[nodiscard]] XmlFile asPlcopen(const XmlFile& file, Report& report);

} // namespace plc::exchange
