#include "session/session_worker.h"

#include <algorithm>
#include <thread>

#include <gtest/gtest.h>

#include "session/picking.h"

namespace brindle::tool {
namespace {

SessionDocument torus_with_stripes(const std::string& stripes = "20") {
  SessionDocument document;
  document.mesh = "shape:torus,resolution=24";
  document.size = {160, 120};
  document.options["stripes"] = {stripes};
  return document;
}

SessionRequest request_of(SessionDocument document, std::uint64_t revision,
                          PictureQuality quality = PictureQuality::final,
                          Follow follow = Follow::afresh) {
  return {std::move(document), revision, quality, follow};
}

Image drawn(const SessionDocument& document, PictureQuality quality = PictureQuality::final) {
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  return LivePicture().draw(pattern.state(), quality);
}

TEST(SessionWorker, TheNewestWins) {
  SessionWorker worker;
  EXPECT_EQ(worker.latest(), nullptr);
  for (int i = 1; i <= 20; ++i) {
    const bool last = i == 20;
    worker.request(request_of(torus_with_stripes(std::to_string(10 + i)),
                              static_cast<std::uint64_t>(i),
                              last ? PictureQuality::final : PictureQuality::interactive));
  }
  worker.wait();
  const auto frame = worker.latest();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->revision, 20u);
  EXPECT_LT(frame->number, 20u) << "not all were made";
  EXPECT_FALSE(worker.take_failure());
  EXPECT_EQ(frame->image.pixels, drawn(torus_with_stripes("30")).pixels);
}

TEST(SessionWorker, GivesUpAndGoesOn) {
  SessionWorker worker;
  worker.cancel();
  worker.request(request_of(torus_with_stripes("20"), 1));
  worker.wait();
  const auto first = worker.latest();
  SessionDocument large = torus_with_stripes();
  large.mesh = "shape:torus,resolution=700";
  worker.request(request_of(large, 2));
  large.options["stripes"] = {"30"};
  worker.request(request_of(large, 3, PictureQuality::final, Follow::last));
  while (worker.step().name.empty()) std::this_thread::yield();
  EXPECT_LE(worker.step().fraction, 1);
  worker.cancel();
  worker.wait();
  EXPECT_TRUE(worker.step().name.empty());
  const auto failure = worker.take_failure();
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->revision, 3u) << "what waits is given up, too";
  EXPECT_EQ(failure->unread_mesh, "");
  EXPECT_EQ(worker.latest(), first);
  worker.request(request_of(torus_with_stripes("24"), 4));
  worker.wait();
  EXPECT_FALSE(worker.take_failure());
  EXPECT_EQ(worker.latest()->revision, 4u);
}

TEST(SessionWorker, WhatWasToBeAfreshIsAfresh) {
  SessionWorker worker;
  worker.request(request_of(torus_with_stripes("20"), 1));
  worker.wait();
  // Undone, and at once looked at from elsewhere.
  SessionDocument moved = torus_with_stripes("24");
  moved.camera.azimuth_deg = 50;
  worker.request(
      request_of(torus_with_stripes("24"), 2, PictureQuality::interactive, Follow::afresh));
  worker.request(request_of(moved, 3, PictureQuality::final, Follow::last));
  worker.wait();
  EXPECT_EQ(worker.latest()->image.pixels, drawn(moved).pixels);
  EXPECT_EQ(worker.latest()->state->phases, nullptr);
}

TEST(SessionWorker, FailuresLeaveTheLastFrame) {
  SessionWorker worker;
  worker.request(request_of(torus_with_stripes(), 1));
  worker.wait();
  const auto good = worker.latest();
  SessionDocument bad = torus_with_stripes();
  bad.mesh = "nowhere.ply";
  worker.request(request_of(bad, 2));
  worker.wait();
  EXPECT_EQ(worker.latest(), good);
  const auto failure = worker.take_failure();
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->revision, 2u);
  EXPECT_NE(failure->text.find("nowhere.ply"), std::string::npos);
  EXPECT_EQ(failure->unread_mesh, "nowhere.ply");
  EXPECT_FALSE(worker.take_failure()) << "said once";
  worker.request(request_of(torus_with_stripes("25"), 3));
  worker.wait();
  EXPECT_EQ(worker.latest()->revision, 3u);
}

