/// Tables for a terminal that are Markdown as well.
#pragma once

#include <string>
#include <vector>

namespace riedel {

using TableRow = std::vector<std::string>;

/// Columns as wide as their widest entry; the first `left` of them stand to the left, numbers to the right.
std::string markdown_table(const TableRow& head, const std::vector<TableRow>& rows, std::size_t left);

/// 93.4 or 1093: three digits at least.
std::string figure(double x);

} // namespace riedel
