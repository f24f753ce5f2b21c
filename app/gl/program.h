#pragma once
// Shader programs.

#include "app/gl/functions.h"

namespace eyeray {

/// A linked pair of vertex and fragment shader.
class Program {
public:
    /// Compiles and links GLSL sources; throws Failure with the first line of the compiler's log.
    Program(const Gl& gl, const char* vertexSource, const char* fragmentSource);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { gl_.useProgram(name_); }

    /// The place of a uniform, −1 when no shader reads it.
    GLint uniform(const char* name) const { return gl_.getUniformLocation(name_, name); }

private:
    const Gl& gl_;
    GLuint name_;
};

}
