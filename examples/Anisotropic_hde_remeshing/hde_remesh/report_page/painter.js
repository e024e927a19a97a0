// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- WebGL: triangles with their edges, and lines of some width ---- */

// the darker the larger; and from inside to outside
const sequential = [[246, 242, 229], [186, 221, 195], [92, 178, 186], [38, 110, 178], [74, 20, 110]];
const diverging = [[33, 80, 160], [140, 185, 220], [247, 247, 247], [235, 165, 130], [170, 30, 40]];
const stopsOf = figure => (figure.worst === "absolute" ? diverging : sequential);
const plainColour = [237, 230, 214];

const cameraCode = `#version 300 es
  precision highp float;
  uniform mat3 rotation; uniform vec3 place; uniform vec2 scale; // place: x, y, zoom
  vec4 projected(vec3 p) {
    vec3 q = rotation * p;
    return vec4((place.z * q.xy + place.xy) * scale, -q.z / 1.5, 1.0);
  }`;
const faceVertexShader = cameraCode + `
  in vec3 position, normal; in float value;
  out vec3 seen, turned, barycentric; flat out float figure;
  void main() {
    int corner = gl_VertexID % 3;
    barycentric = vec3(corner == 0, corner == 1, corner == 2);
    seen = place.z * (rotation * position); turned = rotation * normal; figure = value;
    gl_Position = projected(position);
  }`;
const faceFragmentShader = `#version 300 es
  precision highp float;
  in vec3 seen, turned, barycentric; flat in float figure;
  uniform float low, high, edges, lineWidth, cut; uniform int kind, smoothly; uniform vec3 stops[5], plain;
  out vec4 colour;
  float share() { // of the range; 0 stays in the middle of what has a sign
    if (kind == 1) return log(figure / low) / log(high / low);
    if (kind == 2) return 0.5 + 0.5 * (figure < 0.0 ? -figure / low : figure / high);
    return (figure - low) / (high - low);
  }
  vec3 paint() {
    if (kind < 0) return plain;
    if (figure > 1e37) return vec3(0.85, 0.1, 0.85); // not finite
    float t = clamp(share(), 0.0, 1.0) * 4.0;
    int k = int(min(floor(t), 3.0));
    return mix(stops[k], stops[k + 1], t - float(k));
  }
  void main() {
    vec3 across = cross(dFdx(seen), dFdy(seen));
    vec3 facing = normalize(smoothly == 1 && dot(turned, turned) > 0.0 ? turned : across);
    float light = 0.4 + 0.6 * abs(dot(facing, normalize(vec3(0.25, 0.35, 1.0))));
    vec3 steep = sqrt(pow(dFdx(barycentric), vec3(2.0)) + pow(dFdy(barycentric), vec3(2.0))); // for a pixel
    vec3 pixels = barycentric / max(steep, 1e-6);
    float line = 1.0 - smoothstep(0.5 * lineWidth - 0.5, 0.5 * lineWidth + 0.5, min(pixels.x, min(pixels.y, pixels.z)));
    float altitude = 1.0 / max(steep.x, max(steep.y, steep.z));
    line = mix(min(line, 0.6), line, smoothstep(1.0, 4.0, altitude)); // grey, not black, where all is edges
    colour = vec4(mix(paint() * light, vec3(0.08), edges * line), 1.0);
    if (seen.z > cut) discard;
  }`;
const lineVertexShader = cameraCode + `
  in vec3 begin, end;
  uniform vec2 pixel; uniform float width, nearer;
  out float depth;
  void main() {
    vec4 a = projected(begin), b = projected(end);
    vec2 along = (b.xy - a.xy) / pixel;
    along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
    float side = gl_VertexID % 2 == 0 ? -0.5 : 0.5, over = gl_VertexID < 2 ? -0.5 : 0.5;
    vec4 p = gl_VertexID < 2 ? a : b;
    depth = -1.5 * p.z;
    p.xy += width * pixel * (side * vec2(-along.y, along.x) + 0.5 * over * along);
    p.z -= nearer;
    gl_Position = p;
  }`;
const lineFragmentShader = `#version 300 es
  precision highp float;
  in float depth; uniform vec3 paint; uniform float cut; out vec4 colour;
  void main() {
    colour = vec4(paint, 1.0);
    if (depth > cut) discard;
  }`;

function makeProgram(gl, vertexShader, fragmentShader) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  const places = {};
  return {program, attribute: name => gl.getAttribLocation(program, name),
          uniform: name => (name in places ? places[name] : (places[name] = gl.getUniformLocation(program, name)))};
}

function upload(gl, buffer, values) {
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
}

// the colour of a variable of the style sheet, each part from 0 to 1
function themeColour(name) {
  const hex = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16) / 255);
}

class Painter {
  constructor(canvas, mesh) {
    this.canvas = canvas;
    this.mesh = mesh;
    this.gl = canvas.getContext("webgl2", {antialias: true});
    if (!this.gl) throw new Error("This browser has no WebGL 2: the meshes are not shown.");
    this.makeFaces();
    this.makeLines();
  }

