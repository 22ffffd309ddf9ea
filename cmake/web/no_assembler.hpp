// Before every source of the preset web. Eigen 3.4 works around a fault of g++ by lines of assembler for x86-64 that do
// nothing but keep numbers in registers, wherever it adds by SSE2; for WebAssembly there is no such assembler. (Others, for
// g++ before 6.3, go away by -fgnuc-version=6.3.)
#pragma once
#define __asm__(...)
