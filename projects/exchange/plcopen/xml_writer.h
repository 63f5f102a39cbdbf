// Pieces of PLCopen XML that types, charts and units are written with; one edition decides their form. Values, any
// thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "projects/exchange/plcopen/source_text.h"

#include <pugixml.hpp>

namespace plc::exchange {

enum class Edition : uint8_t {
    Codesys0200, // 0200 with the additions of CODESYS and TwinCAT
    Plain0201,   // 0201 as Beremiz and OpenPLC read it
};

class XmlWriter {
public:
    XmlWriter(Edition edition, const SourceView& source, std::string file, Report& report)
        : m_edition(edition), m_source(source), m_file(std::move(file)), m_report(report) {}

    [[nodiscard]] bool isPlain() const { return m_edition == Edition::Plain0201; }
    [[nodiscard]] const SourceView& source() const { return m_source; }
    void lose(Remark remark) const { m_report.add(m_file, std::move(remark)); }

    /// <xhtml> of 0200, <xhtml:p> of 0201.
    void text(pugi::xml_node parent, std::string_view text) const;
    void documentation(pugi::xml_node parent, std::string_view text) const;
    /// <data> in the element's addData, which is made where it is missing.
    [[nodiscard]] static pugi::xml_node data(pugi::xml_node element, const char* name,
                                             const char* handle = "implementation");
    void plainText(pugi::xml_node element, const std::string& declaration) const;

    /// Writes the type into <type>, <baseType> or <returnType>.
    void type(pugi::xml_node holder, const syntax::TypeSpec& spec) const;
    void value(pugi::xml_node holder, const syntax::Expr& expr) const;
    void variables(pugi::xml_node section, const std::vector<syntax::VarDecl*>& declarations) const;
    /// One <inputVars>, <localVars> … in an <interface>, or <globalVars>.
    void section(pugi::xml_node interface, const syntax::VarSection& section) const;

private:
    void namedType(pugi::xml_node holder, const syntax::TypeSpec& spec) const;
    void arrayType(pugi::xml_node holder, const syntax::TypeSpec& spec) const;
    void enumType(pugi::xml_node holder, const syntax::TypeSpec& spec) const;
    void constructor(pugi::xml_node variable, const syntax::TypeSpec& spec) const;
    void membersOfConstructor(pugi::xml_node variable, const syntax::TypeSpec& spec) const;
    [[nodiscard]] std::string pathText(const syntax::Path& path) const;
    Edition m_edition;
    const SourceView& m_source;
    std::string m_file;
    Report& m_report;
};

} // namespace plc::exchange
