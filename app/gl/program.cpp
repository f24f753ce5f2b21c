#include "app/gl/program.h"

#include <array>
#include <string>

#include "core/base/errors.h"

namespace eyeray {
namespace {

using GetParameter = PFNGLGETSHADERIVPROC;
using GetLog = PFNGLGETSHADERINFOLOGPROC;

void requireSuccess(GLuint object, GLenum status, GetParameter getParameter, GetLog getLog) {
    GLint succeeded = GL_FALSE;
    getParameter(object, status, &succeeded);
    if (succeeded) return;
    std::array<char, 512> text{};
    getLog(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
    const std::string log(text.data());
    throw Failure{"OpenGL shader", log.substr(0, log.find('\n')), "use a driver with OpenGL 3.3 core"};
}

/// A shader that is gone when the program that holds it is.
void attach(const Gl& gl, GLuint program, GLenum stage, const char* source) {
    const GLuint shader = gl.createShader(stage);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
    gl.shaderSource(shader, 1, &source, nullptr);
    gl.compileShader(shader);
    requireSuccess(shader, GL_COMPILE_STATUS, gl.getShaderiv, gl.getShaderInfoLog);
}

}

Program::Program(const Gl& gl, const char* vertexSource, const char* fragmentSource)
    : gl_(gl), name_(gl.createProgram()) {
    try {
        attach(gl, name_, GL_VERTEX_SHADER, vertexSource);
        attach(gl, name_, GL_FRAGMENT_SHADER, fragmentSource);
        gl.linkProgram(name_);
        requireSuccess(name_, GL_LINK_STATUS, gl.getProgramiv, gl.getProgramInfoLog);
    } catch (...) {
        gl.deleteProgram(name_);
        throw;
    }
}

Program::~Program() { gl_.deleteProgram(name_); }

}
