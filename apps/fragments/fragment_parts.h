// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/fragments/plan.h>
#include <linelet/fragments/records.h>
#include <linelet/io/cloud_sink.h>
#include <linelet/io/point_stream.h>

#include "cloud_files.h"
#include "fragment_tasks.h"

namespace linelet::apps {

/** \brief Fails unless outputs, one per input, can be written part by part. */
void
checkPartsOutput(CloudInput& input, CloudOutput& output);

/** \brief The points of \a fragment as a piece of the cloud: from the first to the last
 * that it owns. */
CloudPiece
pieceOf(const fragments::Plan& plan, const fragments::Fragment& fragment);

/** \brief The fragments that hold points of input \a number; empty beyond the last
 * input. */
std::vector<std::size_t>
fragmentsOfInput(const fragments::Plan& plan, std::size_t number);

/** \brief Writes input \a task.number again with what \a add makes of the records of
 * its points: add(cloud, records, number of points left out). Points without a record
 * have \a unknown. */
template <class Record, class Add>
void
writeParts(const OutputTask& task,
           CloudInput& input,
           CloudOutput& output,
           const Record& unknown,
           Add add,
           Frame& frame)
{
  constexpr std::size_t block = 400000;
  io::ReadOptions options = input.readOptions();
  options.shift = task.plan.shift;
  std::vector<std::string> warnings;
  io::PointStream stream(
      task.plan.inputs[task.number].path, options, block, &warnings, task.monitor);
  fragments::RecordStream results(
      task.plan, task.folder, task.number, sizeof(Record), task.usable);
  io::CloudSink sink(output.pathFor(input, task.number), &warnings, task.monitor);
  io::Cloud cloud;
  while (stream.next(cloud)) {
    std::vector<Record> records(cloud.points.size(), unknown);
    results.next(records.size(), records.data());
    const io::UsablePoints usable(cloud, nullptr, input.classes());
    add(cloud, records, usable.leftOut());
    sink.add(cloud);
  }
  sink.commit();
  frame.warn(warnings);
}

} // namespace linelet::apps