TEST(SessionWorker, StopsWhileItSolves) {
  // Descents that nobody would wait for.
  SessionDocument long_lasting = torus_with_stripes();
  long_lasting.mesh = "shape:torus,resolution=100";
  long_lasting.options["cycles"] = {"10000"};
  SessionWorker worker;
  worker.request(request_of(long_lasting, 1));
  while (worker.step().name != "cycles" && worker.busy()) std::this_thread::yield();
  EXPECT_EQ(worker.step().name, "cycles");
  worker.stop();
  EXPECT_EQ(worker.latest(), nullptr) << "it was not solved to its end";
  EXPECT_FALSE(worker.take_failure()) << "to be cancelled is no failure";
  worker.request(request_of(torus_with_stripes(), 2));
  EXPECT_EQ(worker.latest(), nullptr) << "nothing is made any more";
}

TEST(SessionWorker, KeptPhasesGiveThePictureThatWasShown) {
  SessionWorker worker;
  worker.request(request_of(torus_with_stripes("20"), 1));
  worker.wait();
  worker.request(
      request_of(torus_with_stripes("21"), 2, PictureQuality::interactive, Follow::last));
  worker.wait();
  worker.request(request_of(torus_with_stripes("21"), 2, PictureQuality::final, Follow::last));
  worker.wait();
  const auto frame = worker.latest();
  ASSERT_NE(frame->state->phases, nullptr);
  SessionDocument kept = torus_with_stripes("21");
  kept.phases = frame->state->phases;
  EXPECT_EQ(frame->image.pixels, drawn(kept).pixels);
}

TEST(SessionWorker, DrawsEverythingThatStripeDraws) {
  SessionWorker worker;
  std::uint64_t revision = 0;
  for (const OptionValues& options :
       {OptionValues{{"texture", {"bricks"}}}, OptionValues{{"cross", {}}},
        OptionValues{{"points", {}}}, OptionValues{{"view", {"branches"}}},
        OptionValues{{"color-by", {"height"}}, {"outline", {"solid"}}},
        OptionValues{{"width-by", {"light"}}, {"cross-hatch", {"0.5"}}}, OptionValues()}) {
    SessionDocument document = torus_with_stripes();
    document.options.insert(options.begin(), options.end());
    worker.request(request_of(document, ++revision));
    worker.wait();
    const auto failure = worker.take_failure();
    EXPECT_FALSE(failure) << failure->text;
    ASSERT_NE(worker.latest(), nullptr);
    EXPECT_EQ(worker.latest()->revision, revision);
    EXPECT_EQ(worker.latest()->image.pixels, drawn(document).pixels) << "uploaded anew or not";
  }
}

TEST(SessionWorker, WhatIsUploadedAgainInPartIsAsIfUploadedAnew) {
  SessionDocument document = torus_with_stripes();
  LivePattern pattern;
  LivePicture picture;
  const OptionValues plain, branches = {{"view", {"branches"}}},
                            errors = {{"view", {"angle_error"}}};
  const OptionValues styled = {{"color-by", {"height"}},
                               {"with", {"shape:box,resolution=6@striped"}}};
  OptionValues moved = styled, denser = plain;
  moved["width-by"] = {"distance:1,0,0"};
  denser["stripes"] = {"33"};
  for (const OptionValues& options :
       {plain, denser, branches, errors, denser, plain, styled, moved, styled, plain}) {
    document.options = options;
    pattern.update(document, Follow::last);
    EXPECT_EQ(picture.draw(pattern.state(), PictureQuality::final).pixels,
              LivePicture().draw(pattern.state(), PictureQuality::final).pixels)
        << options_to_json(options).dump();
  }
}

