#include "projects/exchange/base/tool_types.h"

#include "projects/exchange/base/format_functions.h"
#include "projects/exchange/base/tool_libraries.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"
#include "runtime/library/sources.h"

#include <algorithm>
#include <optional>

namespace plc::exchange {
namespace {

using lex::TokenKind;

struct ToolType {
    std::string_view name, type;
};

/// Of TwinCAT's system library.
constexpr ToolType kTwinCat[] = {
    {"T_MaxString", "STRING(255)"},
    {"PVOID", "POINTER TO BYTE"},
    {"HRESULT", "DINT"},
    {"TcEventSeverity", "(Verbose, Info, Warning, Error, Critical) UINT"},
    {"T_AmsNetId", "STRING(23)"},
    {"T_AmsPort", "UINT"},
    {"T_IPv4Addr", "STRING(15)"},
    {"T_AmsNetIdArr", "ARRAY[0..5] OF BYTE"},
    {"ST_LibVersion",
     "STRUCT iMajor, iMinor, iBuild, iRevision : UINT; nFlags : DWORD; sVersion : STRING(23); END_STRUCT"},
    {"TIMESTRUCT", "STRUCT wYear, wMonth, wDayOfWeek, wDay, wHour, wMinute, wSecond, wMilliseconds : WORD; END_STRUCT"},
    {"T_FILETIME", "STRUCT dwLowDateTime, dwHighDateTime : DWORD; END_STRUCT"},
    {"T_FILETIME64", "ULINT"},
    {"T_DCTIME32", "UDINT"},
    {"T_DCTIME64", "ULINT"}};

/// Beremiz has a type HMI_INT beside INT, and so on, for variables that its panels see; HMI_NODE groups them.
std::optional<std::string> panelType(std::string_view name) {
    constexpr std::string_view kElementary[] = {"BOOL",  "SINT", "INT",   "DINT",   "LINT", "USINT", "UINT",  "UDINT",
                                                "ULINT", "REAL", "LREAL", "STRING", "BYTE", "WORD",  "DWORD", "LWORD"};
    if (name == "HMI_NODE") return "BOOL";
    if (!name.starts_with("HMI_")) return std::nullopt;
    const auto known = std::find(std::begin(kElementary), std::end(kElementary), name.substr(4));
    return known == std::end(kElementary) ? std::nullopt : std::optional(std::string(*known));
}

struct ToolBlock {
    std::string_view name, needs, text;
};

constexpr std::string_view kAdsLogMessageTypes = "AdsLogMessageTypes";

/// Functions of TwinCAT's and CODESYS's libraries that need nothing but the language.
/// TwinCAT's messages to its log become lines of a list that watches, recordings and tests see.
constexpr ToolBlock kFunctions[] = {
    {"ADSLOGSTR", "AdsLogAdd",
     "FUNCTION ADSLOGSTR : DINT\nVAR_INPUT\n    msgCtrlMask : DWORD;\n    msgFmtStr : STRING(255);\n"
     "    strArg : STRING(255);\nEND_VAR\nADSLOGSTR := AdsLogAdd(msgFmtStr, '%s', strArg);\nEND_FUNCTION\n"},
    {"ADSLOGDINT", "AdsLogAdd",
     "FUNCTION ADSLOGDINT : DINT\nVAR_INPUT\n    msgCtrlMask : DWORD;\n    msgFmtStr : STRING(255);\n"
     "    dintArg : DINT;\nEND_VAR\nADSLOGDINT := AdsLogAdd(msgFmtStr, '%d', DINT_TO_STRING(dintArg));\n"
     "END_FUNCTION\n"},
    {"ADSLOGLREAL", "AdsLogAdd",
     "FUNCTION ADSLOGLREAL : DINT\nVAR_INPUT\n    msgCtrlMask : DWORD;\n    msgFmtStr : STRING(255);\n"
     "    lrealArg : LREAL;\nEND_VAR\nADSLOGLREAL := AdsLogAdd(msgFmtStr, '%f', LREAL_TO_STRING(lrealArg));\n"
     "END_FUNCTION\n"},
    {"AdsLogAdd", "AdsLogMessageTypes",
     "{gvl AdsLog}\nVAR_GLOBAL\n    adsLogLines : ARRAY[1..50] OF STRING(255); // the newest first\n"
     "    adsLogCount : UDINT; // since the start\nEND_VAR\n\n"
     "/// Puts a line at the head of the log, with a value in the place of its mark.\n"
     "FUNCTION AdsLogAdd : DINT\nVAR_INPUT\n    text : STRING(255);\n    mark : STRING(2);\n    value : STRING(255);\n"
     "END_VAR\nVAR\n    i, place : INT;\nEND_VAR\nFOR i := 50 TO 2 BY -1 DO\n    AdsLog.adsLogLines[i] := "
     "AdsLog.adsLogLines[i - "
     "1];\n"
     "END_FOR\nplace := FIND(text, mark);\nIF place > 0 THEN\n    AdsLog.adsLogLines[1] := REPLACE(text, value, 2, "
     "place);\n"
     "ELSE\n    AdsLog.adsLogLines[1] := text;\nEND_IF\nAdsLog.adsLogCount := AdsLog.adsLogCount + 1;\nAdsLogAdd := "
     "0;\nEND_FUNCTION\n"},
    {kAdsLogMessageTypes, "",
     "{gvl AdsLogMessageTypes}\nVAR_GLOBAL CONSTANT\n    ADSLOG_MSGTYPE_HINT : DWORD := 16#01;\n"
     "    ADSLOG_MSGTYPE_WARN : DWORD := 16#02;\n    ADSLOG_MSGTYPE_ERROR : DWORD := 16#04;\n"
     "    ADSLOG_MSGTYPE_LOG : DWORD := 16#10;\n    ADSLOG_MSGTYPE_MSGBOX : DWORD := 16#20;\n"
     "    ADSLOG_MSGTYPE_RESOURCE : DWORD := 16#40;\n    ADSLOG_MSGTYPE_STRING : DWORD := 16#80;\nEND_VAR\n"},
    {"F_GetSystemTime", "",
     "/// 100 ns since 1601-01-01, from the calendar of the controller.\nFUNCTION F_GetSystemTime : ULINT\n"
     "F_GetSystemTime := 116444736000000000 + TO_ULINT(DT_TO_LINT(NOW())) * 10000000;\nEND_FUNCTION\n"},
    {"FAILED", "", "FUNCTION FAILED : BOOL\nVAR_INPUT\n    hr : DINT;\nEND_VAR\nFAILED := hr < 0;\nEND_FUNCTION\n"},
    {"SUCCEEDED", "",
     "FUNCTION SUCCEEDED : BOOL\nVAR_INPUT\n    hr : DINT;\nEND_VAR\nSUCCEEDED := hr >= 0;\nEND_FUNCTION\n"},
    {"LMOD", "",
     "FUNCTION LMOD : LREAL\nVAR_INPUT\n    lr_Value, lr_Arg : LREAL;\nEND_VAR\n"
     "LMOD := lr_Value - TRUNC(lr_Value / lr_Arg) * lr_Arg;\nEND_FUNCTION\n"},
    {"F_LTrim", "",
     "FUNCTION F_LTrim : STRING(255)\nVAR_INPUT\n    in : STRING(255);\nEND_VAR\nF_LTrim := in;\n"
     "WHILE LEN(F_LTrim) > 0 AND LEFT(F_LTrim, 1) = ' ' DO\n    F_LTrim := DELETE(F_LTrim, 1, 1);\nEND_WHILE\n"
     "END_FUNCTION\n"},
    {"F_RTrim", "",
     "FUNCTION F_RTrim : STRING(255)\nVAR_INPUT\n    in : STRING(255);\nEND_VAR\nF_RTrim := in;\n"
     "WHILE LEN(F_RTrim) > 0 AND RIGHT(F_RTrim, 1) = ' ' DO\n    F_RTrim := LEFT(F_RTrim, LEN(F_RTrim) - 1);\n"
     "END_WHILE\nEND_FUNCTION\n"},
    {"MEMCPY", "",
     "FUNCTION MEMCPY : UDINT\nVAR_INPUT\n    destAddr : POINTER TO BYTE;\n    srcAddr : POINTER TO BYTE;\n"
     "    n : UDINT;\nEND_VAR\nVAR\n    i : UDINT;\nEND_VAR\nFOR i := 1 TO n DO\n    destAddr^ := srcAddr^;\n"
     "    destAddr := destAddr + 1;\n    srcAddr := srcAddr + 1;\nEND_FOR\nMEMCPY := n;\nEND_FUNCTION\n"},
    {"MEMMOVE", "",
     "FUNCTION MEMMOVE : UDINT\nVAR_INPUT\n    destAddr : POINTER TO BYTE;\n    srcAddr : POINTER TO BYTE;\n"
     "    n : UDINT;\nEND_VAR\nVAR\n    i : UDINT;\nEND_VAR\nIF destAddr <= srcAddr THEN\n    FOR i := 1 TO n DO\n"
     "        destAddr^ := srcAddr^;\n        destAddr := destAddr + 1;\n        srcAddr := srcAddr + 1;\n    END_FOR\n"
     "ELSE // from the end: the parts overlap\n    destAddr := destAddr + n;\n    srcAddr := srcAddr + n;\n"
     "    FOR i := 1 TO n DO\n        destAddr := destAddr - 1;\n        srcAddr := srcAddr - 1;\n"
     "        destAddr^ := srcAddr^;\n    END_FOR\nEND_IF\nMEMMOVE := n;\nEND_FUNCTION\n"},
    {"MEMSET", "",
     "FUNCTION MEMSET : UDINT\nVAR_INPUT\n    destAddr : POINTER TO BYTE;\n    fillByte : USINT;\n    n : UDINT;\n"
     "END_VAR\nVAR\n    i : UDINT;\nEND_VAR\nFOR i := 1 TO n DO\n    destAddr^ := TO_BYTE(fillByte);\n"
     "    destAddr := destAddr + 1;\nEND_FOR\nMEMSET := n;\nEND_FUNCTION\n"},
    {"MEMCMP", "",
     "FUNCTION MEMCMP : DINT\nVAR_INPUT\n    pBuf1 : POINTER TO BYTE;\n    pBuf2 : POINTER TO BYTE;\n    n : UDINT;\n"
     "END_VAR\nVAR\n    i : UDINT;\nEND_VAR\nMEMCMP := 0;\nFOR i := 1 TO n DO\n    IF pBuf1^ <> pBuf2^ THEN\n"
     "        MEMCMP := SEL(pBuf1^ < pBuf2^, 1, -1);\n        RETURN;\n    END_IF\n    pBuf1 := pBuf1 + 1;\n"
     "    pBuf2 := pBuf2 + 1;\nEND_FOR\nEND_FUNCTION\n"}};

/// Blocks that only look at the clock: the type that they need, and the text.
constexpr ToolBlock kClockBlocks[] = {
    {"NT_GetTime", "TIMESTRUCT",
     "/// Date and time of the controller, one scan after START.\nFUNCTION_BLOCK NT_GetTime\nVAR_INPUT\n"
     "    NETID : STRING(23);\n    START : BOOL;\n    TMOUT : TIME := T#5s;\nEND_VAR\nVAR_OUTPUT\n"
     "    BUSY, ERR : BOOL;\n    ERRID : UDINT;\n    TIMESTR : TIMESTRUCT;\nEND_VAR\nVAR\n    started : R_TRIG;\n"
     "END_VAR\nstarted(CLK := START);\nIF BUSY THEN\n    TIMESTR.wYear := TO_WORD(YEAR_OF(NOW()));\n"
     "    TIMESTR.wMonth := TO_WORD(MONTH_OF(NOW()));\n    TIMESTR.wDayOfWeek := TO_WORD(DAY_OF_WEEK(NOW()));\n"
     "    TIMESTR.wDay := TO_WORD(DAY_OF(NOW()));\n    TIMESTR.wHour := TO_WORD(HOUR_OF(NOW()));\n"
     "    TIMESTR.wMinute := TO_WORD(MINUTE_OF(NOW()));\n    TIMESTR.wSecond := TO_WORD(SECOND_OF(NOW()));\n"
     "    TIMESTR.wMilliseconds := TO_WORD(MILLISECOND_OF(NOW()));\n    BUSY := FALSE;\nEND_IF\n"
     "IF started.Q THEN\n    BUSY := TRUE;\nEND_IF\nEND_FUNCTION_BLOCK\n"}};

/// Writes each of them that is called and that nothing declares.
void addFunctions(Imported& imported, std::map<std::string, std::string> called,
                  const std::set<std::string>& declared) {
    for (const ToolBlock& each : kFunctions)
        if (called.count(foldCase(each.name)) && !each.needs.empty()) called.emplace(foldCase(each.needs), each.needs);
    for (const ToolBlock& each : kFunctions) {
        if (!called.count(foldCase(each.name)) || declared.count(foldCase(each.name))) continue;
        addFile(imported, "", std::string(each.name), std::string(each.text));
        imported.report.add(imported.files.back().path, remarks::ToolTypesAdded(toolOf(imported)));
    }
}

/// FB_FormatString with its arguments, as far as they are used; what is written is no longer missing.
void addFormatting(Imported& imported, std::map<std::string, std::string>& missing,
                   const std::set<std::string>& declared) {
    std::map<std::string, std::string> texts; // by name
    for (const auto& [folded, name] : missing)
        if (folded.starts_with("f_") && !declared.count(folded))
            if (std::string text = formatArgumentText(std::string_view(name).substr(2)); !text.empty())
                texts.emplace(folded, std::move(text));
    const bool isByPointers = missing.count("fb_formatstring2") != 0 && !declared.count("fb_formatstring2");
    const bool isUsed = !texts.empty() || isByPointers || missing.count("fb_formatstring") || missing.count("t_arg");
    if (!isUsed || declared.count("fb_formatstring") || declared.count("t_arg")) return;
    texts.emplace("fb_formatstring", formatStringText());
    if (isByPointers) texts.emplace("fb_formatstring2", formatString2Text());
    missing.erase("t_arg");
    for (auto& [folded, text] : texts) {
        const auto name = missing.find(folded);
        addFile(imported, "", name == missing.end() ? "FB_FormatString" : name->second, std::move(text));
        imported.report.add(imported.files.back().path, remarks::ToolTypesAdded(toolOf(imported)));
        missing.erase(folded);
    }
}

/// Blocks of Beremiz that reach out of the controller: with their connections, so that programs which use them can be
/// checked and run; they do nothing here.
constexpr ToolBlock kBeremizBlocks[] = {
    {"LOGGER", "LOGLEVEL",
     "FUNCTION_BLOCK LOGGER\nVAR_INPUT\n    TRIG : BOOL;\n    MSG : STRING;\n    LEVEL : LOGLEVEL := INFO;\n"
     "END_VAR\nEND_FUNCTION_BLOCK\n"},
    {"LOGLEVEL", "", "TYPE LOGLEVEL : (CRITICAL, WARNING, INFO, DEBUG) := INFO;\nEND_TYPE\n"},
    {"python_eval", "",
     "FUNCTION_BLOCK python_eval\nVAR_INPUT\n    TRIG : BOOL;\n    CODE : STRING;\nEND_VAR\nVAR_OUTPUT\n    ACK : "
     "BOOL;\n"
     "    RESULT : STRING;\nEND_VAR\nEND_FUNCTION_BLOCK\n"},
    {"python_poll", "",
     "FUNCTION_BLOCK python_poll\nVAR_INPUT\n    TRIG : BOOL;\n    CODE : STRING;\nEND_VAR\nVAR_OUTPUT\n    ACK : "
     "BOOL;\n"
     "    RESULT : STRING;\nEND_VAR\nEND_FUNCTION_BLOCK\n"},
    {"python_gear", "",
     "FUNCTION_BLOCK python_gear\nVAR_INPUT\n    N : UINT;\n    TRIG : BOOL;\n    CODE : STRING;\nEND_VAR\nVAR_OUTPUT\n"
     "    ACK : BOOL;\n    RESULT : STRING;\nEND_VAR\nEND_FUNCTION_BLOCK\n"}};

/// Writes each block that is used and that nothing declares; one of them may need another.
void addToolBlocks(Imported& imported, std::set<std::string> used, const std::set<std::string>& declared) {
    for (const ToolBlock& block : kBeremizBlocks)
        if (used.count(foldCase(block.name)) && !block.needs.empty()) used.insert(foldCase(block.needs));
    for (const ToolBlock& block : kBeremizBlocks) {
        if (!used.count(foldCase(block.name)) || declared.count(foldCase(block.name))) continue;
        addFile(imported, "", std::string(block.name), std::string(block.text));
        imported.report.add(imported.files.back().path, remarks::ToolBlockEmpty(block.name));
    }
}

std::optional<std::string> twinCatType(std::string_view name) {
    for (const ToolType& each : kTwinCat)
        if (equalsIgnoringCase(name, each.name)) return std::string(each.type);
    return std::nullopt;
}

/// Folded names of a project and how they are written.
struct NamesInUse {
    std::map<std::string, std::string> types;  // behind `:`, OF or TO
    std::map<std::string, std::string> called; // in front of a parenthesis
    std::set<std::string> declared;            // in front of `:`, and units
    std::set<std::string> units;               // without the variables: what can be a type
    bool hasMessageTypes = false;              // ADSLOG_MSGTYPE_HINT and so on, also where nothing writes to the log
};

void gather(std::string_view text, NamesInUse& names) {
    auto& [used, called, declared, units, hasMessageTypes] = names;
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(0), text, sink);
    bool isInVariables = false;
    for (size_t i = 1; i < list.tokens.size(); ++i) {
        const lex::Token& token = list.tokens[i];
        if (token.kind == TokenKind::EndVar) isInVariables = false;
        if (equalsIgnoringCase(text.substr(token.begin, token.end - token.begin).substr(0, 3), "var") &&
            token.kind != TokenKind::Identifier)
            isInVariables = true;
        if (token.kind != TokenKind::Identifier) continue;
        const std::string name(text.substr(token.begin, token.end - token.begin));
        const lex::Token& before = list.tokens[i - 1];
        const bool isCalled = i + 1 < list.tokens.size() && list.tokens[i + 1].kind == TokenKind::LeftParen;
        if (isCalled && before.kind != TokenKind::Dot) called.emplace(foldCase(name), name);
        const bool isType = before.kind == TokenKind::Colon || before.kind == TokenKind::Of ||
                            equalsIgnoringCase(text.substr(before.begin, before.end - before.begin), "TO");
        const bool isQualifier = i + 1 < list.tokens.size() && list.tokens[i + 1].kind == TokenKind::Dot &&
                                 before.kind != TokenKind::Dot && twinCatType(name);
        if (isType || isQualifier)
            used.emplace(foldCase(name), name);
        else if (before.kind == TokenKind::FunctionBlock || before.kind == TokenKind::Function ||
                 (i + 1 < list.tokens.size() && list.tokens[i + 1].kind == TokenKind::Colon)) {
            declared.insert(foldCase(name));
            if (!isInVariables) units.insert(foldCase(name));
        } else if (foldCase(name).starts_with("adslog_msgtype_")) {
            hasMessageTypes = true;
        }
    }
}

/// Tc2_EtherCAT.Tc2_Utilities.TIMESTRUCT: the types that are declared here have no namespace.
void dropNamespacesOfTypes(ImportedFile& file) {
    const auto isLibrary = [](std::string_view name) {
        const std::string folded = foldCase(name);
        return folded.starts_with("tc2_") || folded.starts_with("tc3_");
    };
    const std::string before = file.text, folded = foldCase(before);
    if (folded.find("tc2_") == std::string::npos && folded.find("tc3_") == std::string::npos) return;
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(0), before, sink);
    const auto textAt = [&](size_t i) {
        return std::string_view(before).substr(list.tokens[i].begin, list.tokens[i].end - list.tokens[i].begin);
    };
    for (size_t i = list.tokens.size(); i-- > 2;) {
        if (list.tokens[i].kind != TokenKind::Identifier || !twinCatType(textAt(i))) continue;
        size_t first = i;
        while (first >= 2 && list.tokens[first - 1].kind == TokenKind::Dot &&
               list.tokens[first - 2].kind == TokenKind::Identifier)
            first -= 2;
        if (first != i && isLibrary(textAt(first)))
            file.text.erase(list.tokens[first].begin, list.tokens[i].begin - list.tokens[first].begin);
    }
}

