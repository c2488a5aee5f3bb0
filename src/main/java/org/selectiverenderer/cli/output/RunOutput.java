package org.selectiverenderer.cli.output;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.head.SampleListener;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.base.problem.Problem;

/**
 * Where a run's words go: what is wrong and what is printed to the messages.
 *
 * @param timeline takes the time line
 * @param samples hears of every frame
 * @param begun called when the scene has been read, before the first frame
 */
public record RunOutput(
    Console console,
    Consumer<TimelineEvent> timeline,
    Optional<SampleListener> samples,
    Beginning begun)
    implements RunListener {
  /** What is done before the first frame. */
  @FunctionalInterface
  public interface Beginning {
    /**
     * @throws IOException with one line, if the scene is not to be run
     */
    void begin() throws IOException;
  }

  /** With nothing to do before the first frame. */
  public RunOutput(
      Console console, Consumer<TimelineEvent> timeline, Optional<SampleListener> samples) {
    this(console, timeline, samples, () -> {});
  }

  /** With nobody who hears of every frame. */
  public RunOutput(Console console, Consumer<TimelineEvent> timeline) {
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
  public void printed(String text) {
    console.message(text);
  }
}
