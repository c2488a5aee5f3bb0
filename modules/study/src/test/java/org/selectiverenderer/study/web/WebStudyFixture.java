package org.selectiverenderer.study.web;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.UUID;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.study.session.LoadedStudy;

/** A study with one exposure, and records as its page sends them. */
abstract class WebStudyFixture {
  @TempDir Path folder = Path.of("");
  final ProblemCollector problems = new ProblemCollector();
  Path data = Path.of("");
  private String checksum = "";

  /** A scene of nothing but a coat, which is always in the middle. */
  static final ExposureReplay COAT =
      (study, exposure) ->
          new ExposureReplay.Replayed(
              new HeadLogMetadata(
                  exposure.started().toString(),
                  "hall.x3d",
                  exposure.group().name(),
                  exposure.seed(),
                  exposure.display(),
                  "none",
                  1,
                  1,
                  1,
                  10,
                  false,
                  SceneMap.EMPTY),
              exposure.log().frames().stream()
                  .map(
                      frame ->
                          new ExposureReplay.Seen(
                              "Coat", 2, 0, List.of("Coat"), List.of("HallSchema")))
                  .toList());

  @BeforeEach
  void study() throws IOException {
    Path study = Files.createDirectory(folder.resolve("study"));
    Files.writeString(
        study.resolve("hall.x3d"),
        "<X3D><Scene><Viewpoint DEF='HallView'/><Shape><Box/></Shape></Scene></X3D>");
    Files.writeString(
        study.resolve("form.json"),
        """
        {"name": "form", "pages": [{"questions": [
          {"id": "name", "kind": "text", "personal": true, "text": "Name"},
          {"id": "eyes", "kind": "text", "text": "Colour of the eyes"}]}]}
        """);
    Files.writeString(
        study.resolve("r.csv"),
        """
        area,object,consistency,present,en
        hall,coat,consistent,yes,Coat
        hall,boat,inconsistent,no,Boat
        """);
    Files.writeString(
        study.resolve("study.json"),
        """
        {"name": "Hall", "scene": "hall.x3d", "conditions": ["high", "selective"],
         "participants": 40, "fade": 1, "form": "form.json", "seed": 7,
         "areas": [{"name": "hall", "viewpoint": "HallView", "seconds": 4}],
         "questionnaires": [{"kind": "recognition", "name": "memory", "items": "r.csv"}]}
        """);
    checksum = Sha256.of(Files.readAllBytes(study.resolve("study.json")));
    data = Files.createDirectory(folder.resolve("data"));
  }

  LoadedStudy material() throws IOException {
    return LoadedStudy.read(folder.resolve("study/study.json"), new ProblemCollector())
        .orElseThrow();
  }

  WebSessionImport.Summary collect() throws IOException {
    return collect(data);
  }

  WebSessionImport.Summary collect(Path... from) throws IOException {
    return WebSessionImport.run(material(), List.of(from), "program 1", COAT, problems);
  }

  List<String> told() {
    return problems.list().stream().map(Problem::message).toList();
  }

  static String session(int number) {
    return new UUID(0x40000000L, number).toString();
  }

  /** Returns the condition that the plan has for a place. */
  String group(int slot) throws IOException {
    return org.selectiverenderer.study.session.PlannedSession.all(material())
        .get(slot - 1)
        .group()
        .name();
  }

  /** Returns a record of a session at a place, whose step began at a minute. */
  String record(int session, int slot, String step, int minute, String content) throws IOException {
    return String.format(
        Locale.ROOT,
        "{\"study\":\"Hall\",\"checksum\":\"%s\",\"session\":\"%s\",\"slot\":%d,"
            + "\"participant\":\"%03d\",\"group\":\"%s\",\"condition\":\"%s\",\"language\":\"en\","
            + "\"step\":\"%s\",\"started\":\"2026-11-01T10:%02d:00.000Z\","
            + "\"ended\":\"2026-11-01T10:%02d:30.000Z\",\"origin\":1793527000000,\"mono\":%d,%s}",
        checksum,
        session(session),
        slot,
        slot,
        group(slot),
        group(slot),
        step,
        minute,
        minute,
        60 * minute + 1,
        content);
  }

  String form(int session, int slot) throws IOException {
    return record(
        session,
        slot,
        "form",
        1,
        """
        "interruptions":[],"recruitment":{"PROLIFIC_PID":"person%d"},
        "device":{"browser":"chrome","width":1000,"height":500},
        "answers":[{"page":"p1","question":"name","kind":"text","value":"Maria","ms":900,"place":1},
        {"page":"p1","question":"eyes","kind":"text","value":"brown","ms":1900,"place":2}]
        """
            .formatted(session)
            .replace("\n", ""));
  }

  String exposure(int session, int slot, String more) throws IOException {
    return record(session, slot, "exposure-hall", 2, more + ",\"log\":" + log(60, 6));
  }

  /** Returns a log that begins 10 seconds after its step. */
  static String log(double rate, int seconds) {
    List<String> rows = new ArrayList<>();
    for (int i = 0; i <= rate * seconds; i++) {
      double t = i / rate;
      rows.add(
          String.format(
              Locale.ROOT,
              "[%.6f,1,1.6,%.3f,0,0,0,%.3f,%d,%.6f]",
              t,
              -t / 10,
              i == 0 ? 0 : 1000 / rate,
              t < 0.5 || t > seconds - 0.5 ? 0 : 1,
              131 + t));
    }
    return "{\"columns\":[\"t\",\"x\",\"y\",\"z\",\"yaw\",\"pitch\",\"roll\",\"frame_ms\","
        + "\"visible\",\"mono\"],\"rows\":"
        + rows.stream().collect(Collectors.joining(",", "[", "]"))
        + ",\"events\":[{\"t\":0,\"event\":\"enter\",\"node\":\"HallProx\"},"
        + "{\"t\":0,\"event\":\"switch\",\"node\":\"Coat\",\"choice\":1},"
        + "{\"t\":2.5,\"event\":\"switch\",\"node\":\"Coat\",\"choice\":0}]}";
  }

  String memory(int session, int slot, String coat) throws IOException {
    return record(
        session,
        slot,
        "memory-hall",
        3,
        ("\"interruptions\":[],\"answers\":[{\"page\":\"hall\",\"question\":\"boat\","
                + "\"kind\":\"recognition\",\"value\":\"no\",\"confidence\":\"4\",\"ms\":2000,"
                + "\"place\":1},{\"page\":\"hall\",\"question\":\"coat\",\"kind\":\"recognition\","
                + "\"value\":\"%s\",\"confidence\":\"5\",\"ms\":3000,\"place\":2}]")
            .formatted(coat));
  }

  List<String> whole(int session, int slot) throws IOException {
    return List.of(
        form(session, slot),
        exposure(session, slot, "\"interruptions\":[]"),
        memory(session, slot, "yes"));
  }

  Path write(String name, List<String> lines) throws IOException {
    return Files.writeString(data.resolve(name), String.join("\n", lines) + "\n");
  }

  /** Returns a part of a session as the page posts it. */
  static String part(int session, int part, boolean last, List<String> records) {
    return "{\"study\":\"Hall\",\"session\":\"%s\",\"part\":%d,\"final\":%s,\"records\":[%s]}"
        .formatted(session(session), part, last, String.join(",", records));
  }
}
