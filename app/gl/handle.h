#pragma once
// Ownership of the OpenGL objects that are made and deleted by number.

#include <utility>

#include "app/gl/functions.h"

namespace eyeray {

/// One texture, buffer, vertex array or framebuffer, deleted with its owner:
/// Handle{gl.genTextures, gl.deleteTextures}.
class Handle {
public:
    using Generate = void(APIENTRYP)(GLsizei, GLuint*);
    using Delete = void(APIENTRYP)(GLsizei, const GLuint*);

    Handle(Generate generate, Delete deleteNames) : delete_(deleteNames) { generate(1, &name_); }
    ~Handle() {
        if (name_ != 0) delete_(1, &name_);
    }
    Handle(Handle&& other) noexcept : delete_(other.delete_), name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(delete_, other.delete_);
        std::swap(name_, other.name_);
        return *this;
    }

    GLuint name() const { return name_; }

private:
    Delete delete_;
    GLuint name_ = 0;
};

}
