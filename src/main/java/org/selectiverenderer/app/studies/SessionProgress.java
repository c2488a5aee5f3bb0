package org.selectiverenderer.app.studies;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.session.JournalContent;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionStep;

/**
 * How far a session is, as its journal tells it while another process writes it.
 *
 * @param steps all steps, in the participant's order as far as it is known
 * @param since when the session began or was resumed; empty where the journal does not tell
 * @param flags the quality flags, each once
 * @param notes the experimenter's notes, in order
 */
public record SessionProgress(
    List<Step> steps,
    State state,
    Optional<Instant> since,
    boolean paused,
    List<SessionFlag> flags,
    List<String> notes) {

  /** The state of a session. */
  public enum State {
    BEGUN,
    FINISHED,
    ABORTED,
    REFUSED
  }

  /** The state of a step. */
  public enum StepState {
    OPEN,
    NOW,
    DONE
  }

  /**
   * A step.
   *
   * @param trials number of finished trials of a block
   */
  public record Step(String id, StepState state, int trials) {}

  public SessionProgress {
    steps = List.copyOf(steps);
    flags = List.copyOf(flags);
    notes = List.copyOf(notes);
  }

  /**
   * Reads a journal.
   *
   * @throws IOException if it cannot be read
   */
  public static SessionProgress read(LoadedStudy material, Path journal) throws IOException {
    return of(
        material.steps().stream().map(SessionStep::id).toList(),
        JournalContent.read(journal).events());
  }

  /**
   * Follows the events of a journal.
   *
   * @param ids the steps of the study
   */
  static SessionProgress of(List<String> ids, List<? extends JsonNode> events) {
    Following following = new Following(ids);
    events.forEach(following::hear);
    return following.progress();
  }

  /** Returns the step that is shown now. */
  public Optional<Step> now() {
    return steps.stream().filter(step -> step.state == StepState.NOW).findFirst();
  }

  /** Returns how many steps are finished. */
  public int done() {
    return (int) steps.stream().filter(step -> step.state == StepState.DONE).count();
  }

  /** The state while events are heard. */
  private static final class Following {
    private final List<String> ids;
    private final Set<String> begun = new LinkedHashSet<>();
    private final Set<String> finished = new LinkedHashSet<>();
    private final Map<String, Integer> trials = new LinkedHashMap<>();
    private final Set<SessionFlag> flags = new LinkedHashSet<>();
    private final List<String> notes = new ArrayList<>();
    private State state = State.BEGUN;
    private Optional<Instant> since = Optional.empty();
    private Optional<String> now = Optional.empty();
    private boolean paused;

    Following(List<String> ids) {
      this.ids = ids;
    }

    void hear(JsonNode event) {
      String trial = event.path("trial").isNumber() ? event.path("block").asText() : "";
      String step = trial.isEmpty() ? event.path("step").asText() : trial;
      switch (event.path("event").asText()) {
        case "session-began", "resumed" -> {
          state = State.BEGUN;
          since = time(event);
          now = Optional.empty();
          paused = false;
        }
        case "step-began" -> {
          begun.add(step);
          now = Optional.of(step);
        }
        case "step-finished" -> finished(step, !trial.isEmpty());
        case "paused" -> paused = true;
        case "continued" -> paused = false;
        case "flag" -> SessionFlag.of(event.path("flag").asText()).ifPresent(flags::add);
        case "note" -> notes.add(event.path("text").asText());
        case "aborted" -> state = State.ABORTED;
        case "refused" -> state = State.REFUSED;
        case "session-finished" -> state = State.FINISHED;
        default -> {
          // Other events say nothing about how far the session is.
        }
      }
    }

    private void finished(String step, boolean trial) {
      if (trial) {
        trials.merge(step, 1, Integer::sum);
        return;
      }
      begun.add(step);
      finished.add(step);
      if (now.filter(step::equals).isPresent()) {
        now = Optional.empty();
      }
    }

    private static Optional<Instant> time(JsonNode event) {
      try {
        return Optional.of(Instant.parse(event.path("time").asText()));
      } catch (DateTimeParseException e) {
        return Optional.empty();
      }
    }

    SessionProgress progress() {
      // Areas come in the participant's order, which the study does not tell: what has begun first.
      Set<String> order = new LinkedHashSet<>(begun);
      order.retainAll(ids);
      order.addAll(ids);
      List<Step> steps = new ArrayList<>();
      for (String id : order) {
        StepState where =
            finished.contains(id)
                ? StepState.DONE
                : state == State.BEGUN && now.filter(id::equals).isPresent()
                    ? StepState.NOW
                    : StepState.OPEN;
        steps.add(new Step(id, where, trials.getOrDefault(id, 0)));
      }
      return new SessionProgress(steps, state, since, paused, List.copyOf(flags), notes);
    }
  }
}
