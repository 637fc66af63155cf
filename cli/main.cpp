// pomona: grows fruit that can be cut anywhere. This file only knows which commands there are.
#include "cli/command.h"
#include "cli/ending_signals.h"

int main(int argc, char** argv) {
  pomona::heed_ending_signals();
  return pomona::run({pomona::list_command, pomona::check_command, pomona::sketch_command, pomona::grow_command,
                      pomona::cut_command, pomona::scene_command, pomona::batch_command, pomona::merge_command,
                      pomona::farm_command, pomona::compare_command, pomona::pages_command},
                     argc, argv);
}
