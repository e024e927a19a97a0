// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The mathematics of Rbf_implicit_function: interpolation, accuracy on a known surface, continuity, sign, with all kernels.

#include "check.h"
#include "shapes.h"

#include <CGAL/Random.h>
#include <CGAL/Rbf_implicit_function.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace shapes;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Thin_plate_rbf, CGAL::Parallel_if_available_tag> Thin_plate_function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Wendland_C2_rbf, CGAL::Parallel_if_available_tag> Wendland_function;

const Ellipsoid_function exact;
const double diagonal = 2 * std::sqrt(30.); // of the box of the ellipsoid

Point_3 on_ellipsoid(const Point_3& p) { return Point_3(exact.a * p.x(), exact.b * p.y(), exact.c * p.z()); }

Vector_3 unit_normal(const Point_3& p)
{
  const Vector_3 gradient = exact.gradient(p);
  return gradient / std::sqrt(gradient.squared_length());
}

// the mean length of the edges of a vertex
double spacing_of(const Mesh& mesh, const Mesh::Vertex_index v)
{
  double sum = 0;
  for (const Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
    sum += std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(mesh.source(h))));
  return sum / double(mesh.degree(v));
}

// a mesh with the exact normals of the ellipsoid
struct Ellipsoid_with_normals
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Vector_3> normals;

  explicit Ellipsoid_with_normals(const unsigned int level) : mesh(ellipsoid(level))
  {
    normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:exact_normal").first;
    for (const Mesh::Vertex_index v : mesh.vertices())
      normals[v] = unit_normal(mesh.point(v));
  }
};

// The distance of the zero set to the ellipsoid, to first order, as it is small: rms over the area of the ellipsoid, over
// the diagonal. The area of the ellipsoid over that of the unit sphere is 10 |(x, y / 2, z / 5)| at (x, y, z) of the sphere.
template <typename F>
double rms_distance(const F& f)
{
  double sum = 0, weights = 0;
  for (const Point_3& q : spiral_points(20000))
  {
    const double weight = std::sqrt(q.x() * q.x() + q.y() * q.y() / 4 + q.z() * q.z() / 25);
    const auto at_p = f.value_and_gradient(on_ellipsoid(q));
    sum += weight * at_p.first * at_p.first / at_p.second.squared_length();
    weights += weight;
  }
  return std::sqrt(sum / weights) / diagonal;
}

// random points within `distance` of the ellipsoid
std::vector<Point_3> points_near_the_surface(const std::size_t n, const double distance)
{
  CGAL::Random random(7);
  std::vector<Point_3> result;
  for (const Point_3& q : spiral_points(n))
  {
    const Point_3 p = on_ellipsoid(q);
    result.push_back(p + random.get_double(-distance, distance) * unit_normal(p));
  }
  return result;
}

// negative inside and positive outside, far away too
template <typename F>
std::size_t number_of_wrong_signs(const F& f)
{
  std::size_t wrong = 0;
  for (const double factor : {0., 0.25, 0.5, 0.9, 0.99, 0.999, 1.001, 1.01, 1.1, 1.5, 2., 4., 1e3, 1e6})
    for (const Point_3& q : spiral_points(2000))
      wrong += (f(CGAL::ORIGIN + factor * (on_ellipsoid(q) - CGAL::ORIGIN)) < 0) == (factor < 1) ? 0 : 1;
  return wrong;
}

// the order of r^3 is 3 at least
void test_accuracy()
{
  const double bounds[3] = {4.5e-5, 3.5e-6, 5e-7};
  double last = 0;
  for (const unsigned int level : {3u, 4u, 5u})
  {
    const double error = rms_distance(Function(ellipsoid(level)));
    std::cout << "r^3, level " << level << ": rms/D " << error << ", order " << std::log2(last / error) << std::endl;
    CHECK(error <= bounds[level - 3]);
    CHECK(level == 3 || std::log2(last / error) >= 3);
    last = error;
  }

  const double thin_plate_3 = rms_distance(Thin_plate_function(ellipsoid(3))),
               thin_plate_4 = rms_distance(Thin_plate_function(ellipsoid(4)));
  std::cout << "thin plate: rms/D " << thin_plate_3 << " " << thin_plate_4 << std::endl;
  CHECK(thin_plate_3 < 4e-4);
  CHECK(std::log2(thin_plate_3 / thin_plate_4) >= 2);
}

