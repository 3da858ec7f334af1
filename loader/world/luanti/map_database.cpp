#include <orris/world/luanti/map_database.h>

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include <orris/core/limits.h>

namespace orris {
namespace {

constexpr int kStepsAtOnce = 1000;
constexpr std::int64_t kStrideY = 1 << 12, kStrideZ = 1 << 24;

/// Nothing but reading the table of map blocks: no function, view or pragma.
int allowReading(void*, int action, const char* table, const char*, const char*, const char*) {
  if (action == SQLITE_SELECT) return SQLITE_OK;
  return action == SQLITE_READ && table && std::strcmp(table, "blocks") == 0 ? SQLITE_OK : SQLITE_DENY;
}

void shutIn(sqlite3* database) {
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  for (const int off : {SQLITE_DBCONFIG_ENABLE_TRIGGER, SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_TRUSTED_SCHEMA,
                        SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, SQLITE_DBCONFIG_DQS_DDL, SQLITE_DBCONFIG_DQS_DML})
    sqlite3_db_config(database, off, 0, nullptr);
  sqlite3_drop_modules(database, nullptr);  // virtual tables
  const std::pair<int, int> most[] = {
      {SQLITE_LIMIT_LENGTH, int(limits::kMapBlockBytes)}, {SQLITE_LIMIT_SQL_LENGTH, 100'000},
      {SQLITE_LIMIT_COLUMN, 100}, {SQLITE_LIMIT_EXPR_DEPTH, 100}, {SQLITE_LIMIT_ATTACHED, 0},
      {SQLITE_LIMIT_TRIGGER_DEPTH, 1}, {SQLITE_LIMIT_WORKER_THREADS, 0}};
  for (const auto& [what, value] : most) sqlite3_limit(database, what, value);
  sqlite3_exec(database, "PRAGMA query_only=1; PRAGMA cell_size_check=1; PRAGMA mmap_size=0", nullptr, nullptr, nullptr);
}

/// As a URI: the file is taken as one that nobody changes, so that nothing is locked, and no journal is looked for.
std::string readOnlyUri(const std::string& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '%' || c == '?' || c == '#')
      uri += fmt::format("%{:02x}", unsigned(c));
    else
      uri += c;
  }
  return uri + "?mode=ro&immutable=1";
}

bool isPlace(std::int64_t value) { return value >= kLowestMapBlock && value <= kHighestMapBlock; }

std::int64_t placeNumber(glm::ivec3 place) {
  return place.z * kStrideZ + place.y * kStrideY + place.x;
}

glm::ivec3 placeOfNumber(std::int64_t number) {
  const std::int64_t shifted = number - placeNumber(glm::ivec3(kLowestMapBlock));
  return glm::ivec3(int(shifted & 0xfff), int(shifted >> 12 & 0xfff), int(shifted >> 24 & 0xfff)) + kLowestMapBlock;
}

}  // namespace

struct MapDatabase::Parts {
  struct CloseDatabase {
    void operator()(sqlite3* opened) const { sqlite3_close_v2(opened); }
  };
  struct FinalizeQuery {
    void operator()(sqlite3_stmt* query) const { sqlite3_finalize(query); }
  };
  using Query = std::unique_ptr<sqlite3_stmt, FinalizeQuery>;

  /// What may still be spent on a database.
  struct MapBudget {
    std::size_t steps = limits::kMapSteps;
    sqlite3_int64 memoryBefore = sqlite3_memory_used();
    bool spent = false;

    static int spend(void* self) {
      auto& budget = *static_cast<MapBudget*>(self);
      budget.steps -= std::min(budget.steps, std::size_t(kStepsAtOnce));
      const bool full = sqlite3_memory_used() - budget.memoryBefore > sqlite3_int64(limits::kMapMemory);
      budget.spent = budget.spent || budget.steps == 0 || full;
      return budget.spent ? 1 : 0;
    }
  };

  MapBudget budget;
  std::unique_ptr<sqlite3, CloseDatabase> database;
  bool byNumber = false;  ///< one column for the place, as before 5.12
  Query held, bytes, all;

  std::string why() const {
    if (budget.spent) return "its database takes too much time or memory to read";
    return fmt::format("its database: {}", sqlite3_errmsg(database.get()));
  }
  Query prepare(const char* text) const {
    sqlite3_stmt* query = nullptr;
    sqlite3_prepare_v2(database.get(), text, -1, &query, nullptr);
    return Query(query);
  }
  bool prepareAll() {
    held = prepare("SELECT y FROM blocks WHERE x=?1 AND z=?2");
    if (held) {
      bytes = prepare("SELECT data FROM blocks WHERE x=?1 AND z=?2 AND y=?3 LIMIT 1");
      all = prepare("SELECT x, z FROM blocks LIMIT ?1");
    } else {
      byNumber = true;
      held = prepare("SELECT pos FROM blocks WHERE pos BETWEEN ?1 AND ?2 ORDER BY pos");
      bytes = prepare("SELECT data FROM blocks WHERE pos=?1 LIMIT 1");
      all = prepare("SELECT pos FROM blocks LIMIT ?1");
    }
    return held && bytes && all;
  }
  /// Why the table of map blocks cannot be asked; "" when it can.
  std::string refusal() const {
    // A view and a virtual table have no page of their own.
    const Query table = prepare("SELECT rootpage FROM sqlite_master WHERE type='table' AND name='blocks'");
    const int found = table ? sqlite3_step(table.get()) : sqlite3_errcode(database.get());
    if (found != SQLITE_ROW && found != SQLITE_DONE) return why();
    if (found == SQLITE_DONE || sqlite3_column_int64(table.get(), 0) <= 0) return "its database has no table \"blocks\"";
    const Query columns = prepare("PRAGMA table_xinfo(blocks)");
    while (columns && sqlite3_step(columns.get()) == SQLITE_ROW) {
      // An expression could take any time.
      if (sqlite3_column_int(columns.get(), 6) != 0) return "the table \"blocks\" of its database has computed columns";
    }
    return "";
  }

