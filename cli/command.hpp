#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

/// What every subcommand of `vicus` shares (DESIGN §9): --json, --quiet, exit codes.
namespace vicus::cli {

enum Exit { kDone = 0, kFailed = 1, kWrongUsage = 2, kRuleBroken = 3, kNothingUsable = 4 };

struct Context {
  bool json = false;   ///< one JSON object on stdout instead of text
  bool quiet = false;  ///< nothing but errors
  int exit_code = kDone;
};

/// Registers the subcommand; its callback does the work and sets context.exit_code. Errors are thrown as CityError and
/// caught in main.cpp only.
void add_build(CLI::App& app, Context& context);
void add_check(CLI::App& app, Context& context);
void add_info(CLI::App& app, Context& context);
void add_serve(CLI::App& app, Context& context);
void add_export(CLI::App& app, Context& context);
void add_render(CLI::App& app, Context& context);
void add_measure(CLI::App& app, Context& context);
void add_tour(CLI::App& app, Context& context);
void add_town(CLI::App& app, Context& context);

/// A new subcommand with --json, --quiet and an example at the end of its help.
CLI::App* new_command(CLI::App& app, Context& context, const std::string& name, const std::string& what,
                      const std::string& example);

/// The one line or object a subcommand ends with: `text` to stdout, or `object` when --json was given.
void print_result(const Context& context, const std::string& text, const nlohmann::json& object);

}  // namespace vicus::cli
