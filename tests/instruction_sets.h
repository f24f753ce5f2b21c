#pragma once
// Code that is compiled for several instruction sets, run under each.

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace eyeray {

/// Runs `body` as a machine would that has no more than each of the instruction sets in turn.
template <class Body>
void withEachInstructionSet(const Body& body) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        body();
    }
    hwy::SetSupportedTargetsForTest(0);
}

}
