// Libraries that would end the program themselves.
#pragma once

namespace epure {

// From now on want of memory, where GMP and FLINT abort and an exception has no way out, is
// what it is elsewhere: one sentence on standard error, and exit code 3. Nothing is left behind: drafts of files have
// no names. What else FLINT aborts for is an internal error, exit code 70. A file that grows too large is a failed
// write, and no signal.
void end_as_told_for_want_of_room();

}  // namespace epure
