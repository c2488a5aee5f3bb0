package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Lines and columns of elements, attributes and words of values, held against the text itself. */
class DocumentLocationsTest {
  private static final String TAG =
      """
      <X3D xmlns:xsd='http://www.w3.org/2001/XMLSchema-instance'
           profile='Immersive'
        version = "3.3"
        xsd:noNamespaceSchemaLocation='x'><Scene
        ><Transform
        DEF='a' rotation='0 1 0
              2' \tscale
          =
          '1 two 1'/></Scene></X3D>
      """;

  static Stream<Arguments> beginnings() {
    return Stream.of("\n", "\r\n", "\r")
        .flatMap(
            end ->
                Stream.of(
                        "",
                        "<?xml version='1.0'?>",
                        "<?xml version='1.0'?>\n",
                        "<?xml version='1.0'?>\n\n\t ",
                        "<?xml version='1.0'?>\n<!DOCTYPE X3D>\n",
                        "<?xml version='1.0'?>\n<!-- \u00e9 -->\n  \n<?pi x?>   \n ",
                        "\n\n")
                    .flatMap(
                        head ->
                            Stream.of(StandardCharsets.UTF_8, StandardCharsets.UTF_16)
                                .map(set -> Arguments.of((head + TAG).replace("\n", end), set))));
  }

  @ParameterizedTest
  @MethodSource("beginnings")
  void areThoseOfTheText(String text, Charset charset) throws IOException {
    if (text.startsWith("\n") || text.startsWith("\r")) {
      charset = StandardCharsets.UTF_8;
    }
    XmlDocument document = document(text, charset);
    DocumentElement root = document.root().orElseThrow();
    DocumentElement node = document.elements().get(2);

    assertThat(root.location()).isEqualTo(place(text, "<X3D"));
    assertThat(attribute(root, "version").location()).isEqualTo(place(text, "version = "));
    assertThat(attribute(root, "profile").location()).isEqualTo(place(text, "profile="));
    assertThat(node.location()).isEqualTo(place(text, "<Transform"));
    assertThat(attribute(node, "scale").location()).isEqualTo(place(text, "scale"));
    assertThat(attribute(node, "DEF").location()).isEqualTo(place(text, "DEF"));
    assertThat(attribute(node, "rotation").location()).isEqualTo(place(text, "rotation"));
    FieldParser.Flaw flaw = attribute(node, "scale").flaws(FieldType.SFVec3f).get(0);
    assertThat(attribute(node, "scale").location(flaw.offset())).isEqualTo(place(text, "two"));
  }

  @Test
  void ofThousandsOfAttributesAreFoundInAnyOrder() throws IOException {
    StringBuilder text = new StringBuilder("<X3D\n");
    for (int i = 0; i < 5000; i++) {
      text.append("a").append(i).append("='").append(i % 7 == 0 ? "\n" : "").append("' ");
    }
    String scene = text + "/>";
    List<DocumentAttribute> all =
        document(scene, StandardCharsets.UTF_8).root().orElseThrow().attributes();
    assertThat(all).hasSize(5000);
    for (int i = 0; i < 5000; i++) {
      int index = i % 50 == 0 ? 4999 - i : i;
      assertThat(all.get(index).location()).isEqualTo(place(scene, "a" + index + "="));
    }
  }

  private static DocumentAttribute attribute(DocumentElement element, String name) {
    return element.attribute(name).orElseThrow();
  }

  private static XmlDocument document(String text, Charset charset) throws IOException {
    byte[] bytes = text.getBytes(charset);
    return new X3dReader(NodeCatalogue.load())
        .document("s.x3d", new ByteArrayInputStream(bytes), bytes.length);
  }

  /** Counted by the book: a line ends by LF, CR or both. */
  private static SourceLocation place(String text, String word) {
    String before = text.substring(0, text.indexOf(word));
    String[] lines = before.split("\r\n|\r|\n", -1);
    return new SourceLocation("s.x3d", lines.length, lines[lines.length - 1].length() + 1);
  }
}
