// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Checks for test programs. Unlike `assert`, they stay in a build with NDEBUG, and a failed one does not hide those
// after it. A program checks what it has to and ends with `return check_summary();`.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CHECK_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CHECK_H

#include <atomic>
#include <cmath>
#include <exception>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

namespace check_internal {

// Atomic, as checks may run in a visitor or in the threads of a parallel loop.
inline std::atomic<int>& number_of_passed()
{
  static std::atomic<int> count{0};
  return count;
}

inline std::atomic<int>& number_of_failed()
{
  static std::atomic<int> count{0};
  return count;
}

// Written in one piece, so that the lines of two threads do not mix.
inline bool record(bool success, const char* file, int line, const std::string& what)
{
  ++(success ? number_of_passed() : number_of_failed());
  if (!success)
    std::cerr << std::string(file) + ":" + std::to_string(line) + ": check failed: " + what + "\n" << std::flush;
  return success;
}

inline bool record_close(double a, double b, double tolerance, const char* file, int line, const std::string& what)
{
  // A difference that is not a number is not below the tolerance, but two equal infinities are close.
  const bool success = (a == b) || std::abs(a - b) <= tolerance;
  std::ostringstream text;
  text << std::setprecision(17) << what << " (" << a << " and " << b << ", tolerance " << tolerance << ")";
  return record(success, file, line, text.str());
}

// what the exception being handled says
inline std::string current_exception()
{
  try
  {
    throw;
  }
  catch (const std::exception& error)
  {
    return std::string("it threw: ") + error.what();
  }
  catch (...)
  {
    return "it threw something that is no std::exception";
  }
}

} // namespace check_internal

// counts whether the condition holds; prints file, line and condition where it does not. Its value is the condition.
#define CHECK(...) ::check_internal::record(static_cast<bool>(__VA_ARGS__), __FILE__, __LINE__, #__VA_ARGS__)

// the two numbers differ by at most `tolerance`
#define CHECK_CLOSE(a, b, tolerance)                                                                                           \
  ::check_internal::record_close(static_cast<double>(a), static_cast<double>(b), static_cast<double>(tolerance), __FILE__,     \
                                 __LINE__, #a " is close to " #b)

// the expression throws an exception of this type or one derived from it. A type with a comma in it needs a typedef.
#define CHECK_THROWS(expression, exception_type)                                                                               \
  (                                                                                                                            \
      [&]() -> bool                                                                                                            \
      {                                                                                                                        \
        const std::string check_text = #expression " throws " #exception_type ", but ";                                        \
        try                                                                                                                    \
        {                                                                                                                      \
          static_cast<void>(expression);                                                                                       \
        }                                                                                                                      \
        catch (const exception_type&)                                                                                          \
        {                                                                                                                      \
          return ::check_internal::record(true, __FILE__, __LINE__, check_text);                                               \
        }                                                                                                                      \
        catch (...)                                                                                                            \
        {                                                                                                                      \
          return ::check_internal::record(false, __FILE__, __LINE__, check_text + ::check_internal::current_exception());      \
        }                                                                                                                      \
        return ::check_internal::record(false, __FILE__, __LINE__, check_text + "it threw nothing");                           \
      }())

// the expression throws nothing
#define CHECK_NO_THROW(expression)                                                                                             \
  (                                                                                                                            \
      [&]() -> bool                                                                                                            \
      {                                                                                                                        \
        const std::string check_text = #expression " throws nothing, but ";                                                    \
        try                                                                                                                    \
        {                                                                                                                      \
          static_cast<void>(expression);                                                                                       \
        }                                                                                                                      \
        catch (...)                                                                                                            \
        {                                                                                                                      \
          return ::check_internal::record(false, __FILE__, __LINE__, check_text + ::check_internal::current_exception());      \
        }                                                                                                                      \
        return ::check_internal::record(true, __FILE__, __LINE__, check_text);                                                 \
      }())

// prints `N passed, N failed`; the exit status of the test. A test that checked nothing has not passed.
inline int check_summary()
{
  const int passed = check_internal::number_of_passed(), failed = check_internal::number_of_failed();
  std::cout << passed << " passed, " << failed << " failed" << std::endl;
  return (failed == 0 && passed > 0) ? 0 : 1;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CHECK_H
