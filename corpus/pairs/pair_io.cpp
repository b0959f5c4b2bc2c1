// SPDX-License-Identifier: MIT
#include "corpus/pairs/pair_io.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/enum_words.hpp"
#include "base/json.hpp"
#include "base/spelling.hpp"
#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The place of a field's numbers among the numbers of a solid.
struct Field {
  std::string_view name;
  std::size_t first, count;  // 0 for a word
};
constexpr std::array<Field, 10> solid_fields{{{"center", 0, 3},
                                              {"axis", 3, 3},
                                              {"radius", 6, 1},
                                              {"height", 7, 1},
                                              {"rounding", 8, 1},
                                              {"point", 0, 3},
                                              {"normal", 3, 3},
                                              {"edges", 9, 3},
                                              {"quaternion", 12, 4},
                                              {"shape", 0, 0}}};

/// A shape's name for people. A quaternion may replace an axis.
struct ShapeForm {
  std::string_view name;
  std::string_view fields;  // one letter each, as in letters_of; capital letters may be left out
  const char* expected;
};
constexpr std::string_view letters_of_fields = "carhgpneqs";
constexpr std::array<ShapeForm, 5> shape_forms{
    {{"cylinder", "carhG", "center, axis or quaternion, radius, height, and perhaps rounding"},
     {"capsule", "carh", "center, axis or quaternion, radius, and height between the centers of its ends"},
     {"sphere", "cr", "center and radius"},
     {"half_space", "pn", "point and normal"},
     {"box", "ceQG", "center, edges, and perhaps quaternion and rounding"}}};

/// A field that other programs have, and how to convert it.
struct ForeignField {
  std::string_view name;
  const char* remedy;
};
constexpr std::array<ForeignField, 8> foreign_fields{
    {{"size", "give edges, the three full lengths"},
     {"half_extents", "give edges, which are twice as much"},
     {"half_height", "give height, which is twice as much"},
     {"halfHeight", "give height, which is twice as much"},
     {"length", "give height"},
     {"rpy", "give axis: (cos r sin p cos y + sin r sin y, cos r sin p sin y - sin r cos y, cos r cos p)"},
     {"from", "give center, the mean of both end points, axis, their difference, and height, its length"},
     {"offset", "give point, which is offset * normal / |normal|^2 for the plane normal.x = offset"}}};
constexpr std::array<std::string_view, 3> guarded_keys{"source", "truth", "note"};

/// The most bytes that an error text repeats from a file.
constexpr std::size_t shown_cap = 40;

constexpr const char* too_long = "the line is longer than 1 MiB";

std::string place(std::size_t line, std::size_t at) {
  return "line " + std::to_string(line) + ", column " + std::to_string(at + 1) + ": ";
}

CaseLine refuse(std::size_t line, std::size_t at, const char* why) {
  return {line, std::nullopt, place(line, at) + why};
}

std::string shorten(std::string_view text) {
  if (text.size() <= shown_cap) return std::string(text);
  std::size_t end = shown_cap;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // whole UTF-8 characters
  return std::string(text.substr(0, end)) + "...";
}

