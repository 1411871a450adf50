// Access to a private member for a test: the arguments of an explicit instantiation are
// exempt from access checks.
#pragma once

namespace test {

/// `Tag` names the member: a struct in this namespace with `using Member = …;` (pointer
/// to member) and `friend Member reach(Tag);`. Instantiate explicitly with the member's
/// address.
template <class Tag, typename Tag::Member kMember>
struct Expose {
  friend typename Tag::Member reach(Tag) { return kMember; }
};

}  // namespace test
