#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "city_db/store.hpp"
#include "tests/support/city_equal.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"

/// What happens to the file when the world fails while it is written.
namespace vicus {
namespace {

using test::one_by_one;
using test::ScratchDirectory;
namespace fs = std::filesystem;

/// What went wrong, "" when nothing did.
template <class F>
std::string city_error(F&& call) {
  try {
    call();
  } catch (const CityError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> names_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// A city that takes some milliseconds to write, with its number in meta and in an artefact.
City numbered_city(int number) {
  City city = test::sample_city();
  city.meta["build"] = std::to_string(number);
  for (int copy = 0; copy < 2000; ++copy) city.borders.push_back(city.borders[static_cast<std::size_t>(copy) % 20]);
  return city;
}

void write_numbered(const fs::path& path, int number) {
  write_city(path, numbered_city(number),
             one_by_one({{"/build", "text/plain", "identity", "h", std::to_string(number)},
                         {"/big", "text/plain", "identity", "h", std::string(1'000'000, 'x')}}));
}

std::string quick_check(const fs::path& path) {
  sqlite3* db = nullptr;
  sqlite3_open_v2(path.c_str(), &db, SQLITE_OPEN_READONLY, nullptr);
  std::string result;
  const auto keep = [](void* out, int, char** values, char**) {
    *static_cast<std::string*>(out) += values[0];
    return 0;
  };
  sqlite3_exec(db, "PRAGMA quick_check", keep, &result, nullptr);
  sqlite3_close(db);
  return result;
}

void expect_whole(const fs::path& path) {
  EXPECT_EQ(quick_check(path), "ok");
  const City city = read_city(path);
  const int number = std::stoi(city.meta.at("build"));
  EXPECT_EQ(test::difference(city, numbered_city(number)), "");
  EXPECT_EQ(CityReader(path).artefact("/build", {"identity"})->body, std::to_string(number));
}

/// Builds over and over in a child, which is killed after `delay`.
void build_and_kill(const fs::path& path, int first_number, std::chrono::microseconds delay) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    for (int number = first_number;; ++number) write_numbered(path, number);
  }
  std::this_thread::sleep_for(delay);
  ASSERT_EQ(::kill(child, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(WriteCity, KilledAtAnyMomentLeavesTheOldOrTheNewCity) {
  ScratchDirectory scratch;
  const fs::path path = scratch / "city.gpkg";
  const auto start = std::chrono::steady_clock::now();
  write_numbered(path, 0);
  const auto once = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start);
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::printf("seed %u, one build %ld us\n", seed, static_cast<long>(once.count()));
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int64_t> delay(0, 3 * once.count() / 2);
  int left_behind = 0;
  for (int kill = 0; kill < 50; ++kill) {
    build_and_kill(path, 1000 * (kill + 1), std::chrono::microseconds(delay(random)));
    expect_whole(path);
    left_behind += names_in(scratch.path()).size() > 1;
  }
  EXPECT_GT(left_behind, 0) << "no kill hit a build at work: the test shows nothing";
  write_numbered(path, 1);
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{"city.gpkg"}) << "stale files stay";
  expect_whole(path);
}

TEST(WriteCity, RemovesOnlyTheStaleFilesOfItsOwnCity) {
  ScratchDirectory scratch;
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  const auto name = [](const char* city, pid_t pid) {
    return "." + std::string(city) + "." + std::to_string(pid) + ".tmp";
  };
  const std::vector<std::string> kept = {name("other.gpkg", child),
                                         name("city.gpkg", ::getppid()),
                                         ".city.gpkg.x.tmp",
                                         ".city.gpkg..tmp",
                                         ".city.gpkg.1",
                                         ".city.gpkg.99999999999999999999.tmp"};
  for (const auto& file : kept) test::write_bytes(scratch / file, "");
  test::write_bytes(scratch / name("city.gpkg", child), "");
  write_city(scratch / "city.gpkg", City{}, nullptr);
  auto expected = kept;
  expected.push_back("city.gpkg");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(names_in(scratch.path()), expected);
}

TEST(WriteCity, LeavesTheOldCityWhenAnArtefactFails) {
  ScratchDirectory scratch;
  write_numbered(scratch / "city.gpkg", 7);
  const auto fail = []() -> std::optional<Artefact> { throw CityError("no such texture"); };
  EXPECT_EQ(city_error([&] { write_city(scratch / "city.gpkg", City{}, fail); }), "no such texture");
  expect_whole(scratch / "city.gpkg");
  EXPECT_EQ(names_in(scratch.path()).size(), 1u);
}

TEST(WriteCity, SaysWhatToDoWhenTheTargetCannotBe) {
  ScratchDirectory scratch;
  const auto error = [&](const fs::path& path) { return city_error([&] { write_city(path, City{}, nullptr); }); };
  EXPECT_NE(error(scratch.path()).find(scratch.path().string() + ": it is a directory"), std::string::npos);
  EXPECT_NE(error(scratch / "no/city.gpkg").find("create it first"), std::string::npos);
  test::write_bytes(scratch / "file", "x");
  EXPECT_NE(error(scratch / "file/city.gpkg").find("is no directory"), std::string::npos);
  EXPECT_NE(error("/proc/city.gpkg").find("/proc/city.gpkg"), std::string::npos);
}

/// In a child as another user, as root may write everywhere.
TEST(WriteCity, NamesADirectoryItMayNotWriteTo) {
  ScratchDirectory scratch;
  fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (::getuid() == 0 && ::setuid(kNobody) != 0) ::_exit(3);
    const auto error = city_error([&] { write_city(scratch / "city.gpkg", City{}, nullptr); });
    ::_exit(error.find("Permission denied; choose a directory you may write to") != error.npos ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  fs::permissions(scratch.path(), fs::perms::owner_all);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

/// A limit on file size stands in for the full disk: write() fails in the same place.
TEST(WriteCity, LeavesTheOldCityWhenTheDiskIsFull) {
  ScratchDirectory scratch;
  const fs::path path = scratch / "city.gpkg";
  write_numbered(path, 7);
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{500'000, 500'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto error = city_error([&] { write_numbered(path, 8); });
    if (error.find("cannot write " + path.string()) == error.npos) ::_exit(1);
    ::_exit(error.find("free space there or choose another place") != error.npos ? 0 : 2);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  expect_whole(path);
  EXPECT_EQ(read_city(path).meta.at("build"), "7");
  EXPECT_EQ(names_in(scratch.path()).size(), 1u);
}

TEST(WriteCity, WorksForAwkwardFileNames) {
  ScratchDirectory scratch;
  for (const char* name : {"a?mode=rw.gpkg", "b#c.gpkg", "d e.gpkg", "Löwe%20&+.gpkg", "%41", "\xff\xfe"}) {
    SCOPED_TRACE(name);
    const City city = numbered_city(3);
    write_city(scratch / name, city, nullptr);
    EXPECT_EQ(test::difference(read_city(scratch / name), city), "");
    EXPECT_EQ(CityReader(scratch / name).sector_ids().size(), 7u);
  }
  EXPECT_EQ(names_in(scratch.path()).size(), 6u);
}

TEST(WriteCity, TakesARelativePath) {
  ScratchDirectory scratch;
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path());
  write_city("city.gpkg", numbered_city(4), nullptr);
  EXPECT_EQ(read_city("city.gpkg").meta.at("build"), "4");
  fs::current_path(before);
}

TEST(CityReader, KeepsReadingTheOldCityAfterANewOneTookItsPlace) {
  ScratchDirectory scratch;
  write_numbered(scratch / "city.gpkg", 1);
  CityReader old(scratch / "city.gpkg");
  write_numbered(scratch / "city.gpkg", 2);
  EXPECT_EQ(old.meta("build"), "1");
  EXPECT_EQ(old.artefact("/build", {"identity"})->body, "1");
  old = CityReader(scratch / "city.gpkg");
  EXPECT_EQ(old.meta("build"), "2");
}

}  // namespace
}  // namespace vicus
