#include "httpd/routes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "city_db/issues.hpp"
#include "tests/unit/httpd/served_city.hpp"
#include "x3d_export/glb.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus {
namespace {

class RoutesOfSampleCity : public testing::Test {
 protected:
  static void SetUpTestSuite() { served_ = new test::ServedCity; }
  static void TearDownTestSuite() { delete served_; }

  HttpResponse get(const std::string& target, HttpFields fields = {}, const std::string& method = "GET") {
    return routes_.respond({method, target, std::move(fields)});
  }
  std::string field(const HttpResponse& response, const char* name) {
    return field_of(response.fields, name).value_or("(none)");
  }
  std::string detail(const HttpResponse& response) {
    return nlohmann::json::parse(*response.body)["detail"].get<std::string>();
  }

  static test::ServedCity* served_;
  Routes routes_ = served_->routes();
};
test::ServedCity* RoutesOfSampleCity::served_ = nullptr;

TEST_F(RoutesOfSampleCity, GiveEverySectorInEveryFormat) {
  for (const auto& sector : test::sample_city().sectors)
    for (const auto& [suffix, media_type] :
         {std::pair(".x3d", "model/x3d+xml"), std::pair(".far.x3d", "model/x3d+xml"), std::pair(".wrl", "model/vrml"),
          std::pair(".x3dj", "model/x3d+json"), std::pair(".json", "application/json")}) {
      const auto response = get("/sectors/" + sector.id + suffix);
      ASSERT_EQ(response.status, 200) << sector.id << suffix;
      EXPECT_EQ(field(response, "Content-Type"), media_type);
      EXPECT_FALSE(response.body->empty());
    }
}

/// Every file of a sector as the exporter writes it, by name.
std::map<std::string, std::string> files_of(const CityIndex& index, const Sector& sector) {
  std::map<std::string, std::string> files;
  int shapes = 0;
  for (const auto format : {SceneFormat::x3d, SceneFormat::vrml, SceneFormat::x3dj})
    for (const auto& file : sector_files(index, sector, Detail::near, format)) {
      files["/" + file.path] = file.text;
      if (format == SceneFormat::x3d) shapes += file.shapes;
    }
  for (const auto detail : {Detail::far, Detail::tall})
    for (const auto& file : sector_files(index, sector, detail, SceneFormat::x3d)) files["/" + file.path] = file.text;
  files["/sectors/" + sector.id + ".json"] = record_json(sector_record(source_of(index), sector, shapes));
  return files;
}

TEST_F(RoutesOfSampleCity, GiveTheBytesOfTheExporterInEveryCodingStoredOrNot) {
  const City city = test::sample_city();
  const CityIndex index(city);
  std::set<std::string> tags;
  std::size_t count = 0;
  for (const auto& sector : city.sectors)
    for (const auto& [target, text] : files_of(index, sector)) {
      SCOPED_TRACE(target);
      for (const char* coding : {"identity", "gzip", "br"}) {
        const auto response = get(target, {{"Accept-Encoding", std::string(coding) + ", identity;q=0.1"}});
        ASSERT_EQ(response.status, 200);
        ASSERT_EQ(field(response, "Content-Encoding"), coding == std::string("identity") ? "(none)" : coding);
        EXPECT_EQ(*response.body, coding == std::string("br")     ? brotli(text, 4)
                                  : coding == std::string("gzip") ? gzip(text, 6)
                                                                  : text);
        const auto etag = field(response, "ETag");
        EXPECT_TRUE(tags.insert(etag).second) << etag;
        const HttpFields again = {{"Accept-Encoding", coding}, {"If-None-Match", etag}};
        EXPECT_EQ(get(target, again).status, 304);
        EXPECT_EQ(field(get(target, {{"Accept-Encoding", coding}}, "HEAD"), "ETag"), etag);
        ++count;
      }
    }
  EXPECT_EQ(count, 3 * (5 * city.sectors.size() + 2));
}

TEST_F(RoutesOfSampleCity, HaveTallFilesWhereHousesAreSeenOverRoofsOnly) {
  EXPECT_EQ(get("/sectors/s-main-w.tall.x3d").status, 200);
  EXPECT_EQ(get("/sectors/s-cross.tall.x3d").status, 404);
  const auto listed = detail(get("/sectors/s-main-w.nix"));
  EXPECT_NE(listed.find(" /sectors/s-main-w.tall.x3d /sectors/s-main-w.wrl"), std::string::npos) << listed;
  EXPECT_EQ(detail(get("/sectors/s-cross.nix")).find("tall"), std::string::npos);
  for (const char* none :
       {"s-cross.far.wrl", "s-cross.1.wrl", "s-cross.x.x3dj", "nowhere.wrl", "s-cross.far.glb", "nowhere.glb"})
    EXPECT_EQ(get(std::string("/sectors/") + none).status, 404) << none;
}

TEST_F(RoutesOfSampleCity, WriteASectorAsGlbWhenAskedAsTheExporterDoes) {
  const City city = test::sample_city();
  const CityIndex index(city);
  for (const auto& sector : city.sectors) {
    const auto response = get("/sectors/" + sector.id + ".glb", {{"Accept-Encoding", "identity"}});
    ASSERT_EQ(response.status, 200) << sector.id;
    EXPECT_EQ(field(response, "Content-Type"), "model/gltf-binary");
    EXPECT_EQ(*response.body,
              sector_glb(index, sector, Detail::near, [](const std::string& id) { return "png " + id; }));
    const auto wanted = get("/sectors/" + sector.id, {{"Accept", "model/gltf-binary"}});
    EXPECT_EQ(field(wanted, "Content-Location"), "/sectors/" + sector.id + ".glb");
  }
}

TEST(Routes, WriteAGlbWithTheStoredImagesAndTellOfOneThatIsMissing) {
  test::ScratchDirectory scratch;
  const City city = test::sample_city_with_facades();
  std::map<std::string, Artefact> images;
  const auto add = [&](const std::string& id) {
    images[id] = {"textures/" + id + ".png", "image/png", "identity", "h" + id, "png " + id};
  };
  add(city.meta.at("atlas"));
  for (const auto& facade : city.facades) add(facade.texture);
  const auto respond = [&](const std::string& without) {
    std::vector<Artefact> stored;
    for (const auto& [id, image] : images)
      if (id != without) stored.push_back(image);
    write_city(scratch / "city.gpkg", city, test::one_by_one(stored));
    Routes routes(scratch / "city.gpkg", std::make_shared<const StaticFiles>(""), std::make_shared<Metrics>());
    return routes.respond({"GET", "/sectors/s-main-w.glb", {{"Accept-Encoding", "identity"}}});
  };
  const auto response = respond("");
  ASSERT_EQ(response.status, 200);
  const CityIndex index(city);
  const auto sector =
      std::find_if(city.sectors.begin(), city.sectors.end(), [](const Sector& s) { return s.id == "s-main-w"; });
  EXPECT_EQ(*response.body,
            sector_glb(index, *sector, Detail::near, [&](const std::string& id) { return images.at(id).body; }));
  const auto broken = respond(city.meta.at("atlas"));
  EXPECT_EQ(broken.status, 500);
  EXPECT_NE(broken.fault.find("texture " + city.meta.at("atlas")), std::string::npos) << broken.fault;
}

TEST(Routes, RefuseStoredBytesThatUnpackToNothingOrTooMuch) {
  test::ScratchDirectory scratch;
  std::string bomb = brotli(std::string(65 << 20, '\0'), 5);
  write_city(scratch / "city.gpkg", test::sample_city(),
             test::one_by_one({{"bomb", "model/x3d+xml", "br", "h1", bomb},
                               {"junk", "model/x3d+xml", "br", "h2", "junk"},
                               {"gz", "model/x3d+xml", "gzip", "h3", gzip("plain", 6)}}));
  Routes routes(scratch / "city.gpkg", std::make_shared<const StaticFiles>(""), std::make_shared<Metrics>());
  for (const char* path : {"/bomb", "/junk"}) {
    EXPECT_EQ(routes.respond({"GET", path, {{"Accept-Encoding", "br"}}}).status, 200) << path;
    for (const char* coding : {"identity", "gzip"}) {
      const auto response = routes.respond({"GET", path, {{"Accept-Encoding", coding}}});
      EXPECT_EQ(response.status, 500) << path;
      EXPECT_NE(response.fault.find(std::string(path + 1) + " is damaged"), std::string::npos) << response.fault;
    }
  }
  EXPECT_EQ(routes.respond({"GET", "/gz", {{"Accept-Encoding", "gzip"}}}).status, 200);
  EXPECT_EQ(routes.respond({"GET", "/gz", {{"Accept-Encoding", "identity"}}}).status, 406);
}

TEST_F(RoutesOfSampleCity, ChooseTheStoredCodingAndTagEachOne) {
  const auto plain = get("/sectors/s-cross.x3d", {{"Accept-Encoding", "identity"}});
  const auto br = get("/sectors/s-cross.x3d", {{"Accept-Encoding", "gzip, br"}});
  const auto gz = get("/sectors/s-cross.x3d", {{"Accept-Encoding", "gzip"}});
  EXPECT_EQ(field(plain, "Content-Encoding"), "(none)");
  EXPECT_EQ(field(br, "Content-Encoding"), "br");
  EXPECT_EQ(field(gz, "Content-Encoding"), "gzip");
  EXPECT_EQ(*br.body, brotli(*plain.body, 4));
  EXPECT_EQ(gz.body->substr(0, 2), "\x1f\x8b");
  EXPECT_NE(field(br, "ETag"), field(plain, "ETag"));
  EXPECT_NE(field(br, "ETag"), field(gz, "ETag"));
  for (const auto* response : {&plain, &br, &gz}) {
    EXPECT_EQ(field(*response, "Vary"), "Accept, Accept-Encoding");
    EXPECT_EQ(field(*response, "Access-Control-Allow-Origin"), "*");
    EXPECT_EQ(field(*response, "X-Content-Type-Options"), "nosniff");
    EXPECT_NE(field(*response, "Cache-Control").find("no-cache"), std::string::npos);
  }
}

TEST_F(RoutesOfSampleCity, Say304ForTheTagOfTheSameCodingOnly) {
  for (const char* target :
       {"/sectors/s-cross.x3d", "/city.x3d", "/", "/x_ite/15.0.1/dist/x_ite.min.mjs", "/collections/sectors/items"}) {
    const auto first = get(target, {{"Accept-Encoding", "br"}});
    ASSERT_EQ(first.status, 200) << target;
    const auto etag = field(first, "ETag");
    const auto again = get(target, {{"Accept-Encoding", "br"}, {"If-None-Match", "\"x\", " + etag}});
    EXPECT_EQ(again.status, 304) << target;
    EXPECT_FALSE(again.body);
    for (const char* kept : {"ETag", "Vary", "Cache-Control"}) EXPECT_EQ(field(again, kept), field(first, kept));
    EXPECT_EQ(get(target, {{"Accept-Encoding", "gzip"}, {"If-None-Match", etag}}).status, 200) << target;
  }
}

TEST_F(RoutesOfSampleCity, Say406WhenEveryCodingIsRefused) {
  for (const char* target : {"/sectors/s-cross.x3d", "/city.x3d", "/", "/collections"}) {
    EXPECT_EQ(get(target, {{"Accept-Encoding", "identity;q=0, deflate"}}).status, 406) << target;
    EXPECT_EQ(get(target, {{"Accept-Encoding", "*;q=0"}}).status, 406) << target;
    EXPECT_EQ(get(target, {{"Accept-Encoding", "identity;q=0, br"}}).status, 200) << target;
    EXPECT_EQ(get(target, {{"Accept-Encoding", "br;q=7"}}).status, 400) << target;
  }
}

TEST_F(RoutesOfSampleCity, ChooseTheFormatByAcceptWhereThePathLeavesItOpen) {
  const auto vrml = get("/sectors/s-cross", {{"Accept", "model/vrml, */*;q=0.1"}});
  EXPECT_EQ(field(vrml, "Content-Type"), "model/vrml");
  EXPECT_EQ(field(vrml, "Content-Location"), "/sectors/s-cross.wrl");
  EXPECT_EQ(field(get("/sectors/s-cross"), "Content-Type"), "model/x3d+xml");
  EXPECT_EQ(field(get("/city", {{"Accept", "model/vrml"}}), "Content-Type"), "model/vrml");
  EXPECT_EQ(get("/city", {{"Accept", "image/png"}}).status, 406);
  EXPECT_EQ(get("/sectors/s-cross", {{"Accept", "image/png"}}).status, 406);
  EXPECT_EQ(get("/sectors/s-cross.x3d", {{"Accept", "image/png"}}).status, 406);
  EXPECT_EQ(get("/sectors/s-cross", {{"Accept", "image"}}).status, 400);
  EXPECT_EQ(field(get("/", {{"Accept", "application/json"}}), "Content-Type"), "application/json");
  EXPECT_EQ(field(get("/", {{"Accept", "text/html,*/*;q=0.8"}}), "Content-Type"), "text/html; charset=utf-8");
}

TEST_F(RoutesOfSampleCity, NameWhatIsNotThere) {
  const auto unknown = get("/sectors/nowhere.x3d");
  EXPECT_EQ(unknown.status, 404);
  EXPECT_NE(detail(unknown).find("nowhere"), std::string::npos);
  EXPECT_EQ(field(unknown, "Content-Type"), "application/problem+json");
  EXPECT_EQ(field(unknown, "Cache-Control"), "no-store");
  const auto no_format = get("/sectors/s-cross.obj");
  EXPECT_EQ(no_format.status, 404);
  EXPECT_NE(detail(no_format).find("/sectors/s-cross.x3d"), std::string::npos);
  for (const char* target :
       {"/nix", "/sectors/nowhere", "/client/nix.js", "/x_ite/15.0.1/dist/nix.js", "/city.obj", "/collections/nix",
        "/collections/sectors/nix", "/collections/gates/items/nix", "/sectors", "/client/", "/favicon.ico"})
    EXPECT_EQ(get(target).status, 404) << target;
}

TEST_F(RoutesOfSampleCity, RefuseBadIdsAndAddresses) {
  for (const char* target :
       {"/sectors/", "/sectors/a%20b.x3d", "/sectors/%C3%B6.x3d", "/sectors/.x3d", "/sectors/a/b.x3d",
        "/city.x3d?start=%22", "/city.x3d?start=a&start=b", "/city.x3d?static=yes", "/city.x3d?static=1&i=77",
        "/city.x3d?test=sphere", "/../etc/passwd", "/%00", "/%"})
    EXPECT_EQ(get(target).status, 400) << target;
  EXPECT_EQ(get("/" + std::string(5000, 'a')).status, 414);
}

TEST_F(RoutesOfSampleCity, AllowReadingOnly) {
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "TRACE", "CONNECT", "get", "X"}) {
    const auto response = get("/", {}, method);
    EXPECT_EQ(response.status, 405) << method;
    EXPECT_EQ(field(response, "Allow"), "GET, HEAD, OPTIONS");
  }
  const auto options = get("/sectors/s-cross.x3d", {{"Origin", "https://example.org"}}, "OPTIONS");
  EXPECT_EQ(options.status, 204);
  EXPECT_EQ(field(options, "Allow"), "GET, HEAD, OPTIONS");
  EXPECT_EQ(field(options, "Access-Control-Allow-Methods"), "GET, HEAD, OPTIONS");
  EXPECT_EQ(get("*", {}, "OPTIONS").status, 204);
}

