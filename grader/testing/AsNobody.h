#pragma once

#include <unistd.h>

namespace testing_help {

/// Root reads everything, so the test becomes somebody else while it looks.
class AsNobody {
public:
    AsNobody() : was_(geteuid()) { changed_ = was_ != 0 || seteuid(65534) == 0; }
    ~AsNobody() { [[maybe_unused]] const int back = seteuid(was_); }
    bool worked() const { return changed_; }

private:
    uid_t was_;
    bool changed_;
};

}  // namespace testing_help
