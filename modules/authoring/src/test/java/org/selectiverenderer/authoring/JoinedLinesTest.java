package org.selectiverenderer.authoring;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Lines that are put into a line which other elements share. */
class JoinedLinesTest {
  private static String inserted(String... lines) throws IOException {
    SceneDocument document =
        SceneDocument.of(
            "scene.x3d",
            "<X3D><Scene><Group/></Scene></X3D>".getBytes(StandardCharsets.UTF_8));
    var scene = document.tree().orElseThrow().scene().orElseThrow();
    document.perform(
        new Edit("test", List.of(document.layout().insertLast(scene, List.of(lines)))));
    String text = document.text().toString();
    String before = "<X3D><Scene><Group/>";
    assertThat(text).startsWith(before).endsWith("</Scene></X3D>");
    return text.substring(before.length(), text.length() - "</Scene></X3D>".length());
  }

  @Test
  void elementsFollowOneAnother() throws IOException {
    assertThat(inserted("<Group>", "  <Shape/>", "</Group>")).isEqualTo("<Group><Shape/></Group>");
  }

  @Test
  void valuesOverSeveralLinesKeepTheirNumbersApart() throws IOException {
    assertThat(inserted("<Coordinate point='0 0 1,", "    2 3 4'", "    DEF='C'/>", "<Shape/>"))
        .isEqualTo("<Coordinate point='0 0 1,\n    2 3 4'\n    DEF='C'/><Shape/>");
  }

  @Test
  void programsAndCommentsKeepTheirLines() throws IOException {
    assertThat(
            inserted(
                "<Script><![CDATA[ecmascript:", "  // why", "  a > b;", "]]>", "</Script>",
                "<!-- one", "  > two -->", "<Group/>"))
        .isEqualTo(
            "<Script><![CDATA[ecmascript:\n  // why\n  a > b;\n]]></Script>"
                + "<!-- one\n  > two --><Group/>");
  }

  @Test
  void textOverSeveralLinesKeepsThem() throws IOException {
    assertThat(inserted("<Script>", "ecmascript: // why", "a &lt; b;", "</Script>"))
        .isEqualTo("<Script>\necmascript: // why\na &lt; b;\n</Script>");
  }
}
