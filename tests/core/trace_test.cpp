#include "core/trace.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

namespace weir {
namespace {

TEST(Trace, HoldsSpansThatEndedWhileItWasOnWithTheirThreads) {
  { const Span before("before"); }
  Trace::start();
  Trace::name_thread("main");
  {
    const Span outer("outer");
    const Span inner("inner");
  }
  std::thread([] {
    Trace::name_thread("other");
    const Span elsewhere("elsewhere");
  }).join();
  const auto json = nlohmann::json::parse(Trace::finish());
  { const Span after("after"); }

  std::map<std::string, nlohmann::json> spans;
  std::map<int, std::string> threads;
  for (const auto& event : json["traceEvents"]) {
    if (event["ph"] == "M") threads[event["tid"]] = event["args"]["name"];
    if (event["ph"] == "X") spans[event["name"]] = event;
  }
  ASSERT_EQ(spans.size(), 3U);
  const auto begin = [&](const char* name) { return spans[name]["ts"].get<double>(); };
  const auto end = [&](const char* name) { return begin(name) + spans[name]["dur"].get<double>(); };
  EXPECT_GE(begin("outer"), 0);
  EXPECT_LE(begin("outer"), begin("inner"));
  EXPECT_GE(end("outer") + 0.002, end("inner"));  // microseconds, three digits
  EXPECT_EQ(threads[spans["outer"]["tid"]], "main");
  EXPECT_EQ(threads[spans["elsewhere"]["tid"]], "other");
}

TEST(Trace, IsEmptyAgainAfterwards) {
  Trace::start();
  const auto json = nlohmann::json::parse(Trace::finish());
  for (const auto& event : json["traceEvents"]) EXPECT_NE(event["ph"], "X");
}

TEST(Trace, EndsWithTheBlockThatRecords) {
  try {
    const Recording recording;
    const Span span("span");
    throw std::runtime_error("in the middle");
  } catch (const std::runtime_error&) {
    EXPECT_FALSE(Trace::on());
  }
  EXPECT_EQ(Trace::finish().find("span"), std::string::npos);
}

}  // namespace
}  // namespace weir
