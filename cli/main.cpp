// pomona: grows fruit that can be cut anywhere. This file lists the commands.
#include "cli/command.h"
#include "cli/deliver/ending_signals.h"
#include "generator/base/free_memory.h"

int main(int argc, char** argv) {
  pomona::heed_ending_signals();
  pomona::keep_free_memory();
  return pomona::run({pomona::list_command, pomona::check_command, pomona::sketch_command, pomona::grow_command,
                      pomona::cut_command, pomona::plate_command, pomona::scene_command, pomona::batch_command,
                      pomona::data_command, pomona::merge_command, pomona::farm_command, pomona::compare_command,
                      pomona::verify_command, pomona::studio_command, pomona::pages_command},
                     argc, argv);
}
