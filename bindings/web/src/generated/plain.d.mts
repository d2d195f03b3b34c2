// Made by bindings/generator/javascript.py from include/langevin_rigid.h: changes here are lost.
// SPDX-License-Identifier: MIT

import type { Input } from '../../langevin_rigid.mjs';
import type * as api from './api.mjs';

export declare class BatchPlain {
  /** Sets the gains of a batch from the next step on. null undoes it. */
  setLoadGains(gains: Input<api.LoadGains> | null): void;
  /** Reads the gains of a batch. */
  readonly loadGains: api.LoadGains;
  /**
   * Sets how often a batch is stepped.
   * divisor: 1 to 1024; default 1.
   */
  setRate(divisor: number): void;
  /** Reads a batch's rate and backlog. */
  readonly pace: api.BatchPace;
  /** Sets the forces on a batch from the next step on. null undoes it. */
  setForce(force: Input<api.BatchForce> | null): void;
  /** Reads the forces on every body of a batch. */
  readonly force: api.BatchForce;
  /** Sets how a batch collides from the next step on. null undoes it. */
  setContact(contact: Input<api.BatchContact> | null): void;
  /** Reads how a batch collides. */
  readonly contact: api.BatchContact;
  /** Sets the rules of a batch. null undoes it. */
  setRules(rules: Input<api.BatchRules> | null): void;
  /** Reads how a batch treats diverged bodies. */
  divergencePolicy: number;
  /** Sets the emitter of a batch. null undoes it. */
  setEmitter(desc: Input<api.EmitterDesc> | null): void;
  /** Reads the counts of a batch. */
  readonly counts: api.BatchCounts;
  /** Replaces the asset's coefficients of AERODYNAMIC loads for a batch from the next step on. null undoes it. */
  setAerodynamics(aerodynamics: Input<api.Aerodynamics> | null): void;
  /** Reads a batch's current coefficients. */
  readonly aerodynamics: api.Aerodynamics;
}

export declare class WorldPlain {
  /** Reads counts, time and settings of the world. */
  readonly info: api.WorldInfo;
  /**
   * Sets the instruction set from the next step on.
   * target: LR_SIMD_*.
   */
  setSimdTarget(target: number): void;
  /** Sets the water from the next step on. null undoes it. */
  setWater(desc: Input<api.WaterDesc> | null): void;
  /**
   * Limits the work of each step to a number of substeps of single bodies.
   * bodySubsteps: at most 2^48; 0, the default, for no limit.
   */
  setBudget(bodySubsteps: bigint | number): void;
  /** Reads the report of the last step. */
  readonly stepReport: api.StepReport;
  /** Reads the timings of the last step. */
  readonly timings: api.Timings;
  /** Reads the state of a body. */
  bodyState(body: bigint): api.BodyState;
  /** Reads the state of a collider. */
  colliderState(collider: bigint): api.ColliderState;
  /** Computes the loads on a body from its present state, wind and water; on a sleeping body as if its wake had ended. */
  bodyLoads(body: bigint): api.BodyLoads;
}
