// GLFW, which opens libGL itself; the commands by glfwGetProcAddress.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "scene.h"

int main() {
  using namespace loaders;
  if (!glfwInit()) return 3;
  GLFWwindow* window = glfwCreateWindow(kSize, kSize, "glfw", nullptr, nullptr);
  if (!window) return 4;
  glfwMakeContextCurrent(window);
  return show(find_functions([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }));
}
