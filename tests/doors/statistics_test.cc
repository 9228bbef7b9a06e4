// When the statistics are written: once, at whatever end a process comes to, and never over another process's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "run.h"

namespace truequad::doors_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Ended ending(const std::vector<std::string>& pieces, const std::string& stats) {
  std::vector<std::string> words = {TRUEQUAD_COMMAND, "--stats", stats, TRUEQUAD_ENDING};
  words.insert(words.end(), pieces.begin(), pieces.end());
  return run(words);
}

// All of `quads` were corrected: the program draws no others.
void expect_quads(const fs::path& file, int quads) {
  ASSERT_TRUE(fs::exists(file)) << file;
  const json stats = json::parse(read_file(file), nullptr, false);
  ASSERT_TRUE(stats.is_object()) << read_file(file);
  EXPECT_EQ(stats.value("quads", -1), quads);
  EXPECT_EQ(stats.value("passed", -1), 0);
  EXPECT_EQ(stats.value("corrected", -1), quads);
  EXPECT_GE(stats.value("triangles", -1), 4 * quads);
}

int files_in(const Scratch& scratch) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(scratch.path())) ++count;
  return count;
}

TEST(Statistics, AreWrittenAtEveryEnd) {
  for (const char* end : {"return", "exit", "_exit", "_Exit", "quick_exit"}) {
    const Scratch scratch;
    const Ended ended = ending({"5", end}, scratch / "stats");
    EXPECT_EQ(ended.status, 3) << end;
    EXPECT_EQ(ended.err, "") << end;
    SCOPED_TRACE(end);
    expect_quads(scratch / "stats", 5);
    EXPECT_EQ(files_in(scratch), 1);
  }
}

TEST(Statistics, GoToStandardErrorForADash) {
  for (const char* end : {"return", "_exit"}) {
    const Ended ended = ending({"2", end}, "-");
    const json stats = json::parse(ended.err, nullptr, false);
    ASSERT_TRUE(stats.is_object()) << ended.err;
    EXPECT_EQ(stats.value("corrected", -1), 2);
    EXPECT_EQ(ended.out, "");
  }
}

TEST(Statistics, OfAProcessThatDrewNothingAreNotWritten) {
  for (const char* end : {"return", "_exit", "_Exit", "quick_exit"}) {
    const Scratch scratch;
    EXPECT_EQ(ending({end}, scratch / "stats").status, 3);
    EXPECT_EQ(files_in(scratch), 0) << end;
  }
}

TEST(Statistics, DoNotKeepAProcessFromDyingOfASignal) {
  const Scratch scratch;
  EXPECT_EQ(ending({"2", "abort"}, scratch / "stats").status, 128 + 6);
}

TEST(Statistics, OfAForkedChildStandBesideItsParents) {
  for (const char* child_end : {"exit", "_exit", "quick_exit"}) {
    SCOPED_TRACE(child_end);
    const Scratch scratch;
    EXPECT_EQ(ending({"3", "fork", "2", child_end, "joined", "1", "return"}, scratch / "stats").status, 3);
    expect_quads(scratch / "stats", 4);
    ASSERT_EQ(files_in(scratch), 2);
    for (const auto& entry : fs::directory_iterator(scratch.path())) {
      if (entry.path() != scratch / "stats") expect_quads(entry.path(), 2);
    }
  }
}

TEST(Statistics, OfAParentAreNotWrittenByAChildThatDrewNothing) {
  for (const char* parent_end : {"return", "_exit"}) {
    for (const std::vector<std::string>& child :
         {std::vector<std::string>{"fork", "_exit", "joined"}, {"fork", "exit", "joined"}, {"vfork"}}) {
      const Scratch scratch;
      std::vector<std::string> pieces = {"3"};
      pieces.insert(pieces.end(), child.begin(), child.end());
      pieces.insert(pieces.end(), {"1", parent_end});
      SCOPED_TRACE(child[0] + " " + (child.size() > 1 ? child[1] : ""));
      EXPECT_EQ(ending(pieces, scratch / "stats").status, 3);
      expect_quads(scratch / "stats", 4);
      EXPECT_EQ(files_in(scratch), 1);
    }
  }
}

// A program that starts another one: the shell has drawn nothing, and what the other drew stays.
TEST(Statistics, SurviveTheShellAroundTheProgram) {
  const Scratch scratch;
  const std::string program = TRUEQUAD_ENDING;
  const Ended ended =
      run({TRUEQUAD_COMMAND, "--stats", scratch / "stats", "sh", "-c", "true; " + program + " 5 return; true; exit 4"});
  EXPECT_EQ(ended.status, 4);
  expect_quads(scratch / "stats", 5);
  EXPECT_EQ(files_in(scratch), 1);
}

TEST(Statistics, OfAProgramThatBecomesAnotherAreTheOthers) {
  const Scratch scratch;
  EXPECT_EQ(ending({"3", "exec", "2", "exit"}, scratch / "stats").status, 3);
  expect_quads(scratch / "stats", 2);
  EXPECT_EQ(files_in(scratch), 1);
}

TEST(Statistics, OfARelativePathStayWhereTheProgramStarted) {
  const Scratch scratch;
  const Ended ended = run({"sh", "-c", "cd '" + scratch.path().string() + "' && '" TRUEQUAD_COMMAND "' --stats here '" +
                                           TRUEQUAD_ENDING + "' 2 return"});
  EXPECT_EQ(ended.status, 3);
  expect_quads(scratch / "here", 2);
}

// Not there, a directory, a full disk, a pipe that nobody reads, a file below a file.
TEST(Statistics, ThatCannotBeWrittenCostOneLine) {
  const Scratch scratch;
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  std::ofstream(scratch / "file") << "text";
  for (const std::string& path : {(scratch / "missing/directory").string(), scratch.path().string(), std::string("/dev/full"),
                                 (scratch / "pipe").string(), (scratch / "file/below").string()}) {
    for (const char* end : {"return", "_exit"}) {
      const Ended ended = ending({"2", end}, path);
      EXPECT_EQ(ended.status, 3) << path;
      EXPECT_THAT(ended.err, ::testing::StartsWith("truequad: cannot write the statistics to " + path));
      EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    }
  }
  EXPECT_EQ(read_file(scratch / "file"), "text");
  EXPECT_EQ(files_in(scratch), 2);  // nothing half written is left
}

// Whoever read the program's stderr went away. The program, which writes nothing there, ends as it would.
TEST(Statistics, DoNotEndAProgramWhoseStandardErrorNobodyReads) {
  for (const char* end : {"return", "_exit"}) {
    const std::string command = std::string("exec '" TRUEQUAD_COMMAND "' --stats - '" TRUEQUAD_ENDING "' 2 ") + end;
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(ends[0]);
      ::signal(SIGPIPE, SIG_DFL);
      ::dup2(ends[1], STDERR_FILENO);
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(99);
    }
    ::close(ends[0]);
    ::close(ends[1]);
    int state = 0;
    ASSERT_EQ(::waitpid(child, &state, 0), child);
    EXPECT_TRUE(WIFEXITED(state)) << "ended by signal " << WTERMSIG(state);
    EXPECT_EQ(WEXITSTATUS(state), 3);
  }
}

}  // namespace
}  // namespace truequad::doors_test
