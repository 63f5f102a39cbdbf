#include "runtime/compiler/driver/definitions.h"

#include "runtime/base/text.h"

namespace plc::driver {

namespace {

void addAttributes(const std::string& name, const std::vector<syntax::Pragma>& pragmas, parse::Definitions& out) {
    for (const syntax::Pragma& pragma : pragmas)
        if (pragma.isAttribute) out.attributes[name].insert(foldCase(pragma.key));
}

void addSection(const syntax::VarSection& section, std::string_view text, parse::Definitions& out) {
    for (const syntax::VarDecl* decl : section.declarations)
        for (const syntax::Name& name : decl->names) {
            const SourceRange type = decl->type ? decl->type->range : SourceRange{};
            const std::string folded = foldCase(name.text);
            out.variables[folded] = text.substr(type.begin, type.length());
            addAttributes(folded, decl->pragmas, out);
        }
}

void addConfiguration(const syntax::ConfigurationDecl& decl, std::string_view text, parse::Definitions& out) {
    for (const syntax::VarSection* section : decl.sections) addSection(*section, text, out);
    for (const syntax::ResourceDecl* resource : decl.resources) {
        for (const syntax::VarSection* section : resource->sections) addSection(*section, text, out);
        for (const syntax::TaskDecl* task : resource->tasks) out.tasks.insert(foldCase(task->name.text));
    }
}

void addDeclarations(const std::vector<syntax::Decl*>& declarations, std::string_view text, parse::Definitions& out) {
    for (const syntax::Decl* decl : declarations) {
        if (decl->pou) {
            const std::string name = foldCase(decl->pou->name.text);
            out.pous.insert(name);
            addAttributes(name, decl->pou->pragmas, out);
        }
        if (decl->type) {
            const std::string name = foldCase(decl->type->name.text);
            out.types.insert(name);
            addAttributes(name, decl->type->pragmas, out);
        }
        if (decl->globals && decl->globals->section) addSection(*decl->globals->section, text, out);
        if (decl->configuration) addConfiguration(*decl->configuration, text, out);
        if (decl->space) addDeclarations(decl->space->declarations, text, out);
    }
}

} // namespace

parse::Definitions definitionsOf(const std::vector<std::string>& defines) {
    parse::Definitions out;
    for (const std::string& each : defines) {
        const size_t equals = each.find('=');
        out.values[foldCase(each.substr(0, equals))] = equals == std::string::npos ? "" : each.substr(equals + 1);
    }
    return out;
}

void addNames(const syntax::SyntaxFile& file, std::string_view text, parse::Definitions& out) {
    addDeclarations(file.declarations, text, out);
}

void addVariables(const syntax::SyntaxFile& file, std::string_view text, parse::Definitions& out) {
    for (const syntax::Decl* decl : file.declarations) {
        if (!decl->pou) continue;
        for (const syntax::VarSection* section : decl->pou->sections) addSection(*section, text, out);
        for (const syntax::Pou* method : decl->pou->methods)
            for (const syntax::VarSection* section : method->sections) addSection(*section, text, out);
    }
}

} // namespace plc::driver