// the largest |f - eps| at the points at the distance eps = offset(vertex) of the vertices along their normals
template <typename F, typename Offset>
double largest_residual(const F& f, const Ellipsoid_with_normals& input, const Offset& offset)
{
  double result = 0;
  for (const Mesh::Vertex_index v : input.mesh.vertices())
    result = (std::max)(result, std::abs(f(input.mesh.point(v) + offset(v) * input.normals[v]) - offset(v)));
  return result;
}

template <typename F>
double largest_residual_on_surface(const F& f, const Ellipsoid_with_normals& input)
{
  return largest_residual(f, input, [](const Mesh::Vertex_index) { return 0.; });
}

// With the default shape and the default offsets, on one side and on both. The condition of the Gaussian's systems is 1e13
// with off-surface points on both sides: sums of large terms of either sign leave a little more.
template <typename Radial_function>
void test_interpolation(const double two_sided_tolerance = 1e-10)
{
  typedef CGAL::Rbf_implicit_function<Kernel, Radial_function, CGAL::Parallel_if_available_tag> F;
  const Ellipsoid_with_normals input(4);
  std::cout << Radial_function::name() << ": residuals/D";
  for (const bool is_two_sided : {false, true})
  {
    const double tolerance = (is_two_sided ? two_sided_tolerance : 1e-10) * diagonal;
    const F f(input.mesh, params::vertex_normal_map(input.normals).two_sided_offsets(is_two_sided).points_on_facets(false));
    CHECK(f.diagnostics().number_of_points == 2562);
    CHECK(f.diagnostics().number_of_shortened_offsets == 0);
    CHECK(f.diagnostics().patches_on_fallback == 0);
    CHECK(f.diagnostics().number_of_failed_checks == 0);
    for (const double relative_offset : {0., 0.05, -0.05})
    {
      if (relative_offset < 0 && !is_two_sided)
        continue;
      const double residual =
          largest_residual(f, input, [&](const Mesh::Vertex_index v) { return relative_offset * spacing_of(input.mesh, v); });
      std::cout << " " << residual / diagonal;
      CHECK(residual <= tolerance);
    }
    const double error = rms_distance(f);
    std::cout << " (told " << f.diagnostics().worst_value_residual / diagonal << "), rms/D " << error << "; ";
    CHECK(f.diagnostics().worst_value_residual <= tolerance);
    CHECK(error <= 1e-3);
  }
  std::cout << std::endl;
}

// A solution of the saddle point system of the books, s = sum alpha_j phi(r_j) + a polynomial. It knows neither the scaling of
// the patches nor the null space method.
template <typename Phi>
class Reference_interpolant
{
public:
  // `normal` is zero for linear polynomials; otherwise the squares along the plane orthogonal to it are there, too
  Reference_interpolant(const std::vector<Eigen::Vector3d>& centres, const Eigen::VectorXd& data, const Phi& phi,
                        const Eigen::Vector3d& normal)
    : m_centres(centres),
      m_phi(phi),
      m_u(normal.unitOrthogonal()),
      m_v(normal.cross(m_u)),
      m_number_of_polynomials(normal.isZero() ? 4 : 7)
  {
    const Eigen::Index n = Eigen::Index(centres.size()), q = m_number_of_polynomials;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + q, n + q);
    for (Eigen::Index i = 0; i < n; ++i)
    {
      const Eigen::VectorXd row = terms(centres[std::size_t(i)]);
      matrix.row(i) = row;
      matrix.col(i).tail(q) = row.tail(q);
    }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + q);
    right.head(n) = data;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix);
    m_coefficients = lu.solve(right);
    m_coefficients += lu.solve(right - matrix * m_coefficients);
  }

  double operator()(const Point_3& p) const { return terms({p.x(), p.y(), p.z()}).dot(m_coefficients); }