/// Writes each block that is used and that nothing declares; the type it needs is in use then.
void addClockBlocks(Imported& imported, NamesInUse& names) {
    for (const ToolBlock& each : kClockBlocks) {
        if (names.units.count(foldCase(each.name)) || !names.types.erase(foldCase(each.name))) continue;
        names.types.emplace(foldCase(each.needs), each.needs);
        addFile(imported, "", std::string(each.name), std::string(each.text));
        imported.report.add(imported.files.back().path, remarks::ToolTypesAdded(toolOf(imported)));
    }
}

/// Objects of CODESYS 2.3 are exported without the list of libraries, and Beremiz has none: which of ours is meant is
/// known by the names that are used.
void useLibrary(Imported& imported, std::string_view library, const NamesInUse& names) {
    if (imported.libraries.count(std::string(library))) return;
    NamesInUse ours;
    for (const library::Source& source : library::sourcesOf(library)) gather(source.text, ours);
    std::map<std::string, std::string> all = names.types;
    all.insert(names.called.begin(), names.called.end());
    for (const auto& [folded, name] : all) {
        if (!ours.units.count(folded) || names.units.count(folded)) continue;
        imported.libraries.insert(std::string(library));
        return imported.report.add(imported.name, remarks::LibraryAdded(name, library));
    }
}

} // namespace

