#pragma once

#include <exception>
#include <type_traits>

namespace lavaray {

// Keeps what the user's functions throw from passing through the renderer, and throws it on afterwards as it
// is.
class Callbacks {
 public:
  template <typename Function, typename... Arguments>
  bool call(const Function& function, Arguments... arguments) {
    if (thrown_) return false;
    if (!function) return true;
    try {
      if constexpr (std::is_void_v<decltype(function(arguments...))>) {
        function(arguments...);
        return true;
      } else {
        return function(arguments...);
      }
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace lavaray