/// Turns the events of the parser into a case, or stops it at the first fault.
class CaseBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  CaseBuilder(std::string_view text, std::size_t line) : text_(text), line_(line) {}

  Case value;
  std::string error;

  bool null() override { return begin_token(), accept("null"); }
  bool boolean(bool x) override { return begin_token(), accept(x ? "true" : "false"); }
  bool number_integer(number_integer_t x) override { return number(static_cast<double>(x)); }
  bool number_unsigned(number_unsigned_t x) override { return number(static_cast<double>(x)); }
  bool number_float(number_float_t x, const string_t& text) override { return number(x, text); }
  bool binary(binary_t&) override { return false; }  // no token of JSON text is one

  bool string(string_t& x) override {
    begin_token();
    if (wanted() != Wanted::text) return accept("a string");
    if (depth_ == in_cylinder) {
      form_ = std::ranges::find(shape_forms, x, &ShapeForm::name);
      return form_ != shape_forms.end() || fail(key_ + ".shape is \"" + shorten(x) +
                                                "\", expected cylinder, capsule, sphere, half_space or box");
    }
    if (key_ == "truth") {
      value.truth = from_word<Verdict>(x);
      return value.truth || fail("truth is \"" + shorten(x) +
                                 "\", expected disjoint, intersecting, touching, undecided or invalid");
    }
    (key_ == "id" ? value.id : key_ == "source" ? value.source : value.note) = std::move(x);
    return true;
  }

  bool key(string_t& x) override {
    begin_token();
    if (skipped_ > 0) return true;
    if (depth_ == in_cylinder) return field_key(x);
    for (std::string_view known : guarded_keys)
      if (x.size() <= known.size() + 1 && known.size() <= x.size() + 1 && typing_errors(x, known) == 1)
        return fail(shorten(x) + " is not a known key; did you mean " + std::string(known) + "?");
    key_ = x;
    return keys_seen_.insert(std::move(x)).second || fail(shorten(key_) + " is given twice");
  }

  bool start_object(std::size_t) override {
    fields_seen_ = {};
    form_ = shape_forms.begin();
    return open(Wanted::object, "an object");
  }

  bool end_object() override {
    begin_token();
    if (skipped_ > 0) return close();
    if (depth_-- == in_cylinder) return finish_solid();
    for (const char* needed : {"a", "b"})
      if (!keys_seen_.contains(needed)) return fail(std::string(needed) + " is missing");
    if (is_half_space(value.pair.a) && is_half_space(value.pair.b))
      return fail("a and b are both half-spaces");
    return true;
  }

  bool start_array(std::size_t) override {
    if (!open(Wanted::list, "a list")) return false;
    if (skipped_ > 0) return true;
    coordinates_ = 0;
    list_start_ = start_;
    return true;
  }

  bool end_array() override {
    begin_token();
    if (skipped_ > 0) return close();
    --depth_;
    start_ = list_start_;
    if (const std::size_t count = solid_fields[field_].count; coordinates_ != count)
      return fail(subject() + " has " + std::to_string(coordinates_) + " coordinates, expected " +
                  std::to_string(count));
    return check_field("");
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& fault) override {
    start_ = std::min(text_.find_first_not_of(between_tokens, token_end_), text_.size());
    const std::string word = shorten(text_.substr(start_, text_.find_first_of(token_ends, start_) - start_));
    constexpr int number_overflow = 406;  // nlohmann/json's number for this fault
    if (fault.id == number_overflow)
      return fail((skipped_ > 0 ? "a number" : subject()) + " overflows a double (" + word + ")");
    if (wanted() == Wanted::number && after_colon_or_comma() && !word.empty())
      return fail(subject() + " is " + word + ", expected " + expected());
    start_ = position - 1;
    // "[json.exception...] parse error at line 1, column 9: syntax error while parsing value - invalid
    // literal; last read: '...'". Keeps the part between the dash and the last words, which may be long.
    std::string_view what = fault.what();
    what.remove_prefix(std::min(what.find(" - ") + 3, what.size()));
    return fail("not JSON: " + std::string(what.substr(0, what.find("; last read: "))));
  }

 private:
  enum Depth { outside, in_line, in_cylinder, in_list };  // of the containers that are not skipped
  enum class Wanted { object, list, number, text, anything };
  static constexpr std::string_view between_tokens = " \t\r\n,:", token_ends = " \t\r\n,:[]{}\"";

  // Every token but ',' and ':' is an event, so a token begins at the first other byte after the last one.
  // When the event comes, the parser has accepted all of the token.
  void begin_token() {
    start_ = text_.find_first_not_of(between_tokens, token_end_);
    token_end_ = start_ + 1;
    if (text_[start_] == '"') {
      while (text_[token_end_] != '"') token_end_ += text_[token_end_] == '\\' ? 2 : 1;
      ++token_end_;
    } else if (std::string_view("[]{}").find(text_[start_]) == std::string_view::npos) {
      token_end_ = std::min(text_.find_first_of(token_ends, start_), text_.size());
    }
  }

  bool after_colon_or_comma() const {
    const auto before = text_.find_last_not_of(" \t\r", start_ == 0 ? 0 : start_ - 1);
    return before != text_.npos && (text_[before] == ':' || text_[before] == ',' || text_[before] == '[');
  }

  bool fail(const std::string& what) {
    error = place(line_, start_) + what;
    return false;
  }

  /// The kind of value that belongs at the place of the parser.
  Wanted wanted() const {
    if (skipped_ > 0) return Wanted::anything;
    if (depth_ == outside) return Wanted::object;
    if (depth_ == in_list) return Wanted::number;
    if (depth_ == in_cylinder) return kind_of_field();
    if (key_ == "a" || key_ == "b") return Wanted::object;
    const bool text = key_ == "id" || std::ranges::find(guarded_keys, key_) != guarded_keys.end();
    return text ? Wanted::text : Wanted::anything;
  }

  Wanted kind_of_field() const {
    const std::size_t count = solid_fields[field_].count;
    return count > 1 ? Wanted::list : count == 1 ? Wanted::number : Wanted::text;
  }

  const char* expected() const {
    constexpr std::array names{"an object", "a list of 3 numbers", "a number", "a string", "anything"};
    if (wanted() == Wanted::list && solid_fields[field_].count == 4) return "a list of 4 numbers";
    return names[static_cast<std::size_t>(wanted())];
  }

  /// Checks the fields against the shape. Makes the radius of a sphere or capsule a rounding.
  bool finish_solid() {
    const auto has = [&](char letter) { return fields_seen_[letters_of_fields.find(letter)]; };
    for (std::size_t i = 0; i < letters_of_fields.size(); ++i) {
      const char letter = letters_of_fields[i];
      const auto holds = [&](char l) { return form_->fields.find(l) != form_->fields.npos; };
      const char capital = static_cast<char>(letter - 'a' + 'A');
      const bool allowed = holds(letter) || holds(capital) || letter == 's' || (letter == 'q' && holds('a'));
      const bool needed = holds(letter) && !(letter == 'a' && has('q'));
      const std::string name = key_ + "." + std::string(solid_fields[i].name);
      if (fields_seen_[i] && !allowed)
        return fail(name + " is given, but a " + std::string(form_->name) + " has " + form_->expected);
      if (needed && !fields_seen_[i]) return fail(name + " is missing");
    }
    if (has('a') && has('q')) return fail(key_ + " has an axis and a quaternion; give one of them");
    Solid& s = cylinder();
    if (has('q') && form_->name != "box") {
      const auto& [w, x, y, z] = std::exchange(s.quaternion, Solid{}.quaternion);
      s.axis = {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z};
    }
    if (form_->name == "capsule" || form_->name == "sphere") s.rounding = std::exchange(s.radius, 0);
    if (form_->name == "half_space") s.shape = Shape::half_space;
    if (form_->name == "box") s.shape = Shape::box;
    const Defect defect = find_defect(s);
    return defect == Defect::none || fail(key_ + "." + to_string(defect));
  }

  std::string subject() const {
    if (depth_ == outside) return "the line";
    if (depth_ == in_line) return shorten(key_);
    const std::string field = key_ + "." + std::string(solid_fields[field_].name);
    return depth_ == in_list ? field + "[" + std::to_string(coordinates_) + "]" : field;
  }

  bool accept(const char* kind) {
    return wanted() == Wanted::anything || fail(subject() + " is " + kind + ", expected " + expected());
  }

  bool open(Wanted container, const char* kind) {
    begin_token();
    if (wanted() == container) return ++depth_, true;
    if (!accept(kind)) return false;
    ++skipped_;
    return true;
  }

  bool close() { return --skipped_, true; }

  bool field_key(const std::string& x) {
    const auto found = std::ranges::find(solid_fields, x, &Field::name);
    if (const auto foreign = std::ranges::find(foreign_fields, x, &ForeignField::name);
        foreign != foreign_fields.end())
      return fail(key_ + "." + x + " is not a field of a solid; " + foreign->remedy);
    if (found == solid_fields.end())
      return fail(key_ + "." + shorten(x) +
                  " is not a field of a solid; a cylinder has center, axis, radius, height, rounding");
    field_ = static_cast<std::size_t>(found - solid_fields.begin());
    return !std::exchange(fields_seen_[field_], true) || fail(subject() + " is given twice");
  }

  Solid& cylinder() { return key_ == "a" ? value.pair.a : value.pair.b; }

  /// `text` has the number's digits if it has a point or an exponent.
  bool number(double x, std::string_view text = {}) {
    begin_token();
    if (x == 0 && text_[start_] == '-') x = -0.0;  // the parser makes the integer 0 of "-0"
    if (wanted() != Wanted::number) return accept("a number");
    const Field& field = solid_fields[field_];
    if (depth_ == in_list && coordinates_ == field.count) {
      --depth_;
      return fail(subject() + " has more than " + std::to_string(field.count) + " coordinates");
    }
    if (x == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != text.npos)
      return fail(subject() + " underflows a double (" + shorten(text) + ")");
    const std::size_t place = field.first + (depth_ == in_list ? coordinates_++ : 0);
    *numbers_of(cylinder())[place] = x;
    return depth_ == in_list || check_field(" (" + format_double(x) + ")");
  }

  // A solid begins without a defect, so the first defect is in the field just read. Whether
  // the shape has the field is checked when all fields are known.
  bool check_field(const std::string& shown) {
    Defect defect = find_defect(cylinder());
    if (defect == Defect::foreign_length) defect = Defect::none;
    const std::string_view what = to_string(defect);  // "axis is zero", of a field that may be a normal
    return defect == Defect::none || fail(subject() + std::string(what.substr(what.find(' '))) + shown);
  }

  std::string_view text_;
  std::size_t line_;
  std::size_t start_ = 0;      // the beginning of the token of this event
  std::size_t token_end_ = 0;  // its end
  int depth_ = outside;
  std::size_t skipped_ = 0;  // open containers with no wanted field
  std::string key_;          // the last key of the line itself
  std::set<std::string, std::less<>> keys_seen_;
  std::size_t field_ = 0;  // index into solid_fields
  std::array<bool, solid_fields.size()> fields_seen_{};
  const ShapeForm* form_ = shape_forms.begin();
  std::size_t coordinates_ = 0;
  std::size_t list_start_ = 0;
};

