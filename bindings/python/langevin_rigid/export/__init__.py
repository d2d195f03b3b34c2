# SPDX-License-Identifier: MIT
"""Writers of recordings for other programs: USD point instancers, and point caches of a carrier mesh (PC2)."""
from .pc2 import CarrierCache, read_pc2, write_carrier_pc2
from .usd import write_usda

__all__ = ["CarrierCache", "read_pc2", "write_carrier_pc2", "write_usda"]
