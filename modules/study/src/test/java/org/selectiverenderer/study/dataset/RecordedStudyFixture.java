package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.session.LoadedStudy;

/**
 * A study's folder as sessions leave it: participant 001 with a finished session in which the
 * experimenter paused for two seconds, and P2, whose session a crash has cut off.
 */
public final class RecordedStudyFixture {
  private static final String SCENE =
      "<X3D><Scene><Viewpoint DEF='HallView'/><Shape><Box/></Shape></Scene></X3D>";

  private static final String STUDY =
      """
      {"name": "Hall, tried", "scene": "hall.x3d", "conditions": ["high", "selective"],
       "participants": 4, "fade": 1, "areas": [{"name": "hall", "viewpoint": "HallView", "seconds": 5}],
       "form": "form.json",
       "questionnaires": [{"kind": "recognition", "name": "memory", "items": "r.csv"},
                          {"file": "closing.json"}]}
      """;

  private static final String FORM =
      """
      {"name": "form", "pages": [{"questions": [
        {"id": "name", "kind": "text", "personal": true, "text": "Name"},
        {"id": "eyes", "kind": "text", "text": "Colour of the eyes"}]}]}
      """;

  private static final String CLOSING =
      """
      {"name": "closing", "pages": [{"name": "p1", "questions": [
        {"id": "changes", "kind": "yes-no", "text": "Did something change?"},
        {"id": "which", "kind": "text", "text": "What?",
         "when": {"question": "changes", "is": ["yes"]}},
        {"id": "remarks", "kind": "text", "text": "Remarks"}]}]}
      """;

  private static final String ITEMS =
      """
      area,object,consistency,present,en
      hall,coat,consistent,yes,Coat
      hall,boat,inconsistent,no,Boat
      """;

  private static final String PEOPLE =
      "participant_id\tcondition\tplace\tassigned_by\tinstead_of\tage\tsimulated\tsex\n"
          + "sub-001\tselective\t1\tschedule\tn/a\t18-22\tfalse\tfemale\n"
          + "sub-P2\thigh\t2\texperimenter\tselective\t23-27\tfalse\trather not say\n";

  private static final String FIRST =
      """
      {"time":"2026-03-01T10:00:00.000+02:00","event":"session-began","participant":"001","session":1,"software":"selective-renderer 2.0","machine":"Linux 6.1 amd64 8 processors","unattended":false}
      {"time":"2026-03-01T10:00:01.000+02:00","event":"step-began","step":"form","run":1}
      {"time":"2026-03-01T10:00:07.000+02:00","event":"answer","step":"form","object":"name","value":"Maria Nobody","ms":4000,"place":1}
      {"time":"2026-03-01T10:00:08.000+02:00","event":"answer","step":"form","object":"eyes","value":"brown","ms":1000,"place":2}
      {"time":"2026-03-01T10:00:09.000+02:00","event":"assigned","condition":"selective","place":1}
      {"time":"2026-03-01T10:00:10.000+02:00","event":"step-finished","step":"form"}
      {"time":"2026-03-01T10:00:11.000+02:00","event":"step-began","step":"exposure-hall","run":1,"head_log":"exposure-hall_run-01"}
      {"time":"2026-03-01T10:00:12.000+02:00","event":"scene","step":"exposure-hall","what":{"t":0.0,"event":"start","switches":{"Coat":1}}}
      {"time":"2026-03-01T10:00:13.000+02:00","event":"shown","step":"exposure-hall","t":1.0}
      {"time":"2026-03-01T10:00:14.000+02:00","event":"scene","step":"exposure-hall","what":{"t":2.0,"event":"enter","sensor":"DeskProx","schemas":["DeskSchema"]}}
      {"time":"2026-03-01T10:00:14.000+02:00","event":"scene","step":"exposure-hall","what":{"t":2.0,"event":"switch","switch":"Coat","from":1,"to":0,"schema":"DeskSchema","visible":true,"pixels":1204,"turning":12.5}}
      {"time":"2026-03-01T10:00:15.000+02:00","event":"paused","step":"exposure-hall"}
      {"time":"2026-03-01T10:00:17.000+02:00","event":"continued","step":"exposure-hall"}
      {"time":"2026-03-01T10:00:18.000+02:00","event":"note","text":"sneezed,\\tor \\"coughed\\""}
      {"time":"2026-03-01T10:00:18.500+02:00","event":"scene","step":"exposure-hall","what":{"t":4.5,"event":"exit","sensor":"DeskProx","schemas":[]}}
      {"time":"2026-03-01T10:00:19.000+02:00","event":"flag","flag":"low-frame-rate","step":"exposure-hall"}
      {"time":"2026-03-01T10:00:21.000+02:00","event":"step-finished","step":"exposure-hall","condition":"selective","figures":{"fps":50.0,"frame_ms":{"p50":20,"p99":25,"slow_share":0.0125},"latency_ms":{"p50":8.5,"p99":14},"display":{"refresh_hz":59.95,"vsync":true},"gl":{"renderer":"GeForce"}}}
      {"time":"2026-03-01T10:00:22.000+02:00","event":"step-began","step":"memory-hall","run":1}
      {"time":"2026-03-01T10:00:25.000+02:00","event":"answer","step":"memory-hall","object":"boat","value":"yes","confidence":2,"ms":2500,"place":1}
      {"time":"2026-03-01T10:00:27.000+02:00","event":"answer","step":"memory-hall","object":"coat","value":"yes","confidence":5,"ms":1500,"place":2}
      {"time":"2026-03-01T10:00:28.000+02:00","event":"answer","step":"memory-hall","object":"boat","value":"no","confidence":4,"ms":5500,"place":1}
      {"time":"2026-03-01T10:00:28.500+02:00","event":"answer","step":"memory-hall","object":"boat","value":"no","confidence":3,"ms":6000,"place":1}
      {"time":"2026-03-01T10:00:28.600+02:00","event":"answer","step":"closing","object":"changes","value":"yes","ms":100,"place":1}
      {"time":"2026-03-01T10:00:28.700+02:00","event":"answer","step":"closing","object":"which","value":"the boat","ms":200,"place":2}
      {"time":"2026-03-01T10:00:28.800+02:00","event":"answer","step":"closing","object":"changes","value":"no","ms":300,"place":1}
      {"time":"2026-03-01T10:00:28.900+02:00","event":"answer","step":"closing","object":"remarks","value":"long, \\"but\\" fine","ms":9000,"place":2}
      {"time":"2026-03-01T10:00:28.950+02:00","event":"answer","step":"dropped","object":"phone","value":"210 1234","ms":9000,"place":1}
      {"time":"2026-03-01T10:00:28.960+02:00","event":"step-finished","step":"closing"}
      {"time":"2026-03-01T10:00:29.000+02:00","event":"step-finished","step":"memory-hall"}
      {"time":"2026-03-01T10:00:30.000+02:00","event":"session-finished"}
      """;

