// Nothing of its own: the headers that src/CMakeLists.txt precompiles belong to a target, and a target has a source.
