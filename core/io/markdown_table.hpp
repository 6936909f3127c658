/// Tables for a terminal that are also Markdown.
#pragma once

#include <string>
#include <vector>

namespace riedel {

using TableRow = std::vector<std::string>;

/// Columns as wide as their widest entry; the first `left` of them are aligned left, numbers right.
std::string markdown_table(const TableRow& head, const std::vector<TableRow>& rows, std::size_t left);

/// 93.4 or 1093: at least three digits.
std::string figure(double x);

} // namespace riedel