TEST_F(RoutesOfSampleCity, MakeTheRootWorldForAnyStart) {
  for (const auto& sector : test::sample_city().sectors) {
    const auto root = get("/city.x3d?start=" + sector.id);
    ASSERT_EQ(root.status, 200);
    EXPECT_NE(root.body->find("sectors/" + sector.id + ".x3d"), std::string::npos) << sector.id;
  }
  EXPECT_NE(get("/city.x3d").body->find("<Script"), std::string::npos);
  EXPECT_NE(get("/city.x3d?i=2").body->find("name='level' type='SFString' accessType='initializeOnly' value='2'"),
            std::string::npos);
  EXPECT_NE(get("/city.x3d?test=gate").body->find("value='gate'"), std::string::npos);
  EXPECT_EQ(get("/city.wrl").body->substr(0, 15), "#VRML V2.0 utf8");
  const auto unknown = get("/city.x3d?start=nowhere");
  EXPECT_EQ(unknown.status, 404);
  EXPECT_NE(detail(unknown).find("nowhere"), std::string::npos);
}

/// For browsers without scripts: L_i as Inlines that load by themselves.
TEST_F(RoutesOfSampleCity, MakeStaticRootWorlds) {
  std::size_t before = 0;
  for (const char* i : {"0", "1", "2", "3"}) {
    const auto root = get(std::string("/city.x3d?static=1&start=s-yard&i=") + i);
    ASSERT_EQ(root.status, 200);
    const std::string& text = *root.body;
    for (const char* part : {"<Script", "ProximitySensor", "load=", "ROUTE"}) EXPECT_EQ(text.find(part), text.npos);
    std::size_t inlines = 0;
    for (std::size_t at = 0; (at = text.find("<Inline", at)) != text.npos; ++at) ++inlines;
    EXPECT_EQ(inlines, *i == '0' ? 1u : inlines);
    EXPECT_GE(inlines, before) << "L_" << i << " holds L_i below it";
    before = inlines;
  }
  EXPECT_EQ(before, test::sample_city().sectors.size());
  for (const char* format : {".wrl", ".x3dj"})
    EXPECT_EQ(get(std::string("/city") + format + "?static=1&start=s-yard").status, 200) << format;
  EXPECT_EQ(get("/city.x3d?static=1&start=nowhere").status, 404);
  for (const char* wrong : {"/city.x3d?static=2", "/city.x3d?static=", "/city.x3d?static=1&i=4",
                            "/city.x3d?static=1&i=-1", "/city.x3d?static=1&i=1.5", "/city.x3d?static=1&i=",
                            "/city.x3d?static=1&static=1", "/city.x3d?static=1&start=a/b", "/city.x3d?static=1&start="})
    EXPECT_EQ(get(wrong).status, 400) << wrong;
}

