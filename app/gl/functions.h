#pragma once
// The OpenGL 3.3 core functions that Eyeray calls, found at run time: from GLFW for a window, from OSMesa
// without one.

#include <GL/glcorearb.h>

namespace eyeray {

/// One member per OpenGL function, named without its "gl". Belongs to the context that was current when it
/// was made; everything drawn with it stays on that context's thread and is destroyed before it.
struct Gl {
    using GetProc = void* (*)(const char* name);

    /// Asks `getProc` for every function; throws Failure with the name of one that is missing.
    explicit Gl(GetProc getProc);
    Gl(const Gl&) = delete;
    Gl& operator=(const Gl&) = delete;

private:
    /// The address of a function, which takes the type of the member that it initialises.
    struct Function {
        void* address;
        template <class Pointer>
        operator Pointer() const {
            return reinterpret_cast<Pointer>(address);
        }
    };
    Function load(const char* name) const;
    GetProc getProc_;

public:
    // state
    const PFNGLENABLEPROC enable = load("glEnable");
    const PFNGLDISABLEPROC disable = load("glDisable");
    const PFNGLVIEWPORTPROC viewport = load("glViewport");
    const PFNGLSCISSORPROC scissor = load("glScissor");
    const PFNGLBLENDEQUATIONPROC blendEquation = load("glBlendEquation");
    const PFNGLBLENDFUNCSEPARATEPROC blendFuncSeparate = load("glBlendFuncSeparate");
    const PFNGLDEPTHFUNCPROC depthFunc = load("glDepthFunc");
    const PFNGLDEPTHMASKPROC depthMask = load("glDepthMask");
    const PFNGLFRONTFACEPROC frontFace = load("glFrontFace");
    const PFNGLPOLYGONMODEPROC polygonMode = load("glPolygonMode");
    const PFNGLCOLORMASKPROC colorMask = load("glColorMask");
    const PFNGLCLEARCOLORPROC clearColor = load("glClearColor");
    const PFNGLCLEARPROC clear = load("glClear");
    const PFNGLCLEARBUFFERFVPROC clearBufferfv = load("glClearBufferfv");
    const PFNGLCLEARBUFFERIVPROC clearBufferiv = load("glClearBufferiv");
    const PFNGLPIXELSTOREIPROC pixelStorei = load("glPixelStorei");
    const PFNGLREADPIXELSPROC readPixels = load("glReadPixels");
    const PFNGLREADBUFFERPROC readBuffer = load("glReadBuffer");
    const PFNGLDRAWBUFFERSPROC drawBuffers = load("glDrawBuffers");
    const PFNGLGETINTEGERVPROC getIntegerv = load("glGetIntegerv");
    // textures and framebuffers
    const PFNGLGENTEXTURESPROC genTextures = load("glGenTextures");
    const PFNGLDELETETEXTURESPROC deleteTextures = load("glDeleteTextures");
    const PFNGLACTIVETEXTUREPROC activeTexture = load("glActiveTexture");
    const PFNGLBINDTEXTUREPROC bindTexture = load("glBindTexture");
    const PFNGLTEXPARAMETERIPROC texParameteri = load("glTexParameteri");
    const PFNGLTEXIMAGE2DPROC texImage2D = load("glTexImage2D");
    const PFNGLTEXSUBIMAGE2DPROC texSubImage2D = load("glTexSubImage2D");
    const PFNGLBINDSAMPLERPROC bindSampler = load("glBindSampler");
    const PFNGLGENFRAMEBUFFERSPROC genFramebuffers = load("glGenFramebuffers");
    const PFNGLDELETEFRAMEBUFFERSPROC deleteFramebuffers = load("glDeleteFramebuffers");
    const PFNGLBINDFRAMEBUFFERPROC bindFramebuffer = load("glBindFramebuffer");
    const PFNGLFRAMEBUFFERTEXTURE2DPROC framebufferTexture2D = load("glFramebufferTexture2D");
    const PFNGLCHECKFRAMEBUFFERSTATUSPROC checkFramebufferStatus = load("glCheckFramebufferStatus");
    const PFNGLBLITFRAMEBUFFERPROC blitFramebuffer = load("glBlitFramebuffer");
    const PFNGLGENRENDERBUFFERSPROC genRenderbuffers = load("glGenRenderbuffers");
    const PFNGLDELETERENDERBUFFERSPROC deleteRenderbuffers = load("glDeleteRenderbuffers");
    const PFNGLBINDRENDERBUFFERPROC bindRenderbuffer = load("glBindRenderbuffer");
    const PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC renderbufferStorageMultisample =
        load("glRenderbufferStorageMultisample");
    const PFNGLFRAMEBUFFERRENDERBUFFERPROC framebufferRenderbuffer = load("glFramebufferRenderbuffer");
    // programs
    const PFNGLCREATESHADERPROC createShader = load("glCreateShader");
    const PFNGLDELETESHADERPROC deleteShader = load("glDeleteShader");
    const PFNGLSHADERSOURCEPROC shaderSource = load("glShaderSource");
    const PFNGLCOMPILESHADERPROC compileShader = load("glCompileShader");
    const PFNGLGETSHADERIVPROC getShaderiv = load("glGetShaderiv");
    const PFNGLGETSHADERINFOLOGPROC getShaderInfoLog = load("glGetShaderInfoLog");
    const PFNGLCREATEPROGRAMPROC createProgram = load("glCreateProgram");
    const PFNGLDELETEPROGRAMPROC deleteProgram = load("glDeleteProgram");
    const PFNGLATTACHSHADERPROC attachShader = load("glAttachShader");
    const PFNGLLINKPROGRAMPROC linkProgram = load("glLinkProgram");
    const PFNGLGETPROGRAMIVPROC getProgramiv = load("glGetProgramiv");
    const PFNGLGETPROGRAMINFOLOGPROC getProgramInfoLog = load("glGetProgramInfoLog");
    const PFNGLUSEPROGRAMPROC useProgram = load("glUseProgram");
    const PFNGLGETUNIFORMLOCATIONPROC getUniformLocation = load("glGetUniformLocation");
    const PFNGLUNIFORM1IPROC uniform1i = load("glUniform1i");
    const PFNGLUNIFORM2FPROC uniform2f = load("glUniform2f");
    const PFNGLUNIFORM1FPROC uniform1f = load("glUniform1f");
    const PFNGLUNIFORM3FPROC uniform3f = load("glUniform3f");
    const PFNGLUNIFORM4FVPROC uniform4fv = load("glUniform4fv");
    const PFNGLUNIFORMMATRIX3FVPROC uniformMatrix3fv = load("glUniformMatrix3fv");
    const PFNGLUNIFORMMATRIX4FVPROC uniformMatrix4fv = load("glUniformMatrix4fv");
    // vertices
    const PFNGLGENVERTEXARRAYSPROC genVertexArrays = load("glGenVertexArrays");
    const PFNGLDELETEVERTEXARRAYSPROC deleteVertexArrays = load("glDeleteVertexArrays");
    const PFNGLBINDVERTEXARRAYPROC bindVertexArray = load("glBindVertexArray");
    const PFNGLGENBUFFERSPROC genBuffers = load("glGenBuffers");
    const PFNGLDELETEBUFFERSPROC deleteBuffers = load("glDeleteBuffers");
    const PFNGLBINDBUFFERPROC bindBuffer = load("glBindBuffer");
    const PFNGLBUFFERDATAPROC bufferData = load("glBufferData");
    const PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray = load("glEnableVertexAttribArray");
    const PFNGLVERTEXATTRIBPOINTERPROC vertexAttribPointer = load("glVertexAttribPointer");
    const PFNGLDRAWELEMENTSBASEVERTEXPROC drawElementsBaseVertex = load("glDrawElementsBaseVertex");
    const PFNGLDRAWARRAYSPROC drawArrays = load("glDrawArrays");
    const PFNGLDRAWELEMENTSPROC drawElements = load("glDrawElements");
};

}
