package org.selectiverenderer.polygon;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.polygon.SmallScene.area;
import static org.selectiverenderer.polygon.SmallScene.document;
import static org.selectiverenderer.polygon.SmallScene.object;
import static org.selectiverenderer.polygon.SmallScene.shape;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.IncrementalSceneCounter.CountResult;
import org.selectiverenderer.polygon.PolygonContributions.ObjectShare;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Counting while a scene is edited. */
class IncrementalSceneCounterTest {
  @TempDir Path folder;
  private final IncrementalSceneCounter counter = new IncrementalSceneCounter();

  private CountResult count(String... content) throws IOException {
    byte[] text = document(content).getBytes(StandardCharsets.UTF_8);
    return counter.count(
        folder.resolve("scene.x3d"), "scene.x3d", text, ContentAccessPolicy.none());
  }

  @Test
  void theSharesAreWhatTheStatisticsCount() throws IOException {
    String[] content = {
      "<Group DEF='Room'>",
      area("Desk", "Office", 0),
      shape(5),
      object("Switch_A", "Desk:100", "Office:10"),
      "<Transform translation='5 0 0'><Switch USE='Switch_A'/></Transform>",
      object("Switch_B", "Office:20", "Desk:200"),
      "</Group>"
    };
    CountResult counted = count(content);
    assertThat(counted.statistics())
        .isEqualTo(
            new SceneStatistics(
                "scene.x3d",
                SmallScene.count(folder, new ProblemCollector(), content).totalHigh(),
                SmallScene.count(folder, new ProblemCollector(), content).objects(),
                SmallScene.count(folder, new ProblemCollector(), content).scopes()));
    PolygonContributions desk = counted.states().get(1);
    assertThat(desk.scope()).isEqualTo("Room");
    assertThat(desk.schemas()).containsExactly("Desk");
    assertThat(desk.fixed()).isEqualTo(5);
    assertThat(desk.objects())
        .containsExactly(
            new ObjectShare("Switch_A", 0, List.of(100L, 10L), 2, 200),
            new ObjectShare("Switch_B", 1, List.of(20L, 200L), 1, 200));
    assertThat(desk.polygons()).isEqualTo(405);
  }

  @Test
  void onlyFilesThatHaveChangedAreReadAgain() throws IOException {
    Path chair = Files.writeString(folder.resolve("chair.x3d"), document(shape(30)));
    Path seat = Files.writeString(folder.resolve("seat.x3d"), document(shape(7)));
    Files.writeString(folder.resolve("sofa.x3d"), document(shape(40), "<Inline url='seat.x3d'/>"));
    String[] content = {"<Inline url='chair.x3d'/>", "<Inline url='sofa.x3d'/>", shape(1)};
    assertThat(count(content).filesRead()).isEqualTo(4);
    CountResult again = count(content);
    assertThat(again.filesRead()).isEqualTo(1);
    assertThat(again.statistics().totalHigh()).isEqualTo(78);

    Files.writeString(seat, document(shape(8)));
    Files.setLastModifiedTime(seat, FileTime.fromMillis(1_000_000));
    CountResult changed = count(content);
    assertThat(changed.filesRead()).isEqualTo(2);
    assertThat(changed.statistics().totalHigh()).isEqualTo(79);

    Files.delete(chair);
    assertThat(count(content).statistics().totalHigh()).isEqualTo(49);
    counter.forget();
    assertThat(count(content).filesRead()).isEqualTo(3);
  }
}
