#pragma once
// The cases by what they are about, each group in a file of its own.

#include "core/study/stability.h"

namespace eyeray {

std::vector<StabilityCase> sphereCases();
std::vector<StabilityCase> triangleCases();
std::vector<StabilityCase> boxCases();
std::vector<StabilityCase> spawnCases();
std::vector<StabilityCase> transformCases();
std::vector<StabilityCase> opticsCases();
std::vector<StabilityCase> samplingCases();
std::vector<StabilityCase> lampCases();
std::vector<StabilityCase> sumCases();
std::vector<StabilityCase> tieCases();
std::vector<StabilityCase> shadingCases();
std::vector<StabilityCase> seriesCases();
std::vector<StabilityCase> pixelCases();
std::vector<StabilityCase> numberCases();

}
