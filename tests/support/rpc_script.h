// Scripts of messages between a client and one of our servers: "> {…}" goes to the server, "< {…}" is what came back,
// "? name" waits for an event, the rest is comment. Played, the script comes out again with what really came back.
// Functions, the test's thread.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace plc {

struct RpcPeer {
    /// Hands one message over; what came back at once.
    std::function<std::vector<std::string>(const std::string& message)> exchange;
    /// What came until an event of that name, the event included.
    std::function<std::vector<std::string>(const std::string& event)> waitFor;
};

/// `names`: "${ROOT}" → what it is now; messages are sent with the values and shown with the names.
[[nodiscard]] std::string playScript(const std::string& script, const std::map<std::string, std::string>& names,
                                     const RpcPeer& peer);
/// Only what is sent.
[[nodiscard]] std::vector<std::string> messagesOf(const std::string& script,
                                                  const std::map<std::string, std::string>& names);

[[nodiscard]] std::string contentOf(const std::filesystem::path& file);

/// A copy of a folder in a folder of its own, which is removed with this.
class FolderCopy {
public:
    FolderCopy(const std::filesystem::path& from, const std::string& nameOfTest);
    ~FolderCopy();
    FolderCopy(const FolderCopy&) = delete;
    FolderCopy& operator=(const FolderCopy&) = delete;
    /// Where the copy lies.
    [[nodiscard]] const std::filesystem::path& root() const { return m_root; }

private:
    std::filesystem::path m_root;
};

} // namespace plc
