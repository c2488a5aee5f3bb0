package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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

  @Test
  void aNodeThatHoldsItsVersionsLeadsToThem() throws IOException {
    EnricherSession session =
        TestSessions.with(
            folder,
            "<Transform DEF='Cup'><Switch DEF='Switch_Cup'><Group/></Switch></Transform>"
                + "<Group><Switch DEF='One'/><Switch DEF='Two'/></Group>");
    List<DocumentElement> nodes =
        session.document().tree().orElseThrow().scene().orElseThrow().children();
    ElementSummary cup =
        ElementSummary.of(session.document(), session.catalogue(), nodes.get(0));
    assertThat(cup.advice()).isEqualTo("It holds Switch Switch_Cup, whose choices are its versions.");
    assertThat(cup.formed()).contains(nodes.get(0).children().get(0));
    assertThat(cup.versions()).isFalse();
    ElementSummary both =
        ElementSummary.of(session.document(), session.catalogue(), nodes.get(1));
    assertThat(both.formed()).isEmpty();
    assertThat(both.versions()).isTrue();
  }

  private static String advice(EnricherSession session, DocumentElement node) {
    return ElementSummary.of(session.document(), session.catalogue(), node).advice();
  }
}
