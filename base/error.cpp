#include <ringwatch/base/error.h>

#include <ringwatch/base/number_format.h>

namespace ringwatch::detail {

void TextPart::appendTo(std::string& text) const {
  switch (kind_) {
    case Kind::text:
      text += text_;
      break;
    case Kind::character:
      text += static_cast<char>(integer_);
      break;
    case Kind::integer:
      text += std::to_string(integer_);
      break;
    case Kind::natural:
      text += std::to_string(natural_);
      break;
    case Kind::real:
      text += digitsOf(real_, 9);
      break;
  }
}

std::string join(std::initializer_list<TextPart> parts) {
  std::string text;
  for (const TextPart& part : parts) part.appendTo(text);
  return text;
}

}  // namespace ringwatch::detail
