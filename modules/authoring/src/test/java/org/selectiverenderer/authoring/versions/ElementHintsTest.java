package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.authoring.versions.ElementHints.Hint;

/** Elements without names are told apart by what is in them. */
class ElementHintsTest {
  private static List<String> hints(String nodes) {
    EnrichmentScenes scene = EnrichmentScenes.with(nodes);
    ElementHints hints = new ElementHints(scene.document);
    return scene.document.tree().orElseThrow().scene().orElseThrow().children().stream()
        .map(hints::of)
        .map(hint -> hint.map(ElementHintsTest::text).orElse("-"))
        .toList();
  }

  private static String text(Hint hint) {
    return hint.content() + (hint.polygons() > 0 ? ":" + hint.polygons() : "");
  }

  @Test
  void theHintIsWhatAReaderTakesTheElementFor() {
    assertThat(
            hints(
                """
                <!-- The office chair -->
                <Transform><Shape><Sphere/></Shape><Shape><Box/></Shape></Transform>
                <Transform><Transform><Group DEF='Desk'/></Transform></Transform>
                <Transform><ProtoInstance name='Lamp'/></Transform>
                <ProtoInstance name='Lamp'/>
                <Inline url='"models/vase.x3d"'/>
                <Transform><Shape><Sphere/></Shape></Transform>
                <Group><Shape><Sphere/></Shape><Shape><Box/></Shape></Group>
                <Group DEF='Named'><Shape DEF='Cup'/></Group>
                <Transform USE='Named'/>
                <Viewpoint/>
                """))
        .containsExactly(
            "Office_chair", "Desk", "Lamp", "Lamp", "Vase", "Sphere", "-", "-", "-", "-");
  }

  @Test
  void facesAreCountedAsTriangles() {
    assertThat(
            hints(
                """
                <Transform><Shape>
                  <IndexedFaceSet coordIndex='0 1 2 3 -1, 4,5,6,-1 7 8 9 10 11'/>
                </Shape></Transform>
                <Shape><IndexedTriangleSet index='0 1 2 3 4 5'/></Shape>
                <Shape><IndexedFaceSet coordIndex=''/></Shape>
                """))
        .containsExactly("IndexedFaceSet:6", "IndexedTriangleSet:2", "IndexedFaceSet");
  }

  @Test
  void aHintFollowsItsElement() {
    EnrichmentScenes scene =
        EnrichmentScenes.with("<Transform><ProtoInstance name='Lamp'/></Transform>");
    ElementHints hints = new ElementHints(scene.document);
    var element = scene.document.tree().orElseThrow().scene().orElseThrow().children().get(0);
    assertThat(hints.of(element)).map(Hint::content).contains("Lamp");
    int at = scene.document.text().toString().indexOf("Lamp");
    scene.document.type(at, at + 4, "Desk");
    var now = scene.document.tree().orElseThrow().scene().orElseThrow().children().get(0);
    assertThat(hints.of(now)).map(Hint::content).contains("Desk");
  }
}
