"""How fast lavaray is, and how fast others are.

The C++ here is the program bench-speed, which measures rays, pictures and builds in one process; processes compares
whole programs; plot draws what bench-speed saved; command runs all of them.
"""
