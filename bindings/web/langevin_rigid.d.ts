// SPDX-License-Identifier: MIT
export * from './langevin_rigid.mjs';
