// SPDX-License-Identifier: MIT
// Errors thrown for refused calls.
import { LR } from './generated/api.mjs';

const names = new Map(Object.entries(LR).filter(([name]) => name === 'OK' || name.startsWith('ERROR_'))
  .map(([name, value]) => [value, `LR_${name}`]));

/** The name of a status, for example LR_ERROR_STALE_BODY. */
export const statusName = (status) => names.get(status) ?? `unknown status ${status}`;

export class LangevinRigidError extends Error {
  /** @param {number} status @param {string} where the C function @param {string} phrase @param {string} detail from the library's log */
  constructor(status, where, phrase, detail) {
    const said = detail && !detail.startsWith(`${where}:`) ? `${where}: ${detail}` : detail;
    super(`${said || `${where}: ${phrase}`} (${statusName(status)})`);
    this.name = 'LangevinRigidError';
    this.status = status;
    this.statusName = statusName(status);
    this.function = where;
  }
}
