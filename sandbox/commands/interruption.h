// The wish to stop, as SIGINT or SIGTERM: what is being drawn is finished first.
#ifndef PLUME_COMMANDS_INTERRUPTION_H
#define PLUME_COMMANDS_INTERRUPTION_H

namespace plume {

/// From now on the first of these signals is a wish; the second ends the program at once.
void heed_interruptions();
bool is_interrupted();

}  // namespace plume
#endif