TEST_F(RoutesOfSampleCity, ServeXIteBelowItsVersionAndNothingBesideIt) {
  const auto script = get("/x_ite/15.0.1/dist/x_ite.min.mjs", {{"Accept-Encoding", "br, gzip"}});
  EXPECT_EQ(script.status, 200);
  EXPECT_EQ(field(script, "Content-Type"), "text/javascript; charset=utf-8");
  EXPECT_EQ(field(script, "Content-Encoding"), "br");
  EXPECT_NE(field(script, "Cache-Control").find("immutable"), std::string::npos);
  const auto wasm = get("/x_ite/15.0.1/dist/assets/a.wasm");
  EXPECT_EQ(field(wasm, "Content-Type"), "application/wasm");
  EXPECT_EQ(*wasm.body, std::string("\0asm\1\0\0\0", 8));
  for (const char* target : {"/x_ite/15.0.1/secret.json", "/x_ite/15.0.1/package.json", "/x_ite/15.0.1/dist/x_ite.zip"})
    EXPECT_EQ(get(target).status, 404) << target;
  for (const char* target : {"/x_ite/14.0.0/dist/x_ite.min.mjs", "/x_ite/dist/x_ite.min.mjs"}) {
    const auto moved = get(target);
    EXPECT_EQ(moved.status, 307) << target;
    EXPECT_EQ(field(moved, "Location"), "/x_ite/15.0.1/dist/x_ite.min.mjs");
  }
  EXPECT_EQ(get("/x_ite/14").status, 404);
}

