#include "baker/json.h"

#include <nlohmann/json.hpp>

#include <ostream>

namespace lr::test {

using Value = nlohmann::json;

Json Json::parse(std::string_view text) {
    return Json(std::make_shared<const Value>(Value::parse(text)));
}
bool Json::is_json(std::string_view text) {
    return Value::accept(text);
}

Json Json::operator[](std::string_view key) const {
    return Json({value_, &value_->at(std::string(key))});
}
Json Json::operator[](std::size_t index) const {
    return Json({value_, &value_->at(index)});
}
bool Json::contains(std::string_view key) const {
    return value_->contains(key);
}
Json Json::without(std::string_view key) const {
    Value copy = *value_;
    copy.erase(std::string(key));
    return Json(std::make_shared<const Value>(std::move(copy)));
}
std::size_t Json::size() const {
    return value_->size();
}

double Json::number() const {
    return value_->get<double>();
}
std::string Json::text() const {
    return value_->get<std::string>();
}
bool Json::is_null() const {
    return value_->is_null();
}
bool Json::is_array() const {
    return value_->is_array();
}
bool Json::is_number() const {
    return value_->is_number();
}

bool Json::operator==(const Json& other) const {
    return *value_ == *other.value_;
}
bool Json::operator==(double value) const {
    return *value_ == value;
}
bool Json::operator==(std::string_view value) const {
    return value_->is_string() && value_->get_ref<const std::string&>() == value;
}
bool Json::operator==(std::span<const double> values) const {
    if (!value_->is_array() || value_->size() != values.size()) return false;
    for (std::size_t i = 0; i < values.size(); ++i)
        if ((*value_)[i] != values[i]) return false;
    return true;
}
bool Json::is(bool value) const {
    return *value_ == value;
}

std::ostream& operator<<(std::ostream& stream, const Json& json) {
    return stream << *json.value_;
}

} // namespace lr::test
