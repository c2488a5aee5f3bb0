package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What is said of elements without a form. */
class ElementSummaryTest {
  @TempDir Path folder;

  @Test
  void referencesToEntitiesSayWhereTheirElementsAre() throws IOException {
    String scene =
        """
        <!DOCTYPE X3D [
          <!ENTITY chair "<Group DEF='Chair'/>">
          <!ENTITY far SYSTEM "far.xml">
        ]>
        <X3D><Scene>&chair;&far;&unknown;</Scene></X3D>
        """;
    EnricherSession session = TestSessions.open(Files.writeString(folder.resolve("s.x3d"), scene));
    DocumentElement in = session.document().tree().orElseThrow().root().children().get(0);
    assertThat(in.children().stream().map(node -> advice(session, node)).toList())
        .satisfiesExactly(
            chair -> assertThat(chair).contains("line 2", "read-only", "<Group DEF='Chair'/>"),
            far -> assertThat(far).contains("never fetched", "line 3"),
            unknown -> assertThat(unknown).contains("does not declare this entity"));
  }

  @Test
  void aShapeWithoutANameCanHaveVersions() throws IOException {
    EnricherSession session = TestSessions.with(folder, "<Shape><Sphere/></Shape>");
    DocumentElement shape =
        session.document().tree().orElseThrow().scene().orElseThrow().children().get(0);
    ElementSummary said = ElementSummary.of(session.document(), session.catalogue(), shape);
    assertThat(said.advice())
        .startsWith("Versions of it with fewer polygons can be made")
        .contains("Make Versions of Many Objects");
    assertThat(said.versions()).isTrue();
  }

  private static String advice(EnricherSession session, DocumentElement node) {
    return ElementSummary.of(session.document(), session.catalogue(), node).advice();
  }
}
