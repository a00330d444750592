#include "tests/support/browser.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "io/base/base64.h"
#include "tests/support/temporary_folder.h"

namespace rubble {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int patience = 120'000;  // ms, for an answer
constexpr int readFrom = 3;        // where Chromium takes commands
constexpr int writeTo = 4;         // where it answers

std::string foundInPath(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::string rest = path != nullptr ? path : "";
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        const std::string candidate = rest.substr(0, colon) + "/" + name;
        if (::access(candidate.c_str(), X_OK) == 0) {
            return candidate;
        }
        rest = colon == std::string::npos ? std::string() : rest.substr(colon + 1);
    }
    return {};
}

[[noreturn]] void become(std::vector<std::string> words, int commands, int answers) {
    // Out of the way of the numbers that it looks at.
    const int in = ::fcntl(commands, F_DUPFD, 10);
    const int out = ::fcntl(answers, F_DUPFD, 10);
    ::dup2(in, readFrom);
    ::dup2(out, writeTo);
    const int nowhere = ::open("/dev/null", O_RDWR);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    ::setpgid(0, 0);
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    ::execv(arguments.front(), arguments.data());
    ::_exit(127);
}

}  // namespace

std::string Browser::program() {
    if (const char* named = std::getenv("RUBBLE_CHROMIUM")) {
        return named;
    }
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
        if (const std::string found = foundInPath(name); !found.empty()) {
            return found;
        }
    }
    return {};
}

Browser* Browser::ofAll() {
    struct Kept {
        io::TemporaryFolder folder;
        Browser browser{folder / "profile", 1280, 800};
    };
    static const std::unique_ptr<Kept> kept = program().empty() ? nullptr : std::make_unique<Kept>();
    return kept ? &kept->browser : nullptr;
}

