// Parameters bound to the members of a plain struct: each declaration names the member that takes its value, so that
// nothing looks a value up by its key while it works.
//
//   struct Law { double p_sand = 0; int neighbours = 4; };
//   const Binding<Law> binding{{&Law::p_sand, {.key = "p_sand", .default_value = 0.6, .maximum = 1}},
//                              {&Law::neighbours, {.key = "neighbours", .default_value = "4", .choices = {"4", "8"}}}};
//   const Law law = binding.read(values);
//
// A member of type double or float takes a real number; a whole number or bool its like; an int also a choice between
// whole numbers; an enumeration a choice, whose enumerators stand in the order of the choices; std::string a choice or
// a path; PiecewiseLinear a curve.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/parameters.h"

namespace erg {

/// A member's value as its parameter keeps it.
template <typename Member>
ParameterValue bound_value(const Parameter& parameter, const Member& member) {
  if constexpr (std::is_enum_v<Member>) {
    return parameter.choices.at(static_cast<std::size_t>(member));
  } else if constexpr (std::is_integral_v<Member> && !std::is_same_v<Member, bool>) {
    if (parameter.kind() == ParameterKind::choice) return std::to_string(member);
    return static_cast<std::int64_t>(member);
  } else if constexpr (std::is_floating_point_v<Member>) {
    return static_cast<double>(member);
  } else {
    return member;
  }
}

/// Gives a member its parameter's value. Throws std::bad_variant_access where the two are of different kinds.
template <typename Member>
void bind_value(const Parameter& parameter, const ParameterValue& value, Member& member) {
  if constexpr (std::is_enum_v<Member>) {
    const auto choice = std::ranges::find(parameter.choices, std::get<std::string>(value));
    member = static_cast<Member>(choice - parameter.choices.begin());
  } else if constexpr (std::is_integral_v<Member> && !std::is_same_v<Member, bool>) {
    const auto* choice = std::get_if<std::string>(&value);
    member = static_cast<Member>(choice != nullptr ? std::stoll(*choice) : std::get<std::int64_t>(value));
  } else if constexpr (std::is_floating_point_v<Member>) {
    member = static_cast<Member>(std::get<double>(value));
  } else {
    member = std::get<Member>(value);
  }
}

/// One declaration. `member` is a pointer to a member, or a function from the struct to a reference to one deeper
/// down. The default of a real number may be written as a whole one; one of any other kind than the member's is a
/// bug: std::logic_error.
template <typename Struct>
struct BindingEntry {
  template <typename Place>
  BindingEntry(Place member, Parameter parameter) : declared(std::move(parameter)) {
    using Member = std::remove_cvref_t<std::invoke_result_t<Place, Struct&>>;
    const auto* whole = std::get_if<std::int64_t>(&declared.default_value);
    if (std::is_floating_point_v<Member> && whole != nullptr) declared.default_value = static_cast<double>(*whole);
    take = [member](Struct& all, const Parameter& from, const ParameterValue& value) {
      bind_value(from, value, std::invoke(member, all));
    };
    give = [member](const Struct& all, const Parameter& to) {
      return bound_value(to, std::invoke(member, const_cast<Struct&>(all)));
    };
    Struct trial{};
    try {
      take(trial, declared, declared.default_value);
    } catch (const std::exception&) {
      throw std::logic_error("parameter " + declared.key + " is of another kind than its member");
    }
  }
  /// An entry of a base of the struct.
  template <typename Base>
  requires std::is_base_of_v<Base, Struct>
  explicit BindingEntry(const BindingEntry<Base>& base) : declared(base.declared), take(base.take), give(base.give) {}

  Parameter declared;
  std::function<void(Struct&, const Parameter&, const ParameterValue&)> take;
  std::function<ParameterValue(const Struct&, const Parameter&)> give;
};

/// The declarations of a struct's values, each with its member.
template <typename Struct>
class Binding {
 public:
  using Entries = std::vector<BindingEntry<Struct>>;

  Binding(std::initializer_list<BindingEntry<Struct>> entries) : Binding(Entries(entries)) {}
  /// Parts that follow one another: Entries, or a Binding of a base of the struct.
  template <typename... Parts>
  explicit Binding(const Parts&... parts) {
    (append(parts), ...);
    Parameters declared;
    for (const BindingEntry<Struct>& entry : entries_) declared.push_back(entry.declared);
    declarations_ = Declarations(std::move(declared));
  }

  const Entries& entries() const { return entries_; }
  const Declarations& declarations() const { return declarations_; }

  /// The struct with these values, which stand under these declarations.
  Struct read(const ParameterValues& values) const {
    Struct all{};
    for (const BindingEntry<Struct>& entry : entries_)
      entry.take(all, entry.declared, values.value(entry.declared.key));
    return all;
  }
  /// The way back. Throws InputError for a value out of its range.
  ParameterValues write(const Struct& all) const {
    ParameterValues values(declarations_);
    for (const BindingEntry<Struct>& entry : entries_) values.set(entry.declared.key, entry.give(all, entry.declared));
    return values;
  }

 private:
  void append(const Entries& entries) { entries_.insert(entries_.end(), entries.begin(), entries.end()); }
  template <typename Base>
  void append(const Binding<Base>& base) {
    for (const BindingEntry<Base>& entry : base.entries()) entries_.emplace_back(entry);
  }

  Entries entries_;
  Declarations declarations_;
};

}  // namespace erg
