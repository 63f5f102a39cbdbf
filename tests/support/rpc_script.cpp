#include "tests/support/rpc_script.h"

#include <fstream>
#include <sstream>
#include <unistd.h>

namespace plc {

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::string withValues(std::string text, const std::map<std::string, std::string>& names) {
    for (const auto& [name, value] : names) text = replaced(std::move(text), name, value);
    return text;
}

std::string withNames(std::string text, const std::map<std::string, std::string>& names) {
    for (const auto& [name, value] : names) text = replaced(std::move(text), value, name);
    return text;
}

} // namespace

std::string playScript(const std::string& script, const std::map<std::string, std::string>& names,
                       const RpcPeer& peer) {
    std::string out;
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("< ")) continue;
        out += line + "\n";
        std::vector<std::string> answers;
        if (line.starts_with("> ")) answers = peer.exchange(withValues(line.substr(2), names));
        if (line.starts_with("? ")) answers = peer.waitFor(line.substr(2));
        for (const std::string& answer : answers) out += "< " + withNames(answer, names) + "\n";
    }
    return out;
}

std::vector<std::string> messagesOf(const std::string& script, const std::map<std::string, std::string>& names) {
    std::vector<std::string> out;
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("> ")) out.push_back(withValues(line.substr(2), names));
    return out;
}

std::string contentOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

FolderCopy::FolderCopy(const std::filesystem::path& from, const std::string& nameOfTest)
    : m_root(std::filesystem::temp_directory_path() / (nameOfTest + "." + std::to_string(::getpid()))) {
    std::filesystem::create_directories(m_root);
    std::filesystem::copy(from, m_root / from.filename(), std::filesystem::copy_options::recursive);
}

FolderCopy::~FolderCopy() {
    std::error_code ignored;
    std::filesystem::remove_all(m_root, ignored);
}

} // namespace plc