private:
  Eigen::VectorXd terms(const Eigen::Vector3d& x) const
  {
    const Eigen::Index n = Eigen::Index(m_centres.size());
    Eigen::VectorXd result(n + m_number_of_polynomials);
    for (Eigen::Index j = 0; j < n; ++j)
      result[j] = m_phi((x - m_centres[std::size_t(j)]).norm());
    result[n] = 1;
    result.segment<3>(n + 1) = x;
    if (m_number_of_polynomials == 7)
      result.tail<3>() << m_u.dot(x) * m_u.dot(x), m_u.dot(x) * m_v.dot(x), m_v.dot(x) * m_v.dot(x);
    return result;
  }

  std::vector<Eigen::Vector3d> m_centres;
  Phi m_phi;
  Eigen::Vector3d m_u, m_v;
  Eigen::Index m_number_of_polynomials;
  Eigen::VectorXd m_coefficients;
};

// the vertices, then the off-surface points
template <typename Phi, typename NormalMap>
Reference_interpolant<Phi> reference_interpolant(const Mesh& mesh, const NormalMap& normals, const double offset,
                                                 const Phi& phi, const Eigen::Vector3d& normal)
{
  std::vector<Eigen::Vector3d> centres;
  std::vector<double> data;
  for (const double distance : {0., offset})
    for (const Mesh::Vertex_index v : mesh.vertices())
    {
      const Point_3 p = mesh.point(v) + distance * normals[v];
      centres.emplace_back(p.x(), p.y(), p.z());
      data.push_back(distance);
    }
  return Reference_interpolant<Phi>(centres, Eigen::Map<Eigen::VectorXd>(data.data(), Eigen::Index(data.size())), phi, normal);
}

template <typename F, typename G>
double largest_difference(const F& f, const G& g, const std::vector<Point_3>& points)
{
  double result = 0;
  for (const Point_3& p : points)
    result = (std::max)(result, std::abs(f(p) - g(p)));
  return result;
}

// The normals of the ellipsoid cancel: only linear polynomials.
template <typename F, typename Phi>
void test_one_patch_of_ellipsoid(const Phi& phi, const double offset)
{
  const Ellipsoid_with_normals input(2);
  const F f(input.mesh,
            params::number_of_patches(1).offset_distance(offset).vertex_normal_map(input.normals).points_on_facets(false));
  CHECK(f.diagnostics().number_of_patches == 1);
  CHECK(f.diagnostics().max_centres == 2 * input.mesh.number_of_vertices());
  const auto reference = reference_interpolant(input.mesh, input.normals, offset, phi, Eigen::Vector3d::Zero());
  const double difference = largest_difference(f, reference, points_near_the_surface(500, 0.5));
  std::cout << "one patch of the ellipsoid against the dense solution: " << difference << std::endl;
  CHECK(difference <= 1e-8);
}

// Those of hills have a mean: the squares along the plane orthogonal to it.
template <typename F, typename Phi>
void test_one_patch_of_hills(const Phi& phi)
{
  const Hills_function exact_hills;
  Mesh mesh = hills(12);
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:exact_normal").first;
  Vector_3 sum(0, 0, 0);
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Vector_3 gradient = exact_hills.gradient(mesh.point(v));
    normals[v] = gradient / std::sqrt(gradient.squared_length());
    sum += normals[v];
  }
  const double offset = 0.01;
  const F f(mesh, params::number_of_patches(1).offset_distance(offset).vertex_normal_map(normals).close_holes(false));
  CHECK(f.diagnostics().max_centres == 2 * mesh.number_of_vertices());
  const Eigen::Vector3d mean = Eigen::Vector3d(sum.x(), sum.y(), sum.z()).normalized();
  const auto reference = reference_interpolant(mesh, normals, offset, phi, mean),
             linear_reference = reference_interpolant(mesh, normals, offset, phi, Eigen::Vector3d::Zero());
  std::vector<Point_3> points;
  for (double x = -0.1; x < 2.1; x += 0.09)
    for (double y = -0.1; y < 2.1; y += 0.09)
      for (const double z : {-0.1, 0., 0.05})
        points.emplace_back(x, y, Hills_function::height(x, y) + z);
  const double difference = largest_difference(f, reference, points);
  std::cout << "one patch of hills against the dense solution: " << difference << std::endl;
  CHECK(difference <= 1e-8);
  CHECK(largest_difference(f, linear_reference, points) > 1e-5);
}

