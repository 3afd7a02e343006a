// Loading: a project being opened beside the window, which shows how far it is and lets a person cancel.
#pragma once

#include "editor/document.h"

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace editor {

class Loading {
public:
    using Opened = io::Result<std::unique_ptr<Document>>;

    Loading() = default;
    ~Loading() { cancel(); }
    Loading(const Loading&) = delete;
    Loading& operator=(const Loading&) = delete;

    void start(std::filesystem::path project, std::string scene); // nothing else is being loaded
    bool running() const { return m_thread.joinable(); }
    void cancel();                    // waits until it has stopped; what was open stays open
    std::optional<Opened> finished(); // once

    void draw(); // the dialog

private:
    void read(const std::filesystem::path& project, const std::string& scene);

    std::thread m_thread;
    std::unique_ptr<Document> m_document; // these two are the thread's until m_done
    io::Error m_error;
    std::atomic<bool> m_done = false;
    std::string m_name;
    std::atomic<bool> m_cancelled = false;
    std::atomic<float> m_fraction = 0;
    std::mutex m_mutex;
    std::string m_step; // guarded
};

} // namespace editor
