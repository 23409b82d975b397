// What is on the disk after a write, above all after one that failed.
#include <dlfcn.h>
#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>

#include "drawings/files/left_drafts.h"
#include "drawings/output.h"
#include "tests/support/catch.h"

using namespace epure::drawings;
namespace fs = std::filesystem;

// The calls of the program, and of its libraries, come through here: a program's own functions are found first.
namespace {
struct Fault {
  std::string call;         // "write", "fsync", ...; empty: none
  int after = 0;            // so many calls succeed first
  int error = 0;            // errno; 0: the signal instead
  std::size_t at_most = 0;  // write takes no more bytes at once; 0: all
  int signal = SIGKILL;
  bool to_process = false;  // the signal: to whichever thread takes it
} fault;

bool strikes(const char* call) {
  if (fault.call != call || fault.after-- > 0) return false;
  if (fault.error == 0) return (fault.to_process ? kill(getpid(), fault.signal) : raise(fault.signal)) != 0;
  errno = fault.error;
  return true;
}

template <class Call>
Call* of_the_system(const char* name) {
  return reinterpret_cast<Call*>(dlsym(RTLD_NEXT, name));
}
ssize_t write_really(int file, const void* bytes, size_t count) {
  static auto* const call = of_the_system<ssize_t(int, const void*, size_t)>("write");
  return call(file, bytes, count);
}
}  // namespace

extern "C" {
ssize_t write(int file, const void* bytes, size_t count) {
  if (strikes("write")) {
    if (fault.error == EINTR) fault = {};
    return -1;
  }
  return write_really(file, bytes, fault.at_most ? std::min(count, fault.at_most) : count);
}
int fsync(int file) {
  static auto* const call = of_the_system<int(int)>("fsync");
  return strikes("fsync") ? -1 : call(file);
}
int close(int file) {
  static auto* const call = of_the_system<int(int)>("close");
  const int result = call(file);
  return strikes("close") ? -1 : result;
}
int rename(const char* from, const char* to) noexcept {
  static auto* const call = of_the_system<int(const char*, const char*)>("rename");
  return strikes("rename") ? -1 : call(from, to);
}
int linkat(int in, const char* from, int to_in, const char* to, int flags) noexcept {
  static auto* const call = of_the_system<int(int, const char*, int, const char*, int)>("linkat");
  return strikes("linkat") ? -1 : call(in, from, to_in, to, flags);
}
int fchmod(int file, mode_t mode) noexcept {
  static auto* const call = of_the_system<int(int, mode_t)>("fchmod");
  return strikes("fchmod") ? -1 : call(file, mode);
}
}

namespace {

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "epure-test-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()));
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator{}));
  }

 private:
  fs::path path_;
};

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}
void put(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }
mode_t mode(const fs::path& path) {
  struct stat found;
  REQUIRE(stat(path.c_str(), &found) == 0);
  return found.st_mode & 07777;
}

std::string refusal(const fs::path& path, std::string_view bytes) {
  try {
    write_whole(path, bytes);
  } catch (const CannotWrite& error) {
    return error.what();
  }
  return "";
}

// Catch2 tells of a signal with much work on a small stack; what is tried here ends as the program does.
void end_at_signals() {
  for (const int by : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(by, SIG_DFL);
}

// Runs in a process of its own; returns what it returned, or how it ended.
std::string in_child(const std::function<std::string()>& work) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    end_at_signals();
    const std::string said = work();
    fault = {};
    _exit(write_really(ends[1], said.data(), said.size()) < 0);
  }
  ::close(ends[1]);
  std::string said;
  char part[4096];
  for (ssize_t count; (count = ::read(ends[0], part, sizeof part)) > 0;)
    said.append(part, static_cast<size_t>(count));
  ::close(ends[0]);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  if (WIFSIGNALED(status)) return "killed by signal " + std::to_string(WTERMSIG(status));
  return said;
}

// Devices of the machine are at stake where the program goes wrong: renaming over /dev/null must then be beyond it.
std::string unprivileged(const std::function<std::string()>& work) {
  return in_child([&]() -> std::string {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0))
      return "cannot change the user";
    return work();
  });
}

const std::string old_bytes = "the old drawing", new_bytes(300'000, 'n');

}  // namespace

TEST_CASE("a file is written whole, into folders made for it") {
  const Folder folder;
  const fs::path path = folder / "a" / "b" / "drawing.pdf";
  write_whole(path, new_bytes);
  CHECK(contents(path) == new_bytes);
  CHECK(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator{}) == 1);
  write_whole(path, "");
  CHECK(contents(path).empty());
  write_whole(path, std::string("\0\n\xFF", 3));
  CHECK(contents(path) == std::string("\0\n\xFF", 3));
}

