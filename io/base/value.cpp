#include "io/base/value.h"

#include "io/base/contract.h"

namespace io {

const Value* Value::find(std::string_view key) const
{
    if (const Object* members = asObject())
        for (const Member& member : *members)
            if (member.first == key) return &member.second;
    return nullptr;
}

Value& Value::operator[](std::string_view key)
{
    if (isNull()) m_data = Object{};
    Object* members = asObject();
    EXPECTS(members != nullptr);
    for (Member& member : *members)
        if (member.first == key) return member.second;
    return members->emplace_back(std::string{key}, Value{}).second;
}

} // namespace io
