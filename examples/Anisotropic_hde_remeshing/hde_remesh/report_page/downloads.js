// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- a picture and the meshes, to be saved ---- */

const stem = path => fileName(path).replace(/\.[^.]*$/, "");

function save(blob, name) {
  const link = document.createElement("a");
  link.download = name;
  link.href = URL.createObjectURL(blob);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// the views as they are, and below what their colours mean
function picture() {
  draw();
  const mode = element("mode").value, {width: w, height: h} = views.after.canvas, ratio = window.devicePixelRatio || 1;
  const canvas = document.createElement("canvas"), context = canvas.getContext("2d"), line = 26 * ratio, gap = 8 * ratio;
  canvas.width = mode === "side" ? 2 * w + gap : w;
  canvas.height = h + 2 * line;
  const style = getComputedStyle(document.documentElement), share = Number(element("slider").value) / 100;
  context.fillStyle = style.getPropertyValue("--page");
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(views.before.canvas, 0, line);
  if (mode === "side") context.drawImage(views.after.canvas, w + gap, line);
  else if (mode === "wipe" && share < 1)
    context.drawImage(views.after.canvas, share * w, 0, (1 - share) * w, h, share * w, line, (1 - share) * w, h);
  else if (mode === "fade") {
    context.globalAlpha = share;
    context.drawImage(views.after.canvas, 0, line);
    context.globalAlpha = 1;
  }
  labelPicture(context, mode, w + gap, h, line, style.getPropertyValue("--text"));
  return canvas;
}

function labelPicture(context, mode, second, h, line, ink) {
  const figure = figureShown(), font = 0.55 * line;
  context.font = font + "px system-ui, sans-serif";
  context.textBaseline = "middle";
  context.fillStyle = ink;
  const name = id => id + ": " + text(data[id].number_of_faces) + " triangles";
  context.fillText(mode === "side" ? name("before") : name("before") + "; " + name("after"), 4, line / 2);
  if (mode === "side") context.fillText(name("after"), second + 4, line / 2);
  if (!figure) return;
  const low = element("low").value + figure.unit, high = element("high").value + figure.unit + " and more";
  const words = figure.title + ", " + element("scale").value + " scale: " + low + " ", y = h + 1.5 * line;
  context.fillText(words, 4, y);
  const x = 4 + context.measureText(words).width;
  drawLegend(context, figure, x, y - font / 2, 5 * line, font);
  context.fillStyle = ink;
  context.fillText(" " + high, x + 5 * line, y);
}

function savePicture() { picture().toBlob(blob => save(blob, stem(data.report.output) + ".png")); }

// nine digits, as the coordinates are rounded to 6e-8 of the box
function vertexLines(mesh, prefix) {
  const lines = [];
  for (let i = 0; i < mesh.steps.length; i += 3)
    lines.push(prefix + [0, 1, 2].map(k => Number(inFile(mesh.steps[i + k], k).toPrecision(9))).join(" "));
  return lines;
}

function objText(mesh) {
  const lines = vertexLines(mesh, "v ");
  for (let f = 0; f < mesh.numberOfFaces; ++f) lines.push("f " + [0, 1, 2].map(k => mesh.faces[3 * f + k] + 1).join(" "));
  return lines.join("\n") + "\n";
}

// with the figures of the faces
function plyText(mesh) {
  const figures = Object.keys(mesh.figures);
  const lines = ["ply", "format ascii 1.0", "comment lengths among the figures are in D", "element vertex " + mesh.steps.length / 3,
                 "property double x", "property double y", "property double z", "element face " + mesh.numberOfFaces,
                 "property list uchar int vertex_indices", ...figures.map(key => "property float " + key), "end_header",
                 ...vertexLines(mesh, "")];
  for (let f = 0; f < mesh.numberOfFaces; ++f)
    lines.push(["3", ...mesh.faces.subarray(3 * f, 3 * f + 3),
                ...figures.map(key => Number(Math.min(mesh.figures[key][f], 3e38).toPrecision(6)))].join(" "));
  return lines.join("\n") + "\n";
}

const meshText = (id, format) => (format === "obj" ? objText : plyText)(views[id].mesh);

function saveMesh(id, format) {
  const name = stem(id === "before" ? data.report.input : data.report.output) + "_" + id + "." + format;
  save(new Blob([meshText(id, format)], {type: "text/plain"}), name);
}

function tellOfSaving() {
  const coded = data[element("save-which").value];
  element("save-note").textContent =
    coded.is_simplified ? "the mesh as shown, simplified to " + text(coded.number_of_shown_faces) + " triangles"
                        : "coordinates to 6e-8 of the box";
}

