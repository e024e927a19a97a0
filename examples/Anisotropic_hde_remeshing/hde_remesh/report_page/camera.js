// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- the camera, one for both views ---- */

// `rotation` by rows: to the right, up, to the eye. In a view, the half of the shorter side is 1.
const camera = {rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], zoom: 1, x: 0, y: 0, isWhole: true};

function multiply(a, b) { // 3 x 3
  const c = [];
  for (let i = 0; i < 9; i += 3)
    for (let j = 0; j < 3; ++j) c.push(a[i] * b[j] + a[i + 1] * b[3 + j] + a[i + 2] * b[6 + j]);
  return c;
}

const rotated = (r, p) => [dot(r.slice(0, 3), p), dot(r.slice(3, 6), p), dot(r.slice(6, 9), p)];

// by another rotation; without a trace of rounding, which would grow with each
function rotateBy(other) {
  const m = multiply(other, camera.rotation), eye = unit(m.slice(6, 9)), right = unit(cross(m.slice(3, 6), eye));
  camera.rotation = [...right, ...cross(eye, right), ...eye];
}

// about the middle of the view
function turn(dx, dy) {
  const cx = Math.cos(dx), sx = Math.sin(dx), cy = Math.cos(dy), sy = Math.sin(dy);
  rotateBy(multiply([1, 0, 0, 0, cy, -sy, 0, sy, cy], [cx, 0, sx, 0, 1, 0, -sx, 0, cx]));
  camera.isWhole = false;
}

function zoomBy(factor) {
  camera.zoom *= factor; camera.x *= factor; camera.y *= factor;
  camera.isWhole = false;
}

function moveBy(dx, dy) { camera.x += dx; camera.y += dy; camera.isWhole = false; }

const viewsAlong = {x: [0, 1, 0, 0, 0, 1, 1, 0, 0], y: [-1, 0, 0, 0, 0, 1, 0, 1, 0], z: [1, 0, 0, 0, 1, 0, 0, 0, 1]};

// along the shortest side of the box, slightly from the side and from above; y is up, or z where y is the shortest
function firstRotation() {
  const [x, y, z] = box.size, isShort = (a, b, c) => a < 0.8 * Math.min(b, c);
  camera.rotation = isShort(y, x, z) ? [1, 0, 0, 0, 0, 1, 0, -1, 0]
    : isShort(x, y, z) ? [0, 0, -1, 0, 1, 0, 1, 0, 0] : viewsAlong.z;
  turn(-0.4, 0.3);
}

// all of the meshes, as large as the view allows
function showWhole(meshes, width, height) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity], r = camera.rotation;
  for (const {points} of meshes)
    for (let i = 0; i < points.length; i += 3)
      for (let k = 0; k < 2; ++k) {
        const x = r[3 * k] * points[i] + r[3 * k + 1] * points[i + 1] + r[3 * k + 2] * points[i + 2];
        if (x < low[k]) low[k] = x;
        if (x > high[k]) high[k] = x;
      }
  const short = Math.min(width, height) || 1, sides = [width / short, height / short];
  camera.zoom = 0.94 * Math.min(...[0, 1].map(k => 2 * sides[k] / Math.max(high[k] - low[k], 1e-6)));
  camera.x = -camera.zoom * (low[0] + high[0]) / 2;
  camera.y = -camera.zoom * (low[1] + high[1]) / 2;
  camera.isWhole = true;
}

// The triangle in the middle, from the front, and large enough to be seen.
function lookAt(mesh, f) {
  const n = rotated(camera.rotation, unit(mesh.areaNormal(f))), p = mesh.corners(f), longest = Math.max(...mesh.lengths(f));
  if (Math.hypot(...n) > 0.5) {
    const side = Math.hypot(n[0], n[2]), c = side > 0 ? n[2] / side : 1, s = side > 0 ? n[0] / side : 0;
    rotateBy(multiply([1, 0, 0, 0, side, -n[1], 0, n[1], side], [c, 0, -s, 0, 1, 0, s, 0, c]));
  }
  const centre = rotated(camera.rotation, [0, 1, 2].map(k => (p[0][k] + p[1][k] + p[2][k]) / 3));
  camera.zoom = Math.min(Math.max(0.7 / (longest || 1), 1), 1e4);
  camera.x = -camera.zoom * centre[0];
  camera.y = -camera.zoom * centre[1];
  camera.isWhole = false;
}

