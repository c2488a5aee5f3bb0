package org.selectiverenderer.app.trigger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.definition.TriggerSettings;
import org.selectiverenderer.study.definition.TriggerSettings.Code;
import org.selectiverenderer.study.definition.TriggerSettings.Line;
import org.selectiverenderer.study.definition.TriggerSettings.Signal;
import org.selectiverenderer.study.definition.TriggerSettings.Wire;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.tracker.emulator.PseudoTerminal;

/** What a session's events send, and what the journal tells of it. */
class TriggerSenderTest {
  @TempDir Path folder;
  private final List<String> sent = new CopyOnWriteArrayList<>();
  private final List<String> told = new CopyOnWriteArrayList<>();

  /** An output that keeps what it gets, and fails as often as it is told to. */
  private final class Recording implements TriggerOutput {
    private int failures;

    @Override
    public void send(int code) throws IOException {
      if (failures-- > 0) {
        throw new IOException("the cable is out");
      }
      sent.add(String.valueOf(code));
    }

    @Override
    public void line(Wire wire, boolean on) {
      sent.add(wire.spelling() + (on ? " on" : " off"));
    }

    @Override
    public void close() {
      sent.add("closed");
    }
  }

  @BeforeEach
  void study() throws IOException {
    Files.writeString(
        folder.resolve("study.json"),
        """
        {"name": "Two", "conditions": ["high", "selective"], "participants": 4, "questionnaires": [{"file": "q.json"}]}
        """);
    Files.writeString(
        folder.resolve("q.json"),
        """
        {"name": "q", "pages": [{"questions": [{"id": "liked", "kind": "yes-no", "text": "?"}]}]}
        """);
  }

  private Session session() throws IOException {
    LoadedStudy material =
        LoadedStudy.read(folder.resolve("study.json"), new ProblemCollector()).orElseThrow();
    return Session.begin(
        material,
        "001",
        1,
        new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
        new ProblemCollector());
  }

  private static TriggerSettings settings(Object... events) {
    Map<String, Signal> signals = new LinkedHashMap<>();
    for (int i = 0; i < events.length; i += 2) {
      signals.put((String) events[i], (Signal) events[i + 1]);
    }
    return new TriggerSettings("none", 9600, signals);
  }

  private List<JsonNode> journal(String event) throws IOException {
    List<JsonNode> found = new ArrayList<>();
    for (String line : Files.readAllLines(folder.resolve("sub-001/ses-01/events.jsonl"))) {
      JsonNode read = JsonTree.parse(line);
      if (read.path("event").asText().equals(event)) {
        found.add(read);
      }
    }
    return found;
  }

  @Test
  void bytesOfEventsAndSignalsAreSentInOrderAndLogged() throws IOException {
    TriggerSettings settings =
        settings(
            "step-began", new Code("1", 0),
            "fixation-began", new Code("2", 0),
            "response", new Code("{code}", 0),
            "session-finished", new Code("9", 0));
    try (TriggerSender opened = TriggerSender.open(settings, Recording::new);
        Session session = session();
        TriggerSender sender = opened.follow(session.journal(), told::add)) {
      session.journal().listen(sender::event);
      session.journal().tell("step-began", Map.of("step", "main-001"));
      session.journal().signal("fixation-began", "main-001", text -> text);
      session.journal().signal("blank-began", "main-001", text -> text);
      session.journal().signal("response", "main-001", text -> text.replace("{code}", "77"));
      session.journal().tell("session-finished", Map.of());
    }
    assertThat(sent).containsExactly("1", "2", "77", "9", "closed");
    assertThat(told).isEmpty();
    assertThat(journal("trigger"))
        .extracting(line -> line.path("at").asText() + " " + line.path("byte").asInt())
        .containsExactly("step-began 1", "fixation-began 2", "response 77", "session-finished 9");
    assertThat(journal("trigger").get(0).path("step").asText()).isEqualTo("main-001");
    assertThat(journal("trigger"))
        .allSatisfy(
            line -> {
              assertThat(line.path("sent_mono").asDouble())
                  .isLessThanOrEqualTo(line.path("mono").asDouble());
              assertThat(line.path("latency_ms").asDouble()).isNotNegative();
            });
  }

