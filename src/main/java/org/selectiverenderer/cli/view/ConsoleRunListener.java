package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * A run listener that prints problems and text to the console and passes on the time line.
 *
 * @param timeline receives the time line
 * @param samples receives the head log's sample of every frame
 * @param observesSwitches whether the time line tells what the viewer sees of each change
 * @param begun called when the scene has been read, before the first frame
 * @param frames receives the polygons of every frame
 */
public record ConsoleRunListener(
    Console console,
    Consumer<TimelineEvent> timeline,
    Optional<HeadSampleListener> samples,
    boolean observesSwitches,
    Beginning begun,
    Frames frames)
    implements RunListener {
  /** An action before the first frame. */
  @FunctionalInterface
  public interface Beginning {
    /**
     * @throws IOException with a one-line message, to prevent the run
     */
    void begin() throws IOException;
  }

  /** Receives frames. */
  @FunctionalInterface
  public interface Frames {
    /** Tells a frame, as {@link RunListener#stepped}. */
    void stepped(double t, long polygons);
  }

  /** Creates a listener that tells nobody of frames. */
  public ConsoleRunListener(
      Console console,
      Consumer<TimelineEvent> timeline,
      Optional<HeadSampleListener> samples,
      boolean observesSwitches,
      Beginning begun) {
    this(console, timeline, samples, observesSwitches, begun, (t, polygons) -> {});
  }

  /**
   * Creates a listener without an action before the first frame, whose time line does not tell what
   * the viewer sees of changes.
   */
  public ConsoleRunListener(
      Console console, Consumer<TimelineEvent> timeline, Optional<HeadSampleListener> samples) {
    this(console, timeline, samples, false, () -> {});
  }

  /** Creates a listener without a receiver of samples. */
  public ConsoleRunListener(Console console, Consumer<TimelineEvent> timeline) {
    this(console, timeline, Optional.empty());
  }

  @Override
  public void opened() throws IOException {
    begun.begin();
  }

  @Override
  public void problem(Problem problem) {
    console.problem(problem);
  }

  @Override
  public void happened(TimelineEvent event) {
    timeline.accept(event);
  }

  @Override
  public void stepped(double t, long polygons) {
    frames.stepped(t, polygons);
  }

  @Override
  public void printed(String text) {
    text.lines().forEach(console::message);
  }
}
