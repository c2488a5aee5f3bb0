package org.selectiverenderer.app.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.render.window.Monitor;

/**
 * Selects the monitor of the operator, never one that shows a picture to the participant's eyes.
 */
public final class OperatorMonitorSelector {
  private OperatorMonitorSelector() {}

  /**
   * Selects the monitor.
   *
   * @param wanted its number, counted as for a display profile, or its name; empty for any that is
   *     free
   * @param monitors all of the desktop, in their order
   * @param message receives a message when no monitor is free
   * @return the monitor; empty where any monitor will do or none is free
   * @throws IllegalArgumentException with a sentence when the wanted monitor does not exist or is
   *     used for an eye
   */
  public static Optional<Monitor> of(
      DisplayConfiguration presentation,
      Optional<String> wanted,
      List<Monitor> monitors,
      Consumer<String> message) {
    List<Monitor> eyes = eyes(presentation, monitors);
    if (wanted.isPresent()) {
      Monitor found =
          find(wanted.get(), monitors)
              .orElseThrow(
                  () ->
                      new IllegalArgumentException(
                          "there is no monitor '%s' for the operator; there are %s"
                              .formatted(wanted.get(), listed(monitors))));
      if (eyes.contains(found)) {
        throw new IllegalArgumentException(
            "monitor '%s' shows the participant's %s eye; name another one for the operator (%s)"
                .formatted(
                    wanted.get(), found.equals(eyes.get(0)) ? "left" : "right", listed(monitors)));
      }
      return Optional.of(found);
    }
    if (eyes.isEmpty()) {
      return Optional.empty();
    }
    Optional<Monitor> free = monitors.stream().filter(each -> !eyes.contains(each)).findFirst();
    if (free.isEmpty()) {
      message.accept(
          "no monitor is left for the operator: the operator's controls are hidden behind the"
              + " participant's pictures; there F4 resets the heading, F8 pauses and F9 continues");
    }
    return free;
  }

  /** Returns whether each eye has a monitor of its own, so that no pointer is seen. */
  public static boolean eyesHaveMonitors(
      DisplayConfiguration presentation, List<Monitor> monitors) {
    return !eyes(presentation, monitors).isEmpty();
  }

  /** The monitors that a display fills; none where it is a window. */
  private static List<Monitor> eyes(DisplayConfiguration presentation, List<Monitor> monitors) {
    DisplayProfile profile = presentation.geometry().profile();
    int most = Math.max(profile.leftScreen(), profile.rightScreen());
    return presentation.mode() == DisplayMode.DUAL
            && profile.leftScreen() != profile.rightScreen()
            && most < monitors.size()
        ? List.of(monitors.get(profile.leftScreen()), monitors.get(profile.rightScreen()))
        : List.of();
  }

  private static Optional<Monitor> find(String wanted, List<Monitor> monitors) {
    if (wanted.matches("\\d{1,3}")) {
      int number = Integer.parseInt(wanted);
      return number < monitors.size() ? Optional.of(monitors.get(number)) : Optional.empty();
    }
    return monitors.stream().filter(each -> each.name().equalsIgnoreCase(wanted)).findFirst();
  }

  private static String listed(List<Monitor> monitors) {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < monitors.size(); i++) {
      lines.add(i + ": " + monitors.get(i));
    }
    return String.join(", ", lines);
  }
}
