package org.selectiverenderer.app.stream;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.SampleListener;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.app.timeline.TimelineJson;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.lsl.StreamDescription;

/** What a run or a session sends to the Lab Streaming Layer, and records from it. */
public final class LabStreams implements AutoCloseable {
  /**
   * Members of a session's events that are sent. Answers, conditions and ages are nobody's in the
   * lab's network, nor is a participant's place in the schedule, which tells the condition; all of
   * them are in the journal.
   */
  private static final List<String> SENT =
      List.of("step", "run", "t", "what", "object", "place", "text", "flag", "file", "samples");

  private final @Nullable StreamSender sender;
  private final Map<String, Object> about;
  private @Nullable StreamRecorder recorder;

  private LabStreams(@Nullable StreamSender sender, Map<String, Object> about) {
    this.sender = sender;
    this.about = new LinkedHashMap<>(about);
  }

  /** Nothing is sent or recorded. */
  public static LabStreams none() {
    return new LabStreams(null, Map.of());
  }

  /**
   * Begins to send.
   *
   * @param about what every event says besides, such as study, participant and session
   * @param problem hears what is not sent
   * @throws IOException if the library refuses it
   */
  public static LabStreams sending(
      LslLibrary lsl, Map<String, Object> about, BiConsumer<String, Map<String, ?>> problem)
      throws IOException {
    return new LabStreams(
        StreamSender.open(
            lsl, String.valueOf(about), text -> problem.accept("problem", Map.of("text", text))),
        about);
  }

  /**
   * Begins to record.
   *
   * @param predicates conditions on streams
   * @param tells hears of events {@code stream-began}, {@code stream-ended} and {@code problem}, on
   *     the recorder's thread
   * @throws IOException if a predicate is none
   */
  public void record(
      LslLibrary lsl,
      List<String> predicates,
      Path folder,
      BiConsumer<String, Map<String, ?>> tells)
      throws IOException {
    recorder =
        StreamRecorder.open(
            lsl,
            predicates,
            folder,
            sender == null ? Set.of() : sender.sourceIds(),
            new StreamRecorder.Listener() {
              @Override
              public void began(StreamDescription stream, Path file) {
                tells.accept(
                    "stream-began",
                    Map.of(
                        "stream", stream.name(),
                        "type", stream.type(),
                        "host", stream.host(),
                        "file", String.valueOf(file.getFileName())));
              }

              @Override
              public void ended(StreamDescription stream, Path file, long samples) {
                tells.accept(
                    "stream-ended",
                    Map.of(
                        "stream", stream.name(),
                        "file", String.valueOf(file.getFileName()),
                        "samples", samples));
              }

              @Override
              public void problem(String text) {
                tells.accept("problem", Map.of("text", text));
              }
            });
  }

  /** Sends poses and what is looked at; empty when nothing is sent. */
  public Optional<SampleListener> samples() {
    return Optional.ofNullable(sender);
  }

  /** Sends an event of a session's journal, without what is nobody's; called by any thread. */
  public void event(JsonNode line) {
    StreamSender out = sender;
    if (out != null) {
      ObjectNode event = JsonTree.object();
      String told = line.path("event").asText();
      event.put("event", told);
      for (String member : SENT) {
        if (line.has(member) && !(told.equals("assigned") && member.equals("place"))) {
          event.set(member, line.get(member));
        }
      }
      about.forEach((name, value) -> event.set(name, JsonTree.of(value)));
      out.event(event.toString());
    }
  }

  /** Sends an event of a run's time line. */
  public void happened(TimelineEvent event) {
    StreamSender out = sender;
    if (out != null) {
      out.event(new TimelineJson().line(event));
    }
  }

  /** Ends both; what has come is written, what was told is sent. */
  @Override
  public void close() {
    if (recorder != null) {
      recorder.close();
    }
    if (sender != null) {
      sender.close();
    }
  }
}
