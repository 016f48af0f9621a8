// Nothing: a target needs a source, and those that hold precompiled headers have no other.
