#include "core/transport/integrator.h"

#include "core/base/errors.h"
#include "core/transport/methods.h"

namespace eyeray {

std::unique_ptr<Integrator> makeIntegrator(Method method) {
    switch (method) {
    case Method::Local:
        return makeLocal();
    case Method::Cast:
        return makeCast();
    case Method::Whitted:
        return makeWhitted();
    case Method::Distributed:
        return makeDistributed();
    case Method::Path:
        return makePath();
    }
    throw InternalError("makeIntegrator: no such method");
}

}
