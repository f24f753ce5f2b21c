#pragma once
// Text for XML and HTML.

#include <string>
#include <string_view>

namespace eyeray {

/// Any text as the content of an element or of a quoted attribute: what the languages reserve is escaped,
/// lines stay lines, and what XML cannot hold (other control characters, bytes that are not UTF-8) is left
/// out.
std::string escaped(std::string_view text);

}
