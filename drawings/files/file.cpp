// Whole files or none.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "drawings/files/left_drafts.h"
#include "drawings/files/signals_later.h"
#include "drawings/files/system_words.h"
#include "drawings/output.h"
#include "drawings/stopwatch.h"

namespace epure::drawings {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const Words& where, const Words& why) {
  throw CannotWrite(Words{"cannot write ", "impossibile scrivere "} + where + ": " + why);
}
[[noreturn]] void fail(const std::string& where, int error) { fail({where, where}, system_words(error)); }

// A broken pipe and a file too large come as signals that would end the program; here they are to be errors.
class SignalsAsErrors {
 public:
  SignalsAsErrors() {
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &pipe_);
    sigaction(SIGXFSZ, &ignore, &size_);
  }
  ~SignalsAsErrors() {
    sigaction(SIGPIPE, &pipe_, nullptr);
    sigaction(SIGXFSZ, &size_, nullptr);
  }
  SignalsAsErrors(const SignalsAsErrors&) = delete;
  SignalsAsErrors& operator=(const SignalsAsErrors&) = delete;

 private:
  struct sigaction pipe_ = {}, size_ = {};
};

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  // Some file systems report only here that the bytes did not fit.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

// False, with errno set, when not all bytes could be written.
bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// Pipes, devices and a few file systems cannot sync; that is no failure.
bool sync(int descriptor) {
  int done;
  do done = ::fsync(descriptor);
  while (done != 0 && errno == EINTR);
  return done == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP || errno == EROFS;
}

// The file behind symbolic links, also when it does not exist yet.
fs::path behind_links(fs::path path) {
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(path, error)); ++links) {
    if (links == 40) fail(path.string(), ELOOP);
    const fs::path target = fs::read_symlink(path, error);
    if (error) fail(path.string(), error.value());
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  return path;
}

// The temporary name of a file that is written. The number tells apart drafts of one process.
std::string name_of_draft(pid_t process, unsigned number) {
  return fmt::format(".epure-{}-{}.part", process, number);
}

// Whose draft has this name; 0: it is the name of none.
pid_t process_of_draft(const std::string& name) {
  pid_t process = 0;
  unsigned number = 0;
  const bool is_read = std::sscanf(name.c_str(), ".epure-%d-%u.part", &process, &number) == 2;
  return is_read && process > 0 && name_of_draft(process, number) == name ? process : 0;
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

void make_folder(const fs::path& folder, const std::string& shown) {
  std::error_code error;
  fs::create_directories(folder, error);
  // A link to a folder counts as an error for some library versions; what matters is that there is a folder.
  std::error_code ignored;
  if (error && !fs::is_directory(folder, ignored))
    fail({shown, shown}, Words{"folder ", "cartella "} + folder.string() + (": " + system_words(error.value())));
}

int open_in_place(const fs::path& path) { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); }

void write_in_place(const fs::path& path, std::string_view bytes, const std::string& shown) {
  Descriptor file(open_in_place(path));
  if (file.number() < 0) fail(shown, errno);
  if (!write_all(file.number(), bytes) || !sync(file.number()) || !file.close()) fail(shown, errno);
}

