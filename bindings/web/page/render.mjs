// SPDX-License-Identifier: MIT
// Draws a storm with WebGL2: all bodies in one instanced call, from the transforms in the module's memory.
import { lookAt, multiply, perspective, unit } from './matrix.mjs';
import { sheet } from './models.mjs';
import { bodyFragment, bodyVertex, groundFragment, groundVertex, skyFragment, skyVertex } from './shaders.mjs';

const sun = unit([-0.55, 0.5, -0.65]);
const angle = 0.85; // rad, the vertical field of view

export class Renderer {
  constructor(canvas) {
    const gl = canvas.getContext('webgl2', { alpha: false, antialias: true, stencil: true });
    if (!gl) throw new Error('This page needs WebGL2, which this browser does not support');
    this.canvas = canvas;
    this.gl = gl;
    this.sky = this.#program(skyVertex, skyFragment);
    this.ground = this.#program(groundVertex, groundFragment);
    this.bodies = this.#program(bodyVertex, bodyFragment);
    this.nothing = gl.createVertexArray();
    this.buffers = [];
  }

  #program(vertex, fragment) {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
      const { name } = gl.getActiveUniform(program, i);
      uniforms[name.replace('[0]', '')] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }

  #buffer(target, data, usage) {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, data, usage);
    this.buffers.push(buffer);
    return buffer;
  }

  setModel(model, capacity) {
    const { gl } = this;
    for (const buffer of this.buffers.splice(0)) gl.deleteBuffer(buffer);
    if (this.instances) gl.deleteVertexArray(this.instances);
    this.model = model;
    const { vertices, triangles } = sheet(model.shape);
    this.indexCount = triangles.length;
    this.instances = gl.createVertexArray();
    gl.bindVertexArray(this.instances);
    this.#buffer(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 20, 0);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 2, gl.FLOAT, false, 20, 12);
    this.#buffer(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    this.transforms = this.#buffer(gl.ARRAY_BUFFER, 64 * capacity, gl.DYNAMIC_DRAW);
    for (let column = 0; column < 4; ++column) {
      gl.enableVertexAttribArray(2 + column);
      gl.vertexAttribPointer(2 + column, 4, gl.FLOAT, false, 64, 16 * column);
      gl.vertexAttribDivisor(2 + column, 1);
    }
    this.keys = this.#buffer(gl.ARRAY_BUFFER, 4 * capacity, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(6);
    gl.vertexAttribIPointer(6, 1, gl.UNSIGNED_INT, 4, 0);
    gl.vertexAttribDivisor(6, 1);
    gl.bindVertexArray(null);
    this.revision = -1;
  }

  /** Uploads only moved bodies: sleeping ones are already in the buffer. Colours follow if bodies have changed places. */
  #upload({ batch, transforms }) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.transforms);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, transforms.writeMoved());
    const view = batch.view();
    if (view.revision !== this.revision) {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.keys);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, view.noiseSeed);
      this.revision = view.revision;
    }
  }

  #use({ program, uniforms }, viewProjection, eye) {
    const { gl } = this;
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.viewProjection ?? null, false, viewProjection);
    gl.uniform3fv(uniforms.eye ?? null, eye);
    gl.uniform3fv(uniforms.sun ?? null, sun);
    gl.uniform1f(uniforms.haze ?? null, 0.035 / this.model.room[0]);
    gl.uniform1f(uniforms.room ?? null, this.model.room[0]);
    return uniforms;
  }

  draw(storm, camera) {
    const { gl, canvas, model } = this;
    const ratio = Math.min(globalThis.devicePixelRatio, 2);
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    this.#upload(storm);

    const [half, top] = model.room;
    const target = [0, 0.36 * top, 0];
    const away = camera.distance * half;
    const back = [Math.sin(camera.yaw) * Math.cos(camera.pitch), Math.sin(camera.pitch), Math.cos(camera.yaw) * Math.cos(camera.pitch)];
    const eye = target.map((t, i) => Math.max(t + away * back[i], i === 1 ? 0.05 * top : -Infinity));
    const view = lookAt(eye, target);
    const viewProjection = multiply(perspective(angle, width / height, 0.02 * half, 100 * half), view);

    gl.clear(gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.bindVertexArray(this.nothing);
    gl.disable(gl.DEPTH_TEST);
    const up = Math.tan(angle / 2);
    const across = (up * width) / height;
    const rows = (i, scale) => [view[i] * scale, view[4 + i] * scale, view[8 + i] * scale, 0];
    const { inverseRays } = this.#use(this.sky, viewProjection, eye);
    gl.uniformMatrix4fv(inverseRays, false, [...rows(0, across), ...rows(1, up), ...rows(2, -1), 0, 0, 0, 1]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.enable(gl.DEPTH_TEST);
    this.#use(this.ground, viewProjection, eye);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);

    const uniforms = this.#use(this.bodies, viewProjection, eye);
    gl.uniform1f(uniforms.half_length, model.half);
    gl.uniform1f(uniforms.ribs, model.ribs);
    gl.uniform3fv(uniforms.colours, model.colours.flat());
    gl.uniform1i(uniforms.colour_count, model.colours.length);
    gl.bindVertexArray(this.instances);
    // Overlapping shadows do not darken each other.
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.disable(gl.DEPTH_TEST);
    gl.uniform1f(uniforms.shadow, 1);
    gl.drawElementsInstanced(gl.TRIANGLES, this.indexCount, gl.UNSIGNED_SHORT, 0, storm.transforms.count);
    gl.disable(gl.STENCIL_TEST);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.uniform1f(uniforms.shadow, 0);
    gl.drawElementsInstanced(gl.TRIANGLES, this.indexCount, gl.UNSIGNED_SHORT, 0, storm.transforms.count);
    gl.bindVertexArray(null);
  }
}
