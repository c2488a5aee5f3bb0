package org.selectiverenderer.openxr;

import java.util.Map;

/** Thrown if a function of OpenXR returns an error code. */
final class XrResultException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  static final int RUNTIME_FAILURE = -2;
  static final int INSTANCE_LOST = -13;
  static final int SESSION_LOST = -17;
  static final int FORM_FACTOR_UNAVAILABLE = -35;
  static final int RUNTIME_UNAVAILABLE = -51;

  /** Names of the error codes that occur (OpenXR 1.0, 2.8.2). */
  private static final Map<Integer, String> NAMES =
      Map.ofEntries(
          Map.entry(-1, "VALIDATION_FAILURE"),
          Map.entry(RUNTIME_FAILURE, "RUNTIME_FAILURE"),
          Map.entry(-4, "API_VERSION_UNSUPPORTED"),
          Map.entry(-6, "INITIALIZATION_FAILED"),
          Map.entry(-7, "FUNCTION_UNSUPPORTED"),
          Map.entry(-8, "FEATURE_UNSUPPORTED"),
          Map.entry(-9, "EXTENSION_NOT_PRESENT"),
          Map.entry(-10, "LIMIT_REACHED"),
          Map.entry(-12, "HANDLE_INVALID"),
          Map.entry(INSTANCE_LOST, "INSTANCE_LOST"),
          Map.entry(-16, "SESSION_NOT_RUNNING"),
          Map.entry(SESSION_LOST, "SESSION_LOST"),
          Map.entry(-22, "PATH_UNSUPPORTED"),
          Map.entry(-32, "FILE_ACCESS_ERROR"),
          Map.entry(-34, "FORM_FACTOR_UNSUPPORTED"),
          Map.entry(FORM_FACTOR_UNAVAILABLE, "FORM_FACTOR_UNAVAILABLE"),
          Map.entry(-37, "CALL_ORDER_INVALID"),
          Map.entry(-38, "GRAPHICS_DEVICE_INVALID"),
          Map.entry(-50, "GRAPHICS_REQUIREMENTS_CALL_MISSING"),
          Map.entry(RUNTIME_UNAVAILABLE, "RUNTIME_UNAVAILABLE"));

  private final int code;

  /**
   * @param function name of the function without {@code xr}
   * @param code result of the function, below 0
   */
  XrResultException(String function, int code) {
    super("xr%s: XR_ERROR_%s".formatted(function, NAMES.getOrDefault(code, "(" + code + ")")));
    this.code = code;
  }

  int code() {
    return code;
  }
}
