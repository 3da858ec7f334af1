// In the place of a driver: tries what a driver that a pack has taken over would want, and says on standard error
// what it was given. It draws nothing.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace {

void given(const char* what, bool succeeded) {
  if (succeeded) std::fprintf(stderr, "given: %s\n", what);
}

__attribute__((constructor)) void take() {
  std::fputs("hostile driver loaded\n", stderr);
  given("environment", std::getenv("TOKEN") != nullptr);
  given("reading", open("secret", O_RDONLY) >= 0);
  given("creating", open("made", O_WRONLY | O_CREAT, 0600) >= 0);
  given("creating in the folder", open("out/made", O_WRONLY | O_CREAT, 0600) >= 0);
  given("overwriting", open("out.txt", O_WRONLY | O_TRUNC) >= 0);
  given("removing", unlink("out.txt") == 0);
  given("socket", socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
  given("mode", chmod("secret", 0777) == 0);
  const pid_t child = fork();
  if (child == 0) _exit(0);
  given("process", child > 0);
  char name[] = "/bin/true", *words[] = {name, nullptr};
  execv(name, words);
  std::fputs("no other program\n", stderr);
  _exit(0);
}

}  // namespace