std::string toolOf(const Imported& imported) {
    if (!imported.side.contains("source")) return {};
    const nlohmann::ordered_json& source = imported.side["source"];
    return source.value("product", source.value("format", ""));
}

void addToolTypes(Imported& imported) {
    const std::string tool = foldCase(toolOf(imported));
    const bool isBeremiz = tool.find("beremiz") != std::string::npos, isTwinCat = tool.find("twincat") == 0;
    const bool isCodesys = tool.find("codesys") != std::string::npos;
    if (!isBeremiz && !isTwinCat && !isCodesys) return;
    if (isTwinCat)
        for (ImportedFile& file : imported.files) dropNamespacesOfTypes(file);
    NamesInUse names;
    for (const ImportedFile& file : imported.files) gather(file.text, names);
    if (isTwinCat) addClockBlocks(imported, names);
    const auto& [used, called, declared, units, hasMessageTypes] = names;
    if (tool == "codesys 2.3") useLibrary(imported, "util", names);
    if (isBeremiz) useLibrary(imported, "analog", names); // the blocks of Annex F
    if (!isBeremiz) {
        std::map<std::string, std::string> functions = called;
        if (isTwinCat && hasMessageTypes && !declared.count("adslog_msgtype_hint"))
            functions.emplace(foldCase(kAdsLogMessageTypes), kAdsLogMessageTypes);
        addFunctions(imported, std::move(functions), declared);
    }
    if (isBeremiz) {
        std::set<std::string> types;
        for (const auto& [folded, name] : used) types.insert(folded);
        addToolBlocks(imported, std::move(types), units);
    }
    std::string text;
    std::map<std::string, std::string> missing = used;
    missing.insert(called.begin(), called.end());
    for (const auto& [folded, name] : used)
        if (const auto type = isBeremiz   ? panelType(name)
                              : isTwinCat ? twinCatType(name)
                                          : std::optional<std::string>();
            type && !units.count(folded)) {
            if (type->starts_with("(")) text += "    {attribute 'qualified_only'}\n";
            text += "    " + name + " : " + *type + ";\n";
            missing.erase(folded);
        }
    if (isTwinCat) addFormatting(imported, missing, units);
    reportLibrariesUsed(imported, missing, declared);
    if (text.empty()) return;
    const std::string from = isBeremiz ? "the panels of Beremiz" : "the system library of TwinCAT";
    addFile(imported, "", "tool_types", "// types of " + from + "\nTYPE\n" + text + "END_TYPE\n");
    imported.report.add(imported.files.back().path, remarks::ToolTypesAdded(toolOf(imported)));
}

} // namespace plc::exchange
