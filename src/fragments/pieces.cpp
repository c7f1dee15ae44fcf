// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/pieces.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include <unistd.h>

#include <linelet/io/file_error.h>
#include <linelet/io/point_stream.h>

namespace linelet::fragments {

namespace fs = std::filesystem;

namespace {

// In the file of a piece points follow one another; what it is whole with, the ledger
// knows. Read on the machine, or kind of machine, that wrote it.
struct Record {
  double x, y, z;
  std::uint32_t place;
  std::uint8_t number_of_class, number_of_returns;
  std::uint16_t unused;
};
static_assert(sizeof(Record) == 32);

constexpr std::size_t block_size = 500000; // points read at a time

struct Closer {
  void
  operator()(std::FILE* file) const
  {
    std::fclose(file);
  }
};
using File = std::unique_ptr<std::FILE, Closer>;

[[noreturn]] void
cannotWrite(const std::string& path)
{
  throw io::FileError(path + ": cannot be written (" + std::strerror(errno) +
                      "); check that the folder exists, may be written and has room");
}

/** Pieces under construction, with names that no other worker uses; removed unless they
 * are whole. */
class Construction {
public:
  ~Construction()
  {
    for (const auto& piece : pieces_)
      if (!piece.second.place.empty())
        std::remove(piece.second.place.c_str());
  }

  void
  add(std::size_t fragment, const Record& record)
  {
    pieces_[fragment].records.push_back(record);
  }

  /** Puts what has come together behind what is there; \a path tells names. */
  template <class Path>
  void
  flush(Path path)
  {
    for (auto& [fragment, piece] : pieces_) {
      if (piece.records.empty())
        continue;
      if (piece.place.empty()) {
        const std::string name = path(fragment);
        std::error_code ignored; // the file tells
        fs::create_directories(fs::path(name).parent_path(), ignored);
        piece.place = name + ".part-" + std::to_string(::getpid());
        std::remove(piece.place.c_str());
      }
      const File file(std::fopen(piece.place.c_str(), "ab"));
      if (!file ||
          std::fwrite(
              piece.records.data(), sizeof(Record), piece.records.size(), file.get()) !=
              piece.records.size() ||
          std::fflush(file.get()) != 0)
        cannotWrite(piece.place);
      piece.points += piece.records.size();
      piece.records.clear();
    }
  }

  /** All are whole. \return their points */
  template <class Path>
  std::map<std::size_t, std::uint64_t>
  publish(Path path)
  {
    std::map<std::size_t, std::uint64_t> points;
    for (auto& [fragment, piece] : pieces_) {
      const std::string name = path(fragment);
      if (std::rename(piece.place.c_str(), name.c_str()) != 0)
        cannotWrite(name);
      piece.place.clear();
      points[fragment] = piece.points;
    }
    return points;
  }

private:
  struct Piece {
    std::vector<Record> records;
    std::string place;
    std::uint64_t points = 0;
  };
  std::map<std::size_t, Piece> pieces_;
};

/** Calls \a use with every usable point of \a cloud, which begins at place \a first of
 * \a input, and its world coordinates. */
template <class Use>
void
forEachRecord(const Plan& plan,
              const PlannedInput& input,
              const io::ClassFilter& filter,
              const io::Cloud& cloud,
              std::size_t first,
              Use use)
{
  if (first + cloud.points.size() > std::numeric_limits<std::uint32_t>::max())
    throw io::FileError(input.path +
                        ": has more than 4,294,967,295 points; cut it in two");
  const Area& area = input.extent.area;
  const io::UsablePoints usable(cloud, nullptr, filter);
  const io::Column* classes = cloud.find("classification");
  const io::Column* returns = cloud.find("number_of_returns");
  const auto numberIn = [](const io::Column* column, std::size_t i) {
    return column == nullptr ? std::uint8_t{0}
                             : static_cast<std::uint8_t>(io::valueAt(*column, i));
  };
  const Point offset = cloud.shift - plan.shift;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!usable.points()[i].allFinite())
      continue;
    const Point p = usable.points()[i] + offset;
    const Point world = p + plan.shift;
    for (std::size_t a = 0; a < 2; ++a) {
      const double value = world[static_cast<Eigen::Index>(a)];
      if (value < area.low[a] || value > area.high[a])
        throw io::FileError(input.path +
                            ": has points outside of the bounds that its header "
                            "names; rewrite it with linelet convert");
    }
    use(Record{p.x(),
               p.y(),
               p.z(),
               static_cast<std::uint32_t>(first + i),
               numberIn(classes, i),
               numberIn(returns, i),
               0},
        world);
  }
}

