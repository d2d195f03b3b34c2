// Made by bindings/generator/javascript.py from include/langevin_rigid.h: changes here are lost.
// SPDX-License-Identifier: MIT

import { whole, wholeWord } from '../heap.mjs';

export class BatchPlain {
  setLoadGains(gains) { this.world.set('lr_load_gains', gains, 'lr_batch_set_load_gains', this.handle); }
  get loadGains() { return this.world.get('lr_load_gains', 'lr_batch_get_load_gains', this.handle); }
  setRate(divisor) { this.world.call('lr_batch_set_rate', this.handle, whole(divisor, 'divisor')); }
  get pace() { return this.world.get('lr_batch_pace', 'lr_batch_get_pace', this.handle); }
  setForce(force) { this.world.set('lr_batch_force', force, 'lr_batch_set_force', this.handle); }
  get force() { return this.world.get('lr_batch_force', 'lr_batch_get_force', this.handle); }
  setContact(contact) { this.world.set('lr_batch_contact', contact, 'lr_batch_set_contact', this.handle); }
  get contact() { return this.world.get('lr_batch_contact', 'lr_batch_get_contact', this.handle); }
  setRules(rules) { this.world.set('lr_batch_rules', rules, 'lr_batch_set_rules', this.handle); }
  set divergencePolicy(policy) { this.world.call('lr_batch_set_divergence_policy', this.handle, whole(policy, 'policy')); }
  get divergencePolicy() { return this.world.number('i32', 'lr_batch_get_divergence_policy', this.handle); }
  setEmitter(desc) { this.world.set('lr_emitter_desc', desc, 'lr_batch_set_emitter', this.handle); }
  get counts() { return this.world.get('lr_batch_counts', 'lr_batch_get_counts', this.handle); }
  setAerodynamics(aerodynamics) { this.world.set('lr_aerodynamics', aerodynamics, 'lr_batch_set_aerodynamics', this.handle); }
  get aerodynamics() { return this.world.get('lr_aerodynamics', 'lr_batch_get_aerodynamics', this.handle); }
}

export class WorldPlain {
  get info() { return this.get('lr_world_info', 'lr_world_get_info'); }
  setSimdTarget(target) { this.call('lr_world_set_simd_target', whole(target, 'target')); }
  setWater(desc) { this.set('lr_water_desc', desc, 'lr_world_set_water'); }
  setBudget(bodySubsteps) { this.call('lr_world_set_budget', wholeWord(bodySubsteps, 'bodySubsteps')); }
  get stepReport() { return this.get('lr_step_report', 'lr_world_get_step_report'); }
  get timings() { return this.get('lr_timings', 'lr_world_get_timings'); }
  bodyState(body) { return this.get('lr_body_state', 'lr_body_get_state', body); }
  colliderState(collider) { return this.get('lr_collider_state', 'lr_collider_get_state', collider); }
  bodyLoads(body) { return this.get('lr_body_loads', 'lr_body_get_loads', body); }
}
