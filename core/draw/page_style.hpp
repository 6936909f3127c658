/// How a page looks and what a click on a run does.
#pragma once

namespace riedel {

const char* page_style();
const char* page_script();

} // namespace riedel
