#pragma once
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace ringwatch {
namespace detail {

/// Takes JSON that is nested as deep as what a run writes, and no deeper: what prints JSON, or reads CBOR, calls itself
/// at every level.
class ShallowParser : public nlohmann::detail::json_sax_dom_parser<nlohmann::ordered_json> {
  using Parser = json_sax_dom_parser;
  static constexpr int deepest = 100;  // a summary has a tenth of it

 public:
  explicit ShallowParser(nlohmann::ordered_json& result) : Parser(result, false) {}
  bool start_object(std::size_t size) { return ++depth_ <= deepest && Parser::start_object(size); }
  bool start_array(std::size_t size) { return ++depth_ <= deepest && Parser::start_array(size); }
  bool end_object() { return --depth_, Parser::end_object(); }
  bool end_array() { return --depth_, Parser::end_array(); }

 private:
  int depth_ = 0;
};

}  // namespace detail

/// JSON that a run has left, as text or as CBOR; discarded where it is damaged or nested deeper.
inline nlohmann::ordered_json savedJson(std::string_view bytes, nlohmann::ordered_json::input_format_t format =
                                                                    nlohmann::ordered_json::input_format_t::json) {
  nlohmann::ordered_json result;
  detail::ShallowParser parser(result);
  if (!nlohmann::ordered_json::sax_parse(bytes.begin(), bytes.end(), &parser, format))
    result = nlohmann::ordered_json(nlohmann::ordered_json::value_t::discarded);
  return result;
}

/// JSON as the text of a file. What is not UTF-8, as the name of a file may be, becomes U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ringwatch
