#pragma once

#include <termios.h>

#include <optional>
#include <string>

namespace grader {

/// Single keys from a terminal, without Enter and without an echo, as long as it lives. The
/// terminal is as it was before once this is gone. Ctrl-C stays a signal.
///
/// Where input or output is no terminal, or this program is not in its foreground, there are no
/// keys, and nothing is changed.
class Keys {
public:
    Keys();
    ~Keys();
    Keys(const Keys&) = delete;
    Keys& operator=(const Keys&) = delete;

    bool available() const { return before_.has_value(); }

    /// Can be read from when a key was pressed; -1 without keys, and while suspended.
    int descriptor() const;

    /// The characters of the keys pressed since the last call. Arrows and the like come as more
    /// than one, the first being Esc. When the terminal is gone, there are no keys any more.
    std::string pressed();

    /// The terminal as it was, for the time that this program is stopped (Ctrl-Z) …
    void suspend();
    /// … and single keys again, unless the program goes on in the background.
    void resume();

private:
    std::optional<termios> before_;
    bool listening_ = false;
};

}  // namespace grader
