/* Emscripten has SSE2 in WebAssembly's own instructions (-msse2), but no MMX. Eigen includes MMX's header beside SSE2's and
   needs nothing of it; without this file clang's own is found, which refuses to be compiled for a page. */
