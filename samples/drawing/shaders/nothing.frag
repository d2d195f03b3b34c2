// Depth alone.    SPDX-License-Identifier: MIT
void main() {}
