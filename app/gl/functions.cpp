#include "app/gl/functions.h"

#include "core/base/errors.h"

namespace eyeray {

Gl::Gl(GetProc getProc) : getProc_(getProc) {}

Gl::Function Gl::load(const char* name) const {
    void* const address = getProc_(name);
    if (!address)
        throw Failure{name, "this OpenGL does not have the function", "use a driver with OpenGL 3.3 core"};
    return {address};
}

}
