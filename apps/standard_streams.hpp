/// Standard input, output and error as a program finds them, and as it leaves them.
#pragma once

namespace riedel {

/// To be called before any file is opened. A closed stream is redirected to /dev/null; otherwise the next file would
/// get its number and receive what is printed. A reader that goes away, or a file that may not grow, causes an error at
/// the write instead of a signal that ends the program during a run.
void secure_standard_streams();

/// Flushes standard output. If it is a pipe without a reader, ends the program by SIGPIPE, as is usual.
/// @return whether everything has been written
bool flush_standard_output();

} // namespace riedel