TEST_CASE("a path without a folder is the working directory") {
  const Folder folder;
  CHECK(in_child([&] {
          if (chdir(folder.path().c_str()) != 0) return std::string("chdir");
          return refusal("drawing.svg", new_bytes);
        }) == "");
  CHECK(contents(folder / "drawing.svg") == new_bytes);
}

TEST_CASE("a new file follows the umask, an old one keeps its permissions") {
  const Folder folder;
  const mode_t before = umask(022);
  write_whole(folder / "open", "x");
  umask(077);
  write_whole(folder / "closed", "x");
  write_whole(folder / "open", "y");
  umask(before);
  CHECK(mode(folder / "open") == 0644);
  CHECK(mode(folder / "closed") == 0600);
  CHECK(contents(folder / "open") == "y");
  REQUIRE(chmod((folder / "closed").c_str(), 0664) == 0);
  write_whole(folder / "closed", "z");
  CHECK(mode(folder / "closed") == 0664);
}

TEST_CASE("a link stays a link, and the file behind it is written") {
  const Folder folder;
  fs::create_directory(folder / "real");
  put(folder / "real" / "old.pdf", old_bytes);
  fs::create_symlink("real/old.pdf", folder / "link.pdf");
  fs::create_symlink("link.pdf", folder / "twice.pdf");
  write_whole(folder / "twice.pdf", new_bytes);
  CHECK(fs::is_symlink(folder / "twice.pdf"));
  CHECK(fs::is_symlink(folder / "link.pdf"));
  CHECK(contents(folder / "real" / "old.pdf") == new_bytes);

  fs::create_symlink("real/new.pdf", folder / "dangling.pdf");
  write_whole(folder / "dangling.pdf", "fresh");
  CHECK(fs::is_symlink(folder / "dangling.pdf"));
  CHECK(contents(folder / "real" / "new.pdf") == "fresh");

  fs::create_symlink("circle.pdf", folder / "circle.pdf");
  CHECK_THAT(refusal(folder / "circle.pdf", "x"), Contains("circle.pdf") && Contains("symbolic links"));
}

TEST_CASE("what cannot be a file is refused with its path and the reason") {
  const Folder folder;
  put(folder / "file", "x");
  CHECK_THAT(refusal(folder.path(), "x"), Contains(folder.path().string()) && Contains("Is a directory"));
  CHECK_THAT(refusal(folder / "new/", "x"), Contains("new/") && Contains("Is a directory"));
  CHECK_THAT(refusal(folder / "file" / "drawing.pdf", "x"),
             Contains("file/drawing.pdf") && Contains("Not a directory"));
  CHECK_THAT(refusal("", "x"), Contains("empty"));
  CHECK_THAT(refusal("/proc/nowhere/drawing.pdf", "x"), Contains("/proc/nowhere"));
  CHECK_THAT(refusal(folder / std::string(300, 'x'), "x"), Contains("name too long"));
  CHECK(folder.entries() == 1);
}