// What is to be a file of `folder`. It has no name until it is complete, where the file system knows of such files:
// whatever ends the program then leaves nothing behind. Elsewhere it has a temporary name from the beginning. It is
// gone again unless it was kept.
class Draft {
 public:
  Draft(const fs::path& folder, const std::string& shown) : folder_(folder), shown_(shown), file_(create()) {}
  ~Draft() {
    if (has_name() && !kept_) ::unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  bool has_name() const { return !name_.empty(); }
  void add(std::string_view bytes) {
    if (!write_all(file_.number(), bytes)) fail(shown_, errno);
  }
  void fill(std::string_view bytes, const std::optional<struct stat>& old) {
    add(bytes);
    if (old) take_after(*old);
  }
  void secure() {
    if (!sync(file_.number())) fail(shown_, errno);
  }
  void name() {
    if (!has_name()) link();
    if (!file_.close()) fail(shown_, errno);
  }
  void keep_as(const fs::path& path) {
    if (::rename(name_.c_str(), path.c_str()) != 0) fail(shown_, errno);
    kept_ = true;
  }

 private:
  // Owner and permissions of the file that is replaced. Only root can give a file away; the owner is then whoever
  // writes it.
  void take_after(const struct stat& old) {
    if (::fchown(file_.number(), old.st_uid, old.st_gid) != 0 && errno != EPERM) fail(shown_, errno);
    if (::fchmod(file_.number(), old.st_mode & 0777) != 0) fail(shown_, errno);
  }

  // Modes are what the user's umask leaves of 0666.
  int create() {
    const int opened = nameless();
    return opened < 0 ? named() : opened;
  }
  int nameless() const {
    if (::access("/proc/self/fd", X_OK) != 0) return -1;  // it gets its name through there
    return ::open(folder_.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
  }
  int named() {
    int opened = -1;
    try_names([&](const fs::path& path) {
      opened = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
      return opened >= 0;
    });
    return opened;
  }
  void link() {
    const std::string here = fmt::format("/proc/self/fd/{}", file_.number());
    try_names([&](const fs::path& path) {
      return ::linkat(AT_FDCWD, here.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
    });
  }
  // Temporary names that nothing has yet.
  template <class Take>
  void try_names(Take take) {
    static std::atomic<unsigned> count = 0;
    for (int attempt = 0; attempt < 1000; ++attempt) {
      fs::path path = folder_ / name_of_draft(::getpid(), ++count);
      if (take(path)) {
        name_ = std::move(path);  // a copy may want memory, and what has its name would stay
        return;
      }
      if (errno != EEXIST) break;
    }
    fail(shown_, errno);
  }

  fs::path folder_;
  std::string shown_;
  fs::path name_;
  Descriptor file_;
  bool kept_ = false;
};

// Drafts without a name stay open until they get one: as many as the system lets us have.
void allow_open_files(std::size_t count) {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || count + 64 < limit.rlim_cur) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

// So that the new name survives a power cut; and a run that was killed leaves nothing beside it. Best effort: the
// file itself is already safe.
void tidy_folder(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) sync(opened.number());
  remove_left_drafts(folder);
}

// A draft for its place.
struct Pending {
  std::unique_ptr<Draft> draft;
  fs::path target;
  std::optional<struct stat> old;  // what it is to replace
};

// Nothing for what is written in place; throws for what cannot become a file.
std::optional<Pending> begin(const fs::path& path) {
  if (is_standard_output(path)) return std::nullopt;
  const std::string shown = path.string();
  if (path.empty()) fail({"a file", "un file"}, {"its name is empty", "il suo nome è vuoto"});
  struct stat old = {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (!exists && errno != ENOENT) fail(shown, errno);
  if (exists ? S_ISDIR(old.st_mode) : !path.has_filename()) fail(shown, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) return std::nullopt;
  // Renaming would replace a file that its owner has protected against writing.
  if (exists && ::access(path.c_str(), W_OK) != 0) fail(shown, errno);

  const fs::path target = behind_links(path), folder = folder_of(target);
  make_folder(folder, shown);
  return Pending{std::make_unique<Draft>(folder, shown), target, exists ? std::optional(old) : std::nullopt};
}

void write_special(const File& file) {
  if (!is_standard_output(file.path)) return write_in_place(file.path, file.bytes, file.path.string());
  if (!write_all(STDOUT_FILENO, file.bytes) || !sync(STDOUT_FILENO))
    fail({"to standard output", "sullo standard output"}, system_words(errno));
}

// A draft that has a name from the beginning is cleared away before Ctrl-C ends the program: it waits for the next
// piece.
class Growth : public GrowingFile::Way {
 public:
  explicit Growth(const fs::path& path) : shown_(path.string()) {
    undisturbed_.emplace();
    pending_ = begin(path);
    if (!pending_) device_ = std::make_unique<Descriptor>(open_in_place(path));
    if (device_ && device_->number() < 0) fail(shown_, errno);
    if (!pending_ || !pending_->draft->has_name()) undisturbed_.reset();
  }

  void write(std::string_view bytes) override {
    if (undisturbed_ && undisturbed_->is_interrupted()) {
      pending_.reset();
      undisturbed_.reset();  // which ends the program, as a rule
      fail(shown_, EINTR);
    }
    if (pending_)
      pending_->draft->add(bytes);
    else if (!write_all(device_->number(), bytes))
      fail(shown_, errno);
  }

  void finish() override {
    if (!pending_) {
      if (!sync(device_->number()) || !device_->close()) fail(shown_, errno);
      return;
    }
    pending_->draft->fill({}, pending_->old);
    pending_->draft->secure();
    if (!undisturbed_) undisturbed_.emplace();
    pending_->draft->name();
    pending_->draft->keep_as(pending_->target);
    tidy_folder(folder_of(pending_->target));
    undisturbed_.reset();
  }

 private:
  std::string shown_;
  SignalsAsErrors guard_;
  std::optional<SignalsLater> undisturbed_;
  std::optional<Pending> pending_;
  std::unique_ptr<Descriptor> device_;
};

}  // namespace

// Opened by its path, standard output would be written from its beginning, over what `>>` should keep; and a link to
// it leads on to the file behind it, which would be replaced.
bool is_standard_output(const fs::path& path) {
  if (path == "-") return true;
  const std::string own = fmt::format("/proc/{}/", ::getpid());
  std::error_code error;
  fs::path next = path;
  for (int links = 0; links < 40; ++links) {
    const fs::path folder = fs::canonical(folder_of(next), error);
    if (error) return false;
    if (next.filename() == "1" && folder.string().starts_with(own) && folder.filename() == "fd") return true;
    if (!fs::is_symlink(fs::symlink_status(next, error))) return false;
    const fs::path target = fs::read_symlink(next, error);
    if (error) return false;
    next = target.is_absolute() ? target : folder / target;
  }
  return false;
}

void write_whole(const std::vector<File>& files) {
  const Timed timed(Work::files);
  const SignalsAsErrors guard;
  allow_open_files(files.size());
  std::optional<SignalsLater> undisturbed;  // while something has, or may get, a name that must not stay
  bool any_name = false;
  std::vector<Pending> drafts;
  std::vector<const File*> special;
  for (const File& file : files) {
    if (!undisturbed) undisturbed.emplace();
    std::optional<Pending> pending = begin(file.path);
    any_name = any_name || (pending && pending->draft->has_name());
    if (!any_name) undisturbed.reset();
    if (!pending) {
      special.push_back(&file);
      continue;
    }
    pending->draft->fill(file.bytes, pending->old);
    drafts.push_back(std::move(*pending));
  }
  for (const Pending& each : drafts) each.draft->secure();
  if (!undisturbed) undisturbed.emplace();
  for (const Pending& each : drafts) each.draft->name();
  std::set<fs::path> folders;
  for (const Pending& each : drafts) {
    each.draft->keep_as(each.target);
    folders.insert(folder_of(each.target));
  }
  for (const fs::path& folder : folders) tidy_folder(folder);
  undisturbed.reset();
  for (const File* file : special) write_special(*file);
}

GrowingFile::GrowingFile(const fs::path& path) : way_(std::make_unique<Growth>(path)) {}

void demand_writable(const fs::path& folder) {
  const SignalsLater undisturbed;
  make_folder(folder, folder.string());
  const Draft trial(folder, folder.string());
}

void remove_left_drafts(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> left;
  for (fs::directory_iterator each(folder, ignored), end; !ignored && each != end; each.increment(ignored)) {
    const pid_t process = process_of_draft(each->path().filename().string());
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) left.push_back(each->path());
  }
  for (const fs::path& each : left) fs::remove(each, ignored);
}

void write_whole(const fs::path& path, std::string_view bytes) {
  write_whole(std::vector{File{path, std::string(bytes)}});
}

}  // namespace epure::drawings
