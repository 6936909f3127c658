/// Standard input, output and error as a program finds them, and as it leaves them.
#pragma once

namespace riedel {

/// To be called before anything opens a file. A stream that is closed becomes one of /dev/null: else the next file
/// would take its number, and receive what is printed. A reader that goes away, and a file that may not grow, become
/// errors where they are met instead of signals that end the program in the middle of a run.
void secure_standard_streams();

/// Hands on what is still to be printed. Ends the program as a pipe without a reader does, when it is that.
/// @return whether all that was printed has gone out
bool flush_standard_output();

} // namespace riedel
