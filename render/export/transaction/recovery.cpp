#include "render/export/transaction/recovery.h"

#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "render/export/transaction/participant.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

/// All participants of a committed transaction that are still there; the leader is first.
std::vector<Participant> participants_of(Participant leader) {
  std::vector<Participant> participants;
  participants.push_back(std::move(leader));
  for (const fs::path& path : std::vector<fs::path>(participants[0].journal.followers)) {
    std::optional<Participant> follower = dead_participant(path);
    if (follower && follower->is_complete) participants.push_back(std::move(*follower));
  }
  return participants;
}

void recover_committed(Participant leader) {
  const std::vector<Participant> participants = participants_of(std::move(leader));
  bool is_done = !participants[0].journal.is_rolled_back;
  for (const Participant& each : participants) is_done = is_done && !roll_forward(each);
  if (!is_done) {
    bool is_rolled_back = true;
    for (const Participant& each : participants) is_rolled_back = roll_back(each) && is_rolled_back;
    if (!is_rolled_back) return;  // a later run tries again
  }
  // The leader's journal goes last.
  for (auto each = participants.rbegin(); each != participants.rend(); ++each) remove_hidden_files(*each);
}

void recover(const fs::path& journal_path) {
  std::optional<Participant> found = dead_participant(journal_path);
  if (!found) return;
  const fs::path leader_path = found->journal.leader;
  if (found->is_complete && leader_path.empty()) return recover_committed(std::move(*found));

  // Another folder leads. If the leader's journal is gone or incomplete, the transaction was not committed.
  std::error_code failed;
  if (found->is_complete && fs::exists(fs::symlink_status(leader_path, failed))) {
    found.reset();  // the leader's recovery locks this journal again
    std::optional<Participant> leader = dead_participant(leader_path);
    if (!leader) return;  // its run lives
    if (leader->is_complete) return recover_committed(std::move(*leader));
    found = dead_participant(journal_path);
  }
  if (found) remove_hidden_files(*found);
}

}  // namespace

void recover_folder(const fs::path& folder) {
  for (const fs::path& journal : journals_in(folder)) recover(journal);
}

}  // namespace pomona
