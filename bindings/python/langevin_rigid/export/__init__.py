# SPDX-License-Identifier: MIT
"""Exports recordings to other programs: USD point instancers, and point caches (PC2) of a carrier mesh."""
from .pc2 import CarrierCache, read_pc2, write_carrier_pc2
from .usd import write_usda

__all__ = ["CarrierCache", "read_pc2", "write_carrier_pc2", "write_usda"]
