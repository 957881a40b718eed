// A variable of the environment, as long as it lives. Nothing else may read the environment meanwhile.
#ifndef PLUME_TESTS_ENVIRONMENT_H
#define PLUME_TESTS_ENVIRONMENT_H

#include <cstdlib>
#include <optional>
#include <string>

namespace plume {

class EnvironmentVariable {
 public:
  EnvironmentVariable(std::string name, const std::string& value) : name_(std::move(name)) {
    if (const char* before = std::getenv(name_.c_str())) before_ = before;
    ::setenv(name_.c_str(), value.c_str(), 1);
  }
  ~EnvironmentVariable() {
    if (before_)
      ::setenv(name_.c_str(), before_->c_str(), 1);
    else
      ::unsetenv(name_.c_str());
  }
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

 private:
  const std::string name_;
  std::optional<std::string> before_;
};

}  // namespace plume
#endif