// the angle between the gradient and the normal of the ellipsoid, rms, in degrees
double rms_angle(const Function& f)
{
  double sum = 0;
  const std::size_t n = 5000;
  for (const Point_3& q : spiral_points(n))
  {
    const Vector_3 gradient = f.gradient(on_ellipsoid(q)), normal = unit_normal(on_ellipsoid(q));
    const double sine = std::sqrt(CGAL::cross_product(gradient, normal).squared_length());
    sum += std::pow(std::atan2(sine, gradient * normal), 2);
  }
  return std::sqrt(sum / double(n)) * 180 / pi;
}

// the ellipsoid with its normals off by `angle` and its points moved by at most `distance` along them
Ellipsoid_with_normals noisy_ellipsoid(const double angle, const double distance)
{
  Ellipsoid_with_normals result(4);
  CGAL::Random random(13);
  for (const Mesh::Vertex_index v : result.mesh.vertices())
  {
    const Vector_3 normal = result.normals[v],
                   noise(random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1)),
                   tangential = noise - (noise * normal) * normal;
    result.normals[v] = normal + std::tan(angle) / std::sqrt(tangential.squared_length()) * tangential;
    result.mesh.point(v) = result.mesh.point(v) + distance * random.get_double(-1, 1) * normal;
  }
  return result;
}

// Smoothing makes the function miss the data and tells by how much. It helps against noise in points, and in normals, too.
void test_smoothing()
{
  const auto check_residual = [](const Function& f, const Ellipsoid_with_normals& input, const bool is_smooth)
  {
    const double residual = largest_residual_on_surface(f, input), told = f.diagnostics().worst_value_residual;
    std::cout << "smoothing: |f(x_i)|/D " << residual / diagonal << ", told " << told / diagonal << ", rms/D "
              << rms_distance(f) << ", angle " << rms_angle(f) << std::endl;
    // a blend of patches misses a datum by no more than the worst of them
    CHECK(residual <= told + 1e-11 * diagonal);
    CHECK(is_smooth ? residual > 0.01 * told : told <= 1e-10 * diagonal);
    CHECK(!is_smooth || told > 1e-6 * diagonal);
  };
  {
    const Ellipsoid_with_normals input = noisy_ellipsoid(10 * pi / 180, 0);
    const auto np = params::vertex_normal_map(input.normals).two_sided_offsets(true);
    const Function rough(input.mesh, np), smooth(input.mesh, np.smoothing(0.001));
    check_residual(rough, input, false);
    check_residual(smooth, input, true);
    CHECK(rms_distance(smooth) < 0.7 * rms_distance(rough));
    CHECK(rms_angle(smooth) < 0.5 * rms_angle(rough));
  }
  const Ellipsoid_with_normals input = noisy_ellipsoid(0, 0.01);
  const auto np = params::vertex_normal_map(input.normals);
  const Function rough(input.mesh, np), smooth(input.mesh, np.smoothing(0.01 / std::sqrt(3.)));
  check_residual(rough, input, false);
  check_residual(smooth, input, true);
  CHECK(rms_distance(smooth) < 0.6 * rms_distance(rough));
  CHECK(rms_angle(smooth) < 0.4 * rms_angle(rough));
}

// With one patch the worst residual is the one that is seen.
void test_residual_of_one_patch()
{
  const Ellipsoid_with_normals input(2);
  const double offset = 0.05;
  const Function f(input.mesh,
                   params::number_of_patches(1).offset_distance(offset).smoothing(0.02).vertex_normal_map(input.normals));
  const double residual = (std::max)(largest_residual_on_surface(f, input),
                                     largest_residual(f, input, [&](const Mesh::Vertex_index) { return offset; }));
  CHECK(residual > 1e-4);
  CHECK_CLOSE(residual, f.diagnostics().worst_value_residual, 1e-6 * residual);
}

