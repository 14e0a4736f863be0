#include "engine/assets/shader_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

#include "engine/core/error.h"

namespace luftpost::assets {
namespace {
std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

/// What follows `#NAME` on the line, if the line is that directive.
std::optional<std::string_view> directive(std::string_view line, std::string_view name) {
    line = trimmed(line);
    if (!line.starts_with('#')) return std::nullopt;
    line = trimmed(line.substr(1));
    if (!line.starts_with(name)) return std::nullopt;
    line.remove_prefix(name.size());
    if (!line.empty() && std::isalnum(static_cast<unsigned char>(line.front()))) return std::nullopt;
    return trimmed(line);
}

/// The name in the shaders folder: "../lib/x" and "./x" are relative to the file that includes.
std::string fromShadersFolder(std::string_view name, std::string const& from) {
    if (name.starts_with('.'))
        return (std::filesystem::path{from}.parent_path() / name).lexically_normal().generic_string();
    if (name.starts_with("shaders/")) name.remove_prefix(std::string_view{"shaders/"}.size());
    return std::string{name};
}

class Resolver {
public:
    Resolver(ReadShader const& read, std::span<std::string const> defines) : read_{read}, defines_{defines} {}

    ShaderSource resolve(std::string const& file) {
        append(file, "");
        return std::move(source_);
    }

private:
    void append(std::string const& file, std::string const& place) {
        if (std::ranges::find(stack_, file) != stack_.end())
            throw core::Error{stack_.back(), place,
                              fmt::format("expected no cycle of includes, found {} -> {}", fmt::join(stack_, " -> "), file)};
        if (std::ranges::find(source_.files, file) != source_.files.end()) return;
        source_.files.push_back(file);
        stack_.push_back(file);
        appendLines(file, source_.files.size() - 1, read_(file));
        stack_.pop_back();
    }

    void appendLines(std::string const& file, std::size_t id, std::string const& text) {
        if (id > 0) mark(1, id);
        int number = 0;
        for (std::size_t start = 0; start < text.size(); ) {
            std::size_t const end = std::min(text.find('\n', start), text.size());
            appendLine(file, id, ++number, std::string_view{text}.substr(start, end - start));
            start = end + 1;
        }
    }

    void appendLine(std::string const& file, std::size_t id, int number, std::string_view line) {
        if (auto const version = directive(line, "version")) {
            source_.text += fmt::format("#version {}\n", *version);
            for (std::string const& define : defines_) source_.text += fmt::format("#define {}\n", define);
            return mark(number + 1, id);
        }
        if (auto const include = directive(line, "include")) {
            includeNamed(*include, fmt::format("line {}", number), file);
            return mark(number + 1, id);
        }
        bool const once = directive(line, "pragma") == "once";
        if (!once) source_.text += line;
        source_.text += '\n';
    }

    void includeNamed(std::string_view name, std::string const& place, std::string const& from) {
        if (name.starts_with('<')) return;
        std::size_t const end = name.size() > 1 ? name.find('"', 1) : std::string_view::npos;
        if (!name.starts_with('"') || end == std::string_view::npos)
            throw core::Error{from, place, "expected #include \"FILE\""};
        append(fromShadersFolder(name.substr(1, end - 1), from), place);
    }

    void mark(int line, std::size_t id) { source_.text += fmt::format("#line {} {}\n", line, id); }

    ReadShader const& read_;
    std::span<std::string const> defines_;
    ShaderSource source_;
    std::vector<std::string> stack_;
};

/// Reads digits at `at`; npos-like nullopt when there are none.
std::optional<std::size_t> digits(std::string_view text, std::size_t& at) {
    std::size_t value = 0;
    std::size_t const start = at;
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) && at - start < 9)
        value = value * 10 + static_cast<std::size_t>(text[at++] - '0');
    if (at == start) return std::nullopt;
    return value;
}

/// "2:17(5): error" (Mesa) or "2(17) : error" (NVIDIA) or "ERROR: 2:17:" at the head of a line.
std::string namedLine(std::string_view line, std::span<std::string const> files) {
    std::size_t head = 0;
    for (std::string_view prefix : {"ERROR: ", "WARNING: "})
        if (line.starts_with(prefix)) head = prefix.size();
    std::size_t at = head;
    auto const file = digits(line, at);
    if (!file || *file >= files.size() || at >= line.size() || (line[at] != ':' && line[at] != '('))
        return std::string{line};
    std::size_t const afterFile = ++at;
    auto const number = digits(line, at);
    if (!number) return std::string{line};
    if (line[afterFile - 1] == '(' && at < line.size() && line[at] == ')') ++at;
    return fmt::format("{}shaders/{}:{}{}", line.substr(0, head), files[*file], *number, line.substr(at));
}
}  // namespace

ShaderSource resolveShader(std::string const& file, ReadShader const& read, std::span<std::string const> defines) {
    return Resolver{read, defines}.resolve(file);
}

std::string namedMessages(std::string_view messages, std::span<std::string const> files) {
    std::string named;
    for (std::size_t start = 0; start < messages.size();) {
        std::size_t const end = std::min(messages.find('\n', start), messages.size());
        named += namedLine(messages.substr(start, end - start), files);
        if (end < messages.size()) named += '\n';
        start = end + 1;
    }
    return named;
}
}  // namespace luftpost::assets
