package org.selectiverenderer.authoring.versions;

/** Receives the progress of work on many objects. */
@FunctionalInterface
public interface BatchProgress {
  /**
   * Reports the progress. What it throws ends the work, such as a {@link
   * java.util.concurrent.CancellationException}.
   *
   * @param fraction from 0 to 1
   * @param object name of the object that the work goes on with; empty for none
   */
  void done(double fraction, String object);
}
