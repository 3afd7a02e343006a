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
    ~Loading();
    Loading(const Loading&) = delete;
    Loading& operator=(const Loading&) = delete;

    void start(std::filesystem::path project, std::string scene); // instead of what is being loaded
    bool running() const { return m_thread.joinable() && !m_cancelled; }
    bool busy() const { return m_thread.joinable(); } // also while one that was cancelled comes to its end
    void cancel() { m_cancelled = true; } // what was open stays open
    std::optional<Opened> finished();     // once, a frame after the dialog has said what comes now

    void draw(); // the dialog

private:
    void read(const std::filesystem::path& project, const std::string& scene);
    void say(float fraction, std::string_view step);

    std::thread m_thread;
    std::unique_ptr<Document> m_document; // these two are the thread's until m_done
    io::Error m_error;
    std::atomic<bool> m_done = false;
    bool m_announced = false;
    std::string m_name;
    std::atomic<bool> m_cancelled = false;
    std::atomic<float> m_fraction = 0;
    std::mutex m_mutex;
    std::string m_step; // guarded
};

} // namespace editor
