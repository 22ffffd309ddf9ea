// Nothing: a target must have a source that uses its precompiled header.