// Sparse Cholesky must find what the dense saddle point system gives.
void test_compact_support()
{
  const double support = 0.75;
  const auto phi = [support](const double r)
  {
    const double t = (std::min)(r / support, 1.);
    return std::pow(1 - t, 4) * (4 * t + 1);
  };
  const CGAL::Wendland_C2_rbf kernel(support, CGAL::Rbf_length_unit::COORDINATES);
  const auto np = params::number_of_patches(1).radial_function(kernel).points_on_facets(false);
  {
    const Ellipsoid_with_normals input(3);
    const double offset = 0.02;
    const Wendland_function f(input.mesh, np.offset_distance(offset).vertex_normal_map(input.normals));
    CHECK(f.diagnostics().patches_with_sparse_cholesky == 1);
    CHECK(f.diagnostics().patches_on_fallback == 0);
    const auto reference = reference_interpolant(input.mesh, input.normals, offset, phi, Eigen::Vector3d::Zero());
    // near the centres, as between coarse ones the function is the distance
    CGAL::Random random(19);
    std::vector<Point_3> points;
    for (const Mesh::Vertex_index v : input.mesh.vertices())
      points.push_back(input.mesh.point(v) +
                       Vector_3(random.get_double(-0.1, 0.1), random.get_double(-0.1, 0.1), random.get_double(-0.1, 0.1)));
    const double difference = largest_difference(f, reference, points);
    std::cout << "sparse against dense solution: " << difference << std::endl;
    CHECK(difference <= 1e-10);
  }
  const Ellipsoid_with_normals input(4);
  const Wendland_function f(input.mesh, np.vertex_normal_map(input.normals));
  CHECK(f.diagnostics().patches_with_sparse_cholesky == 1);
  CHECK(largest_residual_on_surface(f, input) <= 1e-10 * diagonal);
  CHECK(number_of_wrong_signs(f) == 0);
}

// a shape parameter in coordinates is the same one in spacings, where there is one spacing: that of the only patch, the median
void test_units_of_shape_parameter()
{
  const Ellipsoid_with_normals input(2);
  std::vector<double> spacings;
  for (const Mesh::Vertex_index v : input.mesh.vertices())
    spacings.push_back(spacing_of(input.mesh, v));
  std::sort(spacings.begin(), spacings.end());
  const double spacing = spacings[spacings.size() / 2];
  for (const double scale : {1., 1000.})
  {
    Mesh mesh = input.mesh;
    for (const Mesh::Vertex_index v : mesh.vertices())
      mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    const auto function = [&](const double length, const CGAL::Rbf_length_unit unit)
    {
      const CGAL::Wendland_C2_rbf kernel(length, unit);
      return Wendland_function(mesh, params::number_of_patches(1).radial_function(kernel).points_on_facets(false));
    };
    const Wendland_function relative = function(7, CGAL::Rbf_length_unit::LOCAL_SPACING),
                            absolute = function(7 * scale * spacing, CGAL::Rbf_length_unit::COORDINATES),
                            other = function(7 * spacing, CGAL::Rbf_length_unit::LOCAL_SPACING);
    std::vector<Point_3> points;
    for (const Point_3& p : points_near_the_surface(300, 0.1))
      points.push_back(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN));
    CHECK(largest_difference(relative, absolute, points) <= 1e-9 * scale);
    CHECK(largest_difference(relative, other, points) > 1e-4 * scale);
  }
}

// A kernel of the caller that models no more than the concept asks for: no shape parameter, no second derivatives.
struct Biharmonic_rbf
{
  static constexpr unsigned int order = 1;
  static constexpr double sign = -1;

  static const char* name() { return "biharmonic spline r"; }

  template <class T>
  CGAL::Rbf_jet<T, 1> operator()(const T& squared_radius) const
  {
    using std::sqrt;
    const T r = sqrt(T(squared_radius + 1e-300));
    return {r, 1. / r};
  }
};

