/// A page for a browser, one file without network: text, tables, plots and pictures, in which a run can be picked out.
#pragma once

#include "core/draw/plot.hpp"

namespace riedel {

/// A cell of a table. What is chosen by `look` is what the style sheet knows: "agrees", "differs", "cannot", "faint".
struct PageCell {
  std::string text, look = {};
};

struct PageRow {
  std::vector<PageCell> cells;
  std::string run = {}; ///< that it tells of
};

struct PageTable {
  std::string caption;
  std::vector<std::string> header; ///< with units
  std::vector<PageRow> rows;
  std::size_t text_columns = 1; ///< from the left; the others hold numbers and stand at the right
  bool long_text = false;       ///< all columns hold sentences
};

/// A picture of one run.
struct PagePicture {
  std::string png; ///< bytes
  std::string caption, run;
};

/// Pictures side by side with one bar of colours.
struct PagePictures {
  std::string caption;
  std::vector<PagePicture> pictures;
  std::string label;  ///< of the colours, with the unit
  Interval range;     ///< of the colours
  int width_px = 120; ///< of a picture on the screen
};

class Page {
public:
  explicit Page(std::string title);

  void heading(const std::string& text);
  void subheading(const std::string& text);
  void paragraph(const std::string& text);
  /// Names and what they are: version, command, machine.
  void facts(const std::vector<std::pair<std::string, std::string>>& pairs);
  void table(const PageTable& table);
  /// The curves that have an id are listed beneath, each as a button that picks its run out.
  void plot(const Plot& plot, const std::string& caption);
  void pictures(const PagePictures& pictures);

  [[nodiscard]] std::string html() const;

private:
  std::string title_, body_;
};

/// Text that means itself in HTML.
std::string html_escaped(const std::string& text);

/// The letters A-Z, a-z, 0-9, + and / for every six bits (RFC 4648).
std::string base64(const std::string& bytes);

} // namespace riedel
