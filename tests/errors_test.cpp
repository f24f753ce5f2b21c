// labels: unit
#include "core/base/errors.h"

#include <gtest/gtest.h>

namespace eyeray {
namespace {

TEST(Printable, ShowsControlCharactersAsText) {
    EXPECT_EQ(printable("a\nb\x1b[31m\x7f"), "a\\x0ab\\x1b[31m\\x7f");
    EXPECT_EQ(printable("grün “α”"), "grün “α”");
}

TEST(Printable, CutsLongTextBetweenCharacters) {
    EXPECT_EQ(printable("abcdef", 3), "abc…");
    EXPECT_EQ(printable("abc", 3), "abc");
    EXPECT_EQ(printable("αβγ", 3), "αβ…");                             // two bytes each
    EXPECT_EQ(printable("a𝄞b", 2), "a𝄞…");                             // four bytes
    EXPECT_LE(printable(std::string(1000, '\x80'), 100).size(), 110U); // no character at all
}

TEST(Error, IsOneLineOfPlaceFaultAndRemedy) {
    const InputError error{"file\n.glb", "is broken", "mend it"};
    EXPECT_STREQ(error.what(), "file\\x0a.glb: is broken: mend it");
    EXPECT_EQ(error.where(), "file\n.glb");
}

}
}
