package org.selectiverenderer.walkthrough;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** The apartment divided into files has the time line of the whole one. */
class SplitApartmentTest {
  private static final Pattern ROOM =
      Pattern.compile("\n    <(Group|Transform) DEF='(\\w+)'.*?\n    </\\1>", Pattern.DOTALL);
  private @TempDir Path dir;

  private Path divided() throws IOException {
    String whole = withoutModels();
    String head = whole.substring(0, whole.indexOf("<Scene>") + "<Scene>".length());
    Matcher room = ROOM.matcher(whole);
    StringBuilder building = new StringBuilder();
    while (room.find()) {
      Files.writeString(
          dir.resolve(room.group(2) + ".x3d"), head + room.group() + "</Scene></X3D>");
      room.appendReplacement(building, "<Inline url='\"" + room.group(2) + ".x3d\"'/>");
    }
    return Files.writeString(dir.resolve("building.x3d"), room.appendTail(building).toString());
  }

  /** Neither the objects' files nor pictures are needed to see which is to be shown when. */
  private static String withoutModels() throws IOException {
    return Files.readString(Path.of("scenes/apartment.x3d"))
        .replaceAll("<Inline (DEF='\\w+' )?url='[^']*'/>", "<Group/>")
        .replaceAll("\\w+Url='[^']*'", "");
  }

  private static List<ControlEvent> walk(Path scene) throws IOException {
    List<ControlEvent> events = new ArrayList<>();
    CameraPath path =
        CameraPathReader.read(Path.of("scenes/paths/apartment-tour.csv"), new ProblemCollector())
            .orElseThrow();
    try (Walkthrough walk =
        Walkthrough.open(
            scene,
            Settings.SELECTIVE,
            problem -> assertThat(problem.toString()).isEmpty(),
            event -> events.add(((TimelineEvent.ControllerEvent) event).event()),
            line -> {})) {
      PathMotion motion = new PathMotion(path, 0);
      for (int frame = 0; frame * 0.1 < path.end(); frame++) {
        walk.step(frame * 0.1, motion);
      }
    }
    return events;
  }

  @Test
  void theTimeLineIsTheSame() throws IOException {
    Path whole = Files.writeString(dir.resolve("whole.x3d"), withoutModels());

    List<ControlEvent> events = walk(divided());

    assertThat(events).hasSizeGreaterThan(30).isEqualTo(walk(whole));
    assertThat(dir.resolve("Kitchen.x3d")).exists();
  }
}
