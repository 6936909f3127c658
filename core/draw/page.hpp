/// A page for a browser, one file that needs no network: text, tables, plots and pictures, with highlighting of a run.
#pragma once

#include "core/draw/plot.hpp"

namespace riedel {

/// A cell of a table. `look` is a class of the style sheet: "agrees", "differs", "cannot", "faint".
struct PageCell {
  std::string text, look = {};
};

struct PageRow {
  std::vector<PageCell> cells;
  std::string run = {}; ///< that it belongs to
};

struct PageTable {
  std::string caption;
  std::vector<std::string> header; ///< with units
  std::vector<PageRow> rows;
  std::size_t text_columns = 1; ///< from the left; the others hold numbers, aligned right
  bool long_text = false;       ///< all columns contain sentences
};

/// A picture of one run.
struct PagePicture {
  std::string png; ///< bytes
  std::string caption, run;
};

/// Pictures side by side with a common colour bar.
struct PagePictures {
  std::string caption;
  std::vector<PagePicture> pictures;
  std::string label;  ///< of the colour bar, with the unit
  Interval range;     ///< of the colour bar
  int width_px = 120; ///< of a picture on the screen
};

class Page {
public:
  explicit Page(std::string title);

  void heading(const std::string& text);
  void subheading(const std::string& text);
  void paragraph(const std::string& text);
  /// Names and values: version, command, machine.
  void facts(const std::vector<std::pair<std::string, std::string>>& pairs);
  void table(const PageTable& table);
  /// The curves that have an id are listed below, each as a button that highlights its run.
  void plot(const Plot& plot, const std::string& caption);
  void pictures(const PagePictures& pictures);

  [[nodiscard]] std::string html() const;

private:
  std::string title_, body_;
};

/// Text escaped for HTML.
std::string html_escaped(const std::string& text);

/// Base 64: the letters A-Z, a-z, 0-9, + and / for every six bits (RFC 4648).
std::string base64(const std::string& bytes);

} // namespace riedel
