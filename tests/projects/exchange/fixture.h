// What the tests of import and export share: small documents of PLCopen XML around the part that a test is about, a
// folder of its own, and the texts that an import gives.
#pragma once
#include "projects/exchange/import.h"
#include "runtime/compiler/driver/driver.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace plc::exchange {

class ExchangeTest : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder =
            std::filesystem::temp_directory_path() / ("exchange-" + std::to_string(::getpid()) + "-" +
                                                      ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(m_folder);
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    [[nodiscard]] std::string path(const std::string& name) const { return (m_folder / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = m_folder / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file.string();
    }
    static std::string read(const std::string& file) {
        std::ifstream in(file, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    Imported import(const std::string& document) const {
        auto imported = importFrom(write("document.xml", document));
        EXPECT_TRUE(imported) << imported.error().english();
        return imported ? std::move(*imported) : Imported();
    }
    /// What is made of a folder of the test's.
    Imported folder(const std::string& name) const {
        auto imported = importFrom(path(name));
        EXPECT_TRUE(imported) << imported.error().english();
        return imported ? std::move(*imported) : Imported();
    }
    static std::string fileOf(const Imported& imported, const std::string& path) {
        for (const ImportedFile& file : imported.files)
            if (file.path == path) return file.text;
        std::string known;
        for (const ImportedFile& file : imported.files) known += file.path + "\n";
        ADD_FAILURE() << "no " << path << " among\n" << known;
        return {};
    }
    /// Messages of the check, one a line, with the texts when there are any.
    static std::string errorsOf(const Imported& imported) {
        const driver::Checked checked = driver::check(toProject(imported).buildInput());
        std::string out;
        for (const diagnostics::Diagnostic& each : checked.analysis->diagnostics)
            if (each.severity == diagnostics::Severity::Error)
                out += diagnostics::renderText(*checked.sources, each, false);
        return out;
    }

    /// A project of version 0200 with these <pous>.
    static std::string document(const std::string& pous, const std::string& types = {},
                                const std::string& instances = "<configurations/>", const std::string& more = {},
                                const std::string& product = "Editor") {
        return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<project xmlns=\"http://www.plcopen.org/xml/tc6_0200\">\n"
               "<fileHeader companyName=\"\" productName=\"" +
               product +
               "\" productVersion=\"1\" "
               "creationDateTime=\"2020-01-01T00:00:00\"/>\n<contentHeader name=\"Plant\"><coordinateInfo>"
               "<fbd><scaling x=\"1\" y=\"1\"/></fbd><ld><scaling x=\"1\" y=\"1\"/></ld><sfc><scaling x=\"1\" y=\"1\"/>"
               "</sfc></coordinateInfo></contentHeader>\n<types><dataTypes>" +
               types + "</dataTypes><pous>" + pous + "</pous></types>\n<instances>" + instances + "</instances>\n" +
               more + "</project>\n";
    }
    static std::string pou(const std::string& name, const std::string& kind, const std::string& interface,
                           const std::string& body, const std::string& more = {}) {
        return "<pou name=\"" + name + "\" pouType=\"" + kind + "\"><interface>" + interface + "</interface><body>" +
               body + "</body>" + more + "</pou>";
    }
    static std::string st(const std::string& text) {
        return "<ST><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">" + text + "</xhtml></ST>";
    }
    static std::string variable(const std::string& name, const std::string& type, const std::string& more = {}) {
        return "<variable name=\"" + name + "\"><type>" + type + "</type>" + more + "</variable>";
    }
    static std::string bools(std::initializer_list<const char*> names) {
        std::string out = "<localVars>";
        for (const char* name : names) out += variable(name, "<BOOL/>");
        return out + "</localVars>";
    }

private:
    std::filesystem::path m_folder;
};

} // namespace plc::exchange
