// Tests that ask the workbench as the page does, without the transport.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "support/workbench/serve_session.hpp"
#include "workbench/serve/api.hpp"

namespace workbench::test {

class ApiTest : public ::testing::Test {
 protected:
  ApiResponse ask(const std::string& method, const std::string& path,
                  const std::string& body = "",
                  const std::map<std::string, std::string>& query = {}) {
    return answer(session_, {method, path, query, body});
  }
  nlohmann::json get(const std::string& path) {
    return nlohmann::json::parse(ask("GET", path).body);
  }
  // Posts and waits for what it started.
  int post(const std::string& path, const std::string& body = "",
           const std::map<std::string, std::string>& query = {}) {
    const ApiResponse response = ask("POST", path, body, query);
    last_ = nlohmann::json::parse(response.body);
    wait(session_);
    return response.status;
  }

  Session session_;
  nlohmann::json last_;
};

}  // namespace workbench::test
