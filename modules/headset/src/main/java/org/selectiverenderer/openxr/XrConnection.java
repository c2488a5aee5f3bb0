package org.selectiverenderer.openxr;

import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Set;

/** A connection to a runtime that has a headset. */
final class XrConnection implements AutoCloseable {
  static final String OPENGL = "XR_KHR_opengl_enable";
  static final String MASK = "XR_KHR_visibility_mask";
  static final String PRESENCE = "XR_EXT_user_presence";
  static final String CLOCK = "XR_KHR_convert_timespec_time";

  /** Extensions that are enabled if the runtime supports them. */
  private static final Set<String> WANTED =
      Set.of(OPENGL, MASK, PRESENCE, CLOCK, XrActionBindings.GAZE, InteractionProfile.HANDS);

  private final XrInstance instance;
  private final Set<String> enabled;
  private final long system;
  private final XrInstance.SystemFacts facts;
  private final String runtime;

  private XrConnection(XrInstance instance, Set<String> enabled, String runtime, long system) {
    this.instance = instance;
    this.enabled = enabled;
    this.runtime = runtime;
    this.system = system;
    facts = instance.facts(system);
  }

  /**
   * Connects to the runtime and finds a headset.
   *
   * @throws HeadsetUnavailableException with a message that says what is missing and what to do
   */
  static XrConnection open(XrLoader loader) throws HeadsetUnavailableException {
    try {
      Set<String> offered = loader.extensions();
      if (!offered.contains(OPENGL)) {
        throw new HeadsetUnavailableException(
            "the OpenXR runtime of this computer does not support OpenGL (it lacks "
                + OPENGL
                + "): make another one the active runtime, such as "
                + runtimes(System.getProperty("os.name", "")));
      }
      Set<String> enabled = new LinkedHashSet<>(WANTED);
      enabled.retainAll(offered);
      return open(loader.create(enabled), enabled);
    } catch (XrResultException e) {
      throw new HeadsetUnavailableException(missing(e), e);
    } catch (LinkageError e) {
      throw new HeadsetUnavailableException(
          "there is no OpenXR for this computer (%s, %s): --display openxr needs Linux or Windows"
              .formatted(
                  System.getProperty("os.name"),
                  System.getProperty("os.arch").toLowerCase(Locale.ROOT)),
          e);
    }
  }

  private static XrConnection open(XrInstance instance, Set<String> enabled)
      throws HeadsetUnavailableException {
    try {
      String runtime = instance.runtime();
      return new XrConnection(instance, enabled, runtime, system(instance, runtime));
    } catch (HeadsetUnavailableException | XrResultException e) {
      instance.close();
      throw e;
    }
  }

  private static long system(XrInstance instance, String runtime)
      throws HeadsetUnavailableException {
    try {
      return instance.system();
    } catch (XrResultException e) {
      if (e.code() == XrResultException.INSTANCE_LOST
          || e.code() == XrResultException.RUNTIME_FAILURE) {
        throw e;
      }
      throw new HeadsetUnavailableException(
          "the OpenXR runtime %s finds no headset: connect it, switch it on and try again"
              .formatted(runtime),
          e);
    }
  }

  private static String missing(XrResultException failure) {
    return switch (failure.code()) {
      case XrResultException.RUNTIME_UNAVAILABLE, -32 -> missing(System.getProperty("os.name", ""));
      default ->
          "the OpenXR runtime of this computer does not answer (%s): start it, and see that its headset is connected"
              .formatted(failure.getMessage());
    };
  }

  /**
   * Returns what to do where there is no runtime.
   *
   * @param system the name of the operating system, as in {@code os.name}
   */
  static String missing(String system) {
    return "no OpenXR runtime is set up on this computer: install "
        + (windows(system)
            ? "the runtime of the headset's maker or SteamVR"
            : "the headset's runtime, SteamVR or Monado")
        + " and make it the active one, or name its manifest file in XR_RUNTIME_JSON";
  }

  /** Returns runtimes that support OpenGL on a system. */
  private static String runtimes(String system) {
    return windows(system) ? "SteamVR" : "SteamVR or Monado";
  }

  private static boolean windows(String system) {
    return system.toLowerCase(Locale.ROOT).startsWith("windows");
  }

  XrInstance instance() {
    return instance;
  }

  long system() {
    return system;
  }

  String runtime() {
    return runtime;
  }

  String headset() {
    return facts.name();
  }

  /** Returns whether the headset tracks its position, not only its orientation. */
  boolean position() {
    return facts.position();
  }

  boolean has(String extension) {
    return enabled.contains(extension);
  }

  XrActionBindings actions() {
    return new XrActionBindings(instance.inputs(), enabled, tracksEyes());
  }

  /** Returns whether the headset has an eye tracker that the runtime supports. */
  boolean tracksEyes() {
    return facts.eyeGaze() && has(XrActionBindings.GAZE);
  }

  @Override
  public void close() {
    instance.close();
  }
}
