#include "runtime/compiler/parse/section_keyword.h"

namespace plc::syntax {

std::string_view keywordOf(SectionKind kind) {
    switch (kind) {
    case SectionKind::Var:
        return "VAR";
    case SectionKind::Input:
        return "VAR_INPUT";
    case SectionKind::Output:
        return "VAR_OUTPUT";
    case SectionKind::InOut:
        return "VAR_IN_OUT";
    case SectionKind::Temp:
        return "VAR_TEMP";
    case SectionKind::Stat:
        return "VAR_STAT";
    case SectionKind::Inst:
        return "VAR_INST";
    case SectionKind::Global:
        return "VAR_GLOBAL";
    case SectionKind::External:
        return "VAR_EXTERNAL";
    case SectionKind::Access:
        return "VAR_ACCESS";
    case SectionKind::Config:
        return "VAR_CONFIG";
    }
    return {};
}

} // namespace plc::syntax
