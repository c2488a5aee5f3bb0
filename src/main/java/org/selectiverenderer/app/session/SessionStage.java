package org.selectiverenderer.app.session;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.run.OperatorMonitor;
import org.selectiverenderer.experiment.study.Study;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.runtime.render.window.Monitor;

/**
 * What the operator of a session has and sees.
 *
 * @param monitor of the operator; empty for wherever the desktop puts windows
 * @param reading the monitor of what the participant reads and answers; empty for wherever the
 *     desktop puts windows. Where each eye has a monitor, these are inside the display that the
 *     participant has taken off, and it is the operator's
 * @param pointerKept whether the pointer is kept in the participant's window while something is
 *     shown
 * @param blind whether the operator's windows keep the condition to themselves
 */
public record SessionStage(
    Optional<Monitor> monitor, Optional<Monitor> reading, boolean pointerKept, boolean blind) {
  /** On a desk: one monitor, which everybody sees. */
  public static final SessionStage DESK =
      new SessionStage(Optional.empty(), Optional.empty(), false, true);

  /**
   * Whether the operator's view has a place: on the only monitor it would lie over the picture of
   * the participant.
   */
  public static boolean viewFits(List<Monitor> monitors) {
    return monitors.size() > 1;
  }

  /**
   * As a study wants it on a desktop.
   *
   * @param wantedMonitor number or name of the operator's monitor instead of the study's
   * @param open whether the operator may know the condition, whatever the study says
   * @param monitors all of the desktop
   * @param message hears what is not as asked for
   * @throws IllegalArgumentException with a sentence when the operator's monitor is not there, or
   *     an eye's
   */
  public static SessionStage of(
      Study study,
      Presentation presentation,
      Optional<String> wantedMonitor,
      boolean open,
      List<Monitor> monitors,
      Consumer<String> message) {
    Optional<Monitor> monitor =
        OperatorMonitor.of(
            presentation, wantedMonitor.or(study.display()::operator), monitors, message);
    boolean worn = OperatorMonitor.eyesHaveMonitors(presentation, monitors);
    boolean kept =
        switch (study.display().pointer()) {
          case KEPT -> true;
          case FREE -> false;
          case AUTO -> worn;
        };
    return new SessionStage(
        monitor, worn ? monitor : Optional.empty(), kept, study.course().blind() && !open);
  }
}