TEST_F(RoutesOfSampleCity, ServeThePageUnderAPolicyWithoutEval) {
  const auto page = get("/");
  EXPECT_EQ(page.status, 200);
  const auto policy = field(page, "Content-Security-Policy");
  for (const char* part : {"default-src 'none'", "script-src 'self';", "worker-src"})
    EXPECT_NE(policy.find(part), std::string::npos) << part;
  EXPECT_EQ(policy.find("eval"), std::string::npos) << policy;
  for (const auto& file : embedded_client_files()) {
    const auto response = get("/client/" + std::string(file.path));
    EXPECT_EQ(response.status, 200) << file.path;
    EXPECT_EQ(*response.body, file.bytes) << file.path;
  }
  EXPECT_GT(embedded_client_files().size(), 3u);
}

TEST_F(RoutesOfSampleCity, GiveTheWorldFromAboveAndTheLayoutsOfItsTiles) {
  const auto world = get("/flyover.x3d");
  EXPECT_EQ(world.status, 200);
  EXPECT_EQ(field(world, "Content-Type"), "model/x3d+xml");
  for (const char* script : {"/client/flyer.js", "/client/x3d/flyover.vert", "/client/x3d/flyover.frag"}) {
    EXPECT_EQ(get(script).status, 200) << script;
    EXPECT_NE(world.body->find(std::string(script).substr(1)), std::string::npos) << script;
  }
  for (const char* layout : {"prism_tile", "ground_tile", "blockmap"}) {
    const auto header = get(std::string("/client/layout/") + layout + "_layout.h");
    EXPECT_EQ(header.status, 200) << layout;
    EXPECT_NE(header.body->find("#define "), std::string::npos) << layout;
  }
}

