// What is printed in a scope, however it is printed, and whether it says more than another text.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace course {

/// While it lives, descriptors 1 and 2 lead into a pipe that nobody waits on: what does not fit is
/// lost.
class PrintWatch {
public:
    PrintWatch() {
        if (pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
            throw std::runtime_error("cannot open a pipe");
        }
        flush();
        for (const int stream : {1, 2}) {
            kept_[std::size_t(stream - 1)] = fcntl(stream, F_DUPFD_CLOEXEC, 10);
            dup2(pipe_[1], stream);
        }
    }
    PrintWatch(const PrintWatch&) = delete;
    PrintWatch& operator=(const PrintWatch&) = delete;
    ~PrintWatch() {
        flush();
        for (const int stream : {1, 2}) {
            dup2(kept_[std::size_t(stream - 1)], stream);
            close(kept_[std::size_t(stream - 1)]);
        }
        close(pipe_[0]);
        close(pipe_[1]);
    }

    /// What was printed since this was last asked.
    std::string text() {
        flush();
        std::string all;
        char piece[4096];
        for (ssize_t got; (got = read(pipe_[0], piece, sizeof piece)) > 0;) {
            all.append(piece, std::size_t(got));
        }
        return all;
    }

private:
    static void flush() {
        std::cout.flush();
        std::cerr.flush();
        std::clog.flush();
        std::fflush(nullptr);
    }

    std::array<int, 2> pipe_{}, kept_{};
};

/// The shortest text that gives this one when it is repeated: "node" of "nodenodenode".
inline std::string withoutRepeats(const std::string& text) {
    for (std::size_t period = 1; 2 * period <= text.size(); ++period) {
        if (text.size() % period == 0 &&
            text.compare(period, std::string::npos, text, 0, text.size() - period) == 0) {
            return text.substr(0, period);
        }
    }
    return text;
}

/// The lines of a text, each as its different words in their order. Numbers and addresses are left
/// out, and so is how often a word comes: traces of two traversals differ in these.
inline std::set<std::string> saidIn(const std::string& text) {
    std::set<std::string> said;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        for (char& each : line) {
            const bool letter = std::isalpha(static_cast<unsigned char>(each)) || (each & 0x80);
            each = letter || std::isdigit(static_cast<unsigned char>(each)) ? each : ' ';
        }
        std::vector<std::string> words;
        std::istringstream pieces(line);
        for (std::string word; pieces >> word;) {
            const bool address = word.size() > 2 && word[0] == '0' && word[1] == 'x';
            std::erase_if(word, [](unsigned char c) { return std::isdigit(c); });
            word = withoutRepeats(word);
            if (!address && !word.empty() &&
                std::find(words.begin(), words.end(), word) == words.end()) {
                words.push_back(word);
            }
        }
        std::string all;
        for (const std::string& word : words) {
            all += word + " ";
        }
        if (!all.empty()) {
            said.insert(all);
        }
    }
    return said;
}

/// Whether `text` has a line that says what no line of `usual` says.
inline bool saysMore(const std::string& text, const std::string& usual) {
    const std::set<std::string> known = saidIn(usual), said = saidIn(text);
    return std::any_of(said.begin(), said.end(),
                       [&](const std::string& line) { return !known.contains(line); });
}

}  // namespace course
