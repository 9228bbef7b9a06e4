// System V ABI, "Dynamic Section": DT_SONAME is an offset into the string table at DT_STRTAB.
#include "doors/loaded.h"

namespace truequad {
namespace {

std::string_view name_of(const ElfW(Dyn)* entry, ElfW(Addr) base, std::string_view file) {
  const char* strings = nullptr;
  const ElfW(Dyn)* name = nullptr;
  for (; entry && entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_SONAME) name = entry;
    // The dynamic linker has added the base on most architectures, and left the file's value on others.
    if (entry->d_tag == DT_STRTAB) {
      strings = reinterpret_cast<const char*>(entry->d_un.d_ptr < base ? base + entry->d_un.d_ptr : entry->d_un.d_ptr);
    }
  }
  if (name && strings) return strings + name->d_un.d_val;
  return file.substr(file.rfind('/') + 1);
}

std::string_view text(const char* string) { return string ? string : ""; }

int compare(dl_phdr_info* info, std::size_t, void* name) {
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    if (info->dlpi_phdr[i].p_type != PT_DYNAMIC) continue;
    const auto* dynamic = reinterpret_cast<const ElfW(Dyn)*>(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
    if (name_of(dynamic, info->dlpi_addr, text(info->dlpi_name)) == *static_cast<std::string_view*>(name)) return 1;
  }
  return 0;
}

}  // namespace

std::string_view name_of(const link_map* library) {
  return name_of(library->l_ld, library->l_addr, text(library->l_name));
}

bool is_loaded(std::string_view name) { return dl_iterate_phdr(compare, &name) == 1; }

}  // namespace truequad
