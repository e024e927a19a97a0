// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- histograms: counts by C++, bars here ---- */

function svg(name, attributes, parent, content) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const key of Object.keys(attributes)) node.setAttribute(key, attributes[key]);
  if (content !== undefined) node.textContent = content;
  parent.appendChild(node);
  return node;
}

function drawHistogram(histogram) {
  const width = 320, height = 130, left = 6, bottom = 18, figure = document.createElement("figure");
  const caption = document.createElement("figcaption");
  caption.textContent = histogram.title + (histogram.logarithmic ? ", logarithmic scale" : "");
  figure.appendChild(caption);
  const picture = svg("svg", {viewBox: "0 0 " + width + " " + height, role: "img", "aria-label": histogram.title}, figure);
  const shares = which => {
    const counts = histogram[which], sum = counts.reduce((a, b) => a + b, 0) || 1;
    return counts.map(c => c / sum);
  };
  const before = shares("before"), after = shares("after"), n = before.length;
  const top = Math.max(...before, ...after) || 1;
  const x = i => left + (width - 2 * left) * i / n, y = s => (height - bottom) * (1 - 0.96 * s / top);
  before.forEach((s, i) => svg("rect", {x: x(i), y: y(s), width: x(1) - x(0), height: height - bottom - y(s),
                                        class: "before", "fill-opacity": 0.55}, picture));
  let path = "M" + x(0) + " " + (height - bottom);
  after.forEach((s, i) => { path += " L" + x(i) + " " + y(s) + " L" + x(i + 1) + " " + y(s); });
  path += " L" + x(n) + " " + (height - bottom);
  svg("path", {d: path, class: "after", "fill-opacity": 0.35, "stroke-width": 1.2}, picture);
  svg("line", {x1: left, x2: width - left, y1: height - bottom, y2: height - bottom}, picture);
  for (const tick of [0, 0.5, 1]) {
    const value = histogram.logarithmic ? histogram.low * Math.pow(histogram.high / histogram.low, tick)
                                        : histogram.low + tick * (histogram.high - histogram.low);
    svg("text", {x: left + tick * (width - 2 * left), y: height - 5,
                 "text-anchor": tick === 0 ? "start" : tick === 1 ? "end" : "middle"}, picture,
        text(value) + (histogram.unit || "") + (tick === 1 ? " and more" : tick === 0 && histogram.low < 0 ? " and less" : ""));
  }
  element("histograms").appendChild(figure);
}

