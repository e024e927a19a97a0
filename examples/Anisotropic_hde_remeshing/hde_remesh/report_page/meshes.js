// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- the meshes: in the ball of radius one about the middle of the box of both ---- */

const digits85 = "#$%'()*+,-./0123456789:;=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[]^_`abcdefghijklmnopqrstuvwxyz";

// five characters are four bytes
function bytesOf(coded) {
  const values = new Uint8Array(128), bytes = new Uint8Array(coded.length / 5 * 4);
  for (let i = 0; i < 85; ++i) values[digits85.charCodeAt(i)] = i;
  for (let i = 0, at = 0; i < coded.length; i += 5, at += 4) {
    let word = 0;
    for (let k = 0; k < 5; ++k) word = word * 85 + values[coded.charCodeAt(i + k)];
    bytes[at] = word >>> 24; bytes[at + 1] = word >>> 16; bytes[at + 2] = word >>> 8; bytes[at + 3] = word;
  }
  return bytes;
}

// numbers of some bits each
function numbersOf({bits, count, text}) {
  const bytes = bytesOf(text), numbers = new Uint32Array(count);
  for (let i = 0, at = 0, rest = 0, left = 0; i < count; ++i) {
    for (; left < bits; left += 8) rest = rest * 256 + bytes[at++];
    const power = 2 ** (left -= bits);
    numbers[i] = rest / power;
    rest %= power;
  }
  return numbers;
}

const box = {low: data.box.low, size: data.box.high.map((x, i) => x - data.box.low[i])};
box.step = Math.max(...box.size) / 0xffffff;
box.radius = Math.hypot(...box.size) / 2;

// in the coordinates of the file, and back from those of the views
const inFile = (step, k) => box.low[k] + box.step * step;
const fromView = (x, k) => box.low[k] + box.size[k] / 2 + box.radius * x;

const inView = steps => Float32Array.from(steps, (step, i) => (box.step * step - box.size[i % 3] / 2) / box.radius);

// what is not finite, as the aspect ratio of a degenerate triangle, is infinite here
function figureOf({low, high, logarithmic, codes}) {
  return Float64Array.from(numbersOf(codes), code => {
    const x = low + (high - low) * code / 0xfffe;
    return code === 0xffff ? Infinity : logarithmic ? Math.exp(x) : x;
  });
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = a => { const length = Math.hypot(...a); return length > 0 ? a.map(x => x / length) : a; };

class Mesh {
  constructor(coded) {
    this.numberOfFaces = coded.number_of_shown_faces;
    this.isSimplified = coded.is_simplified;
    this.steps = numbersOf(coded.points);
    this.points = inView(this.steps);
    this.faces = numbersOf(coded.faces);
    this.curves = inView(numbersOf(coded.curves));
    this.figures = {};
    for (const key of Object.keys(coded.figures)) this.figures[key] = figureOf(coded.figures[key]);
    this.orders = {};
  }

  point(v) { return Array.from(this.points.subarray(3 * v, 3 * v + 3)); }
  corners(f) { return [0, 1, 2].map(k => this.point(this.faces[3 * f + k])); }
  lengths(f) { const p = this.corners(f); return [0, 1, 2].map(k => Math.hypot(...minus(p[k], p[(k + 1) % 3]))); }
  areaNormal(f) { const [a, b, c] = this.corners(f); return cross(minus(b, a), minus(c, a)).map(x => x / 2); }

  // of the triangles, the median of the least altitudes
  typicalAltitude() {
    const altitudes = new Float64Array(this.numberOfFaces);
    for (let f = 0; f < this.numberOfFaces; ++f)
      altitudes[f] = 2 * Math.hypot(...this.areaNormal(f)) / (Math.max(...this.lengths(f)) || 1);
    return altitudes.sort()[this.numberOfFaces >> 1];
  }

  // the corners of all triangles, one after the other
  cornerPositions() {
    const positions = new Float32Array(3 * this.faces.length);
    for (let i = 0; i < this.faces.length; ++i)
      for (let k = 0; k < 3; ++k) positions[3 * i + k] = this.points[3 * this.faces[i] + k];
    return positions;
  }

  facesOfVertices() {
    const begin = new Uint32Array(this.points.length / 3 + 1), all = new Uint32Array(this.faces.length);
    for (const v of this.faces) ++begin[v + 1];
    for (let v = 1; v < begin.length; ++v) begin[v] += begin[v - 1];
    const at = begin.slice();
    this.faces.forEach((v, i) => { all[at[v]++] = Math.floor(i / 3); });
    return {begin, all};
  }

  // A corner has the mean normal of the triangles around its vertex that turn by less than 40 degrees from its own.
  cornerNormals() {
    const {begin, all} = this.facesOfVertices(), least = Math.cos(40 * Math.PI / 180);
    const normals = new Float32Array(3 * this.faces.length);
    const areas = [], units = [];
    for (let f = 0; f < this.numberOfFaces; ++f) { areas.push(this.areaNormal(f)); units.push(unit(areas[f])); }
    for (let i = 0; i < this.faces.length; ++i) {
      const own = units[Math.floor(i / 3)], v = this.faces[i];
      let sum = [0, 0, 0];
      for (let j = begin[v]; j < begin[v + 1]; ++j)
        if (dot(own, units[all[j]]) >= least) sum = sum.map((x, k) => x + areas[all[j]][k]);
      normals.set(unit(sum), 3 * i);
    }
    return normals;
  }

  // the triangles, the worst first
  order(figure) {
    const values = this.figures[figure.key];
    const badness = {largest: x => x, least: x => -x, absolute: Math.abs}[figure.worst];
    const isBefore = (a, b) => { const x = badness(values[a]), y = badness(values[b]); return x === y ? a - b : x > y ? -1 : 1; };
    if (!this.orders[figure.key]) this.orders[figure.key] = Uint32Array.from(values, (_, f) => f).sort(isBefore);
    return this.orders[figure.key];
  }
}

