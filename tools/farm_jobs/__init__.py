"""Renders pictures in parts on many machines.

cuts says where to cut a picture so that the parts take equal time; plan makes the tasks of a picture and says which
are done; jobs keeps them in a folder as scripts, and hands those to Slurm, to OpenJD or to a shell; command is the
program.
"""
