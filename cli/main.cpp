#include <cstdio>
#include <exception>

#include "city_db/issues.hpp"
#include "cli/command.hpp"

namespace vicus::cli {

CLI::App* new_command(CLI::App& app, Context& context, const std::string& name, const std::string& what,
                      const std::string& example) {
  auto* command = app.add_subcommand(name, what);
  command->add_flag("--json", context.json, "print one JSON object on stdout");
  command->add_flag("--quiet", context.quiet, "print nothing but errors");
  command->footer("Example:\n  " + example);
  return command;
}

void print_result(const Context& context, const std::string& text, const nlohmann::json& object) {
  // Names come from maps: bytes that are no UTF-8 are replaced, not thrown over.
  if (context.json)
    std::printf("%s\n", object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  else if (!context.quiet)
    std::printf("%s", text.c_str());
  std::fflush(stdout);
}

}  // namespace vicus::cli

int main(int argc, char** argv) {
  using namespace vicus::cli;
  CLI::App app{"Vicus: from the map of a real city to a city people walk through", "vicus"};
  app.require_subcommand(1);
  app.set_version_flag("--version", VICUS_VERSION);
  Context context;
  add_build(app, context);
  add_check(app, context);
  add_info(app, context);
  add_serve(app, context);
  add_export(app, context);
  add_render(app, context);
  add_measure(app, context);
  add_tour(app, context);
  add_town(app, context);
  try {
    app.parse(argc, argv);
    return context.exit_code;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kWrongUsage;
  } catch (const vicus::CityError& e) {
    std::fprintf(stderr, "vicus: %s\n", e.what());
    return e.exit_code;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "vicus: internal error: %s (please report this with the input)\n", e.what());
    return kFailed;
  }
}