void append(std::string& out, const Solid& c) {
  const std::string_view fields = is_half_space(c) ? "pn" : is_box(c) ? "ceqg" : "carhg";
  const auto numbers = numbers_of(c);
  out += '{';
  if (c.shape != Shape::cylinder) out.append("\"shape\":\"").append(to_string(c.shape)).append("\",");
  for (const char letter : fields) {
    if (letter == 'g' && c.rounding == 0) continue;
    const auto& [name, first, count] = solid_fields[letters_of_fields.find(letter)];
    out.append("\"").append(name).append(count > 1 ? "\":[" : "\":");
    for (std::size_t i = 0; i < count; ++i)
      out.append(i > 0 ? "," : "").append(format_number(numbers[first + i]));
    out.append(count > 1 ? "]," : ",");
  }
  out.back() = '}';
}

}  // namespace

bool LineReader::next() {
  for (;;) {
    // The buffer has room for the \r of a line that just fits and for the terminating zero.
    in_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    const auto got = static_cast<std::size_t>(in_.gcount());
    if (in_.bad() || got == 0) return false;
    ++line_;
    if (in_.fail()) {  // the buffer was full before the end of the line
      in_.clear();
      in_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      text_ = {buffer_.data(), got};
      return true;
    }
    text_ = {buffer_.data(), in_.eof() ? got : got - 1};  // a newline counts but is not stored
    if (line_ == 1 && text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
    if (text_.ends_with('\r')) text_.remove_suffix(1);
    if (text_.find_first_not_of(" \t\r") != text_.npos) return true;
  }
}

std::optional<CaseLine> CaseReader::next() {
  if (!lines_.next()) return std::nullopt;
  return parse_case(lines_.text(), lines_.line());
}

CaseLine parse_case(std::string_view text, std::size_t line) {
  if (text.size() > line_cap) return refuse(line, line_cap, too_long);
  // The parser would take a NUL for the end of its input, and would skip a byte order mark.
  if (const auto nul = text.find('\0'); nul != text.npos) return refuse(line, nul, "not JSON: a NUL byte");
  if (text.starts_with(byte_order_mark)) return refuse(line, 0, "not JSON: a byte order mark");

  CaseBuilder builder(text, line);
  CaseLine out;
  out.line = line;
  if (nlohmann::json::sax_parse(text, &builder))
    out.value = std::move(builder.value);
  else
    out.error = std::move(builder.error);
  return out;
}

std::string format_double(double x) {
  std::array<char, 32> digits;  // the longest, "-2.2250738585072014e-308", has 24
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
  return std::string(digits.data(), end);
}

std::string format_number(double x) {
  return std::isfinite(x) ? format_double(x) : '"' + format_double(x) + '"';
}

std::string quote_json(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string format_pair(const Pair& p) {
  std::string out = "{\"a\":";
  append(out, p.a);
  out += ",\"b\":";
  append(out, p.b);
  out += '}';
  return out;
}

std::string format_case(const Case& c) {
  std::string out = format_pair(c.pair);
  out.pop_back();
  if (!c.id.empty()) out += ",\"id\":" + quote_json(c.id);
  if (!c.source.empty()) out += ",\"source\":" + quote_json(c.source);
  if (c.truth) out += std::string(",\"truth\":\"") + to_string(*c.truth) + '"';
  if (!c.note.empty()) out += ",\"note\":" + quote_json(c.note);
  out += '}';
  return out;
}

}  // namespace cyl
