#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/types.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rubble {

/// A Chromium without a window, driven over the pipe of its DevTools protocol. It draws in software and reaches no network: every
/// name fails to resolve, and the proxy answers nobody.
class Browser {
public:
    /// The program; empty where there is none. RUBBLE_CHROMIUM may name another.
    static std::string program();
    /// The one that all tests of a program share, as it takes longer to start than pages do; null where there is none.
    static Browser* ofAll();

    /// @param folder  for its profile
    /// @param more    further options
    Browser(const std::string& folder, int width, int height, const std::vector<std::string>& more = {});
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// Opens a page from a file, anew if it is there, and waits until it says that it is ready; what it then says. What was asked
    /// for and complained about before is forgotten.
    std::string open(const std::string& path);
    /// Value of an expression in the page; a promise is waited for. Throws std::runtime_error with what the page threw.
    nlohmann::json evaluate(const std::string& expression);
    /// Waits until an expression is neither null, false nor 0, whatever the machine takes for it, and returns what it then is.
    /// Throws std::runtime_error that says what was waited for.
    nlohmann::json waitFor(const std::string& expression);
    /// Bytes of a PNG.
    std::string screenshot();
    /// Presses and lets go a key: "Tab", "Enter", " ".
    void press(const std::string& key);
    /// Gives the window another size, px.
    void resize(int width, int height);
    /// Clicks at a place of the page, px.
    void click(double x, double y);

    /// Addresses that were asked for, but for data that pages hold themselves.
    const std::vector<std::string>& requests() const { return m_requests; }
    /// Exceptions, and errors in the log of the page.
    const std::vector<std::string>& complaints() const { return m_complaints; }

private:
    nlohmann::json command(const std::string& method, nlohmann::json parameters);
    nlohmann::json nextMessage();
    void note(const nlohmann::json& event);

    pid_t m_process = 0;
    int m_out = -1;
    int m_in = -1;
    int m_number = 0;
    std::string m_buffer;
    std::string m_session;
    std::vector<std::string> m_requests;
    std::vector<std::string> m_complaints;
};

/// What all tests of a page look at: a fixture that makes the page in its constructor, made once for all of them.
template <class Page>
class PageForAll {
public:
    static Page* page() {
        if (!made()) {
            made() = std::make_unique<Page>();
        }
        return made().get();
    }
    static void end() { made().reset(); }

private:
    static std::unique_ptr<Page>& made() {
        static std::unique_ptr<Page> page;
        return page;
    }
};

/// Tests of a page in a browser. Nothing is run where there is none: then `m_browser` is null.
template <class Page>
class PageTest : public testing::Test {
protected:
    using Shared = PageForAll<Page>;

    static void TearDownTestSuite() { Shared::end(); }
    void SetUp() override {
        m_browser = Browser::ofAll();
        if (m_browser == nullptr) {
            std::cout << "not run: no Chromium here\n";
            return;
        }
        m_browser->resize(1280, 800);
    }
    void TearDown() override {
        if (m_browser != nullptr) {
            EXPECT_THAT(m_browser->complaints(), testing::IsEmpty());
        }
    }
    nlohmann::json said(const std::string& expression) { return m_browser->evaluate(expression); }

    Browser* m_browser = nullptr;
};

}  // namespace rubble
