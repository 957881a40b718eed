#include "sandbox/commands/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace plume {
namespace {

constexpr size_t kKept = 1 << 16;  // bytes of its standard error
constexpr int kPatienceMs = 50;    // between looks at whether somebody wants to stop

std::runtime_error failure(const char* what) {
  return std::runtime_error(
      fmt::format("a job cannot be isolated: {}: {}", what, std::generic_category().message(errno)));
}

/// Between fork and exec only what is safe in a copy of one thread.
[[noreturn]] void become(char** argv, int errors, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it was killed before that
  const int nothing = open("/dev/null", O_RDWR);
  if (dup2(nothing, STDIN_FILENO) >= 0 && dup2(nothing, STDOUT_FILENO) >= 0 &&
      dup2(errors, STDERR_FILENO) >= 0)
    execv("/proc/self/exe", argv);
  _exit(127);
}

}  // namespace

std::string why(const Ending& ending) {
  std::string text = ending.signal ? fmt::format("signal {} ({})", *ending.signal, strsignal(*ending.signal))
                                   : fmt::format("exit {}", ending.exit_code);
  const size_t end = ending.errors.find_last_not_of('\n');
  if (end == ending.errors.npos) return text;
  const size_t before = ending.errors.rfind('\n', end);
  std::string line = ending.errors.substr(before + 1, end - before);  // npos + 1 is 0
  constexpr std::string_view kName = "plume: ";
  if (line.starts_with(kName)) line.erase(0, kName.size());
  return text + ": " + line;
}

Ending run_child(const std::vector<std::string>& arguments, const std::function<bool()>& interrupted) {
  std::string name = "plume";
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{name.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int pipe[2];
  if (pipe2(pipe, O_CLOEXEC) != 0) throw failure("pipe");
  const pid_t parent = getpid(), child = fork();
  if (child == 0) become(argv.data(), pipe[1], parent);
  const int error = errno;
  close(pipe[1]);
  if (child < 0) {
    close(pipe[0]);
    errno = error;
    throw failure("fork");
  }

  Ending ending;
  bool told = false;
  for (;;) {
    if (!told && interrupted && interrupted()) told = ::kill(child, SIGINT) == 0;
    pollfd readable{.fd = pipe[0], .events = POLLIN, .revents = 0};
    if (poll(&readable, 1, kPatienceMs) <= 0) continue;
    char bytes[4096];
    const ssize_t got = ::read(pipe[0], bytes, sizeof bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    ending.errors.append(bytes, size_t(got));
    if (ending.errors.size() > kKept) ending.errors.erase(0, ending.errors.size() - kKept);
  }
  close(pipe[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status))
    ending.signal = WTERMSIG(status);
  else
    ending.exit_code = WEXITSTATUS(status);
  return ending;
}

}  // namespace plume
