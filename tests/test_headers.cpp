// Nothing but its headers: the program exists to precompile them, and tests nothing by itself.
