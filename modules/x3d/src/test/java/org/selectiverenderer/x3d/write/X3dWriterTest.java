package org.selectiverenderer.x3d.write;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

class X3dWriterTest {
  private static X3dFile read(String text) {
    ProblemCollector problems = new ProblemCollector();
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    X3dFile file = new X3dReader(NodeCatalogue.load()).read("a.x3d", bytes, problems);
    assertThat(problems.list()).isEmpty();
    return file;
  }

  @Test
  void anElementStandsOnALineAndEndsInItsTagWhenItIsEmpty() {
    X3dWriter out = new X3dWriter().file("Interchange", "3.3");
    out.open("head").meta("title", "a.x3d").unit("length", "feet", 0.3048).close();
    out.open("Scene").comment("A box.").open("Shape").def("Box").material();
    out.open("Box").attribute("size", "1 1 1").close().close();
    out.open("Group");

    assertThat(out.finish())
        .isEqualTo(
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <X3D profile='Interchange' version='3.3'>
              <head>
                <meta name='title' content='a.x3d'/>
                <unit category='length' name='feet' conversionFactor='0.3048'/>
              </head>
              <Scene>
                <!-- A box. -->
                <Shape DEF='Box'>
                  <Appearance>
                    <Material/>
                  </Appearance>
                  <Box size='1 1 1'/>
                </Shape>
                <Group/>
              </Scene>
            </X3D>
            """);
  }

  @Test
  void valuesReadBackAsTheyWere() {
    String[] strings = {"Tom's \"A\\B\" & <c>", "two\nlines\tand a tab", ""};
    X3dWriter out = new X3dWriter().file("Immersive", "3.3").open("Scene");
    out.empty("WorldInfo", "DEF", "Info", "info", FieldValueFormatter.strings(strings));

    assertThat(read(out.finish()).named().get("Info").strings("info")).containsExactly(strings);
  }

  @Test
  void anAttributeAfterItsTagIsAMistake() {
    X3dWriter out = new X3dWriter().empty("Group");

    assertThatThrownBy(() -> out.attribute("DEF", "Late"))
        .isInstanceOf(IllegalStateException.class);
  }

  @Test
  void theSecondOccurrenceOfANodeIsAUse() {
    String scene =
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <X3D profile='Immersive' version='3.3'>
          <Scene>
            <Shape>
              <Appearance DEF='Look'>
                <Material diffuseColor='1 0 0.25'/>
              </Appearance>
              <Sphere/>
            </Shape>
            <Collision>
              <Shape containerField='proxy'>
                <Appearance USE='Look'/>
                <Box/>
              </Shape>
            </Collision>
          </Scene>
        </X3D>
        """;
    X3dWriter out = new X3dWriter().file("Immersive", "3.3").open("Scene");
    X3dNodeWriter nodes = new X3dNodeWriter(out, X3dNodeWriter.Written.GIVEN);
    read(scene).nodes().forEach(node -> nodes.append(node, "", (of, url) -> url));

    assertThat(out.finish()).isEqualTo(scene);
  }

  @Test
  void fullLinesAreBroken() {
    TupleListBuilder two = TupleListBuilder.perLine(2);
    TupleListBuilder wide = TupleListBuilder.wide(4);
    for (int i = 10; i < 15; i++) {
      two.next().append(i);
      wide.next().append(i);
    }

    assertThat(two.text().toString()).isEqualTo("10 11\n12 13\n14");
    assertThat(wide.text().toString()).isEqualTo("10 11\n12 13\n14");
    assertThat(
            TupleListBuilder.perLine(2).triangles(new int[] {0, 1, 2, 2, 1, 3}).text().toString())
        .isEqualTo("0 1 2 -1 2 1 3 -1");
  }

  @Test
  void whatMakesTheTextLongerThanItMayBeIsRefused() {
    X3dWriter out = new X3dWriter(100, 1000).open("Coordinate").attribute("DEF", "a");

    assertThatExceptionOfType(UncheckedIOException.class)
        .isThrownBy(() -> out.numbers("point", "0 ".repeat(500)))
        .havingCause()
        .withMessageContaining("an X3D text of more than 0.0 MB, which is the limit");
    assertThat(out.finish()).isEqualTo("<Coordinate DEF='a'/>\n");
  }
}
