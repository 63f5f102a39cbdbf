// A folder of its own and a command called with words, its output kept: what every test of the command line needs.
#pragma once
#include "app/cli/command_line.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace plc {

class CommandTest : public ::testing::Test {
protected:
    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.path().toStdString() + "/" + name; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    [[nodiscard]] std::string read(const std::string& name) const {
        std::ifstream in(path(name), std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        return text.str();
    }
    int command(const std::vector<std::string>& words) {
        std::ostringstream outText, errText;
        std::streambuf* const oldOut = std::cout.rdbuf(outText.rdbuf());
        std::streambuf* const oldErr = std::cerr.rdbuf(errText.rdbuf());
        const int code = cli::runCommandLine(words);
        std::cout.rdbuf(oldOut);
        std::cerr.rdbuf(oldErr);
        out = outText.str();
        err = errText.str();
        return code;
    }
    std::string out, err;

private:
    QTemporaryDir m_folder;
};

} // namespace plc