TEST(SessionWorker, WhatIsShownChangesAndComesBack) {
  LivePattern pattern;
  LivePicture picture;
  SessionDocument document = torus_with_stripes();
  document.curves = {{"lines", {"both"}}};
  SessionDocument glyphs = document, styled = document;
  glyphs.samples = {{"glyph", {"ellipse"}}, {"color-by", {"height"}}};
  styled.options["color-by"] = {"height"};
  const std::pair<const SessionDocument*, Shown> sequence[] = {
      {&document, Shown::stripes}, {&document, Shown::curves},  {&document, Shown::samples},
      {&glyphs, Shown::samples},   {&styled, Shown::stripes},   {&glyphs, Shown::samples},
      {&document, Shown::stripes}, {&document, Shown::samples}, {&styled, Shown::stripes},
      {&styled, Shown::curves},    {&document, Shown::stripes}};
  for (const auto& [one, shown] : sequence) {
    SessionDocument next = *one;
    next.shown = shown;
    pattern.update(next, Follow::last);
    EXPECT_EQ(picture.draw(pattern.state(), PictureQuality::final).pixels,
              LivePicture().draw(pattern.state(), PictureQuality::final).pixels)
        << name_of(shown);
    const Image draft = picture.draft(pattern.state());
    EXPECT_EQ(draft.width, next.size.width);
    EXPECT_EQ(draft.height, next.size.height);
  }
}

TEST(SessionWorker, DraftsHaveTheSizeOfThePictureAndAreNearIt) {
  LivePattern pattern;
  for (const OptionValues& options :
       {OptionValues{}, OptionValues{{"color-by", {"height"}}}, OptionValues{{"points", {}}}}) {
    SessionDocument document = torus_with_stripes("6");
    document.options.insert(options.begin(), options.end());
    pattern.update(document, Follow::afresh);
    LivePicture picture;  // whose first draft has a size that does not depend on the machine
    const Image draft = picture.draft(pattern.state());
    const Image final = picture.draw(pattern.state(), PictureQuality::final);
    ASSERT_EQ(draft.pixels.size(), final.pixels.size());
    double difference = 0;
    for (std::size_t i = 0; i < draft.pixels.size(); ++i) {
      difference += std::abs(draft.pixels[i].green - final.pixels[i].green);
    }
    EXPECT_LT(difference / static_cast<double>(draft.pixels.size()), 12);
  }
}

/// Whether a triangle at the vertex faces away from the viewer.
bool is_on_outline(const Mesh& mesh, const Camera& camera, std::size_t v) {
  const auto seen = [&](Index i) { return *place_in_picture(mesh.positions[i], camera, 160, 120); };
  return std::ranges::any_of(mesh.triangles, [&](const Triangle& t) {
    if (std::ranges::find(t, static_cast<Index>(v)) == t.end()) return false;
    const Eigen::Vector2d a = seen(t[1]) - seen(t[0]), b = seen(t[2]) - seen(t[0]);
    return a.x() * b.y() >= a.y() * b.x();  // y is downwards
  });
}

TEST(SessionWorker, FramesCanBePicked) {
  SessionWorker worker;
  SessionDocument document = torus_with_stripes();
  document.options["color-by"] = {"height"};  // with a legend beside it
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    document.camera.projection = projection;
    worker.request(request_of(document, 1));
    worker.wait();
    const auto frame = worker.latest();
    const Surface& surface = frame->surface();
    int picked = 0;
    for (std::size_t v = 0; v < surface.mesh.vertex_count(); v += 7) {
      const auto place = place_in_picture(surface.mesh.positions[v], frame->camera, 160, 120);
      ASSERT_TRUE(place);
      const auto hit = pick(surface, frame->camera, 160, 120, place->x(), place->y());
      const float depth = -(frame->camera.view_from_world *
                            Vec3(surface.mesh.positions[v] - frame->camera.origin).homogeneous())
                               .z();
      // At outlines a ray may pass by the vertex that it is aimed at.
      const bool passed_by = !hit || hit->depth > depth + 1e-3f;
      if (passed_by && is_on_outline(surface.mesh, frame->camera, v)) continue;
      ASSERT_TRUE(hit);
      EXPECT_LE(hit->depth, depth + 1e-3f);
      picked += (hit->position - surface.mesh.positions[v]).norm() < 1e-3f ? 1 : 0;
    }
    EXPECT_GT(picked, 10) << "those in front";
  }
}

}  // namespace
}  // namespace brindle::tool
