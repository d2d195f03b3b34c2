# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""Version of this package: that of the header."""
__version__ = "0.2.0"
