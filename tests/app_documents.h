#pragma once
// Documents of built-in scenes, and edits of them.

#include <string>

#include <gtest/gtest.h>

#include "app/document/document_commands.h"
#include "app/document/scene_files.h"

namespace eyeray {

inline Document edited(const Document& document, const std::string& line) {
    return apply(document, Command::parse(line));
}

class Documents : public testing::Test {
protected:
    Document homage = openScene("homage").document;
    Document shadows = openScene("shadows").document; // several lamps
};

}
