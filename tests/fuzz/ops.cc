#include "ops.h"

#include <fstream>

namespace truequad::fuzz {

void write(const std::vector<Sequence>& sequences, const std::string& path) {
  std::ofstream file(path);
  for (const Sequence& sequence : sequences) {
    file << sequence.size() << '\n';
    for (const Op& op : sequence) {
      file << int(op.step) << ' ' << int(op.warp) << ' ' << op.index << ' ' << op.shape << ' ' << op.seed << '\n';
    }
  }
}

bool read(const std::string& path, std::vector<Sequence>& sequences) {
  std::ifstream file(path);
  for (std::size_t size; file >> size;) {
    Sequence& sequence = sequences.emplace_back();
    for (; size > 0; --size) {
      int step, warp;
      Op op;
      if (!(file >> step >> warp >> op.index >> op.shape >> op.seed) || step < 0 || step >= int(Step::kCount)) return false;
      op.step = Step(step);
      op.warp = std::uint16_t(warp);
      sequence.push_back(op);
    }
  }
  return file.eof();
}

}  // namespace truequad::fuzz
