#pragma once

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "Error.h"

namespace grader {

using Json = nlohmann::ordered_json;

/// What kind a value of a field must be. (The library's own conversions would take 2.7 or true for
/// a whole number.)
template <class T>
struct FieldKind;
template <>
struct FieldKind<std::string> {
    static std::string name() { return "a text"; }
    static bool holds(const Json& json) { return json.is_string(); }
};
template <>
struct FieldKind<int> {
    static std::string name() { return "a whole number"; }
    static bool holds(const Json& json) {
        return json.is_number_unsigned()
                   ? std::in_range<int>(json.get<std::uint64_t>())
                   : json.is_number_integer() && std::in_range<int>(json.get<std::int64_t>());
    }
};
template <>
struct FieldKind<bool> {
    static std::string name() { return "true or false"; }
    static bool holds(const Json& json) { return json.is_boolean(); }
};
template <>
struct FieldKind<double> {
    static std::string name() { return "a number"; }
    static bool holds(const Json& json) { return json.is_number(); }
};
template <>
struct FieldKind<Json> {
    static std::string name() { return "anything"; }
    static bool holds(const Json&) { return true; }
};
template <class T>
struct FieldKind<std::vector<T>> {
    static std::string name() { return "an array, each element " + FieldKind<T>::name(); }
    static bool holds(const Json& json) {
        return json.is_array() && std::all_of(json.begin(), json.end(), FieldKind<T>::holds);
    }
};
template <class T>
struct FieldKind<std::set<T>> : FieldKind<std::vector<T>> {};
template <class T>
struct FieldKind<std::map<std::string, T>> {
    static std::string name() { return "an object, each value " + FieldKind<T>::name(); }
    static bool holds(const Json& json) {
        return json.is_object() && std::all_of(json.begin(), json.end(), FieldKind<T>::holds);
    }
};

/// Reads a JSON object that people write by hand. Every complaint names the file, the place, what
/// is allowed and what was found.
class Fields {
public:
    /// `where` is "file" or "file: tasks[2]".
    Fields(const Json& object, std::string where) : object_(object), where_(std::move(where)) {
        if (!object.is_object())
            throw Error("{}: expected an object, found {}", where_, object.type_name());
    }

    template <class T>
    T get(const std::string& name) {
        known_.insert(name);
        if (!object_.contains(name))
            throw Error("{}: field \"{}\" is missing", where_, name);
        return convert<T>(name);
    }
    template <class T>
    T get(const std::string& name, T fallback) {
        known_.insert(name);
        return object_.contains(name) ? convert<T>(name) : std::move(fallback);
    }
    /// The elements of an array as objects of their own.
    std::vector<Fields> list(const std::string& name) {
        const auto array = get<Json>(name, Json::array());
        if (!array.is_array())
            throw Error("{}: field \"{}\": expected an array, found {}", where_, name,
                        array.type_name());
        std::vector<Fields> all;
        for (std::size_t i = 0; i < array.size(); ++i)
            all.emplace_back(object_.at(name).at(i), fmt::format("{}: {}[{}]", where_, name, i));
        return all;
    }
    Fields object(const std::string& name) {
        known_.insert(name);
        static const Json empty = Json::object();
        return {object_.contains(name) ? object_.at(name) : empty, where_ + ": " + name};
    }

    /// Throws for any field that nobody asked for.
    void done() const {
        for (const auto& [name, value] : object_.items())
            if (!known_.contains(name))
                throw Error("{}: unknown field \"{}\"; allowed are {}", where_, name,
                            fmt::join(known_, ", "));
    }
    const std::string& where() const { return where_; }

private:
    template <class T>
    T convert(const std::string& name) const {
        const Json& value = object_.at(name);
        if (!FieldKind<T>::holds(value))
            throw Error("{}: field \"{}\": expected {}, found {}", where_, name,
                        FieldKind<T>::name(), value.dump());
        return value.get<T>();
    }

    const Json& object_;
    std::string where_;
    std::set<std::string> known_;
};

/// Parses a file of JSON; syntax errors name the file and the place.
Json parseJsonFile(const std::string& path);
/// The same from the file's text.
Json parseJson(const std::string& text, const std::string& path);

}  // namespace grader
