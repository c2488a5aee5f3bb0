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
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.lsl.StreamInfo;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineJson;

/** The Lab Streaming Layer (LSL) streams that a run or a session sends and records. */
public final class LslStreams implements AutoCloseable {
  /**
   * The members of a session's events that are sent. Answers, conditions and ages are private, as
   * is a participant's place in the schedule, which reveals the condition: these are in the journal
   * only.
   */
  private static final List<String> SENT =
      List.of("step", "run", "t", "what", "object", "place", "text", "flag", "file", "samples");

  private final @Nullable StreamSender sender;
  private final Map<String, Object> about;
  private @Nullable StreamRecorder recorder;

  private LslStreams(@Nullable StreamSender sender, Map<String, Object> about) {
    this.sender = sender;
    this.about = new LinkedHashMap<>(about);
  }

  /** Creates an object that neither sends nor records. */
  public static LslStreams none() {
    return new LslStreams(null, Map.of());
  }

  /**
   * Opens the outgoing streams.
   *
   * @param about members added to every event, such as study, participant and session
   * @param problem receives messages about data that cannot be sent
   * @throws IOException if the library refuses it
   */
  public static LslStreams sending(
      LslLibrary lsl, Map<String, Object> about, BiConsumer<String, Map<String, ?>> problem)
      throws IOException {
    return new LslStreams(
        StreamSender.open(
            lsl, String.valueOf(about), text -> problem.accept("problem", Map.of("text", text))),
        about);
  }

  /**
   * Starts recording.
   *
   * @param predicates LSL predicates that select streams
   * @param tells receives the events {@code stream-began}, {@code stream-ended}, {@code
   *     calibration} and {@code problem}, on the recorder's thread
   * @throws IOException if a predicate is malformed
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
              public void began(StreamInfo stream, Path file) {
                tells.accept(
                    "stream-began",
                    Map.of(
                        "stream", stream.name(),
                        "type", stream.type(),
                        "host", stream.host(),
                        "file", String.valueOf(file.getFileName())));
              }

              @Override
              public void ended(StreamInfo stream, Path file, long samples) {
                tells.accept(
                    "stream-ended",
                    Map.of(
                        "stream", stream.name(),
                        "file", String.valueOf(file.getFileName()),
                        "samples", samples));
              }

              @Override
              public void calibrated(StreamInfo stream, double time, String text) {
                tells.accept(
                    "calibration",
                    Map.of(
                        "by",
                        "stream",
                        "stream",
                        stream.name(),
                        "stream_time",
                        time,
                        "text",
                        text));
              }

              @Override
              public void problem(String text) {
                tells.accept("problem", Map.of("text", text));
              }
            });
  }

  /** Returns the listener that sends poses and gaze; empty when nothing is sent. */
  public Optional<HeadSampleListener> samples() {
    return Optional.ofNullable(sender);
  }

  /**
   * Sends an event of a session's journal without its private members; may be called on any thread.
   */
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

  /** Ends sending and recording; all pending data is sent and written. */
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
