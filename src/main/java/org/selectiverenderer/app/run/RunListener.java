package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.openxr.HeadsetEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * Receives the events of a run. It is called on the stepping thread, or during loading, in order.
 */
public interface RunListener {
  /**
   * Reports that the scene and its files have been read; no frame has been stepped.
   *
   * @throws IOException with a one-line message, to prevent the run
   */
  default void opened() throws IOException {}

  /** Reports a problem of the scene. */
  void problem(Problem problem);

  /**
   * Reports that the requested display is not available, with a sentence that says what is shown
   * instead.
   */
  default void displayFallback(String told) {}

  /** Reports an event of the headset; its text is a sentence. */
  default void headset(HeadsetEvent news) {
    printed(news.text());
  }

  /** Reports an event of the time line. */
  void happened(TimelineEvent event);

  /**
   * Returns whether the events are to tell what the viewer sees of each change of a version, for
   * which rays are cast.
   */
  default boolean observesSwitches() {
    return true;
  }

  /**
   * Reports that a frame was stepped.
   *
   * @param t seconds since the start of the walkthrough
   * @param polygons polygons of the whole scene with its current versions, visible or not
   */
  default void stepped(double t, long polygons) {}

  /** Returns the listener for the head log's samples of every frame, if any. */
  default Optional<HeadSampleListener> samples() {
    return Optional.empty();
  }

  /** Reports text that an application or a scene printed through the SAI. */
  void printed(String text);
}
