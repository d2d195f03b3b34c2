// SPDX-License-Identifier: MIT
#include "baker/windows_text.h"
#include "tools/console.h"

#include <shellapi.h>

#include <algorithm>

namespace lr::baker {
namespace {

// The files that match the last component of the path, sorted by name; the argument itself if none matches.
void append_matches(const std::wstring& argument, std::vector<std::string>& out) {
    const std::size_t slash = argument.find_last_of(L"/\\:");
    const std::wstring folder = slash == std::wstring::npos ? L"" : argument.substr(0, slash + 1);
    const bool pattern = argument.find_first_of(L"*?", folder.size()) != std::wstring::npos &&
                         folder.find_first_of(L"*?") == std::wstring::npos && argument.front() != L'-';
    std::vector<std::string> found;
    WIN32_FIND_DATAW entry;
    const HANDLE search = pattern ? FindFirstFileW(argument.c_str(), &entry) : INVALID_HANDLE_VALUE;
    if (search != INVALID_HANDLE_VALUE) {
        do {
            if ((entry.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0)
                found.push_back(to_utf8(folder + entry.cFileName));
        } while (FindNextFileW(search, &entry) != 0);
        FindClose(search);
    }
    if (found.empty()) found.push_back(to_utf8(argument));
    std::sort(found.begin(), found.end());
    out.insert(out.end(), found.begin(), found.end());
}
} // namespace

std::vector<std::string> utf8_arguments(int argc, char** argv) {
    int count = 0;
    wchar_t** const wide = CommandLineToArgvW(GetCommandLineW(), &count);
    if (!wide) return {argv, argv + argc};
    std::vector<std::string> arguments;
    for (int i = 0; i < count; ++i)
        if (i == 0 || wide[i][0] == L'\0')
            arguments.push_back(to_utf8(wide[i]));
        else
            append_matches(wide[i], arguments);
    LocalFree(wide);
    return arguments;
}

void set_up_console() {
    SetConsoleOutputCP(CP_UTF8);
}

bool shows_progress() {
    const HANDLE error = GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    return GetConsoleMode(error, &mode) != 0 && SetConsoleMode(error, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::string with_slashes(std::string path) {
    if (!path.starts_with("\\\\?\\")) std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}
} // namespace lr::baker
