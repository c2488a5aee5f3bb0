package org.selectiverenderer.openxr;

import java.nio.ByteBuffer;
import java.util.Map;
import org.lwjgl.system.APIUtil;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.Platform;
import org.lwjgl.system.SharedLibrary;

/**
 * Silences the log output of the OpenXR loader and Monado's client on standard error, by
 * environment variables that set their log levels. Java cannot set variables of its own process, so
 * {@code setenv} of the C library does, before the loader is loaded. Variables that the user has
 * set are not changed.
 *
 * <p>The quietest log level of Monado is {@code error} (its {@code debug_string_to_log_level}; an
 * unknown word means its default, which logs more), so its client still reports that the service
 * died.
 */
final class OpenXrLogSuppressor {
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

  private OpenXrLogSuppressor() {}

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
      // The C library has another name on this system: the output is not silenced.
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
