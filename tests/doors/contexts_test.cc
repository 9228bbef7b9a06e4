// Real drivers: OSMesa, GLX and EGL in one process, on one thread in turn and on several at once, reached by linked
// symbols and by each API's getProcAddress. What is affine comes out as without truequad, bit for bit; what is not is
// corrected in whichever context is current. Needs a display for GLX.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "run.h"

namespace truequad::doors_test {
namespace {

using ::testing::Contains;
using ::testing::SizeIs;
using Lines = std::vector<std::string>;
using Environment = std::map<std::string, std::string>;

const char* const kKinds[] = {"osmesa", "glx", "egl"};
const std::string kLibrary = TRUEQUAD_PRELOAD;

Lines lines_of(const std::string& text) {
  std::istringstream in(text);
  Lines lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Ended run_preloaded(const std::string& preload, const Lines& words, Environment environment = {}) {
  environment["LD_PRELOAD"] = preload;
  environment["EGL_PLATFORM"] = "surfaceless";
  environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
  return run(words, environment);
}

Lines contexts_words(const Lines& words) {
  Lines all = {TRUEQUAD_CONTEXTS};
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

// What the program printed, truequad having nothing to complain of.
Lines output(const std::string& preload, const Lines& words, const Environment& environment = {}) {
  const Ended ended = run_preloaded(preload, words, environment);
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_THAT(ended.err, ::testing::Not(::testing::HasSubstr("truequad:")));
  return lines_of(ended.out);
}
Lines native(const Lines& words) { return output("", contexts_words(words)); }
Lines with_truequad(const Lines& words, const Environment& environment = {}) {
  return output(kLibrary, contexts_words(words), environment);
}

int corrected_in(const std::string& file) {
  const auto stats = nlohmann::json::parse(read_file(file), nullptr, false);
  return stats.is_object() ? stats.value("corrected", -1) : -1;
}

// The one line that `words` print for a context.
std::string line(const Lines& printed) {
  EXPECT_THAT(printed, SizeIs(1));
  return printed.empty() ? "" : printed[0];
}

// ---- getProcAddress ---------------------------------------------------------------------------------------------------

std::set<std::string> exported_names() {
  // An initializer list of strings would keep the compiler busy for minutes.
  static constexpr const char* kCommands[] = {
#define TQ_COMMAND(name, result, parameters, arguments) "gl" #name,
#include "gl_commands.inc"
#undef TQ_COMMAND
  };
  std::set<std::string> names(std::begin(kCommands), std::end(kCommands));
  std::ifstream others(TRUEQUAD_OTHER_EXPORTS);
  for (std::string name; std::getline(others, name);) {
    if (name.starts_with("glX") || name.starts_with("egl") || name.starts_with("OSMesa")) names.insert(name);
  }
  return names;
}

class GetProcAddress : public ::testing::TestWithParam<const char*> {
 protected:
  Lines ask(const std::string& preload, const Environment& environment = {}) {
    const Scratch scratch;
    std::ofstream file(scratch / "names");
    for (const std::string& name : exported_names()) file << name << '\n';
    for (const char* name : kOthers) file << name << '\n';
    file.close();
    const std::string command = std::string("exec '") + TRUEQUAD_CONTEXTS + "' " + GetParam() + " names <'" +
                                (scratch / "names").string() + "'";
    return output(preload, {"sh", "-c", command}, environment);
  }
  // Names that we do not export: no one's, and the drivers' own.
  static constexpr const char* kOthers[] = {"glNoSuchFunction", "NoSuchFunction",   "gl",        "glVertex9f",
                                            "glXChooseVisual",  "eglQueryString",   "_exit",     "glVertex3",
                                            "glVertex3fff",     "OSMesaPixelStore", "eglGetError"};
};

TEST_P(GetProcAddress, KnowsWhatTheDriverKnowsAndNothingElse) { EXPECT_EQ(ask(kLibrary), ask("")); }

TEST_P(GetProcAddress, AnswersWithOurDoors) {
  const std::set<std::string> exported = exported_names();
  int doors = 0;
  for (const std::string& line : ask(kLibrary, {{"TRUEQUAD_TEST_WHERE", "1"}})) {
    std::istringstream in(line);
    std::string name, known, where;
    in >> name >> known >> where;
    if (known != "known") continue;
    EXPECT_EQ(where == "libtruequad.so", exported.contains(name)) << line;
    doors += where == "libtruequad.so";
  }
  EXPECT_GT(doors, 1000);
}

INSTANTIATE_TEST_SUITE_P(Apis, GetProcAddress, ::testing::ValuesIn(kKinds),
                         [](const auto& info) { return std::string(info.param); });

// ---- Which context a call goes to ---------------------------------------------------------------------------------------

TEST(Contexts, AffineQuadsAreTheDriversAndOthersAreCorrected) {
  for (const std::string kind : kKinds) {
    SCOPED_TRACE(kind);
    const Lines affine = native({kind, "affine"}), warped = native({kind, "warped"});
    EXPECT_NE(line(affine), line(warped));
    EXPECT_EQ(with_truequad({kind, "affine"}), affine);
    const Scratch scratch;
    const Lines corrected = with_truequad({kind, "warped"}, {{"TRUEQUAD_STATS", scratch / "stats"}});
    EXPECT_NE(corrected, warped);
    EXPECT_EQ(corrected_in(scratch / "stats"), 1);
    EXPECT_EQ(with_truequad({kind, "warped"}, {{"TRUEQUAD_MODE", "off"}}), warped);
  }
}

// The program is linked with libGL before libOSMesa, so natively the linked functions never reach OSMesa's context.
TEST(Contexts, LinkedFunctionsGoToTheCurrentContext) {
  for (const std::string kind : kKinds) {
    SCOPED_TRACE(kind);
    EXPECT_EQ(line(with_truequad({kind, "linked-warped"})), line(with_truequad({kind, "warped"})));
    EXPECT_EQ(line(with_truequad({kind, "linked-affine"})), line(native({kind, "affine"})));
  }
}

TEST(Contexts, OfThreeApisTakeTurnsOnOneThread) {
  std::map<std::string, std::string> expected;
  for (const std::string kind : kKinds) expected[kind] = line(with_truequad({kind, "warped"}));
  const Lines orders[] = {{"osmesa", "glx", "egl"}, {"egl", "osmesa", "glx"}, {"glx", "osmesa", "egl"},
                          {"glx", "egl", "osmesa"}};
  for (const Lines& order : orders) {
    Lines words, wanted;
    for (int round = 0; round < 2; ++round) {
      for (const std::string& kind : order) {
        // An API of a vendor-neutral dispatch refuses while the other one is current.
        if (kind != "osmesa") words.insert(words.end(), {"no-egl", "no-glx"});
        words.insert(words.end(), {kind, "warped", "linked-warped"});
        wanted.insert(wanted.end(), 2, expected[kind]);
      }
    }
    const Scratch scratch;
    EXPECT_EQ(with_truequad(words, {{"TRUEQUAD_STATS", scratch / "stats"}}), wanted);
    EXPECT_EQ(corrected_in(scratch / "stats"), int(wanted.size()));
  }
}

TEST(Contexts, OfOneApiStayCurrentWhileAnotherIsReleased) {
  EXPECT_EQ(with_truequad({"osmesa", "no-glx", "no-egl", "osmesa", "warped"}), with_truequad({"osmesa", "warped"}));
  EXPECT_EQ(with_truequad({"osmesa", "no-glx", "warped"}), with_truequad({"osmesa", "warped"}));
  EXPECT_EQ(with_truequad({"osmesa", "no-egl", "warped"}), with_truequad({"osmesa", "warped"}));
  // Mesa's OSMesa and its GLX share what is current; whatever that comes to, it is the driver's matter.
  for (const std::string kind : {"glx", "egl"}) {
    EXPECT_EQ(with_truequad({kind, "no-osmesa", kind, "affine"}), native({kind, "no-osmesa", kind, "affine"}));
  }
}

TEST(Contexts, OfThreeApisWorkOnThreadsAtOnce) {
  Lines expected;
  for (const std::string kind : kKinds) expected.push_back("threads " + line(with_truequad({kind, "warped"})));
  for (std::string& text : expected) text.erase(text.find(" warped"), 7);
  for (int trial = 0; trial < 5; ++trial) {
    const Scratch scratch;
    EXPECT_EQ(with_truequad({"threads"}, {{"TRUEQUAD_STATS", scratch / "stats"}}), expected);
    EXPECT_EQ(corrected_in(scratch / "stats"), 6 * 50);
  }
}

TEST(Contexts, ComeAndGo) {
  Lines expected;
  for (const std::string kind : kKinds) expected.push_back("again " + line(with_truequad({kind, "warped"})));
  for (std::string& text : expected) text.erase(text.find(" warped"), 7);
  EXPECT_EQ(with_truequad({"again", "150"}), expected);
}

// What cannot be drawn with Begin/End is left alone, and the driver says what it says without us.
TEST(Contexts, OfOtherProfilesAreLeftAlone) {
  for (const std::string kind : {"core", "gles"}) {
    SCOPED_TRACE(kind);
    const Lines expected = native({kind, "triangle"});
    EXPECT_THAT(expected, Contains("error 0"));
    EXPECT_THAT(expected.back(), ::testing::Not(::testing::HasSubstr("of 0 pixels")));
    EXPECT_EQ(with_truequad({kind, "triangle"}), expected);
  }
}

TEST(Contexts, RaiseTheirOwnErrorsInOrder) {
  for (const std::string kind : kKinds) {
    SCOPED_TRACE(kind);
    Lines expected = native({kind, "illegal"}), errors = with_truequad({kind, "illegal"});
    ASSERT_GT(expected.size(), 5u);
    // The picture has a corrected quad.
    expected.pop_back();
    if (!errors.empty()) errors.pop_back();
    EXPECT_EQ(errors, expected);
    EXPECT_EQ(with_truequad({kind, "illegal"}, {{"TRUEQUAD_MODE", "off"}}), native({kind, "illegal"}));
  }
}

TEST(Contexts, AreNotNeededForACall) {
  EXPECT_EQ(with_truequad({"linked-affine"}), native({"linked-affine"}));
  EXPECT_EQ(with_truequad({"linked-illegal"}), native({"linked-illegal"}));
  EXPECT_EQ(with_truequad({"osmesa", "no-osmesa", "linked-affine"}), native({"osmesa", "no-osmesa", "linked-affine"}));
}

// ---- Who else is in the process -----------------------------------------------------------------------------------------

TEST(Neighbours, APlugInMayBringItsDriverAlong) {
  for (const char* scope : {"local", "global"}) {
    for (const std::string kind : kKinds) {
      SCOPED_TRACE(kind + " " + scope);
      const Lines words = {TRUEQUAD_PLUG_IN_HOST, scope, TRUEQUAD_PLUG_IN, kind};
      for (const std::string scene : {"affine", "warped", "linked-warped"}) {
        Lines with_scene = words;
        with_scene.push_back(scene);
        EXPECT_EQ(output(kLibrary, with_scene), with_truequad({kind, scene}));
      }
    }
  }
}

TEST(Neighbours, VariablesAreNotTakenForFunctions) {
  for (const std::string kind : kKinds) {
    for (const std::string scene : {"affine", "warped"}) {
      EXPECT_EQ(output(kLibrary + ":" + TRUEQUAD_VARIABLES, contexts_words({kind, scene})),
                with_truequad({kind, scene}));
    }
  }
}

TEST(Neighbours, AnotherHookSeesTheSameCallsInEitherOrder) {
  const std::string hook = TRUEQUAD_HOOK;
  const Lines words = contexts_words({"glx", "linked-affine", "linked-affine"});
  const Ended alone = run_preloaded(hook, words);
  EXPECT_THAT(alone.err, ::testing::HasSubstr("hook: 2 Finish, 8 Vertex2f, 1 current"));
  for (const std::string& preload : {kLibrary + ":" + hook, hook + ":" + kLibrary}) {
    const Ended ended = run_preloaded(preload, words);
    EXPECT_EQ(ended.err, alone.err) << preload;
    EXPECT_EQ(ended.out, alone.out) << preload;
    EXPECT_EQ(ended.status, 0);
  }
  // And quads are corrected either way.
  for (const std::string& preload : {kLibrary + ":" + hook, hook + ":" + kLibrary}) {
    EXPECT_EQ(lines_of(run_preloaded(preload, contexts_words({"glx", "linked-warped"})).out),
              with_truequad({"glx", "warped"}));
  }
}

}  // namespace
}  // namespace truequad::doors_test