  private static final String SECOND =
      """
      {"time":"2026-03-01T11:00:00.000Z","event":"session-began","participant":"P2","session":1,"software":"selective-renderer 2.0","unattended":false}
      {"time":"2026-03-01T11:00:01.000Z","event":"assigned","condition":"high","place":2}
      {"time":"2026-03-01T11:00:02.000Z","event":"no
      {"time":"2026-03-01T11:00:03.000Z","event":"step-began","step":"exposure-hall","run":1,"head_log":"exposure-hall_run-01"}
      {"time":"2026-03-01T11:00:04.000Z","event":"shown","step":"exposure-hall","t":1.0}
      {"time":"2026-03-01T11:00:0""";

  private static final String LOG =
      "t,x,y,z,yaw,pitch,roll,motion,object,distance,version,cone,schemas,frame_ms\n";

  private RecordedStudyFixture() {}

  /** Writes it. */
  public static void write(Path folder) throws IOException {
    Files.writeString(folder.resolve("hall.x3d"), SCENE);
    Files.writeString(folder.resolve("study.json"), STUDY);
    Files.writeString(folder.resolve("r.csv"), ITEMS);
    Files.writeString(folder.resolve("form.json"), FORM);
    Files.writeString(folder.resolve("closing.json"), CLOSING);
    Files.writeString(folder.resolve("participants.tsv"), PEOPLE);
    Path first = Files.createDirectories(folder.resolve("sub-001/ses-01/head"));
    Files.writeString(first.resolveSibling("events.jsonl"), FIRST);
    Files.writeString(
        first.resolve("exposure-hall_run-01_tracker.csv"),
        "t,yaw,pitch,roll,number,wall,mono\n0.5,0,0,0,1,2026-03-01T08:00:12.500Z,100.5\n"
            + "0.51,90,0,0,2,2026-03-01T08:00:12.510Z,100.51\n0.5");
    Path second = Files.createDirectories(folder.resolve("sub-P2/ses-01/head"));
    Files.writeString(second.resolveSibling("events.jsonl"), SECOND);
    for (Path head : List.of(first, second)) {
      Files.writeString(head.resolve("exposure-hall_run-01.csv"), log());
      Files.writeString(head.resolve("exposure-hall_run-01.json"), description());
    }
    Path tracked = second.resolve("exposure-hall_run-01.csv");
    Files.writeString(tracked, withEyes(Files.readString(tracked)));
  }

  /**
   * The eyes look at the boat for two seconds, one of them in view; then nobody sees them, until
   * the last sample's.
   */
  private static String withEyes(String log) {
    List<String> lines = new ArrayList<>(log.lines().toList());
    lines.set(0, lines.get(0) + ",eyes,gaze_yaw,gaze_pitch,gaze_object,gaze_distance,gaze_version");
    for (int i = 1; i < lines.size(); i++) {
      String eyes =
          i < 5 ? "tracked,10,0,Boat,2," : i < lines.size() - 1 ? "lost,,,,," : "tracked,90,0,,,";
      lines.set(i, lines.get(i) + "," + eyes);
    }
    return String.join("\n", lines) + "\n";
  }

  /** Seven seconds at two samples a second: the coat for three seconds, then nothing. */
  private static String log() {
    StringBuilder text = new StringBuilder(LOG);
    for (int i = 0; i <= 14; i++) {
      boolean coat = i >= 2 && i < 8;
      text.append(
          "%s,%s,1.6,0,90,0,0,moved,%s\n"
              .formatted(i / 2.0, 2 * i, coat ? "Coat,2.5,1,Coat,,500" : ",,,,,500"));
    }
    return text.toString();
  }

  private static String description() {
    return """
        {"started": "2026-03-01T10:00:12+02:00", "scene": "hall.x3d", "condition": "selective",
         "tracker": "none", "metres_per_unit": 0.5,
         "field_of_view": {"half_tangent_x": 0.5, "half_tangent_y": 0.4},
         "map": {"areas": [], "rooms": [],
                 "objects": [{"name": "Coat", "box": [0, 0, 0, 1, 1, 1]},
                             {"name": "Boat", "box": [0, 0, 0, 1, 1, 1]}]}}
        """;
  }

  /** The study in the folder. */
  public static LoadedStudy material(Path folder) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    return LoadedStudy.read(folder.resolve("study.json"), problems)
        .orElseThrow(() -> new AssertionError(problems.list()));
  }
}
