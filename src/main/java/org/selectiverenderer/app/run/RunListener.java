package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.app.head.SampleListener;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.openxr.HeadsetNews;

/** Hears what a run has to say. Called on the stepping thread, or while loading, in order. */
public interface RunListener {
  /**
   * The scene has been read with all that it names; no frame has been stepped.
   *
   * @throws IOException with one line, if it is not to be run
   */
  default void opened() throws IOException {}

  /** Something is wrong with the scene. */
  void problem(Problem problem);

  /** The display is not as asked for: what is shown instead, in a sentence. */
  default void displayFallback(String told) {}

  /** Something became of the headset; its text is a sentence. */
  default void headset(HeadsetNews news) {
    printed(news.text());
  }

  /** A line of the time line. */
  void happened(TimelineEvent event);

  /** Who hears of every frame what a head log has of it; empty for nobody. */
  default Optional<SampleListener> samples() {
    return Optional.empty();
  }

  /** An application or a scene printed something through the SAI. */
  void printed(String text);
}
