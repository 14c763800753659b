#include "httpd/message.hpp"

#include <algorithm>

namespace vicus {
namespace {
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
}  // namespace

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<std::string> field_of(const HttpFields& fields, std::string_view name) {
  std::optional<std::string> found;
  for (const auto& [field, value] : fields) {
    if (!equal_ignoring_case(field, name)) continue;
    if (found)
      *found += ", " + value;
    else
      found = value;
  }
  return found;
}

void set_field(HttpFields& fields, const std::string& name, const std::string& value) {
  std::erase_if(fields, [&](const auto& field) { return equal_ignoring_case(field.first, name); });
  fields.emplace_back(name, value);
}

std::shared_ptr<const std::string> body_of(std::string bytes) {
  return std::make_shared<const std::string>(std::move(bytes));
}

}  // namespace vicus
