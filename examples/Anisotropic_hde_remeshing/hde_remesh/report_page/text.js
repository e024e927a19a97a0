// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- words, numbers and tables ---- */

const data = JSON.parse(document.getElementById("data").textContent);
const element = id => document.getElementById(id);

function text(value, digits = 3) {
  if (value === null || value === undefined) return "-";
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value)) return value.toLocaleString("en-US");
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
}

// a length in the unit of the mesh, told in D
const inD = length => (length === null || length === undefined ? "-" : text(length / data.report.diagonal) + " D");

const fileName = path => path.split(/[\/\\]/).pop();

function addRow(table, cells, isHead = false) {
  const tr = table.insertRow();
  for (const cell of cells) {
    const td = document.createElement(isHead ? "th" : "td");
    td.textContent = cell;
    tr.appendChild(td);
  }
}

function fillHeading() {
  const r = data.report, name = fileName(r.input) + " \u2192 " + fileName(r.output);
  document.title = name + ", " + text(data.after.number_of_faces) + " triangles - hde_remesh";
  element("title").textContent = name;
  const table = element("verdict");
  for (const [name, said] of data.verdict) addRow(table, [name, said]);
  for (const row of [...table.rows].slice(data.verdict.length - r.warnings.length)) row.className = "problem";
  element("subtitle").textContent = "All lengths are in D, the diagonal of the bounding box of " + fileName(r.input) + ", which is " +
    text(r.diagonal, 6) + " in the unit of the mesh.";
}

function describeMesh(id, mesh) {
  element(id + "-text").textContent = id + ": " + text(mesh.number_of_faces) + " triangles" +
    (mesh.is_simplified ? "; too many for a page: shown simplified to " + text(mesh.number_of_shown_faces) +
     ", with the figures of the nearest triangle of the mesh" : "");
}

function fillParameters() {
  const r = data.report, table = element("parameters");
  const add = (name, ...values) => addRow(table, [name, values.join(", ")]);
  add("input, output", r.input, r.output);
  if (r.sigma !== undefined) add("sigma", inD(r.sigma));
  add("embedding", text(r.embedding).replace(/^sigma ([\d.e+-]+)(?=,|$)/, (_, sigma) => "sigma " + inD(Number(sigma))));
  if (r.target_edge_length !== undefined) add("6D edge length aimed at", inD(r.target_edge_length));
  if (r.target_faces !== undefined) add("triangles aimed at", text(r.target_faces));
  if (r.error !== undefined) add("error asked for, and the bound found", inD(r.error), inD(r.error_bound));
  if (r.sharp !== undefined) add("edges kept that turn by", text(r.sharp) + "\u00b0 or more");
  if (r.kernel !== undefined) add("kernel", r.kernel);
  if (r.function)
    add("patches; of these replaced by the distance to the input", text(r.function.patches), text(r.function.patches_on_fallback));
  add("scheme, iterations", r.scheme, text(r.remeshing.iterations));
  for (const stage of Object.keys(r.seconds || {})) add("time: " + stage, r.seconds[stage].toFixed(2) + " s");
  add("program", r.program);
}

function fillText() {
  fillHeading();
  describeMesh("before", data.before);
  describeMesh("after", data.after);
  addRow(element("measures"), ["", "before", "after"], true);
  for (const row of data.table) addRow(element("measures"), row);
  fillParameters();
  element("command").textContent = data.command_line;
}

