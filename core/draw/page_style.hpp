/// Appearance of a page, and its reaction to a click on a run.
#pragma once

namespace riedel {

const char* page_style();
const char* page_script();

} // namespace riedel
