#include "brindle/gl/gl_buffer.h"

#include <algorithm>
#include <array>
#include <functional>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/headless_context.h"

namespace brindle {
namespace {

std::string message_of(const std::function<void()>& job) {
  try {
    job();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(GlBuffer, HoldsACopyOrZeros) {
  const HeadlessContext context;
  const std::vector<std::uint32_t> items{7, 8, 9};
  std::array<std::uint32_t, 3> read{1, 1, 1};
  glGetNamedBufferSubData(buffer_of(items, "numbers"), 0, sizeof read, read.data());
  EXPECT_TRUE(std::ranges::equal(read, items));
  glGetNamedBufferSubData(make_buffer(sizeof read, nullptr, "zeros"), 0, sizeof read, read.data());
  EXPECT_EQ(read, (std::array<std::uint32_t, 3>{}));
  EXPECT_EQ(buffer_of(std::vector<float>(), "nothing"), 0u);
  context.check_errors("the test");
}

TEST(GlBuffer, WhatIsWrittenOverZerosStays) {
  const HeadlessContext context;
  const std::vector<std::uint32_t> items(std::size_t{1} << 18, 7);
  const auto bytes = static_cast<GLsizeiptr>(items.size() * sizeof items[0]);
  const GlBuffer buffer =
      make_buffer(static_cast<std::size_t>(bytes), nullptr, "zeros", GL_DYNAMIC_STORAGE_BIT);
  glNamedBufferSubData(buffer, 0, bytes, items.data());
  std::vector<std::uint32_t> read(items.size());
  glGetNamedBufferSubData(buffer, 0, bytes, read.data());
  EXPECT_EQ(read, items);
  context.check_errors("the test");
}

TEST(GlBuffer, BeyondTheDriversLimitIsAnErrorThatSaysWhatWasMeant) {
  const HeadlessContext context;
  const std::string message =
      message_of([] { make_buffer(std::size_t{1} << 40, nullptr, "couplings"); });
  EXPECT_NE(message.find("1099511627776 bytes of couplings"), std::string::npos) << message;
  context.check_errors("the test");
}

TEST(GlBuffer, ComplaintsAreErrorsOnce) {
  const HeadlessContext context;
  glEnable(GL_LINE_STRIP);
  EXPECT_NE(message_of([] { check_gl("the test"); }).find("the test failed"), std::string::npos);
  EXPECT_NO_THROW(check_gl("the test"));
  EXPECT_THROW(context.check_errors("the test"), Error);
}

TEST(GlDevice, NamesItselfAndItsLimits) {
  const HeadlessContext context;
  const GlDevice device = gl_device();
  EXPECT_EQ(describe(device), context.renderer());
  for (const auto& [name, value] : device.limits) EXPECT_GT(value, 0) << name;
  EXPECT_NE(std::ranges::find(device.limits, "max_compute_work_group_count",
                              &std::pair<std::string, std::int64_t>::first),
            device.limits.end());
}

}  // namespace
}  // namespace brindle
