#include "run_semantics.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "run.h"

namespace truequad::semantics {
namespace {

std::map<std::string, std::string> parse(const std::string& bytes) {
  std::map<std::string, std::string> records;
  std::size_t at = 0;
  while (at + 8 <= bytes.size()) {
    std::uint32_t sizes[2];
    std::memcpy(sizes, bytes.data() + at, sizeof sizes);
    at += sizeof sizes;
    if (at + sizes[0] + sizes[1] > bytes.size()) break;
    const std::string name = bytes.substr(at, sizes[0]);
    EXPECT_EQ(records.count(name), 0u) << name << " was recorded twice";
    records[name] = bytes.substr(at + sizes[0], sizes[1]);
    at += sizes[0] + sizes[1];
  }
  EXPECT_EQ(at, bytes.size()) << "the records are cut short";
  return records;
}

Outcome run(const Job& job, const std::map<std::string, std::string>& settings, bool with_truequad) {
  const doors_test::Scratch scratch;
  const std::string records = scratch / "records", statistics = scratch / "statistics";
  auto environment = settings;
  if (with_truequad) environment["TRUEQUAD_STATS"] = statistics;
  const doors_test::Ended ended =
      doors_test::run({DRAW_SEMANTICS_PREFIX + job.interface, job.scene, std::to_string(job.first),
                       std::to_string(job.seeds), records},
                      environment);
  Outcome result;
  EXPECT_EQ(ended.status, 0) << job.interface << " " << job.scene << ": " << ended.err;
  if (ended.status != 0) return result;
  result.records = parse(doors_test::read_file(records));
  if (!with_truequad) return result;
  const auto json = nlohmann::json::parse(doors_test::read_file(statistics), nullptr, false);
  EXPECT_TRUE(json.is_object()) << "no statistics from " << job.scene;
  if (!json.is_object()) return result;
  result.quads = json.value("quads", 0L);
  result.corrected = json.value("corrected", 0L);
  if (json.contains("pass_reasons")) result.pass_reasons = json["pass_reasons"].get<std::map<std::string, long>>();
  return result;
}

}  // namespace

Outcome run_natively(const Job& job) { return run(job, {}, false); }

Outcome run_with_truequad(const Job& job, const std::string& mode) {
  return run(job, {{"LD_PRELOAD", TRUEQUAD_PRELOAD}, {"TRUEQUAD_MODE", mode}, {"TRUEQUAD_TOLERANCE", "0.25"}},
             true);
}

}  // namespace truequad::semantics
