#ifndef HDE_REMESH_FUNCTION_VIEW_H
#define HDE_REMESH_FUNCTION_VIEW_H

#include "Soup.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace hde_remesh {

// A smooth function, or one of several smooth pieces, of any type. Or none at all, where only the number of pieces is needed.
class Function_view
{
public:
  class Piece
  {
  public:
    typedef Kernel::FT FT;
    typedef Kernel::Point_3 Point;
    typedef Kernel::Point_3 Point_3;
    typedef Kernel::Vector_3 Vector_3;
    typedef std::function<std::pair<FT, Vector_3>(const Point_3&)> Evaluate;

    explicit Piece(Evaluate evaluate) : m_evaluate(std::move(evaluate)) {}

    FT operator()(const Point_3& p) const { return m_evaluate(p).first; }
    Vector_3 gradient(const Point_3& p) const { return m_evaluate(p).second; }
    std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const { return m_evaluate(p); }

  private:
    Evaluate m_evaluate;
  };

  Function_view() = default;

  // keeps a copy, which is cheap for the functions of the package
  template <typename Function>
  static Function_view of(const Function& function)
  {
    Function_view view;
    view.m_pieces.emplace_back([function](const Point_3& p) { return function.value_and_gradient(p); });
    return view;
  }

  template <typename Function>
  static Function_view of_pieces(const Function& function)
  {
    Function_view view;
    for (std::size_t i = 0; i < function.number_of_pieces(); ++i)
      view.m_pieces.emplace_back([function, i](const Point_3& p) { return function.piece(i).value_and_gradient(p); });
    return view;
  }

  // pieces that no one may evaluate
  static Function_view without_values(const std::size_t number_of_pieces)
  {
    Function_view view;
    view.m_has_values = false;
    view.m_pieces.assign(number_of_pieces, Piece(nullptr));
    return view;
  }

  bool has_values() const { return m_has_values; }
  std::size_t number_of_pieces() const { return m_pieces.size(); }
  const Piece& piece(const std::size_t i) const { return m_pieces[i]; }

private:
  std::vector<Piece> m_pieces;
  bool m_has_values = true;
};

} // namespace hde_remesh

#endif // HDE_REMESH_FUNCTION_VIEW_H