TEST_CASE("a full device is reported, and stays a device") {
  CHECK_THAT(unprivileged([] { return refusal("/dev/full", new_bytes); }),
             Contains("/dev/full") && Contains("No space left on device"));
  CHECK(fs::is_character_file("/dev/full"));
  CHECK(unprivileged([] { return refusal("/dev/null", new_bytes); }) == "");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("whatever fails, the old file is unharmed and nothing is left beside it") {
  struct Case {
    Fault fault;
    std::string says;
  };
  for (const auto& [injected, says] : std::vector<Case>{{{"write", 0, ENOSPC}, "No space left"},
                                                        {{"write", 3, EIO, 50'000}, "Input/output error"},
                                                        {{"write", 5, EDQUOT, 50'000}, "quota"},
                                                        {{"fsync", 0, EIO}, "Input/output error"},
                                                        {{"fsync", 0, ENOSPC}, "No space left"},
                                                        {{"close", 0, ENOSPC}, "No space left"},
                                                        {{"fchmod", 0, EPERM}, "not permitted"},
                                                        {{"linkat", 0, ENOSPC}, "No space left"},
                                                        {{"rename", 0, EACCES}, "Permission denied"}}) {
    CAPTURE(injected.call, injected.after, injected.error);
    const Folder folder;
    put(folder / "drawing.pdf", old_bytes);
    fault = injected;
    const std::string said = refusal(folder / "drawing.pdf", new_bytes);
    fault = {};
    CHECK_THAT(said, Contains((folder / "drawing.pdf").string()) && Contains(says));
    CHECK(contents(folder / "drawing.pdf") == old_bytes);
    CHECK(folder.entries() == 1);
  }
}

TEST_CASE("short writes and interruptions are no failure") {
  const Folder folder;
  fault = {"write", 2, EINTR, 1000};
  const std::string said = refusal(folder / "drawing.pdf", new_bytes);
  fault = {};
  CHECK(said.empty());
  CHECK(contents(folder / "drawing.pdf") == new_bytes);
  fault = {"", 0, 0, 777};
  write_whole(folder / "drawing.pdf", new_bytes + "!");
  fault = {};
  CHECK(contents(folder / "drawing.pdf") == new_bytes + "!");
  for (const int unsupported : {EINVAL, ENOSYS, ENOTSUP}) {
    fault = {"fsync", 0, unsupported};
    const std::string unsynced = refusal(folder / "drawing.pdf", new_bytes);
    fault = {};
    CHECK(unsynced.empty());
    CHECK(contents(folder / "drawing.pdf") == new_bytes);
  }
}

TEST_CASE("killed at any moment, the old file or the new one is whole, and up to the renaming nothing is left") {
  for (const Fault& kill : {Fault{"write", 2, 0, 1000}, Fault{"fsync", 0}, Fault{"linkat", 0}, Fault{"rename", 0}}) {
    CAPTURE(kill.call);
    const Folder folder;
    put(folder / "drawing.pdf", old_bytes);
    CHECK(in_child([&] {
            fault = kill;
            return refusal(folder / "drawing.pdf", new_bytes);
          }) == "killed by signal " + std::to_string(SIGKILL));
    CHECK(contents(folder / "drawing.pdf") == old_bytes);
    CHECK(folder.entries() == (kill.call == "rename" ? 2 : 1));
    // What the killed one left does not stand in the way.
    write_whole(folder / "drawing.pdf", new_bytes);
    CHECK(contents(folder / "drawing.pdf") == new_bytes);
  }
}

// Also where drafts have names from the beginning, as without /proc.
TEST_CASE("interrupted at any moment, nothing is left, and no file is replaced without the others") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    for (const bool names : {false, true})
      for (const char* call : {"write", "fsync", "linkat", "close", "rename"})
        for (const int after : {0, 1, 2, 3}) {
          if (names && call == std::string_view("linkat")) continue;
          CAPTURE(signal, names, call, after);
          const Folder folder;
          std::vector<File> files;
          for (const char* name : {"a.svg", "b.svg", "c.svg"}) {
            put(folder / name, old_bytes);
            files.push_back({folder / name, new_bytes});
          }
          const std::string ended = in_child([&]() -> std::string {
            if (names &&
                (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
                 mount("tmpfs", "/proc", "tmpfs", 0, "size=64k") != 0))
              return "cannot mount";
            fault = {call, after, 0, 100'000, signal};
            write_whole(files);
            return "not interrupted";
          });
          if (ended == "cannot mount") continue;
          CHECK((ended == "killed by signal " + std::to_string(signal) || ended == "not interrupted"));
          CHECK(folder.entries() == 3);
          for (const File& file : files) CHECK(contents(file.path) == contents(files.front().path));
        }
}

// The system gives a signal to any thread that lets it through, such as one that a library keeps.
TEST_CASE("interrupted beside another thread, nothing is left") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    for (const char* call : {"linkat", "rename"}) {
      CAPTURE(signal, call);
      const Folder folder;
      put(folder / "a.svg", old_bytes);
      const std::string ended = in_child([&]() -> std::string {
        std::thread([] {
          for (;;) pause();
        }).detach();
        sigset_t held;  // the calling thread does not take it: the other one does
        sigemptyset(&held);
        sigaddset(&held, signal);
        pthread_sigmask(SIG_BLOCK, &held, nullptr);
        fault = {call, 0, 0, 0, signal, true};
        write_whole(folder / "a.svg", new_bytes);
        pthread_sigmask(SIG_UNBLOCK, &held, nullptr);
        return "not interrupted";
      });
      CHECK(ended == "killed by signal " + std::to_string(signal));
      CHECK(folder.entries() == 1);
    }
}

TEST_CASE("a file that is replaced keeps its owner where the system allows it") {
  const Folder folder;
  put(folder / "drawing.pdf", old_bytes);
  if (geteuid() != 0) return;  // only root can give files away
  REQUIRE(chown((folder / "drawing.pdf").c_str(), 12345, 54321) == 0);
  REQUIRE(chmod((folder / "drawing.pdf").c_str(), 0640) == 0);
  write_whole(folder / "drawing.pdf", new_bytes);
  struct stat found;
  REQUIRE(stat((folder / "drawing.pdf").c_str(), &found) == 0);
  CHECK(found.st_uid == 12345);
  CHECK(found.st_gid == 54321);
  CHECK(mode(folder / "drawing.pdf") == 0640);
}

TEST_CASE("more files at once than may be open by default") {
  const Folder folder;
  CHECK(in_child([&]() -> std::string {
          const rlimit few{40, 400};
          if (setrlimit(RLIMIT_NOFILE, &few) != 0) return "cannot limit";
          std::vector<File> files;
          for (int i = 0; i < 100; ++i) files.push_back({folder / std::to_string(i), "x"});
          write_whole(files);
          return "good";
        }) == "good");
  CHECK(folder.entries() == 100);
}

TEST_CASE("the limit of open files stays as it is where it is wide enough") {
  const Folder folder;
  CHECK(in_child([&]() -> std::string {
          rlimit limit{100, 400};
          if (setrlimit(RLIMIT_NOFILE, &limit) != 0) return "cannot limit";
          write_whole({{folder / "a", "x"}, {folder / "b", "x"}});
          getrlimit(RLIMIT_NOFILE, &limit);
          return std::to_string(limit.rlim_cur);
        }) == "100");
}

TEST_CASE("whether a folder takes files is found out without a trace") {
  const Folder folder;
  demand_writable(folder / "new" / "deep");
  CHECK(fs::is_empty(folder / "new" / "deep"));
  put(folder / "file", "x");
  CHECK_THROWS_AS(demand_writable(folder / "file"), CannotWrite);
  CHECK_THROWS_AS(demand_writable("/proc/nowhere"), CannotWrite);
}

TEST_CASE("a file that happens to have the temporary name is not touched") {
  const Folder folder;
  constexpr int traps = 900;
  CHECK(in_child([&] {
          for (int i = 1; i <= traps; ++i)
            put(folder / (".epure-" + std::to_string(getpid()) + "-" + std::to_string(i) + ".part"), "precious");
          return refusal(folder / "drawing.pdf", new_bytes);
        }) == "");
  CHECK(contents(folder / "drawing.pdf") == new_bytes);
  CHECK(folder.entries() == traps + 1);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path().filename() != "drawing.pdf" && contents(entry.path()) != "precious") FAIL(entry.path());
}

TEST_CASE("drafts of processes that are no more are cleared away, and nothing else") {
  const Folder folder;
  const auto draft = [&](const std::string& process, const std::string& rest) {
    return folder / (".epure-" + process + rest);
  };
  const std::string gone = in_child([] { return std::to_string(getpid()); }), here = std::to_string(getpid());
  for (const char* rest : {"-1.part", "-27.part"}) put(draft(gone, rest), old_bytes);
  std::vector<fs::path> others = {draft(here, "-1.part"), draft("1", "-1.part"), draft("0", "-1.part"),
                                  draft("-1", "-1.part"), folder / "drawing.pdf"};
  for (const char* rest : {"-01.part", "-1.part~", "-1", "-.part", "-1.pdf"}) others.push_back(draft(gone, rest));
  for (const fs::path& each : others) put(each, "precious");
  remove_left_drafts(folder.path());
  CHECK(folder.entries() == others.size());
  for (const fs::path& each : others) CHECK(contents(each) == "precious");
  remove_left_drafts(folder / "nowhere");
  put(draft(gone, "-2.part"), old_bytes);
  write_whole(folder / "new.pdf", new_bytes);  // which clears them away too
  CHECK(folder.entries() == others.size() + 1);
}

TEST_CASE("a limit on the size of files is an error, not the end of the program") {
  const Folder folder;
  put(folder / "drawing.pdf", old_bytes);
  CHECK_THAT(in_child([&] {
               const rlimit limit{100'000, 100'000};
               setrlimit(RLIMIT_FSIZE, &limit);
               signal(SIGXFSZ, SIG_DFL);
               return refusal(folder / "drawing.pdf", new_bytes);
             }),
             Contains("drawing.pdf") && Contains("File too large"));
  CHECK(contents(folder / "drawing.pdf") == old_bytes);
  CHECK(folder.entries() == 1);
}

TEST_CASE("a really full disk and one that is mounted read-only") {
  const Folder folder;
  const std::string answer = in_child([&]() -> std::string {
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
      return "cannot mount";
    put(folder / "drawing.pdf", old_bytes);
    std::string said = refusal(folder / "drawing.pdf", new_bytes);
    if (said.find("No space left on device") == said.npos) return "full: " + said;
    if (contents(folder / "drawing.pdf") != old_bytes || folder.entries() != 1) return "full: the old file is harmed";
    if (mount("tmpfs", folder.path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "") != 0) return "cannot mount";
    said = refusal(folder / "drawing.pdf", "x");
    if (said.find("Read-only file system") == said.npos) return "read-only: " + said;
    if (contents(folder / "drawing.pdf") != old_bytes) return "read-only: the old file is harmed";
    return "good";
  });
  if (answer == "cannot mount")
    WARN("this test may not mount a file system here: a full disk was only simulated");
  else
    CHECK(answer == "good");
}

TEST_CASE("folders and files protected against writing stay as they are") {
  const Folder folder;
  fs::create_directory(folder / "protected");
  fs::create_directory(folder / "own");
  put(folder / "protected" / "drawing.pdf", old_bytes);
  put(folder / "own" / "drawing.pdf", old_bytes);
  REQUIRE(chmod(folder.path().c_str(), 0755) == 0);
  REQUIRE(chmod((folder / "own").c_str(), 0777) == 0);
  REQUIRE(chmod((folder / "own" / "drawing.pdf").c_str(), 0444) == 0);
  REQUIRE(chmod((folder / "protected" / "drawing.pdf").c_str(), 0666) == 0);
  REQUIRE(chmod((folder / "protected").c_str(), 0555) == 0);
  for (const auto& path : {folder / "protected" / "drawing.pdf", folder / "protected" / "new" / "drawing.pdf",
                           folder / "own" / "drawing.pdf"})
    CHECK_THAT(unprivileged([&] { return refusal(path, new_bytes); }),
               Contains(path.string()) && Contains("Permission denied"));
  CHECK(contents(folder / "protected" / "drawing.pdf") == old_bytes);
  CHECK(contents(folder / "own" / "drawing.pdf") == old_bytes);
  REQUIRE(chmod((folder / "protected").c_str(), 0755) == 0);
}

TEST_CASE("standard output takes everything or says why not") {
  const Folder folder;
  const auto with_output = [](const fs::path& output, int flags, const fs::path& target) {
    const int opened = open(output.c_str(), flags | O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    REQUIRE(opened >= 0);
    const std::string said = unprivileged([&]() -> std::string {
      if (dup2(opened, STDOUT_FILENO) < 0) return "cannot redirect";
      return refusal(target, new_bytes);
    });
    ::close(opened);
    return said;
  };
  for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    CAPTURE(name);
    put(folder / "out", "before ");
    CHECK(with_output(folder / "out", O_APPEND, name) == "");
    CHECK(contents(folder / "out") == "before " + new_bytes);
    CHECK_THAT(with_output("/dev/full", 0, name), Contains("standard output") && Contains("No space left on device"));
  }
  CHECK_THAT(in_child([] {
               ::close(STDOUT_FILENO);
               return refusal("-", "x");
             }),
             Contains("standard output") && Contains("Bad file descriptor"));
  CHECK_THAT(in_child([]() -> std::string {
               int ends[2];
               if (pipe(ends) != 0) return "no pipe";
               dup2(ends[1], STDOUT_FILENO);
               ::close(ends[0]);
               signal(SIGPIPE, SIG_DFL);
               return refusal("-", new_bytes);
             }),
             Contains("standard output") && Contains("Broken pipe"));
  put(folder / "out", "");
  CHECK_THAT(in_child([&]() -> std::string {
               const int opened = open((folder / "out").c_str(), O_WRONLY);
               if (opened < 0 || dup2(opened, STDOUT_FILENO) < 0) return "cannot open";
               fault = {"fsync", 0, EIO};
               return refusal("-", "x");
             }),
             Contains("standard output") && Contains("Input/output error"));
  // A slow reader gets every byte.
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t writer = fork();
  REQUIRE(writer >= 0);
  if (writer == 0) {
    ::close(ends[0]);
    dup2(ends[1], STDOUT_FILENO);
    _exit(refusal("-", new_bytes).empty() ? 0 : 1);
  }
  ::close(ends[1]);
  std::size_t received = 0;
  char part[1000];
  for (ssize_t count; (count = ::read(ends[0], part, sizeof part)) > 0;) received += static_cast<std::size_t>(count);
  ::close(ends[0]);
  int status = -1;
  REQUIRE(waitpid(writer, &status, 0) == writer);
  CHECK(status == 0);
  CHECK(received == new_bytes.size());
}