// Along a line through all patches, a value or a gradient that jumps breaks the bounds that a Lipschitz continuous gradient
// sets to the steps. The neighbours of a patch differ from it by some 1e-4, a hundred times what the bounds let through.
void test_continuity()
{
  const Function f(ellipsoid(3), params::number_of_patches(60));
  // largest curvature of the ellipsoid: 5, at its tips; the blending adds a little
  const double lipschitz = 4 * 5;
  const std::size_t steps = 200000;
  double largest_value = 0, largest_gradient = 0;
  Point_3 last;
  std::pair<double, Vector_3> at_last;
  for (std::size_t i = 0; i <= steps; ++i)
  {
    const double u = 2 * pi * double(i) / double(steps), v = 0.3 + 2 * u; // winds about the ellipsoid
    const Point_3 p = on_ellipsoid(Point_3(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)));
    const auto at_p = f.value_and_gradient(p);
    if (i > 0)
    {
      const Vector_3 step = p - last;
      const double length = std::sqrt(step.squared_length());
      const double trapezium = 0.5 * ((at_p.second + at_last.second) * step);
      largest_value = (std::max)(largest_value, std::abs(at_p.first - at_last.first - trapezium) / (length * length));
      largest_gradient = (std::max)(largest_gradient, std::sqrt((at_p.second - at_last.second).squared_length()) / length);
    }
    last = p;
    at_last = at_p;
  }
  std::cout << "continuity: " << largest_value << " " << largest_gradient << std::endl;
  CHECK(largest_value <= lipschitz / 2);
  CHECK(largest_gradient <= lipschitz);
}

void test_sign()
{
  const Function f(ellipsoid(4));
  const Kernel::Sphere_3 sphere = f.bounding_sphere();
  CHECK(number_of_wrong_signs(f) == 0);
  double least_cosine = 1, least_length = 1, largest_length = 1;
  std::size_t outside_sphere = 0;
  for (const Point_3& q : spiral_points(2000))
  {
    const Point_3 p = on_ellipsoid(q);
    const Vector_3 gradient = f.gradient(p);
    const double length = std::sqrt(gradient.squared_length());
    least_cosine = (std::min)(least_cosine, gradient * unit_normal(p) / length);
    least_length = (std::min)(least_length, length);
    largest_length = (std::max)(largest_length, length);
    outside_sphere += sphere.has_on_bounded_side(p) ? 0 : 1;
  }
  std::cout << "gradients: " << least_cosine << " " << least_length << " " << largest_length << std::endl;
  CHECK(least_cosine > 0.999);
  CHECK(least_length > 0.9);
  CHECK(largest_length < 1.1);
  CHECK(outside_sphere == 0);
}

template <typename F>
std::vector<double> values_of(const F& f, const std::vector<Point_3>& points)
{
  std::vector<double> values;
  for (const Point_3& p : points)
  {
    const auto at_p = f.value_and_gradient(p);
    values.insert(values.end(), {at_p.first, at_p.second.x(), at_p.second.y(), at_p.second.z()});
  }
  return values;
}

void test_copies()
{
  const Mesh mesh = ellipsoid(2);
  const std::vector<Point_3> points = points_near_the_surface(50, 0.1);
  std::vector<Function> copies;
  std::vector<double> expected;
  {
    const Function f(mesh);
    expected = values_of(f, points);
    copies.assign(10, f);
    // they share the data, hence are as cheap as their size
    CHECK(&copies[3].diagnostics() == &f.diagnostics());
    static_assert(sizeof(Function) <= 128, "a copy must not hold the data itself");
  }
  // and keep them alive
  for (const Function& copy : copies)
    CHECK(values_of(copy, points) == expected);
}