  makeFaces() {
    const gl = this.gl;
    this.faces = makeProgram(gl, faceVertexShader, faceFragmentShader);
    this.faceArrays = gl.createVertexArray();
    this.buffers = {};
    gl.bindVertexArray(this.faceArrays);
    for (const [name, size] of [["position", 3], ["normal", 3], ["value", 1]]) {
      this.buffers[name] = gl.createBuffer();
      const values = name === "position" ? this.mesh.cornerPositions() : new Float32Array(size * this.mesh.faces.length);
      upload(gl, this.buffers[name], values);
      gl.enableVertexAttribArray(this.faces.attribute(name));
      gl.vertexAttribPointer(this.faces.attribute(name), size, gl.FLOAT, false, 0, 0);
    }
    this.hasNormals = false;
  }

  makeLines() {
    const gl = this.gl;
    this.lines = makeProgram(gl, lineVertexShader, lineFragmentShader);
    this.lineSets = {};
    for (const name of ["curves", "selected"]) {
      const set = this.lineSets[name] = {arrays: gl.createVertexArray(), buffer: gl.createBuffer(), count: 0};
      gl.bindVertexArray(set.arrays);
      gl.bindBuffer(gl.ARRAY_BUFFER, set.buffer);
      for (const [attribute, offset] of [["begin", 0], ["end", 12]]) {
        const at = this.lines.attribute(attribute);
        gl.enableVertexAttribArray(at);
        gl.vertexAttribPointer(at, 3, gl.FLOAT, false, 24, offset);
        gl.vertexAttribDivisor(at, 1);
      }
    }
    this.setLines("curves", this.mesh.curves);
  }

  // two points each
  setLines(name, points) {
    upload(this.gl, this.lineSets[name].buffer, Float32Array.from(points));
    this.lineSets[name].count = points.length / 6;
  }

  select(f) {
    const p = f === null ? [] : this.mesh.corners(f);
    this.setLines("selected", f === null ? [] : [p[0], p[1], p[1], p[2], p[2], p[0]].flat());
  }

  setValues(figure) {
    if (!figure) return;
    const values = this.mesh.figures[figure.key], all = new Float32Array(this.mesh.faces.length);
    for (let i = 0; i < all.length; ++i) all[i] = Math.min(values[Math.floor(i / 3)], 3e38);
    upload(this.gl, this.buffers.value, all);
  }

  fitCanvas() {
    const ratio = window.devicePixelRatio || 1, canvas = this.canvas;
    const w = Math.max(1, Math.round(canvas.clientWidth * ratio)), h = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
    this.gl.viewport(0, 0, w, h);
  }

  useProgram(made) {
    const gl = this.gl, w = this.canvas.width, h = this.canvas.height, short = Math.min(w, h), r = camera.rotation;
    gl.useProgram(made.program);
    gl.uniformMatrix3fv(made.uniform("rotation"), true, r);
    gl.uniform3f(made.uniform("place"), camera.x, camera.y, camera.zoom);
    gl.uniform2f(made.uniform("scale"), short / w, short / h);
  }

  // `how`: figure, low, high, logarithmic, edges (how dark), smooth, creases, cut (in front of which nothing is drawn)
  draw(how) {
    this.fitCanvas();
    const gl = this.gl;
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.clearColor(...themeColour("--view"), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawFaces(how);
    const pixelDepth = 2 / (1.5 * camera.zoom * Math.min(this.canvas.width, this.canvas.height));
    if (how.creases) this.drawLines("curves", 2.6, [1, 0.42, 0], 2 * pixelDepth, how.cut);
    gl.disable(gl.DEPTH_TEST);
    this.drawLines("selected", 3, [0.9, 0, 0.7], 0, 10);
  }

  drawFaces(how) {
    const gl = this.gl, uniform = this.faces.uniform;
    if (how.smooth && !this.hasNormals) {
      upload(gl, this.buffers.normal, this.mesh.cornerNormals());
      this.hasNormals = true;
    }
    this.useProgram(this.faces);
    const figure = how.figure;
    gl.uniform1i(uniform("kind"), !figure ? -1 : figure.worst === "absolute" ? 2 : how.logarithmic ? 1 : 0);
    gl.uniform3fv(uniform("plain"), plainColour.map(c => c / 255));
    gl.uniform3fv(uniform("stops"), stopsOf(figure || {}).flat().map(c => c / 255));
    gl.uniform1f(uniform("low"), how.low);
    gl.uniform1f(uniform("high"), how.high);
    gl.uniform1f(uniform("edges"), how.edges);
    gl.uniform1f(uniform("cut"), how.cut * camera.zoom);
    gl.uniform1f(uniform("lineWidth"), 1.2 * (window.devicePixelRatio || 1));
    gl.uniform1i(uniform("smoothly"), how.smooth ? 1 : 0);
    gl.bindVertexArray(this.faceArrays);
    gl.drawArrays(gl.TRIANGLES, 0, this.mesh.faces.length);
  }

  drawLines(name, width, paint, nearer, cut) {
    const gl = this.gl, set = this.lineSets[name];
    if (set.count === 0) return;
    this.useProgram(this.lines);
    gl.uniform2f(this.lines.uniform("pixel"), 2 / this.canvas.width, 2 / this.canvas.height);
    gl.uniform1f(this.lines.uniform("width"), width * (window.devicePixelRatio || 1));
    gl.uniform1f(this.lines.uniform("nearer"), nearer);
    gl.uniform1f(this.lines.uniform("cut"), cut);
    gl.uniform3fv(this.lines.uniform("paint"), paint);
    gl.bindVertexArray(set.arrays);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, set.count);
  }
}

