#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes all files generated from the public header.

    all.py [--check]     --check writes nothing, and fails if a file is out of date
"""
import sys

import csharp
import javascript
import python
import runtime

if __name__ == "__main__":
    sys.exit(not all([generator.main() for generator in (runtime, csharp, python, javascript)]))
