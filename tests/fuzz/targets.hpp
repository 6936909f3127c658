/// All readers of input that the program did not write itself, as functions of bytes. A reader accepts an input or
/// refuses it with an InputError; anything else is a fault.
#pragma once

#include <array>
#include <string_view>

namespace riedel::fuzz {

void assignment(std::string_view input);         ///< --set
void campaign(std::string_view input);           ///< campaign.json
void case_file(std::string_view input);          ///< of the biaxial test
void command_line(std::string_view input);       ///< one word per line
void frame(std::string_view input);              ///< of domains, as written for ParaView
void frame_index(std::string_view input);        ///< domains.pvd
void incremental_driver(std::string_view input); ///< parameters.inp, initialconditions.inp and test.inp
void marked_document(std::string_view input);    ///< --document
void quantity(std::string_view input);           ///< numbers with units
void run_result(std::string_view input);         ///< summary.json and history.csv
void table(std::string_view input);              ///< --reference
void umat_states(std::string_view input);        ///< material.state_names
void variations(std::string_view input);         ///< --vary, one per line

struct Target {
  const char* name;
  void (*read)(std::string_view input);
};
inline constexpr std::array<Target, 13> targets{{{"assignment", assignment},
                                                 {"campaign", campaign},
                                                 {"case_file", case_file},
                                                 {"command_line", command_line},
                                                 {"frame", frame},
                                                 {"frame_index", frame_index},
                                                 {"incremental_driver", incremental_driver},
                                                 {"marked_document", marked_document},
                                                 {"quantity", quantity},
                                                 {"run_result", run_result},
                                                 {"table", table},
                                                 {"umat_states", umat_states},
                                                 {"variations", variations}}};

} // namespace riedel::fuzz
