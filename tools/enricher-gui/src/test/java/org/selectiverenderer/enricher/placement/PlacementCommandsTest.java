package org.selectiverenderer.enricher.placement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.NoScene;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Placing selected nodes without a picture of the scene. */
class PlacementCommandsTest {
  @TempDir Path folder;

  private static DocumentElement named(EnricherSession session, String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  private static List<String> selected(EnricherSession session) {
    return get(
        () ->
            session.selectedElements().stream()
                .map(each -> each.def().orElse("unnamed " + each.name()))
                .toList());
  }

  private static void nudge(EnricherSession session, String... names) {
    edt(
        () -> {
          session.selectAll(Stream.of(names).map(name -> named(session, name)).toList(), session);
          new PlacementCommands(session, new NoScene()).nudge(new Vector3d(1, 0, 0));
        });
  }

  @Test
  void nodesThatGetATransformStaySelected() throws IOException {
    EnricherSession session =
        TestSessions.with(
            folder,
            """
              <Group DEF='Room'>
                <Transform DEF='Fan'><Shape DEF='Blades'><Box/></Shape><Shape/></Transform>
                <Shape DEF='Chair'><Box/></Shape>
                <Transform DEF='Still' translation='1 1 1'><Shape/><Shape/></Transform>
              </Group>
              <ROUTE fromNode='I' fromField='value_changed' toNode='Fan' toField='rotation'/>
            """);
    nudge(session, "Fan");
    assertThat(selected(session)).containsExactly("Fan");
    nudge(session, "Chair", "Fan", "Still");
    assertThat(selected(session)).containsExactly("Chair", "Fan", "Still");
    assertThat(session.document().text().toString())
        .contains("<Transform translation='2 0 0'>")
        .contains("<Transform DEF='Fan'><Shape")
        .contains("<Transform DEF='Still' translation='2 1 1'>");
    assertThat(session.document().history().names()).hasSize(2);
  }

  @Test
  void aNodeInOneThatGetsATransformStaysSelectedToo() throws IOException {
    EnricherSession session =
        TestSessions.with(
            folder,
            """
              <Group DEF='Table'>
                <Shape DEF='Leg'><Box/></Shape>
                <Transform DEF='Top'>
                  <Shape DEF='Plate'><Box/></Shape>
                  <Shape DEF='Cup'><Box/></Shape>
                </Transform>
              </Group>
            """);
    nudge(session, "Cup", "Table");
    assertThat(selected(session)).containsExactly("Cup", "Table");
    assertThat(named(session, "Table").parent().orElseThrow().text("translation"))
        .contains("1 0 0");
  }
}
