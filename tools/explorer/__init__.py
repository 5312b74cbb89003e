"""A render with all of its views on one page that needs nothing else: docs/explorer.html. It needs numpy, and the
Python package of the build."""