TEST_F(RoutesOfSampleCity, AnswerOperators) {
  EXPECT_EQ(*get("/healthz").body, "ok\n");
  EXPECT_EQ(get("/metrics").status, 200);
  EXPECT_EQ(field(get("/metrics"), "Cache-Control"), "no-store");
  EXPECT_STREQ(get("/sectors/s-cross.x3d").route, "sector");
}

TEST(Routes, TakeUpANewlyBuiltCityAndKeepTheOldOneOverABrokenFile) {
  test::ServedCity served;
  auto routes = served.routes();
  const auto name = [&] {
    const auto response = routes.respond({"GET", "/collections/sectors/items/s-cross", {}});
    return nlohmann::json::parse(*response.body)["properties"]["name"].get<std::string>();
  };
  const auto old_name = name();
  std::this_thread::sleep_for(LiveCity::kLookInterval + std::chrono::milliseconds(50));
  test::write_bytes(served.scratch / "broken", "this is no city");
  std::filesystem::rename(served.scratch / "broken", served.path());
  EXPECT_EQ(name(), old_name);
  test::write_sample(served.scratch / "new.gpkg", "Neue Kreuzung");
  std::filesystem::rename(served.scratch / "new.gpkg", served.path());
  std::this_thread::sleep_for(LiveCity::kLookInterval + std::chrono::milliseconds(50));
  EXPECT_EQ(name(), "Neue Kreuzung");
  std::filesystem::remove(served.path());
  std::this_thread::sleep_for(LiveCity::kLookInterval + std::chrono::milliseconds(50));
  EXPECT_EQ(name(), "Neue Kreuzung");
}

