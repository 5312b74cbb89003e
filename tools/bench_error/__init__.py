"""How far lavaray's images are from the truth, and what that costs.

scenes -> running -> experiment -> analysis -> tables, plot; images reads and compares, command is the program.
"""
