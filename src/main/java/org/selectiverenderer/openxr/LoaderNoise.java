package org.selectiverenderer.openxr;

import java.nio.ByteBuffer;
import java.util.Map;
import org.lwjgl.system.APIUtil;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.Platform;
import org.lwjgl.system.SharedLibrary;

/**
 * Keeps what the OpenXR loader and Monado's client write to standard error out of users' terminals:
 * both ask the environment how much to say. Java cannot set that of its own process, so the C
 * library does, before the loader is loaded. What the user has set is kept.
 *
 * <p>Monado's levels end at {@code error} (its {@code debug_string_to_log_level}; an unknown word
 * is its default, which says more): what its client says when the service dies stays.
 */
final class LoaderNoise {
  private static final Map<String, String> QUIET =
      Map.of(
          "XR_LOADER_DEBUG",
          "none",
          "XRT_LOG",
          "error",
          "IPC_LOG",
          "error",
          "OXR_NO_PRINTING",
          "1");

  private LoaderNoise() {}

  static void silence() {
    if (Platform.get() != Platform.LINUX && Platform.get() != Platform.WINDOWS) {
      return;
    }
    boolean windows = Platform.get() == Platform.WINDOWS;
    try (SharedLibrary library = APIUtil.apiCreateLibrary(windows ? "kernel32" : "libc.so.6")) {
      long set = library.getFunctionAddress(windows ? "SetEnvironmentVariableA" : "setenv");
      if (set == MemoryUtil.NULL) {
        return;
      }
      QUIET.forEach(
          (name, value) -> {
            if (System.getenv(name) == null) {
              set(set, name, value, windows);
            }
          });
    } catch (UnsatisfiedLinkError e) {
      // The C library has another name here: then there is some noise.
    }
  }

  private static void set(long function, String name, String value, boolean windows) {
    ByteBuffer key = MemoryUtil.memASCII(name);
    ByteBuffer text = MemoryUtil.memASCII(value);
    try {
      long keyAt = MemoryUtil.memAddress(key);
      long textAt = MemoryUtil.memAddress(text);
      if (windows) {
        JNI.callPPI(keyAt, textAt, function);
      } else {
        JNI.callPPI(keyAt, textAt, 1, function);
      }
    } finally {
      MemoryUtil.memFree(key);
      MemoryUtil.memFree(text);
    }
  }
}
