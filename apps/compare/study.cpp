#include "apps/compare/study.hpp"

#include "apps/built_in.hpp"
#include "core/base/error.hpp"
#include "core/base/suggestion.hpp"
#include "core/io/readable.hpp"

#include <algorithm>

namespace riedel {

namespace {

using Texts = std::vector<std::string>;

void refuse_unknown(const CaseFile& file) {
  const Texts known{"compare.title", "compare.schemes", "compare.vary"};
  for (const std::string& name : file.names_in("compare"))
    if (std::ranges::find(known, name) == known.end())
      throw InputError(file.place(name) + ": unknown key" + did_you_mean(name, known) +
                       "; [compare] takes title, schemes, vary");
}

/// Replaces an earlier variation of the same key, or appends the variation.
void put(std::vector<Variation>& variations, Variation variation) {
  const auto same = std::ranges::find(variations, variation.key, &Variation::key);
  if (same == variations.end())
    variations.push_back(std::move(variation));
  else
    *same = std::move(variation);
}

void add_wishes(std::vector<Variation>& variations, const Texts& wishes) {
  for (Variation& variation : variations_of(wishes)) put(variations, std::move(variation));
}

Texts schemes_of(const Arguments& arguments, const CaseFile& file) {
  const Texts listed = file.peek_texts("compare.schemes").value_or(Texts{});
  if (file.peek_texts("compare.schemes") && listed.empty())
    throw InputError(file.place("compare.schemes") + ": the list is empty");
  const Texts known = load_catalogue(file.without("compare")).catalogue.in_2d.schemes.names();
  const Texts wished = arguments.list("schemes", listed);
  if (arguments.has("schemes") && wished.empty()) throw InputError("--schemes: the list is empty");
  if (wished == Texts{"all"}) return known;
  refuse_unknown_names(arguments.has("schemes") ? "--schemes" : file.place("compare.schemes") + ":", wished, known);
  return wished;
}

} // namespace

Study study_of(const Arguments& arguments) {
  const CaseFile file = arguments.case_file();
  refuse_unknown(file);
  Study study{.title = "", .given = file.without("compare"), .variations = {}};
  const std::string otherwise =
      arguments.words.empty() ? "Comparison" : std::filesystem::path(arguments.words.front()).stem().string();
  study.title = readable(file.peek_text("compare.title").value_or(otherwise));
  if (const Texts schemes = schemes_of(arguments, file); !schemes.empty())
    study.variations.push_back({"scheme", schemes});
  add_wishes(study.variations, file.peek_texts("compare.vary").value_or(Texts{}));
  if (const auto wishes = arguments.options.find("vary"); wishes != arguments.options.end())
    add_wishes(study.variations, wishes->second);
  if (study.variations.empty())
    throw InputError("nothing to compare: give --schemes A,B or --vary KEY=A,B, or a case file with [compare]");
  return study;
}

} // namespace riedel