// The cells of the patches are convex, none is empty, and none holds many more points than its share: a cell whose overlap
// makes it too large is divided further, hence there may be more patches than asked, and smaller ones.
void test_patches()
{
  const Mesh mesh = ellipsoid(4);
  const std::size_t asked = 60;
  const Function f(mesh, params::number_of_patches(asked));
  const std::size_t n = f.diagnostics().number_of_patches;
  CHECK(n >= asked && n < 2 * asked);
  std::vector<std::vector<Point_3>> points(n);
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const std::size_t patch = f.patch(mesh.point(v));
    CHECK(patch < n);
    points[patch].push_back(mesh.point(v));
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    CHECK(!points[k].empty() && 4 * points[k].size() * asked < 5 * mesh.number_of_vertices());
    if (points[k].empty())
      continue;
    for (const Point_3& p : points[k])
      CHECK(f.patch(CGAL::midpoint(p, points[k].front())) == k);
  }
  CHECK_THROWS(f.patch(Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0)), std::invalid_argument);
}

// Far from the surface the function is the signed distance to the facets.
void test_far()
{
  const Mesh mesh = icosphere(4); // its edges are 0.08 long
  std::vector<Kernel::Triangle_3> triangles;
  for (const Mesh::Face_index face : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(face);
    triangles.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
  }
  const Function f(mesh);
  double difference = 0, length = 0;
  for (const double factor : {0.1, 0.5, 1.5, 2., 1e4})
    for (const Point_3& q : spiral_points(40))
    {
      const Point_3 p = CGAL::ORIGIN + factor * (q - CGAL::ORIGIN);
      double squared_distance = std::numeric_limits<double>::infinity();
      for (const Kernel::Triangle_3& triangle : triangles)
        squared_distance = (std::min)(squared_distance, CGAL::squared_distance(p, triangle));
      const double distance = std::sqrt(squared_distance) * (factor < 1 ? -1 : 1);
      difference = (std::max)(difference, std::abs(f(p) / distance - 1));
      length = (std::max)(length, std::abs(std::sqrt(f.gradient(p).squared_length()) - 1));
    }
  std::cout << "far: difference to the distance " << difference << ", gradient " << length << std::endl;
  CHECK(difference <= 1e-12);
  CHECK(length <= 1e-12);
  // so far that squares overflow, too: there all facets are as near as the centre
  for (const double distance : {1e12, 1e30, 1e160, 1e300})
    for (const Point_3& q : spiral_points(40))
    {
      const Kernel::Vector_3 direction = (q - CGAL::ORIGIN) / std::sqrt((q - CGAL::ORIGIN).squared_length());
      const Point_3 p = CGAL::ORIGIN + distance * direction;
      CHECK(std::abs(f(p) / distance - 1) <= 1e-12);
      CHECK(f.gradient(p) * direction >= 1 - 1e-12);
    }
  const double no_number = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS(f(Point_3(0, no_number, 0)), std::invalid_argument);
  CHECK_THROWS(f.gradient(Point_3(0, 0, infinity)), std::invalid_argument);
  // near, it is none
  CHECK(std::abs(f(CGAL::centroid(triangles[0]))) > 1e-4);
}

int main()
{
  test_accuracy();
  test_interpolation<CGAL::Polyharmonic_rbf>();
  test_interpolation<CGAL::Thin_plate_rbf>();
  test_interpolation<CGAL::Gaussian_rbf>(5e-10);
  test_interpolation<CGAL::Multiquadric_rbf>();
  test_interpolation<CGAL::Inverse_multiquadric_rbf>();
  test_interpolation<CGAL::Wendland_C2_rbf>();
  test_interpolation<CGAL::Wendland_C4_rbf>();
  test_interpolation<CGAL::Wendland_C6_rbf>();
  test_interpolation<Biharmonic_rbf>();
  const auto cube = [](const double r) { return r * r * r; };
  const auto thin_plate = [](const double r) { return r > 0 ? r * r * std::log(r) : 0.; };
  for (const double offset : {0.05, 0.02})
  {
    test_one_patch_of_ellipsoid<Function>(cube, offset);
    test_one_patch_of_ellipsoid<Thin_plate_function>(thin_plate, offset);
  }
  test_one_patch_of_hills<Function>(cube);
  test_one_patch_of_hills<Thin_plate_function>(thin_plate);
  test_smoothing();
  test_residual_of_one_patch();
  test_compact_support();
  test_units_of_shape_parameter();
  test_continuity();
  test_sign();
  test_far();
  test_copies();
  test_patches();
  return check_summary();
}