void
put(const Record& record, bool core, Fragment& fragment)
{
  fragment.points.emplace_back(record.x, record.y, record.z);
  fragment.classes.push_back(record.number_of_class);
  fragment.returns.push_back(record.number_of_returns);
  fragment.places.push_back(record.place);
  fragment.core.push_back(core);
}

} // namespace

std::size_t
Fragment::owned() const
{
  return static_cast<std::size_t>(std::count(core.begin(), core.end(), true));
}

Pieces::Pieces(const Plan& plan,
               std::string folder,
               io::ReadOptions options,
               io::ClassFilter classes)
    : plan_(plan),
      folder_(std::move(folder)),
      options_(std::move(options)),
      classes_(std::move(classes)),
      ledger_(folder_, plan.fingerprint())
{
  options_.shift = plan.shift;
}

std::string
Pieces::path(std::size_t fragment, std::size_t input) const
{
  char name[64];
  std::snprintf(name, sizeof(name), "%06zu/%06zu.bin", fragment, input);
  return (fs::path(folder_) / "pieces" / name).string();
}

void
Pieces::cut(std::size_t input, ProgressMonitor* monitor) const
{
  const PlannedInput& planned = plan_.inputs[input];
  const Area& area = planned.extent.area;
  const auto pathFor = [&](std::size_t fragment) { return path(fragment, input); };
  std::vector<bool> wanted(plan_.tiling.boxes(), false);
  for (const std::size_t f : plan_.tiling.near(area, plan_.reach()))
    wanted[f] = !ledger_.done(Ledger::task, f);
  Construction pieces;
  io::PointStream stream(planned.path, options_, block_size, nullptr, monitor);
  io::Cloud cloud;
  std::size_t first = 0;
  while (stream.next(cloud)) {
    forEachRecord(plan_,
                  planned,
                  classes_,
                  cloud,
                  first,
                  [&](const Record& record, const Point& world) {
                    plan_.tiling.forEachNear(
                        world.x(), world.y(), plan_.reach(), [&](std::size_t fragment) {
                          if (wanted[fragment])
                            pieces.add(fragment, record);
                        });
                  });
    first += cloud.points.size();
    pieces.flush(pathFor);
    throwIfCanceled(monitor);
  }
  Ledger::Entry entry;
  entry.done = true;
  entry.points = static_cast<double>(first);
  entry.pieces = pieces.publish(pathFor);
  ledger_.write(Ledger::cut, input, entry);
}

/** Where an input keeps what fragment \a number may have; nothing where it has no
 * octree to go by. */
Pieces::Ranges
Pieces::octreeRanges(std::size_t input, std::size_t number) const
{
  // Places are those of all that is read.
  if (!options_.bounds.empty() || !options_.bounds_3d.empty() ||
      options_.resolution > 0 || options_.lenient)
    return {};
  const Area box = plan_.tiling.box(number);
  const double reach = plan_.reach();
  return io::copcRanges(plan_.inputs[input].path,
                        {box.low[0] - reach,
                         box.low[1] - reach,
                         box.high[0] + reach,
                         box.high[1] + reach});
}

/** \return how many points came to it */
std::size_t
Pieces::appendOfOctree(std::size_t input,
                       const std::vector<io::PointRange>& ranges,
                       Fragment& fragment,
                       ProgressMonitor* monitor) const
{
  const PlannedInput& planned = plan_.inputs[input];
  const std::size_t before = fragment.points.size();
  io::PointStream stream(planned.path, options_, block_size, nullptr, monitor);
  io::Cloud cloud;
  for (const io::PointRange& range : ranges) {
    std::size_t first = range.first;
    for (stream.seek(first, first + range.count); stream.next(cloud);
         first += cloud.points.size()) {
      forEachRecord(plan_,
                    planned,
                    classes_,
                    cloud,
                    first,
                    [&](const Record& record, const Point& world) {
                      bool near = false;
                      plan_.tiling.forEachNear(
                          world.x(), world.y(), plan_.reach(), [&](std::size_t number) {
                            near = near || number == fragment.number;
                          });
                      if (near)
                        put(record,
                            plan_.tiling.owner(world.x(), world.y()) == fragment.number,
                            fragment);
                    });
      throwIfCanceled(monitor);
    }
  }
  return fragment.points.size() - before;
}

