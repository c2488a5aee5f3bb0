package org.selectiverenderer.app.session;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.run.OperatorMonitorSelector;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.render.window.Monitor;
import org.selectiverenderer.study.definition.Study;

/**
 * The monitors of a session's operator and participant, and what the operator may see.
 *
 * @param monitor the monitor of the operator; empty for wherever the desktop puts windows
 * @param reading the monitor on which the participant reads and answers questions; empty for
 *     wherever the desktop puts windows. Where each eye has a monitor of its own, both are inside
 *     the display that the participant has taken off, so it is the operator's
 * @param pointerKept whether the pointer is confined to the participant's window while a scene is
 *     shown
 * @param blind whether the condition is hidden in the operator's windows
 */
public record OperatorViewSettings(
    Optional<Monitor> monitor, Optional<Monitor> reading, boolean pointerKept, boolean blind) {
  /** The settings for a desktop with one monitor, which everybody sees. */
  public static final OperatorViewSettings DESK =
      new OperatorViewSettings(Optional.empty(), Optional.empty(), false, true);

  /**
   * Returns whether the operator's view fits: on a single monitor it would cover the participant's
   * picture.
   */
  public static boolean viewFits(List<Monitor> monitors) {
    return monitors.size() > 1;
  }

  /**
   * Creates the settings that a study asks for, on the monitors of a desktop.
   *
   * @param wantedMonitor number or name of the operator's monitor instead of the study's
   * @param open whether the operator may see the condition although the study is blind
   * @param monitors all of the desktop
   * @param message receives messages about monitors that are not available as requested
   * @throws IllegalArgumentException with a sentence when the operator's monitor does not exist or
   *     is used for an eye
   */
  public static OperatorViewSettings of(
      Study study,
      DisplayConfiguration presentation,
      Optional<String> wantedMonitor,
      boolean open,
      List<Monitor> monitors,
      Consumer<String> message) {
    Optional<Monitor> monitor =
        OperatorMonitorSelector.of(
            presentation, wantedMonitor.or(study.display()::operator), monitors, message);
    boolean worn = OperatorMonitorSelector.eyesHaveMonitors(presentation, monitors);
    boolean kept =
        switch (study.display().pointer()) {
          case KEPT -> true;
          case FREE -> false;
          case AUTO -> worn;
        };
    return new OperatorViewSettings(
        monitor, worn ? monitor : Optional.empty(), kept, study.course().blind() && !open);
  }
}