  @Test
  void aColumnOfAnEventsStimulusIsTheByte() throws IOException {
    try (TriggerSender sender =
        TriggerSender.open(settings("step-began", new Code("{code}", 0)), Recording::new)) {
      sender.event(
          JsonTree.parse(
              "{\"event\":\"step-began\",\"step\":\"a\",\"levels\":{},\"stimulus\":{\"code\":\"42\"}}"));
    }
    assertThat(sent).containsExactly("42", "closed");
  }

  @Test
  void signalsThatLastEndByThemselvesOrBeforeTheNextOne() throws IOException {
    TriggerSettings settings =
        settings(
            "note", new Code("5", 900),
            "response", new Line(Wire.RTS, 1),
            "page", new Line(Wire.DTR, 900));
    try (TriggerSender sender = TriggerSender.open(settings, Recording::new)) {
      sender.signal("note", "", text -> text);
      sender.signal("response", "", text -> text);
      sender.signal("page", "", text -> text);
    }
    assertThat(sent).containsExactly("5", "0", "rts on", "rts off", "dtr on", "dtr off", "closed");
  }

  @Test
  void whatCannotBeSentIsFlaggedOnceForAStepAndThePortIsOpenedAgain() throws IOException {
    List<Recording> opened = new ArrayList<>();
    TriggerOutput.Opener opener =
        () -> {
          Recording output = new Recording();
          output.failures = opened.size() < 2 ? 1 : 0;
          opened.add(output);
          return output;
        };
    try (TriggerSender first = TriggerSender.open(settings("response", new Code("3", 0)), opener);
        Session session = session();
        TriggerSender sender = first.follow(session.journal(), told::add)) {
      for (int i = 0; i < 3; i++) {
        sender.signal("response", "main-001", text -> text);
      }
    }
    assertThat(sent).containsExactly("closed", "closed", "3", "closed");
    assertThat(told).containsExactly("the trigger of response was not sent: the cable is out");
    assertThat(journal("flag"))
        .singleElement()
        .satisfies(
            flag -> {
              assertThat(flag.path("flag").asText()).isEqualTo("trigger-failed");
              assertThat(flag.path("step").asText()).isEqualTo("main-001");
            });
  }

  @Test
  void aPortThatIsNotThereIsToldBeforeTheSession() {
    TriggerSettings settings =
        new TriggerSettings(
            folder.resolve("none").toString(), 9600, Map.of("response", new Code("1", 0)));
    assertThatThrownBy(() -> TriggerSender.of(Optional.of(settings)).close())
        .isInstanceOf(IOException.class)
        .hasMessageContaining("there is no serial port");
  }

  @Test
  void aStudyWithoutTriggersOpensNothing() throws IOException {
    try (TriggerSender sender = TriggerSender.of(Optional.empty())) {
      sender.signal("response", "", text -> text);
    }
  }

  @Test
  void bytesComeOutOfARealPort() throws IOException {
    PseudoTerminal.Maker maker = PseudoTerminal.Maker.SOCAT;
    assumeTrue(maker.installed(), "socat is not installed");
    Path link = folder.resolve("port");
    try (PseudoTerminal terminal = PseudoTerminal.open(link, maker);
        TriggerSender sender =
            TriggerSender.of(
                Optional.of(
                    new TriggerSettings(
                        link.toString(), 115_200, Map.of("response", new Code("{n}", 0)))))) {
      byte[] expected = new byte[255];
      for (int i = 1; i <= 255; i++) {
        String code = String.valueOf(i);
        expected[i - 1] = (byte) i;
        sender.signal("response", "", text -> code);
      }
      assertThat(terminal.input().readNBytes(255)).isEqualTo(expected);
    }
  }
}
