#include "batch/Moment.h"

#include <fmt/chrono.h>

#include <regex>

#include "Error.h"

namespace grader {

Moment parseMoment(const std::string& text, const std::string& where) {
    static const std::regex kForm(
        R"((\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d)(?::(\d\d)(?:\.\d+)?)? ?(Z|UTC|([+-])(\d\d):?(\d\d)))",
        std::regex::icase);
    std::smatch part;
    if (!std::regex_match(text, part, kForm))
        throw Error(
            "{}: \"{}\" is no time: expected one like 2026-11-03T23:59:00+01:00, with its "
            "distance from UTC (or Z)",
            where, text);
    using namespace std::chrono;
    const auto number = [&](int i) { return part[i].matched ? std::stoi(part[i].str()) : 0; };
    const year_month_day date{year(number(1)), month(static_cast<unsigned>(number(2))),
                              day(static_cast<unsigned>(number(3)))};
    constexpr int kFarthest = 14;  // hours from UTC, on an island of Kiribati
    if (!date.ok() || number(4) > 23 || number(5) > 59 || number(6) > 60 || number(9) > kFarthest ||
        number(10) > 59)
        throw Error("{}: there is no such time as \"{}\"", where, text);
    const auto offset = (hours(number(9)) + minutes(number(10))) * (part[8] == "-" ? -1 : 1);
    return sys_days(date) + hours(number(4)) + minutes(number(5)) + seconds(number(6)) - offset;
}

std::string toString(Moment moment) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(moment)));
}

}  // namespace grader
