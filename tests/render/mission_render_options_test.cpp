#include "app/render/mission_render.h"
#include "tests/support/missions.h"

#include <npsee/units.h>

#include <gtest/gtest.h>

namespace npsee::render {
namespace {

using Kind = MissionCamera::Kind;

MissionRender parsed(const std::string& text) {
  auto out = parseMissionRender(text);
  EXPECT_TRUE(out) << (out ? "" : out.error().text());
  return out ? *out : MissionRender{};
}

std::string refusal(const std::string& text) {
  const auto out = parseMissionRender(text);
  EXPECT_FALSE(out) << text;
  if (out) return {};
  EXPECT_EQ(out.error().kind, ErrorKind::usage);
  return out.error().text();
}

TEST(MissionRenderOption, TimeCameraAndSizeAreRead) {
  const MissionRender render = parsed("t=12.5, camera=observer:fo2 ,size=640x360,field=80,turn=-20,out=a.png");
  EXPECT_EQ(render.time_s, 12.5);
  EXPECT_EQ(render.view.camera.kind, Kind::observer);
  EXPECT_EQ(render.subject, "fo2");
  EXPECT_EQ(render.width, 640);
  EXPECT_EQ(render.height, 360);
  EXPECT_NEAR(render.view.camera.field_mil, 80.0, 1e-9);
  EXPECT_NEAR(render.view.camera.turn_rad, toSi(Unit::mil, -20.0), 1e-12);
  EXPECT_EQ(render.output, "a.png");
}

TEST(MissionRenderOption, OverlaysAreShownAndHidden) {
  const MissionOverlays overlays = parsed("hide=all,show=rings+sight").view.overlays;
  EXPECT_TRUE(overlays.range_rings);
  EXPECT_TRUE(overlays.sight_fan);
  EXPECT_FALSE(overlays.trails);
  EXPECT_FALSE(overlays.icons);
}

TEST(MissionRenderOption, EveryMistakeIsNamedWithTheNearestWordThatFits) {
  EXPECT_NE(refusal("tme=3").find("there is no key \"tme\""), std::string::npos);
  EXPECT_NE(refusal("camera=obsever").find("Did you mean observer?"), std::string::npos);
  EXPECT_NE(refusal("camera=plan:gun1").find("has no subject"), std::string::npos);
  EXPECT_NE(refusal("camera=free").find("eye=X/Y/Z"), std::string::npos);
  EXPECT_NE(refusal("size=10x10").find("16 to 8192"), std::string::npos);
  EXPECT_NE(refusal("t=-1").find("it goes from 0 s"), std::string::npos);
  EXPECT_NE(refusal("t").find("has no value"), std::string::npos);
  EXPECT_NE(refusal("show=ring").find("trails"), std::string::npos);
  EXPECT_NE(refusal("target=1/2/3/4").find("x/y/z"), std::string::npos);
  EXPECT_NE(refusal("smooth=2").find("0 or 1"), std::string::npos);
  EXPECT_NE(refusal("distance=nan").find("not a finite number"), std::string::npos);
}

TEST(MissionRenderOption, TheHelpNamesEveryKeyThatIsUnderstood) {
  for (const char* key : {"t ", "camera", "size", "target", "eye", "distance", "yaw", "pitch", "fov", "span", "look", "field", "turn", "show", "hide", "least", "preset", "smooth", "out"})
    EXPECT_NE(missionRenderHelp().find(std::string("  ") + key), std::string_view::npos) << key;
}

class InAMission : public ::testing::Test {
 protected:
  InAMission() : made_(test::terrainOf({}, 4000.0, -10.0)) {
    made_.observer(500.0, 2000.0);
    made_.vehicle(2500.0, 2000.0, Side::hostile);
    made_.fire(made_.gun(300.0, 3000.0, 1.2, 0.4), 1.0, 150.0, "air_burst");
  }
  Expected<MissionView> view(const std::string& text) { return missionView(parsed(text), made_.recording); }
  std::string refusalOf(const std::string& text) {
    const auto out = view(text);
    EXPECT_FALSE(out) << text;
    return out ? std::string() : out.error().text();
  }
  test::HandRecording made_;
};

TEST_F(InAMission, NamesAreLookedUp) {
  EXPECT_EQ(view("camera=gun:gun1")->camera.subject, 0);
  EXPECT_EQ(view("camera=follow:1")->camera.subject, 0);
  EXPECT_EQ(view("camera=observer:fo1,look=v1")->camera.look_at, 1);
  EXPECT_NE(refusalOf("camera=gun:gn1").find("Did you mean gun1?"), std::string::npos);
  EXPECT_NE(refusalOf("camera=follow:7").find("from 1 to 1"), std::string::npos);
  EXPECT_NE(refusalOf("camera=observer,look=v9").find("there is no vehicle"), std::string::npos);
  EXPECT_NE(refusalOf("preset=no_such_preset").find("no_such_preset"), std::string::npos);
}

TEST_F(InAMission, WithoutAPlaceThePictureShowsWhereTheMissionHappens) {
  for (const char* camera : {"camera=orbit", "camera=plan"}) {
    const auto shown = view(camera);
    ASSERT_TRUE(shown);
    const MissionEye eye = missionEye(made_.recording, 0.0, shown->camera, 1280, 720);
    for (const Vec3& place : {made_.recording.guns[0].muzzle_m, made_.recording.vehiclePlace(0, 0.0), made_.recording.vehiclePlace(1, 0.0), made_.recording.shells[0].burst_m}) {
      const auto pixel = eye.project(place);
      ASSERT_TRUE(pixel) << camera;
      EXPECT_GT(pixel->x, 20.0) << camera;
      EXPECT_LT(pixel->x, 1260.0) << camera;
      EXPECT_GT(pixel->y, 20.0) << camera;
      EXPECT_LT(pixel->y, 700.0) << camera;
    }
  }
}

TEST_F(InAMission, APlaceOnTheGroundNeedsNoHeight) {
  const auto shown = view("camera=free,eye=100/200,target=500/3/600");
  ASSERT_TRUE(shown);
  EXPECT_NEAR(shown->camera.eye.y, 2.0, 1e-9);
  EXPECT_EQ(shown->camera.target, (Vec3{500.0, 3.0, 600.0}));
}

TEST_F(InAMission, ProjectingAPlaceAndCastingARayThroughItsPixelMeetAgain) {
  for (const char* camera : {"camera=orbit", "camera=plan", "camera=free,eye=200/150/2600,target=1500/0/2100"}) {
    const MissionEye eye = missionEye(made_.recording, 0.0, view(camera)->camera, 1280, 720);
    const Vec3 place{1400.0, 0.0, 2200.0};
    const auto pixel = eye.project(place);
    ASSERT_TRUE(pixel) << camera;
    const auto back = eye.groundAt(made_.recording.terrain, pixel->x, pixel->y);
    ASSERT_TRUE(back) << camera;
    EXPECT_NEAR(back->x, place.x, 0.05) << camera;
    EXPECT_NEAR(back->z, place.z, 0.05) << camera;
  }
}

}  // namespace
}  // namespace npsee::render