TEST(Routes, NeedACityThatCanBeOpened) {
  const auto files = std::make_shared<const StaticFiles>("");
  EXPECT_THROW(Routes("/nowhere/city.gpkg", files, std::make_shared<Metrics>()), CityError);
}

TEST(Routes, SayHowToGetXIteWhereThereIsNone) {
  test::ServedCity served;
  Routes routes(served.path(), std::make_shared<const StaticFiles>(""), std::make_shared<Metrics>());
  const auto response = routes.respond({"GET", "/x_ite/15.0.1/dist/x_ite.min.mjs", {}});
  EXPECT_EQ(response.status, 404);
  EXPECT_NE(response.body->find("--x_ite"), std::string::npos);
}

TEST(Routes, GiveAPictureOfTheFolderInsteadOfTheCitys) {
  const test::ServedCity served;
  std::filesystem::create_directories(served.scratch / "photos");
  test::write_bytes(served.scratch / "photos" / "s-main-w-to-s-cross.png", "a photograph");
  test::write_bytes(served.scratch / "photos" / "readme.txt", "no picture");
  const auto files = std::make_shared<const StaticFiles>("", served.scratch / "photos");
  Routes routes(served.path(), files, std::make_shared<Metrics>());
  const auto photo = routes.respond({"GET", "/impostors/s-main-w-to-s-cross.png", {}});
  EXPECT_EQ(photo.status, 200);
  EXPECT_EQ(*photo.body, "a photograph");
  EXPECT_EQ(field_of(photo.fields, "Content-Type"), "image/png");
  EXPECT_EQ(routes.respond({"GET", "/impostors/readme.txt", {}}).status, 404);
  EXPECT_EQ(routes.respond({"GET", "/impostors/../routes.png", {}}).status / 100, 4);
  EXPECT_THROW(StaticFiles("", served.scratch / "none"), CityError);
}

TEST(FindXIte, TakesThePackageOrItsDistAndRefusesAnythingElse) {
  test::ScratchDirectory scratch;
  test::write_x_ite(scratch / "node_modules/x_ite");
  const auto package = scratch / "node_modules/x_ite";
  EXPECT_EQ(find_x_ite(package, ""), package);
  EXPECT_EQ(find_x_ite(package / "dist", ""), package);
  EXPECT_EQ(find_x_ite(scratch / "node_modules", ""), package);
  EXPECT_EQ(find_x_ite("", scratch / "vicus"), package);
  EXPECT_THROW(find_x_ite(scratch.path(), ""), CityError);
  EXPECT_EQ(StaticFiles(package).x_ite_version(), "15.0.1");
  test::write_bytes(package / "package.json", R"({"version": "../../etc"})");
  EXPECT_THROW(StaticFiles{package}, CityError);
}

}  // namespace
}  // namespace vicus
