package org.selectiverenderer.authoring.editing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Elements taken out of a document and put in. */
class ElementEditsTest {
  private static final String SCENE =
      """
      <X3D>
        <Scene>
          <Group DEF='A'>
            <TimeSensor DEF='T'/>
          </Group>
          <Group DEF='B'/> <!-- stays -->
          <Group USE='B'/>
          <ROUTE fromNode='T' fromField='isActive' toNode='B' toField='x'/>
        </Scene>
      </X3D>
      """;

  private final SceneDocument document;
  private final ElementEdits edits;

  ElementEditsTest() throws IOException {
    document = SceneDocument.of("scene.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
    edits = new ElementEdits(document);
  }

  private DocumentElement named(String def) {
    return document.tree().orElseThrow().named(def).orElseThrow();
  }

  private String text() {
    return document.snapshot().text();
  }

  @Test
  void aNodeGoesWithItsRoutesAndNothingElse() {
    document.perform(edits.remove(named("A"), "Cut"));
    assertThat(text())
        .isEqualTo(
            """
            <X3D>
              <Scene>
                <Group DEF='B'/> <!-- stays -->
                <Group USE='B'/>
              </Scene>
            </X3D>
            """);
    document.history().undo();
    assertThat(text()).isEqualTo(SCENE);
  }

  @Test
  void whatIsNeededStays() {
    assertThatThrownBy(() -> edits.remove(named("B"), "Cut"))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("line 7");
    DocumentElement root = document.tree().orElseThrow().root();
    assertThatThrownBy(() -> edits.remove(root, "Cut")).isInstanceOf(EditRejectedException.class);
    assertThat(NodeEdits.removable(root.children().get(0))).isFalse();
  }

  @Test
  void namesOfPrototypesAreOthersAndExportsGo() throws IOException {
    String kept =
        "<ProtoDeclare name='P'><ProtoBody><Group DEF='A'/><Group USE='A'/></ProtoBody></ProtoDeclare>";
    SceneDocument with =
        SceneDocument.of(
            "scene.x3d",
            ("<X3D><Scene><Transform DEF='A'/><EXPORT localDEF='A'/>" + kept + "</Scene></X3D>")
                .getBytes(StandardCharsets.UTF_8));
    DocumentElement scene = with.tree().orElseThrow().root().children().get(0);
    with.perform(new ElementEdits(with).remove(scene.children().get(0), "Cut"));
    assertThat(with.snapshot().text()).isEqualTo("<X3D><Scene>" + kept + "</Scene></X3D>");
  }

  @Test
  void whatIsPastedIsIndentedAndNamesAnew() {
    String copied = document.text(named("A"));
    document.perform(edits.paste(named("T"), copied, "Paste"));
    assertThat(text())
        .contains(
            """
                  <TimeSensor DEF='T'/>
                  <Group DEF='A_2'>
                    <TimeSensor DEF='T_2'/>
                  </Group>
                </Group>
            """);
    DocumentElement root = document.tree().orElseThrow().root();
    document.perform(edits.paste(root, "<Shape>\r\n</Shape>", "Paste"));
    assertThat(text()).contains("toField='x'/>\n    <Shape>\n    </Shape>\n  </Scene>");
  }

  @Test
  void whatIsNoElementIsNotPasted() {
    for (String text : new String[] {"", "words", "<a><b></a>", "<a/><b/>"}) {
      assertThatThrownBy(() -> edits.paste(named("A"), text, "Paste"))
          .isInstanceOf(EditRejectedException.class)
          .hasMessageStartingWith("The clipboard contains no");
    }
  }
}
