#pragma once
// Ctrl-C, heeded between two pieces of work.

namespace eyeray {

/// From now on a request to end (SIGINT, SIGTERM) is only noted.
void heedInterrupts();

/// True once the program was asked to end.
bool interrupted();

}