  /// Places of one row follow each other in x, then in y: what lies beside the wanted x is jumped over.
  bool addNumberedRow(int z, int lowX, int highX, std::vector<glm::ivec3>& places) {
    const std::int64_t end = placeNumber({highX, kHighestMapBlock, z});
    std::int64_t from = placeNumber({lowX, kLowestMapBlock, z});
    while (from <= end) {
      sqlite3_reset(held.get());
      sqlite3_bind_int64(held.get(), 1, from);
      sqlite3_bind_int64(held.get(), 2, end);
      int result = SQLITE_ROW;
      bool beside = false;
      while (!beside && (result = sqlite3_step(held.get())) == SQLITE_ROW) {
        const std::int64_t number = sqlite3_column_int64(held.get(), 0);
        if (number < from || number > end) return true;  // no number: sorted behind them
        const glm::ivec3 place = placeOfNumber(number);
        beside = place.x < lowX || place.x > highX;
        if (!beside) places.push_back(place);
        if (beside) from = placeNumber({lowX, place.x < lowX ? place.y : place.y + 1, z});
      }
      if (!beside) return result == SQLITE_DONE;
    }
    return true;
  }

  bool addColumn(int x, int z, std::vector<glm::ivec3>& places) {
    sqlite3_reset(held.get());
    sqlite3_bind_int(held.get(), 1, x);
    sqlite3_bind_int(held.get(), 2, z);
    int result = SQLITE_ROW;
    while ((result = sqlite3_step(held.get())) == SQLITE_ROW) {
      const std::int64_t y = sqlite3_column_int64(held.get(), 0);
      if (isPlace(y)) places.emplace_back(x, int(y), z);
    }
    return result == SQLITE_DONE;
  }
};

MapDatabase::MapDatabase(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MapDatabase::~MapDatabase() = default;

std::unique_ptr<MapDatabase> MapDatabase::open(const std::string& file, std::string& problem) {
  auto parts = std::make_unique<Parts>();
  sqlite3* database = nullptr;
  const int result = sqlite3_open_v2(readOnlyUri(file).c_str(), &database,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  parts->database.reset(database);
  if (result != SQLITE_OK) {
    problem = fmt::format("its database: {}", sqlite3_errstr(result));
    return nullptr;
  }
  sqlite3_progress_handler(database, kStepsAtOnce, Parts::MapBudget::spend, &parts->budget);
  shutIn(database);
  problem = parts->refusal();
  if (!problem.empty()) return nullptr;
  sqlite3_set_authorizer(database, allowReading, nullptr);
  if (!parts->prepareAll()) {
    problem = parts->why();
    return nullptr;
  }
  return std::unique_ptr<MapDatabase>(new MapDatabase(std::move(parts)));
}

bool MapDatabase::addRow(int z, int lowX, int highX, std::vector<glm::ivec3>& places, std::string& problem) {
  lowX = std::max(lowX, kLowestMapBlock);
  highX = std::min(highX, kHighestMapBlock);
  if (!isPlace(z) || lowX > highX) return true;
  bool read = true;
  if (parts_->byNumber)
    read = parts_->addNumberedRow(z, lowX, highX, places);
  else
    for (int x = lowX; x <= highX && read; ++x) read = parts_->addColumn(x, z, places);
  if (!read) problem = parts_->why();
  sqlite3_reset(parts_->held.get());
  return read;
}

std::vector<glm::ivec2> MapDatabase::firstColumns() {
  std::vector<glm::ivec2> columns;
  sqlite3_stmt* query = parts_->all.get();
  sqlite3_reset(query);
  sqlite3_bind_int64(query, 1, sqlite3_int64(limits::kMapPlaces));
  while (sqlite3_step(query) == SQLITE_ROW) {
    if (parts_->byNumber) {
      const glm::ivec3 place = placeOfNumber(sqlite3_column_int64(query, 0));
      columns.emplace_back(place.x, place.z);
    } else if (isPlace(sqlite3_column_int64(query, 0)) && isPlace(sqlite3_column_int64(query, 1))) {
      columns.emplace_back(sqlite3_column_int(query, 0), sqlite3_column_int(query, 1));
    }
  }
  sqlite3_reset(query);
  return columns;
}

std::optional<std::string> MapDatabase::bytesAt(glm::ivec3 place, std::string& problem) {
  sqlite3_stmt* query = parts_->bytes.get();
  sqlite3_reset(query);
  if (parts_->byNumber) {
    sqlite3_bind_int64(query, 1, placeNumber(place));
  } else {
    sqlite3_bind_int(query, 1, place.x);
    sqlite3_bind_int(query, 2, place.z);
    sqlite3_bind_int(query, 3, place.y);
  }
  const int result = sqlite3_step(query);
  std::optional<std::string> bytes;
  if (result == SQLITE_ROW) {
    const void* data = sqlite3_column_blob(query, 0);
    bytes.emplace(static_cast<const char*>(data), data ? std::size_t(sqlite3_column_bytes(query, 0)) : 0);
  } else if (result == SQLITE_TOOBIG) {
    problem = fmt::format("it has more than {} bytes", limits::kMapBlockBytes);
  } else {
    problem = result == SQLITE_DONE ? "its database has lost it" : parts_->why();
  }
  sqlite3_reset(query);
  return bytes;
}

}  // namespace orris
