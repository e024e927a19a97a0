// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- all together ---- */

function makeView(id) {
  const canvas = element(id), mesh = new Mesh(data[id]), view = {canvas, mesh, painter: new Painter(canvas, mesh)};
  view.altitude = mesh.typicalAltitude();
  canvas.setAttribute("aria-label", id + ": the mesh, " + text(data[id].number_of_faces) + " triangles");
  canvas.addEventListener("webglcontextlost", e => e.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => {
    view.painter = new Painter(canvas, mesh);
    view.painter.setValues(figureShown());
    if (chosen.view === id) view.painter.select(chosen.face);
    askForDraw();
  });
  return view;
}

function showMeshes() {
  const select = element("colour");
  select.add(new Option("none", "-1"));
  data.figures.forEach((figure, i) => select.add(new Option(figure.title, String(i))));
  select.value = "0";
  views.before = makeView("before");
  views.after = makeView("after");
  const hasCurves = views.before.mesh.curves.length + views.after.mesh.curves.length > 0;
  element("creases-label").hidden = !hasCurves;
  firstRotation();
  camera.isWhole = true;
  listen();
  tellOfSaving();
  chooseFigure();
  draw();
}

setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
fillText();
data.histograms.forEach(drawHistogram);
try {
  showMeshes();
  document.documentElement.dataset.state = "shown";
} catch (error) {
  element("problem").textContent = error.message;
  document.documentElement.dataset.state = "without meshes";
}