Browser::Browser(const std::string& folder, int width, int height, const std::vector<std::string>& more) {
    std::vector<std::string> words{program(),
                                   "--headless=new",
                                   "--no-sandbox",
                                   "--remote-debugging-pipe",
                                   "--use-angle=swiftshader",
                                   "--enable-unsafe-swiftshader",
                                   "--disable-background-networking",
                                   "--disable-component-update",
                                   "--no-first-run",
                                   "--lang=en",
                                   "--proxy-server=127.0.0.1:9",
                                   "--host-resolver-rules=MAP * ~NOTFOUND",
                                   "--user-data-dir=" + folder,
                                   "--window-size=" + std::to_string(width) + "," + std::to_string(height)};
    words.insert(words.end(), more.begin(), more.end());
    words.emplace_back("about:blank");
    std::array<int, 2> commands{};
    std::array<int, 2> answers{};
    if (::pipe2(commands.data(), O_CLOEXEC) != 0 || ::pipe2(answers.data(), O_CLOEXEC) != 0) {
        throw std::runtime_error("no pipe");
    }
    m_process = ::fork();
    if (m_process == 0) {
        become(words, commands[0], answers[1]);
    }
    ::close(commands[0]);
    ::close(answers[1]);
    m_out = commands[1];
    m_in = answers[0];
    const std::string target = command("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    m_session = command("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
    for (const char* domain : {"Page.enable", "Runtime.enable", "Network.enable", "Log.enable"}) {
        command(domain, json::object());
    }
    resize(width, height);
}

void Browser::resize(int width, int height) {
    command("Emulation.setDeviceMetricsOverride",
            {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

Browser::~Browser() {
    // It ends when nobody commands it any more; its children with it, for what is lost of their profile.
    ::close(m_out);
    ::close(m_in);
    ::kill(-m_process, SIGKILL);
    ::waitpid(m_process, nullptr, 0);
}

json Browser::nextMessage() {
    for (;;) {
        if (const std::size_t end = m_buffer.find('\0'); end != std::string::npos) {
            json message = json::parse(m_buffer.substr(0, end));
            m_buffer.erase(0, end + 1);
            return message;
        }
        pollfd ready{m_in, POLLIN, 0};
        std::array<char, 65536> block{};
        const bool answered = ::poll(&ready, 1, patience) > 0;
        const ssize_t count = answered ? ::read(m_in, block.data(), block.size()) : 0;
        if (count <= 0) {
            throw std::runtime_error("the browser does not answer");
        }
        m_buffer.append(block.data(), static_cast<std::size_t>(count));
    }
}

void Browser::note(const json& event) {
    const std::string method = event.value("method", "");
    if (method == "Network.requestWillBeSent") {
        const std::string url = event["params"]["request"]["url"];
        if (!url.starts_with("data:")) {
            m_requests.push_back(url);
        }
    } else if (method == "Runtime.exceptionThrown" ||
               (method == "Log.entryAdded" && event["params"]["entry"]["level"] == "error")) {
        m_complaints.push_back(event["params"].dump());
    }
}

json Browser::command(const std::string& method, json parameters) {
    json message = {{"id", ++m_number}, {"method", method}, {"params", std::move(parameters)}};
    if (!m_session.empty()) {
        message["sessionId"] = m_session;
    }
    const std::string text = message.dump() + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t count = ::write(m_out, text.data() + sent, text.size() - sent);
        if (count <= 0) {
            throw std::runtime_error("the browser has ended");
        }
        sent += static_cast<std::size_t>(count);
    }
    for (;;) {
        json answer = nextMessage();
        if (answer.value("id", 0) != m_number) {
            note(answer);
            continue;
        }
        if (answer.contains("error")) {
            throw std::runtime_error(method + ": " + answer["error"].dump());
        }
        return answer["result"];
    }
}

std::string Browser::open(const std::string& path) {
    // What was open tells until it is gone.
    command("Page.navigate", {{"url", "about:blank"}});
    evaluate("1");
    m_requests.clear();
    m_complaints.clear();
    command("Page.navigate", {{"url", "file://" + fs::absolute(path).string()}});
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(patience);
    while (std::chrono::steady_clock::now() < end) {
        const json ready =
            evaluate("document.documentElement && location.protocol === 'file:' && document.documentElement.dataset.ready || ''");
        if (ready.is_string() && ready != "") {
            return ready;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    throw std::runtime_error("the page is never ready");
}

json Browser::waitFor(const std::string& expression) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(patience);
    while (std::chrono::steady_clock::now() < end) {
        json value = evaluate(expression);
        if (value != json(nullptr) && value != json(false) && value != json(0)) {
            return value;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    throw std::runtime_error("waited in vain for: " + expression);
}

json Browser::evaluate(const std::string& expression) {
    const json result = command("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
    if (result.contains("exceptionDetails")) {
        throw std::runtime_error(result["exceptionDetails"].dump());
    }
    return result["result"].value("value", json(nullptr));
}

std::string Browser::screenshot() {
    std::string bytes;
    io::decodeBase64(command("Page.captureScreenshot", {{"format", "png"}})["data"].get<std::string>(), bytes);
    return bytes;
}

void Browser::press(const std::string& key) {
    static const json codes = {{"Tab", 9}, {"Enter", 13}, {" ", 32}, {"ArrowLeft", 37}, {"ArrowRight", 39}};
    json parameters = {
        {"type", "keyDown"}, {"key", key}, {"code", key == " " ? "Space" : key}, {"windowsVirtualKeyCode", codes.value(key, 0)}};
    if (key == "Enter" || key == " ") {
        parameters["text"] = key == "Enter" ? "\r" : " ";
    }
    command("Input.dispatchKeyEvent", parameters);
    parameters["type"] = "keyUp";
    parameters.erase("text");
    command("Input.dispatchKeyEvent", parameters);
}

void Browser::click(double x, double y) {
    for (const char* type : {"mousePressed", "mouseReleased"}) {
        command("Input.dispatchMouseEvent", {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"clickCount", 1}});
    }
}

}  // namespace rubble
