// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "output_queue.h"

#include <filesystem>
#include <utility>

#include <linelet/fragments/records.h>

namespace linelet::apps {

using fragments::Ledger;

OutputQueue::OutputQueue(FragmentJob& job,
                         const fragments::Plan& plan,
                         const std::string& folder,
                         const Ledger& ledger,
                         Write write)
    : folder_(folder),
      write_(std::move(write)),
      done_(plan.tiling.boxes()),
      of_(done_.size()),
      pending_(done_.size(), 0)
{
  for (std::size_t f = 0; f < done_.size(); ++f)
    done_[f] = ledger.done(Ledger::task, f);
  for (std::size_t i = 0;; ++i) {
    Pending output{i, job.needs(plan, i), 0};
    if (output.needs.empty())
      break;
    if (ledger.done(Ledger::output, i))
      continue;
    for (const std::size_t f : output.needs) {
      output.missing += done_[f] ? 0 : 1;
      of_[f].push_back(outputs_.size());
      ++pending_[f];
    }
    outputs_.push_back(std::move(output));
  }
}

void
OutputQueue::begin()
{
  for (std::size_t f = 0; f < done_.size(); ++f)
    removeUnneeded(f);
  for (const Pending& output : outputs_)
    if (output.missing == 0)
      write(output);
}

void
OutputQueue::add(std::size_t number)
{
  if (done_[number])
    return;
  done_[number] = true;
  removeUnneeded(number);
  for (const std::size_t i : of_[number])
    if (--outputs_[i].missing == 0)
      write(outputs_[i]);
}

void
OutputQueue::write(const Pending& output)
{
  write_(output.number, done_);
  for (const std::size_t f : output.needs) {
    --pending_[f];
    removeUnneeded(f);
  }
}

void
OutputQueue::removeUnneeded(std::size_t number) const
{
  if (!done_[number] || pending_[number] > 0)
    return;
  std::error_code ignored;
  std::filesystem::remove(fragments::resultPath(folder_, number), ignored);
}

} // namespace linelet::apps
