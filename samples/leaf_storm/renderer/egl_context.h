// An OpenGL context without a window or a display.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

class EglContext {
public:
    EglContext(); // makes it current; throws Failure
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    std::string renderer() const;

private:
    void close();

    void* display_ = nullptr;
    void* context_ = nullptr;
};
