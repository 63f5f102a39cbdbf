<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>FigureText</name>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message numerus="yes">
        <source>%n scan(s) skipped: the machine was late</source>
        <translation>
            <numerusform>%n scan skipped: the machine was late</numerusform>
            <numerusform>%n scans skipped: the machine was late</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::DevicesView</name>
    <message numerus="yes">
        <source>%n address(es) proposed</source>
        <translation>
            <numerusform>%n address proposed</numerusform>
            <numerusform>%n addresses proposed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::EditorTabs</name>
    <message numerus="yes">
        <source>%n file(s) were changed: %1. Save them?</source>
        <translation>
            <numerusform>%n file was changed: %1. Save it?</numerusform>
            <numerusform>%n files were changed: %1. Save them?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s); those edited since stay as they are</source>
        <translation>
            <numerusform>Changed in %n file; those edited since stay as they are</numerusform>
            <numerusform>Changed in %n files; those edited since stay as they are</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Changed in %n file(s)</source>
        <translation>
            <numerusform>Changed in %n file</numerusform>
            <numerusform>Changed in %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::RenameDialog</name>
    <message numerus="yes">
        <source>%n place(s) change:</source>
        <translation>
            <numerusform>%n place changes:</numerusform>
            <numerusform>%n places change:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::UnitCommands</name>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s); the panels are saved, the sources not yet</source>
        <translation>
            <numerusform>%1 is now %2 in %n place; the panels are saved, the sources not yet</numerusform>
            <numerusform>%1 is now %2 in %n places; the panels are saved, the sources not yet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is now %2 in %n place(s)</source>
        <translation>
            <numerusform>%1 is now %2 in %n place</numerusform>
            <numerusform>%1 is now %2 in %n places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is used in %n other place(s).</source>
        <translation>
            <numerusform>It is used in %n other place.</numerusform>
            <numerusform>It is used in %n other places.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::app::SearchView</name>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n place</numerusform>
            <numerusform>%n places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n file</numerusform>
            <numerusform>%n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced</source>
        <translation>
            <numerusform>%n place replaced</numerusform>
            <numerusform>%n places replaced</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::editor::FindBar</name>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n replaced</numerusform>
            <numerusform>%n replaced</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n found</numerusform>
            <numerusform>%n found</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::editor::RunControl</name>
    <message numerus="yes">
        <source>%n error(s): the program was not built</source>
        <translation>
            <numerusform>%n error: the program was not built</numerusform>
            <numerusform>%n errors: the program was not built</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::editor::TuningView</name>
    <message numerus="yes">
        <source>%n step(s) found, %1 used.</source>
        <translation>
            <numerusform>%n step found, %1 used.</numerusform>
            <numerusform>%n steps found, %1 used.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::PropertySheet</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n element</numerusform>
            <numerusform>%n elements</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::TextEditor</name>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>%n text</numerusform>
            <numerusform>%n texts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) taken.</source>
        <translation>
            <numerusform>%n text taken.</numerusform>
            <numerusform>%n texts taken.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) as they were.</source>
        <translation>
            <numerusform>%n text as it was.</numerusform>
            <numerusform>%n texts as they were.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) without a translation.</source>
        <translation>
            <numerusform>%n text without a translation.</numerusform>
            <numerusform>%n texts without a translation.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::trace::TraceView</name>
    <message numerus="yes">
        <source>(%n shot(s))</source>
        <translation>
            <numerusform>(%n shot)</numerusform>
            <numerusform>(%n shots)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>plc::hmi::ThemeDialog</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
</TS>
