#include "shader_compiler/isolated_work.hpp"

#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace lavaray {
namespace {

using Send = IsolatedWork::Send;

constexpr std::size_t kLarge = std::size_t{64} << 20U;

// Each request is a way to end.
void work(const std::string& request, const Send& send) {
  send("begun ");
  if (request == "abort") std::abort();
  if (request == "segmentation fault") std::raise(SIGSEGV);
  if (request == "kill") std::raise(SIGKILL);
  if (request == "exit") std::exit(0);
  if (request == "throw") throw std::runtime_error("no message");
  if (request == "Ctrl-C") {  // of which all processes of a terminal hear
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      kill(getppid(), signal);
      std::raise(signal);
    }
  }
  if (request == "kill the server") kill(getppid(), SIGKILL);
  if (request == "print") {
    std::puts("stdout is the program's");
    std::fputs("stderr, too", stderr);
    std::fflush(stdout);
  }
  if (request == "large") send(std::string(kLarge, 'x'));
  if (request == "much memory") {
    const rlimit limit{std::size_t{256} << 20U, std::size_t{256} << 20U};
    setrlimit(RLIMIT_AS, &limit);
    std::vector<std::unique_ptr<char[]>> blocks;
    for (;;) blocks.push_back(std::make_unique<char[]>(std::size_t{1} << 20U));
  }
  send("and done");
}

class IsolatedWorkTest : public testing::Test {
 protected:
  IsolatedWork isolated_{[] {}, work};
};

TEST_F(IsolatedWorkTest, ReturnsWhatIsSent) {
  const auto [sent, failure] = isolated_.run("");
  EXPECT_EQ(sent, "begun and done");
  EXPECT_EQ(failure, "");
}

TEST_F(IsolatedWorkTest, ReturnsLargeResults) {
  const auto [sent, failure] = isolated_.run("large");
  EXPECT_EQ(sent.size(), kLarge + std::string_view("begun and done").size());
  EXPECT_EQ(failure, "");
  EXPECT_EQ(isolated_.run(std::string(kLarge, 'x')).failure, "");
}

TEST_F(IsolatedWorkTest, SurvivesEachWayToEnd) {
  const std::pair<const char*, const char*> kEnds[] = {
      {"abort", "aborted"},
      {"kill", "killed"},
      {"exit", "it gave up"},
      {"throw", "it gave up"},
#ifndef __SANITIZE_ADDRESS__  // which makes other ends of these
      {"segmentation fault", "segmentation fault"},
      {"much memory", "out of memory"},
#endif
  };
  for (const auto& [request, end] : kEnds) {
    const auto [sent, failure] = isolated_.run(request);
    EXPECT_EQ(sent, "begun ") << request;
    EXPECT_EQ(failure, end) << request;
    EXPECT_EQ(isolated_.run("").sent, "begun and done") << "after " << request;
  }
}

TEST_F(IsolatedWorkTest, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  // Forked while they are captured, so that they are its own streams.
  IsolatedWork isolated([] {}, work);
  EXPECT_EQ(isolated.run("print").failure, "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(IsolatedWorkTest, PreparesOnce) {
  int prepared = 0;
  IsolatedWork isolated([&] { ++prepared; },
                        [&](const std::string&, const Send& send) { send(std::to_string(prepared++)); });
  for (int i = 0; i < 3; ++i) EXPECT_EQ(isolated.run("").sent, "1");
  EXPECT_EQ(prepared, 0) << "in this process";
}

TEST_F(IsolatedWorkTest, ALostServerIsAFailure) {
  EXPECT_EQ(isolated_.run("kill the server").failure, "killed");
  EXPECT_EQ(isolated_.run("").failure, "killed");
  IsolatedWork unprepared([] { std::abort(); }, work);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(unprepared.run("").failure, "aborted");
}

TEST_F(IsolatedWorkTest, DoesNotEndWithACtrlC) {
  for (int i = 0; i < 2; ++i) EXPECT_EQ(isolated_.run("Ctrl-C").sent, "begun and done");
}

// Wherever the other threads are when it is asked for: the processes are not forked from this one.
TEST_F(IsolatedWorkTest, WorksBesideThreadsThatLock) {
  std::atomic<bool> isOver{false};
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
      while (!isOver) {
        if (void* library = dlopen("libm.so.6", RTLD_NOW)) dlclose(library);
        const std::unique_ptr<char[]> block(new char[100000]);
        std::fputs("", stdout);
      }
    });
  }
  for (int i = 0; i < 300; ++i) EXPECT_EQ(isolated_.run("").sent, "begun and done");
  isOver = true;
  for (std::thread& thread : threads) thread.join();
}

// Even where it was in the middle of its work and had no time for a farewell.
TEST_F(IsolatedWorkTest, NothingIsLeftOfAKilledProgram) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t program = fork();
  ASSERT_GE(program, 0);
  if (program == 0) {
    close(ends[0]);
    IsolatedWork isolated([] {}, [](const std::string&, const Send&) { pause(); });
    // The work has the pipe, too, until it ends.
    (void)!write(ends[1], "x", 1);
    (void)isolated.run("");
    _exit(0);
  }
  close(ends[1]);
  char byte = 0;
  ASSERT_EQ(read(ends[0], &byte, 1), 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  ASSERT_EQ(kill(program, SIGKILL), 0);
  EXPECT_EQ(waitpid(program, nullptr, 0), program);
  EXPECT_EQ(read(ends[0], &byte, 1), 0);  // waits for the last of them
  close(ends[0]);
}

}  // namespace
}  // namespace lavaray
