"""Many scenes in one process, against a process for each."""
