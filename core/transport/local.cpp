#include "core/transport/methods.h"

namespace eyeray {

// Ray casting without its shadow rays, which TraceContext switches off for this method.
std::unique_ptr<Integrator> makeLocal() { return makeCast(); }

}
