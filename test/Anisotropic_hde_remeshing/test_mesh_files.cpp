// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The readers of hde_remesh: dialects give the points and faces that they mean; a count or an index that does not fit what follows
// is refused, with its place. One mesh, a tetrahedron, in all formats.

#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/Text_reader.h"
#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/readers.h"

#include "check.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using hde_remesh::Point_3;
using hde_remesh::Soup;

namespace {

const std::vector<Point_3> points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1.5)};
const std::vector<std::vector<std::size_t>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

typedef std::function<Soup(const std::string&)> Read;

const std::string off_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1.5\n", off_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
                  off = "OFF\n4 4 6\n" + off_points + off_faces;
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1.5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
const std::string ply_header = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
                               "property list uchar int vertex_indices\nend_header\n";
const std::string ply = "ply\nformat ascii 1.0\n" + ply_header + off_points + off_faces;

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  std::size_t number = 0;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()), ++number)
    text.replace(at, from.size(), to);
  CHECK(number > 0);
  return text;
}

std::string in_capitals(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char c) { return std::toupper(c); });
  return text;
}

std::string stl()
{
  std::string text = "solid tetrahedron\n";
  for (const std::vector<std::size_t>& face : faces)
  {
    text += "facet normal 0 0 1\n outer loop\n";
    for (const std::size_t v : face)
      text += "  vertex " + std::to_string(points[v].x()) + " " + std::to_string(points[v].y()) + " " +
              std::to_string(points[v].z()) + "\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

// the bytes of a number
template <typename Bits>
void append(std::string& bytes, Bits value, const bool is_big_endian)
{
  value = is_big_endian ? boost::endian::native_to_big(value) : boost::endian::native_to_little(value);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

void append_point(std::string& bytes, const Point_3& p, const bool is_big_endian = false)
{
  for (int i = 0; i < 3; ++i)
  {
    const float x = float(p[i]);
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    append(bytes, bits, is_big_endian);
  }
}

std::string binary_stl(const std::string& header = "binary")
{
  std::string bytes = header + std::string(80 - header.size(), ' ');
  append(bytes, std::uint32_t(faces.size()), false);
  for (const std::vector<std::size_t>& face : faces)
  {
    append_point(bytes, Point_3(0, 0, 0));
    for (const std::size_t v : face)
      append_point(bytes, points[v]);
    append(bytes, std::uint16_t(0), false);
  }
  return bytes;
}

template <typename Size, typename Index>
std::string binary_ply(const std::string& list, const bool is_big_endian)
{
  std::string bytes = std::string("ply\nformat binary_") + (is_big_endian ? "big" : "little") + "_endian 1.0\n" +
                      replaced(ply_header, "uchar int", list);
  for (const Point_3& p : points)
    append_point(bytes, p, is_big_endian);
  for (const std::vector<std::size_t>& face : faces)
  {
    append(bytes, Size(3), is_big_endian);
    for (const std::size_t v : face)
      append(bytes, Index(v), is_big_endian);
  }
  return bytes;
}

std::string binary_off()
{
  std::string bytes = "OFF BINARY\n";
  for (const std::uint32_t count : {4, 4, 6})
    append(bytes, count, true);
  for (const Point_3& p : points)
    append_point(bytes, p, true);
  for (const std::vector<std::size_t>& face : faces)
  {
    append(bytes, std::uint32_t(3), true);
    for (const std::size_t v : face)
      append(bytes, std::uint32_t(v), true);
    append(bytes, std::uint32_t(0), true);
  }
  return bytes;
}

// the faces, each by its points, as STL may number the points anew
std::vector<std::vector<Point_3>> corners(const Soup& soup)
{
  std::vector<std::vector<Point_3>> result;
  for (const std::vector<std::size_t>& face : soup.faces)
  {
    result.emplace_back();
    for (const std::size_t v : face)
      result.back().push_back(soup.points.at(v));
  }
  return result;
}

void check_read(const std::string& name, const Read& read, const std::string& text)
{
  try
  {
    const Soup soup = read(text);
    Soup expected;
    expected.points = points;
    expected.faces = faces;
    const bool is_right = soup.points.size() == 4 && corners(soup) == corners(expected);
    CHECK(is_right);
    if (!is_right)
      std::cout << name << ": other points or faces" << std::endl;
  }
  catch (const hde_remesh::Unreadable& error)
  {
    CHECK(false);
    std::cout << name << ": " << error.what() << std::endl;
  }
}

// "" if the text is read
std::string refusal(const Read& read, const std::string& text)
{
  try
  {
    read(text);
    return "";
  }
  catch (const hde_remesh::Unreadable& error)
  {
    return error.what();
  }
}

void check_refused(const Read& read, const std::string& text, const std::string& message)
{
  const std::string found = refusal(read, text);
  CHECK(found.find(message) != std::string::npos);
  if (found.find(message) == std::string::npos)
    std::cout << "not '" << message << "' but '" << found << "'" << std::endl;
}

void test_dialects_of_off()
{
  const Read read = hde_remesh::read_off;
  check_read("OFF", read, off);
  check_read("no number of edges", read, replaced(off, "4 4 6", "4 4"));
  check_read("no number of edges, comments", read, replaced(off, "4 4 6", "# two\n\n4 4 # counts\n"));
  check_read("no number of edges in one line with the keyword", read, replaced(off, "OFF\n4 4 6", "OFF 4 4"));
  check_read("counts behind the keyword", read, replaced(off, "OFF\n4 4 6", "OFF4 4 6"));
  check_read("two counts behind the keyword", read, replaced(off, "OFF\n4 4 6", "OFF4 4"));
  check_read("number of edges in its own line", read, replaced(off, "4 4 6", "4 4\n6"));
  check_read("counts in lines", read, replaced(off, "4 4 6", "4\n4\n6"));
  check_read("no keyword", read, replaced(off, "OFF\n", ""));
  check_read("small letters", read, replaced(off, "OFF", "off"));
  check_read("lines of Windows", read, replaced(off, "\n", "\r\n"));
  check_read("lines of old Macintoshes", read, replaced(off, "\n", "\r"));
  check_read("no last end of a line", read, off.substr(0, off.size() - 1));
  check_read("colours of faces", read, replaced(off, "3 1 2 3", "3 1 2 3 255 0 0"));
  check_read("colours and normals", read, "CNOFF\n4 4 6\n" + replaced(off_points, "\n", " 0 0 1 .5 .5 .5 1\n") + off_faces);
  check_read("texture", read, "STOFF\n4 4 6\n" + replaced(off_points, "\n", " 0 1\n") + off_faces);
  check_read("colours without a C", read, "OFF\n4 4 6\n" + replaced(off_points, "\n", " 9 9 9\n") + off_faces);
  check_read("a stream of numbers", read, "OFF 4 4 6 " + replaced(off_points + off_faces, "\n", " "));
  check_read("a number a line", read, replaced(off, " ", "\n"));
  check_read("binary", read, binary_off());
}

void test_counts_and_indices_of_off()
{
  const Read read = hde_remesh::read_off;
  check_refused(read, "", "expected OFF, but the file ends");
  check_refused(read, replaced(off, "OFF", "OOF"), "line 1: expected OFF, found 'OOF'");
  check_refused(read, replaced(off, "OFF", "4OFF"), "line 1: expected OFF with three coordinates");
  check_refused(read, replaced(off, "4 4 6", "4 four 6"), "line 2: expected the number of faces, found 'four'");
  check_refused(read, replaced(off, "4 4 6", "4 -4 6"), "line 2: expected the number of faces, found '-4'");
  check_refused(read, replaced(off, "4 4 6", "4 3 6"), "line 10: expected the end of the file after 3 faces, found '3'");
  check_refused(read, replaced(off, "4 4 6", "4 5 6"),
                "line 10: expected the number of vertices of face 5 of 5, but the file ends");
  check_refused(read, replaced(off, "4 4 6", "4 99999999999 6"), "line 2: the file is too short for 99999999999 faces");
  check_refused(read, replaced(off, "4 4 6", "3 4 6"), "face 1 of 4");
  check_refused(read, replaced(off, "4 4 6", "5 4 6"), "");
  check_refused(read, replaced(off, "3 1 2 3", "3 1 2 4"),
                "line 9: expected a vertex of face 3 of 4, a number below 4, found '4'");
  check_refused(read, replaced(off, "3 1 2 3", "3 1 2 -1"), "line 9");
  check_refused(read, replaced(off, "3 1 2 3", "3 1 2"), "line 9: expected 3 vertices of face 3 of 4, found 2");
  check_refused(read, replaced(off, "3 1 2 3", "0"), "line 9");
  check_refused(read, replaced(off, "1 0 0\n", "1 0\n"), "line 4: expected the coordinates of vertex 2 of 4 in one line");
  check_refused(read, replaced(off, "0 0 1.5", "0 0 1,5"),
                "line 6: expected a number, a coordinate of vertex 4 of 4, found '1,5'");
  check_refused(read, replaced(off, "0 0 1.5", "0 nan 1"), "line 6: 'nan' is not a finite number");
  std::string bytes = binary_off();
  check_refused(read, bytes.substr(0, bytes.size() - 1), "byte 147: expected the number of colours");
  check_refused(read, bytes + "more", "byte 151: expected the end of the file after 4 faces");
  bytes[11 + 12 + 48 + 7] = 9; // the first index
  check_refused(read, bytes, "byte 75: expected a vertex of face 1 of 4, found 9");
}

void test_obj()
{
  const Read read = hde_remesh::read_obj;
  check_read("OBJ", read, obj);
  check_read("lines and points", read, obj + "l 1 2\np 3\nl 1/1 2/2 \\\n 3/3\n");
  check_read("continued lines", read, replaced(obj, "f 1 3 2", "f 1 \\\n3 \\\r\n 2"));
  check_read("a comment ends in a backslash", read, replaced(obj, "f 1 3 2", "# C:\\\nf 1 3 2"));
  check_read("textures and normals", read, replaced(obj, "f 1 3 2", "vt 0 0\nvn 0 0 1\nf 1/1/1 3//1 2/1"));
  check_read("from the end", read, replaced(obj, "f 1 3 2", "f -4 -2 -3"));
  check_read("faces first", read, obj.substr(obj.find("f 1 3 2")) + obj.substr(0, obj.find("f 1 3 2")));
  check_read("colours and weights", read, replaced(obj, "v 1 0 0", "v 1 0 0 .5 .5 .5"));
  check_read("tabulators, lines of Windows", read, replaced(replaced(obj, " ", "\t"), "\n", "\r\n"));
  check_refused(read, replaced(obj, "f 1 3 2", "f 1 3 5"), "line 5: expected a vertex of face 1 of 4 from 1 to 4, found 5");
  check_refused(read, replaced(obj, "f 1 3 2", "f 1 3 0"),
                "line 5: expected a vertex of face 1, a whole number but 0, found '0'");
  check_refused(read, replaced(obj, "f 1 3 2", "f 1 3 2.5"), "line 5");
  check_refused(read, replaced(obj, "f 1 3 2", "f 1 3 -5"),
                "line 5: expected a vertex of face 1 among the 4 before it, found '-5'");
  check_refused(read, replaced(obj, "f 1 3 2", "f"), "line 5: expected a vertex of face 1, found 'the end of the line'");
  check_refused(read, replaced(obj, "f 1 3 2", "f1 3 2"), "line 5: expected v, f or another keyword of OBJ, found 'f1'");
  check_refused(read, replaced(obj, "f 1 3 2", "1 3 2"), "line 5: expected v, f or another keyword of OBJ, found '1'");
  check_refused(read, replaced(obj, "v 1 0 0", "v 1 0"), "line 2: expected a coordinate of vertex 2");
  check_refused(read, replaced(obj, "v 1 0 0", "v 1 X 0"), "line 2");
}

void test_ply()
{
  const Read read = [](const std::string& text) { return hde_remesh::read_ply(text); };
  check_read("PLY", read, ply);
  check_read("lines of Windows", read, replaced(ply, "\n", "\r\n"));
  check_read("unsigned short indices", read, binary_ply<std::uint8_t, std::uint16_t>("uchar ushort", true));
  check_read("short indices", read, binary_ply<std::uint8_t, std::uint16_t>("uint8 int16", false));
  check_read("char sizes", read, binary_ply<std::uint8_t, std::uint32_t>("char uint", false));
  check_read("int sizes, char indices", read, binary_ply<std::uint32_t, std::uint8_t>("int uchar", true));
  check_read("vertex_index", read, replaced(ply, "vertex_indices", "vertex_index"));
  check_read(
      "other elements and lists", read,
      replaced(replaced(ply, "element face 4", "element edge 1\nproperty list int int of\nproperty char is\nelement face 4"),
               off_faces, "2 7 8 1\n" + off_faces));
  check_read(
      "a list before the indices", read,
      replaced(replaced(ply, "property list", "property list uchar float texture\nproperty list"), "\n3 ", "\n2 .5 .5 3 "));
  CHECK((hde_remesh::read_ply_property(replaced(replaced(ply, "float z\n", "float z\nproperty int heat\n"), off_points,
                                                "0 0 0 5\n1 0 0 6\n0 1 0 7\n0 0 1.5 8\n"),
                                       "heat") == std::vector<double>{5, 6, 7, 8}));
  CHECK(hde_remesh::read_ply_property(ply, "heat").empty());
  check_refused(read, replaced(ply, "float z\n", "float z\nproperty float x\n"),
                "line 7: the element 'vertex' has two properties 'x'");
  check_refused(read, replaced(ply, "element face 4", "element vertex 4\nelement face 4"),
                "line 7: there are two elements 'vertex'");
  check_refused(read, replaced(ply, "1 0 0\n", "1 0\n"), "line 11: expected z of vertex 2 of 4, found 'the end of the line'");
  check_refused(read, replaced(ply, "1 0 0\n", "1 0 0 0\n"), "line 11: expected the end of the line before vertex 3 of 4");
  check_read("a stream of numbers", read, ply.substr(0, ply.find("0 0 0")) + replaced(off_points + off_faces, "\n", " "));
  check_refused(read, replaced(ply, "face 4", "face 3"),
                "line 17: expected the end of the file after the elements of the header");
  check_refused(read, replaced(ply, "face 4", "face 5"),
                "line 17: expected the size of vertex_indices of face 5 of 5, but the file ends");
  check_refused(read, replaced(ply, "vertex 4", "vertex 3"), "");
  check_refused(read, replaced(ply, "3 1 2 3", "3 1 2 4"), "face 3 of 4: expected the numbers of vertices below 4, found 4");
  check_refused(read, replaced(ply, "3 1 2 3", "3 1 2 -1"),
                "line 16: expected vertex_indices of face 3 of 4, the number of a vertex");
  check_refused(read, replaced(ply, "3 1 2 3", "-3 1 2 3"), "line 16: expected the size of vertex_indices of face 3 of 4");
  check_refused(read, replaced(ply, "0 0 1.5", "0 0 inf"),
                "line 13: 'inf' is not a finite number: expected z of vertex 4 of 4");
  check_refused(read, replaced(ply, "property float y\n", ""), "expected a property y of the vertices");
  check_refused(read, replaced(ply, "uchar int", "float int"), "the size of a list is no whole number");
  check_refused(read, replaced(ply, "format ascii 1.0\n", ""), "expected the line of the format");
  check_refused(read, replaced(ply, "ascii", "binary_middle_endian"), "line 2: expected the format");
  const std::string bytes = binary_ply<std::uint8_t, std::uint32_t>("uchar int", false);
  check_refused(read, bytes.substr(0, bytes.size() - 1), "vertex_indices of face 4 of 4, but the file ends");
  check_refused(read, bytes + "more", "expected the end of the file after the elements of the header");
}

void test_stl()
{
  const Read read = hde_remesh::read_stl;
  check_read("STL", read, stl());
  check_read("capitals", read, in_capitals(stl()));
  check_read("two words", read, replaced(replaced(stl(), "endsolid", "end solid"), "endfacet", "End Facet"));
  check_read("no endsolid", read, stl().substr(0, stl().find("endsolid")));
  CHECK(read(stl()).notes.empty());
  CHECK(read(stl().substr(0, stl().find("endsolid"))).notes.size() == 1);
  check_read("no name, no normal", read, replaced(replaced(stl(), "solid tetrahedron", "solid"), " normal 0 0 1", ""));
  check_read("a facet a line", read, replaced(replaced(stl(), "\n outer", " outer"), "loop\n", "loop "));
  std::string with_minus_zero = stl();
  with_minus_zero.insert(with_minus_zero.rfind("0.000000 0.000000 1.500000"), "-");
  check_read("-0 and 0 are one", read, with_minus_zero);
  check_read("binary", read, binary_stl());
  check_read("binary that begins with solid", read, binary_stl("solid facet vertex"));
  check_read("a byte behind the last facet", read, binary_stl() + "\n");
  check_read("several solids", read, replaced(stl(), "endfacet\nfacet", "endfacet\nendsolid\nsolid\nfacet"));
  check_refused(read, stl().substr(0, stl().size() - 40), "expected");
  check_refused(read, replaced(stl(), "vertex 1.000000 0.000000 0.000000", "vertex 1.000000 0.000000"),
                "expected a number, a coordinate of face 1");
  check_refused(read, replaced(stl(), " endloop", "  vertex 9 9 9\n endloop"), "line 7: expected endloop, found 'vertex'");
  check_refused(read, replaced(stl(), "endfacet", ""), "line 9: expected endfacet, found 'facet'");
  check_refused(read, replaced(stl(), "outer loop", "loop"), "line 3: expected outer loop");
  check_refused(read, replaced(stl(), "1.500000", "nan"), "is not a finite number");
  std::string bytes = binary_stl();
  check_refused(read, bytes.substr(0, 70), "byte 70: expected 'solid', or a header of 80 bytes");
  check_refused(read, bytes.substr(0, bytes.size() - 1), "byte 80: expected the number of facets that follow, 3, found 4");
  bytes[80] = 3;
  check_refused(read, bytes, "byte 80: expected the number of facets that follow, 4, found 3");
}

// Each line of a text counts: without it, or with it twice, the file is refused.
void test_each_line(const Read& read, const std::string& text, const std::size_t first_line)
{
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    lines.push_back(text.substr(begin, text.find('\n', begin) + 1 - begin));
  for (std::size_t i = first_line; i < lines.size(); ++i)
    for (const std::size_t times : {0, 2})
    {
      std::string other;
      for (std::size_t k = 0; k < lines.size(); ++k)
        for (std::size_t t = 0; t < (k == i ? times : 1); ++t)
          other += lines[k];
      CHECK(!refusal(read, other).empty());
    }
}

// CGAL's meshes as CGAL reads them
void test_meshes_of_cgal()
{
  const std::filesystem::path folder = std::filesystem::path(CGAL::data_file_path("meshes/elephant.off")).parent_path();
  std::size_t number = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const std::string extension = entry.path().extension().string();
    if (entry.file_size() > 1000000 || (extension != ".off" && extension != ".stl" && extension != ".ply"))
      continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    std::istringstream again(text.str());
    Soup soup, of_cgal;
    bool is_read = false;
    const auto np = CGAL::parameters::verbose(false);
    if (extension == ".off")
      is_read = CGAL::IO::read_OFF(again, of_cgal.points, of_cgal.faces, np);
    else if (extension == ".stl")
      is_read = CGAL::IO::read_STL(again, of_cgal.points, of_cgal.faces, np);
    else
      is_read = CGAL::IO::read_PLY(again, of_cgal.points, of_cgal.faces, np);
    const Read read = extension == ".off"   ? Read(hde_remesh::read_off)
                      : extension == ".stl" ? Read(hde_remesh::read_stl)
                                            : Read([](const std::string& bytes) { return hde_remesh::read_ply(bytes); });
    if (!is_read || of_cgal.faces.empty() || !refusal(read, text.str()).empty())
      continue; // some are broken: prim.off has more faces than it says
    soup = read(text.str());
    CHECK(soup.points == of_cgal.points && soup.faces == of_cgal.faces);
    ++number;
  }
  std::cout << number << " meshes of CGAL" << std::endl;
  CHECK(number > 80);
}

const std::vector<hde_remesh::Vector_3> normals(4, hde_remesh::Vector_3(0, 0, .5));

// four points without faces, with the normals above or none, and as many further numbers
void check_points(const std::string& name, const Read& read, const std::string& text, const bool has_normals,
                  const std::size_t number_of_arrays = 0)
{
  std::string message = name;
  try
  {
    const Soup soup = read(text);
    CHECK(soup.is_of_points());
    CHECK(soup.points == points);
    CHECK(soup.normals == (has_normals ? normals : std::vector<hde_remesh::Vector_3>()));
    CHECK(soup.vertex_arrays.size() == number_of_arrays);
    for (const hde_remesh::Array& array : soup.vertex_arrays)
      CHECK(array.values == std::vector<double>({7, 8, 7, 8}) && array.are_bytes == (array.name == "red"));
    return;
  }
  catch (const hde_remesh::Unreadable& error)
  {
    message += std::string(": ") + error.what();
  }
  std::cout << message << std::endl;
  CHECK(false);
}

// the points with something behind each: the same, or 7 and 8 by turns, too
std::string points_with(const std::string& text, const bool has_numbers = false)
{
  std::istringstream lines(off_points);
  std::string result;
  int i = 0;
  for (std::string line; std::getline(lines, line); ++i)
    result += line + text + (has_numbers ? (i % 2 == 0 ? " 7" : " 8") : "") + "\n";
  return result;
}

void test_points()
{
  using namespace hde_remesh;
  const Read read_ply_points = [](const std::string& text) { return read_ply(text); };
  check_points("XYZ", read_xyz, off_points, false);
  check_points("normals in XYZ", read_xyz, "# with normals\n" + points_with(" 0 0 .5"), true);
  check_points("the number of points in XYZ", read_xyz, "4\n" + points_with(" 0 0 .5"), true);
  check_points("a fourth column in XYZ", read_xyz, points_with("", true), false, 1);
  check_points("a seventh column in XYZ", read_xyz, points_with(" 0 0 .5", true), true, 1);
  check_points("OFF", read_off, "OFF\n4 0 0\n" + off_points, false);
  check_points("normals in OFF", read_off, "NOFF\n4 0 0\n" + points_with(" 0 0 .5"), true);
  check_points("normals in OFF as a stream", read_off, "NOFF 4 0 0 " + replaced(points_with(" 0 0 .5"), "\n", " "), true);
  check_points("OBJ", read_obj, obj.substr(0, obj.find('f')), false);
  check_points("normals in OBJ", read_obj, replaced(obj.substr(0, obj.find('f')), "v ", "vn 0 0 .5\nv "), true);
  const std::string xyz = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n",
                    n = "property float nx\nproperty float ny\nproperty float nz\n", end = "end_header\n";
  check_points("PLY", read_ply_points, xyz + end + off_points, false);
  check_points("PLY with no faces", read_ply_points, xyz + "element face 0\n" + end + off_points, false);
  check_points("normals in PLY", read_ply_points, xyz + n + end + points_with(" 0 0 .5"), true);
  check_points("numbers in PLY", read_ply_points, xyz + n + "property uchar red\n" + end + points_with(" 0 0 .5", true), true,
               1);
  check_points("other numbers in PLY", read_ply_points, xyz + "property int label\n" + end + points_with("", true), false, 1);
  const Soup colours = read_xyz(points_with(" 200 0 30"));
  CHECK(colours.normals.empty() && colours.vertex_arrays.size() == 3);
  CHECK(colours.vertex_arrays.front().name == "red" && colours.vertex_arrays.front().are_bytes);
  CHECK(colours.vertex_arrays.back().values == std::vector<double>(4, 30));
  CHECK(read_ply(ply).normals.empty() && !read_ply(ply).is_of_points());
  check_refused(read_xyz, "", "expected the coordinates of a point, but the file ends");
  check_refused(read_xyz, "0 0 0\n1 0\n", "line 2: expected 3 numbers, as before, found 2");
  check_refused(read_xyz, "0 0\n", "line 1: expected three coordinates, found 2");
  check_refused(read_xyz, "0 0 0\n1 inf 0\n", "line 2: 'inf' is not a finite number");
  check_refused(read_xyz, "5\n" + off_points, "expected 5 points, as the first line has it");
  check_refused(read_xyz, "-5\n" + off_points, "line 1: expected the number of points");
  check_refused(read_off, "NOFF\n4 0 0\n" + off_points, "line 3: expected a normal of vertex 1 of 4 in the same line");
  check_refused(read_ply_points, xyz + n + end + off_points, "line 11: expected nx of vertex 1 of 4");
  check_refused(read_ply_points,
                xyz + "element tristrips 1\nproperty list int int vertex_indices\n" + end + off_points + "1 0\n",
                "expected an element face in the place of tristrips");
}

} // namespace

int main()
{
  test_points();
  test_dialects_of_off();
  test_counts_and_indices_of_off();
  test_obj();
  test_ply();
  test_stl();
  test_each_line(hde_remesh::read_off, off, 1);
  test_each_line([](const std::string& text) { return hde_remesh::read_ply(text); }, ply, 9);
  test_meshes_of_cgal();
  return check_summary();
}
