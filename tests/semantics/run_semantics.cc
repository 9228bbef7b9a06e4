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

}  // namespace

Outcome run_program(std::vector<std::string> words, bool with_truequad, const std::string& mode, bool color) {
  const doors_test::Scratch scratch;
  const std::string records = scratch / "records", statistics = scratch / "statistics";
  std::map<std::string, std::string> environment;
  if (with_truequad) {
    environment = {{"LD_PRELOAD", TRUEQUAD_PRELOAD},
                   {"TRUEQUAD_MODE", mode},
                   {"TRUEQUAD_TOLERANCE", "0.25"},
                   {"TRUEQUAD_COLOR", color ? "1" : "0"},
                   {"TRUEQUAD_STATS", statistics}};
  }
  words.push_back(records);
  const doors_test::Ended ended = doors_test::run(words, environment);
  Outcome result;
  EXPECT_EQ(ended.status, 0) << words[0] << " " << words[1] << ": " << ended.err;
  if (ended.status != 0) return result;
  result.records = parse(doors_test::read_file(records));
  if (!with_truequad) return result;
  const auto json = nlohmann::json::parse(doors_test::read_file(statistics), nullptr, false);
  EXPECT_TRUE(json.is_object()) << "no statistics from " << words[1];
  if (!json.is_object()) return result;
  result.quads = json.value("quads", 0L);
  result.corrected = json.value("corrected", 0L);
  return result;
}

namespace {

std::vector<std::string> words_of(const Job& job) {
  return {DRAW_SEMANTICS_PREFIX + job.interface, job.scene, std::to_string(job.first),
          std::to_string(job.seeds)};
}

}  // namespace

Outcome run_natively(const Job& job) { return run_program(words_of(job), false); }
Outcome run_with_truequad(const Job& job, const std::string& mode, bool color) {
  return run_program(words_of(job), true, mode, color);
}

}  // namespace truequad::semantics
