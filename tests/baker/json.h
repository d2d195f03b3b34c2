// Parsed JSON for assertions. Only json.cpp includes the JSON library, which takes seconds to compile.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <concepts>
#include <cstddef>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace lr::test {

class Json {
public:
    // Invalid JSON fails the test.
    static Json parse(std::string_view text);
    static bool is_json(std::string_view text);

    // A missing key or index fails the test, as does a value of another kind.
    Json operator[](std::string_view key) const;
    Json operator[](std::size_t index) const;
    double number() const;
    std::string text() const;

    bool contains(std::string_view key) const;
    Json without(std::string_view key) const;
    std::size_t size() const;
    bool empty() const { return size() == 0; }

    bool is_null() const;
    bool is_array() const;
    bool is_number() const;

    // Values of different kinds differ.
    bool operator==(const Json& other) const;
    bool operator==(double value) const;
    bool operator==(std::same_as<bool> auto value) const { return is(value); }
    bool operator==(std::string_view value) const;
    bool operator==(std::span<const double> values) const;

    friend std::ostream& operator<<(std::ostream& stream, const Json& json);

private:
    explicit Json(std::shared_ptr<const nlohmann::json> value) : value_(std::move(value)) {}
    bool is(bool value) const;

    std::shared_ptr<const nlohmann::json> value_; // owns the parsed document
};

} // namespace lr::test
