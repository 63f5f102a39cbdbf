#include "projects/exchange/base/tool_libraries.h"

#include "runtime/base/text.h"

namespace plc::exchange {
namespace {

struct ToolNames {
    std::string_view library, names; // names with blanks around each
};

/// Whole families begin with a prefix, which ends with *.
constexpr ToolNames kToolNames[] = {
    {"Tc2_System",
     " ADSREAD ADSREADEX ADSWRITE ADSRDWRT ADSRDWRTEX ADSRDSTATE ADSWRTCTL ADSRDDEVINFO ADSREADIND ADSWRITEIND "
     "ADSREADRES ADSWRITERES FB_FileOpen FB_FileClose FB_FileRead FB_FileWrite FB_FileGets FB_FilePuts FB_FileSeek "
     "FB_FileTell FB_FileEOF FB_FileDelete FB_FileRename FB_CreateDir FB_RemoveDir FB_EOF DRAND GETCURTASKINDEX "
     "FB_GetCurTaskIdx FB_IecCriticalSection FW_* SETBIT32 CSETBIT32 GETBIT32 CLEARBIT32 TestAndSet "
     "FB_CreateGUID T_AmsAddr ST_AmsAddr E_OpenPath GETTASKTIME F_CreateAmsNetId F_ScanAmsNetIds "
     "PlcAppSystemInfo PlcTaskSystemInfo FB_SetLedColor_BAPI FB_NamedPipe AnalyzeExpression "},
    {"Tc2_Utilities",
     " FB_LocalSystemTime FB_GetTimeZoneInformation FB_SetTimeZoneInformation NT_GetTime NT_SetLocalTime "
     "NT_StartProcess "
     "NT_Shutdown NT_Reboot NT_AbortShutdown RTC_EX RTC_EX2 DCF77_TIME F_GetSystemTime FILETIME_TO_DT IsFinite "
     "FILETIME64_TO_SYSTEMTIME "
     "SYSTEMTIME_TO_DT DT_TO_SYSTEMTIME SYSTEMTIME_TO_STRING STRING_TO_SYSTEMTIME FB_FormatString FB_FormatString2 "
     "F_INT F_UINT F_DINT F_UDINT F_LREAL F_REAL F_STRING F_BOOL F_BYTE F_WORD F_DWORD F_SINT F_USINT T_Arg "
     "FB_MemRingBuffer FB_MemRingBufferEx FB_MemStackBuffer FB_StringRingBuffer FB_HashTableCtrl FB_LinkedListCtrl "
     "FB_CSVMemBufferReader FB_CSVMemBufferWriter FB_EnumFindFileEntry FB_EnumFindFileList FB_GetAdaptersInfo "
     "FB_GetHostName FB_GetHostAddrByName PLC_Start PLC_Stop PLC_Reset TC_Restart TC_Stop TC_Config DINT_TO_DECSTR "
     "DWORD_TO_HEXSTR LREAL_TO_FMTSTR BE16_TO_HOST BE32_TO_HOST BE64_TO_HOST HOST_TO_BE16 HOST_TO_BE32 HOST_TO_BE64 "
     "BYTE_TO_HEXSTR WORD_TO_HEXSTR HEXSTR_TO_DATA DATA_TO_HEXSTR F_ToUCase F_ToLCase FB_BasicPID "
     "FB_RegQueryValue FB_RegSetValue Profiler FB_WritePersistentData WritePersistentData "},
    {"Tc2_MC2",
     " AXIS_REF MC_Power MC_Reset MC_Home MC_Halt MC_Stop MC_Jog MC_SetPosition MC_SetOverride MC_GearIn MC_GearOut "
     "MC_Move* "
     "MC_Read* MC_Write* MC_TouchProbe MC_AbortTrigger MC_Direction MC_BufferMode MC_HomingMode MC_AxisStates "
     "MC_AxisParameter ST_McOutputs ST_MoveOptions TRIGGER_REF PLCTONC_AXIS_REF NCTOPLC_AXIS_REF ST_AxisStatus "
     "E_JogMode "
     "MC_ExtSetPointGenEnable MC_ExtSetPointGenDisable MC_ExtSetPointGenFeed "},
    {"Tc3_EventLogger",
     " FB_TcMessage FB_TcAlarm FB_TcEventLogger FB_TcEvent FB_ListenerBase FB_ListenerBase2 "
     "FB_TcSourceInfo "
     "FB_TcArguments FB_RequestEventText I_TcMessage I_TcSourceInfo I_TcArguments I_TcEventBase TcEventEntry "
     "FB_TcClearLoggedEventsSettings TcEventConfirmationState "},
    {"Tc2_SerialCom",
     " ComBuffer SerialLineControl SerialLineControlADS SendString SendString255 ReceiveString ReceiveString255 "
     "SendByte "
     "ReceiveByte SendData ReceiveData ClearComBuffer EL6inData22B EL6outData22B KL6inData22B KL6outData22B "
     "ComError_t ComSerialLineMode_t "},
    {"Tc2_TcpIp",
     " FB_SocketConnect FB_SocketListen FB_SocketAccept FB_SocketClose FB_SocketCloseAll FB_SocketSend "
     "FB_SocketReceive "
     "FB_SocketUdpCreate FB_SocketUdpSendTo FB_SocketUdpReceiveFrom FB_ClientServerConnection T_HSOCKET ST_SockAddr "
     "FB_ServerClientConnection T_HSERVER "},
    {"Tc2_EtherCAT",
     " FB_EcCoESdoRead FB_EcCoESdoWrite FB_EcCoESdoReadEx FB_EcCoESdoWriteEx FB_EcGetSlaveState FB_EcGetAllSlaveStates "
     "FB_EcGetMasterState FB_EcSetSlaveState FB_EcReqSlaveState ST_EcSlaveState FB_EcGetSlaveCount "
     "FB_EcSoERead FB_EcSoEWrite FB_EcGetAllSlaveAddr ST_EcMasterStatistic "},
    {"Tc2_MDP", " FB_MDP_* "},
    {"Tc3_JsonXml",
     " FB_JsonDomParser FB_JsonSaxWriter FB_JsonSaxReader FB_JsonSaxPrettyWriter FB_JsonReadWriteDataType "
     "FB_XmlDomParser SJsonValue SXmlNode SXmlAttribute SXmlIterator SJsonIterator SJsonAIterator "},
    {"Tc3_IotBase", " FB_IotMqttClient FB_IotMqttMessage FB_IotMqttMessageQueue FB_IotHttpClient FB_IotHttpRequest "},
    {"Tc2_ModbusSrv",
     " FB_MBReadCoils FB_MBReadInputs FB_MBReadRegs FB_MBReadInputRegs FB_MBWriteSingleCoil FB_MBWriteSingleReg "
     "FB_MBWriteCoils FB_MBWriteRegs "},
    {"SM3_Basic", " AXIS_REF_SM3 SMC_* MC_Cam* MC_Phasing "},
    {"SysTime", " SysTimeGetMs SysTimeGetUs SysTimeGetNs SysTimeRtcGet SysTimeRtcSet SYSTIMEDATE SYSTIME "},
    {"SysFile", " SysFileOpen SysFileClose SysFileRead SysFileWrite SysFileGetSize SysFileDelete SysFileSetPos "},
    {"SysSocket", " SysSockCreate SysSockConnect SysSockSend SysSockRecv SysSockClose SysSockBind SysSockListen "},
    {"SysLibCom", " SysComOpen SysComClose SysComRead SysComWrite SysComSetSettings COMSETTINGS "},
};

constexpr size_t kMostNames = 12; // of one line

/// Which library a name is of.
class NamedLibraries {
public:
    NamedLibraries() {
        for (const ToolNames& row : kToolNames) {
            const std::string all = foldCase(row.names);
            for (size_t at = all.find_first_not_of(' '); at != std::string::npos; at = all.find_first_not_of(' ', at)) {
                const size_t end = std::min(all.find(' ', at), all.size());
                if (all[end - 1] == '*')
                    m_prefixes.emplace_back(all.substr(at, end - at - 1), row.library);
                else
                    m_names.emplace(all.substr(at, end - at), row.library);
                at = end;
            }
        }
    }
    /// Empty: of none that is known.
    [[nodiscard]] std::string_view of(const std::string& folded) const {
        if (const auto name = m_names.find(folded); name != m_names.end()) return name->second;
        for (const auto& [prefix, library] : m_prefixes)
            if (folded.starts_with(prefix)) return library;
        return {};
    }

private:
    std::map<std::string, std::string_view> m_names;
    std::vector<std::pair<std::string, std::string_view>> m_prefixes;
};

} // namespace

void reportLibrariesUsed(Imported& imported, const std::map<std::string, std::string>& used,
                         const std::set<std::string>& declared) {
    const NamedLibraries libraries;
    std::map<std::string_view, std::vector<std::string>> missing;
    for (const auto& [folded, name] : used)
        if (const std::string_view library = libraries.of(folded); !library.empty() && !declared.count(folded))
            missing[library].push_back(name);
    for (const auto& [library, names] : missing) {
        std::string list;
        for (size_t i = 0; i < names.size() && i < kMostNames; ++i) list += (i == 0 ? "" : ", ") + names[i];
        if (names.size() > kMostNames) list += ", …";
        imported.report.add(imported.name, remarks::LibraryNamesUsed(list, library));
    }
}

} // namespace plc::exchange
