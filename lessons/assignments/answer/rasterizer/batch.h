// The engine's formulas run on whole vectors as well; yours is asked in double and in float. This
// file stands where the engine has its vectors.
#pragma once