void
Pieces::append(const Section& section, Fragment& fragment) const
{
  const std::string name = path(fragment.number, section.input);
  const File file(std::fopen(name.c_str(), "rb"));
  std::vector<Record> block(65536);
  std::size_t got = 0;
  while (file &&
         (got = std::fread(block.data(), sizeof(Record), block.size(), file.get())) > 0)
    for (std::size_t i = 0; i < got; ++i) {
      const Record& record = block[i];
      const Point world = Point(record.x, record.y, record.z) + plan_.shift;
      put(record,
          plan_.tiling.owner(world.x(), world.y()) == fragment.number,
          fragment);
    }
  if (fragment.points.size() != section.first + section.count)
    throw io::FileError(name + ": cannot be read; check its disk");
}

void
Pieces::refuseIfDone(std::size_t fragment) const
{
  if (ledger_.done(Ledger::task, fragment))
    throw io::FileError("fragment " + std::to_string(fragment) +
                        " was done by another worker in the meantime");
}

std::uint64_t
Pieces::require(std::size_t input, std::size_t fragment, ProgressMonitor* monitor) const
{
  const auto points = [&]() -> std::optional<std::uint64_t> {
    refuseIfDone(fragment);
    const auto entry = ledger_.find(Ledger::cut, input);
    if (!entry)
      return {};
    if (!entry->done)
      throw io::FileError(entry->reason);
    const auto piece = entry->pieces.find(fragment);
    if (piece == entry->pieces.end())
      return 0;
    std::error_code error;
    const auto bytes = fs::file_size(path(fragment, input), error);
    if (error || bytes != piece->second * sizeof(Record))
      return {};
    return piece->second;
  };
  if (const auto known = points())
    return *known;
  // Not cut yet, or by now without this piece.
  const WorkLock lock(ledger_.path(Ledger::cut, input));
  if (const auto known = points())
    return *known;
  cutOrTellWhyNot(input, monitor);
  if (const auto known = points())
    return *known;
  throw io::FileError(path(fragment, input) + ": cannot be read back");
}

void
Pieces::cutOrTellWhyNot(std::size_t input, ProgressMonitor* monitor) const
{
  for (const bool again : {false, true})
    try {
      return cut(input, monitor);
    }
    catch (const Canceled&) {
      throw;
    }
    catch (const std::exception& error) {
      if (!again)
        continue;
      Ledger::Entry entry;
      entry.reason = error.what();
      ledger_.write(Ledger::cut, input, entry); // other fragments need not try
      throw;
    }
}

Fragment
Pieces::load(std::size_t number, ProgressMonitor* monitor) const
{
  Fragment fragment;
  fragment.number = number;
  const std::vector<std::size_t> inputs = plan_.inputsOf(number);
  std::vector<std::uint64_t> counts; // of octrees, no less
  std::vector<Ranges> octrees;
  std::uint64_t all = 0;
  for (const std::size_t input : inputs) {
    octrees.push_back(octreeRanges(input, number));
    std::uint64_t count = 0;
    if (octrees.back())
      for (const io::PointRange& range : *octrees.back())
        count += range.count;
    else
      count = require(input, number, monitor);
    counts.push_back(count);
    all += count;
  }
  fragment.points.reserve(all);
  fragment.classes.reserve(all);
  fragment.returns.reserve(all);
  fragment.places.reserve(all);
  fragment.core.reserve(all);
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    Section section{inputs[k], fragment.points.size(), counts[k]};
    if (octrees[k])
      section.count = appendOfOctree(inputs[k], *octrees[k], fragment, monitor);
    else if (section.count > 0)
      append(section, fragment);
    if (section.count > 0)
      fragment.sections.push_back(section);
  }
  // Who cuts an input anew leaves out what is done by then: no points, but no error.
  refuseIfDone(number);
  return fragment;
}

void
Pieces::remove(std::size_t number) const
{
  std::error_code ignored;
  fs::remove_all(fs::path(path(number, 0)).parent_path(), ignored);
}

} // namespace linelet::fragments
