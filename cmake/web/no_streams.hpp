// Before every source of the preset web: Eigen 3.4's SparseLU puts a number into a sentence by std::ostringstream, and with
// it come the standard library's streams and locales, 30 kB of a page. This stands in its place; what a
// program prints it prints without streams (common/text.hpp).
#pragma once

#include <sstream>
#include <string>

#ifdef __EMSCRIPTEN__
namespace std {

class rigid_small_stream {
public:
    template <class Number>
    rigid_small_stream& operator<<(const Number& number)
    {
        text_ += to_string(number);
        return *this;
    }
    string str() const { return text_; }

private:
    string text_;
};

}  // namespace std
#define ostringstream rigid_small_stream
#endif
