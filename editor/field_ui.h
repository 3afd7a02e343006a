// FieldUi: the visitor that shows a fields() list as rows of widgets: label, value, unit, and a way back to the
// default. It edits the copy that it is given and says what was changed; making a command of it is the panel's.
#pragma once

#include "editor/scalars.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

struct FieldUiOptions {
    std::string prefix;                                // "template." : the labels are tr("field.template.KEY")
    std::vector<Scalar> defaults;                      // empty: no way back to them
    std::vector<bool> mixed;                           // by place; empty: none is
    std::string filter;                                // lowered: only rows that hold each word of it
    std::function<bool(std::string_view key)> enabled; // none: all are
    std::function<void(std::string_view key)> lists; // draws what a list holds, in its place; none: it is left out
    std::function<std::vector<std::string>(std::string_view key)> files; // that a text may name; none: it is typed
};

class FieldUi {
public:
    explicit FieldUi(FieldUiOptions options) : m_options{std::move(options)} {}

    template <class T> void operator()(const char* key, T& value, const io::Hint& hint)
    {
        if constexpr (HasFields<T, FieldUi>) {
            if (!beginSection(key)) return skipSection(scalarsOf(value).size());
            fields(*this, value);
            endSection();
        } else if constexpr (NamedEnum<T>) {
            const auto names = enumNames(value);
            int chosen = int(value);
            if (choice(key, {names.begin(), names.end()}, chosen)) value = T(chosen);
        } else if constexpr (std::is_same_v<T, bool>) {
            toggle(key, value);
        } else if constexpr (std::is_same_v<T, std::string>) {
            text(key, value);
        } else if constexpr (std::is_arithmetic_v<T>) {
            double number = double(value);
            if (numbers(key, &number, 1, hint, std::is_integral_v<T>)) value = T(number);
        } else if constexpr (Vector<T>) {
            double all[4] = {};
            for (int i = 0; i < T::length(); ++i)
                all[i] = double(value[i]);
            if (!numbers(key, all, T::length(), hint, false)) return;
            for (int i = 0; i < T::length(); ++i)
                value[i] = typename T::value_type(all[i]);
        } else if constexpr (requires { value.emplace_back(); }) {
            if (m_options.lists && m_options.filter.empty()) m_options.lists(m_options.prefix + m_path + key);
        }
    }

    const std::vector<ScalarChange>& changes() const { return m_changes; }
    const std::string& changedKey() const { return m_changedKey; }     // dotted, with the prefix
    const std::string& changedLabel() const { return m_changedLabel; } // for the undo step's name
    bool found() const { return m_found || m_options.filter.empty(); }

private:
    struct Row;
    bool beginSection(const char* key);
    void endSection();
    bool matches(const Row& row, std::string_view unit);
    void skipSection(std::size_t scalars) { m_place += scalars; }
    bool choice(const char* key, const std::vector<std::string_view>& names, int& chosen);
    bool toggle(const char* key, bool& value);
    bool text(const char* key, std::string& value);
    bool fileChoice(const Row& row, std::vector<std::string> files, std::string& value);
    bool numbers(const char* key, double* values, int count, const io::Hint& hint, bool whole);

    bool beginRow(Row& row, const char* key, int count, std::string_view unit = {}, std::string_view unitAtLabel = {});
    void endRow(const Row& row);
    bool resetButton(const Row& row);
    bool isMixed(std::size_t place) const { return place < m_options.mixed.size() && m_options.mixed[place]; }
    void note(const Row& row, ScalarChange change);

    FieldUiOptions m_options;
    std::string m_path; // of the open section, "sun."
    std::string m_section; // its name, while only what is searched for is shown
    bool m_headed = false; // and whether that stands there
    bool m_found = false;
    std::size_t m_place = 0;
    std::vector<ScalarChange> m_changes;
    std::string m_changedKey, m_changedLabel;
};

} // namespace editor
