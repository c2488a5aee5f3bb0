package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class RoutesTest {
  private static final String NODES =
      "<TimeSensor DEF='Clock'/><PositionInterpolator DEF='Path'/><Transform DEF='T'/>\n";

  private final ReaderFixture fixture = new ReaderFixture();

  private List<String> routes(String content) {
    return ReaderFixture.routes(fixture.scene(content));
  }

  @Test
  void understandsBothSpellingsOfFieldNames() {
    assertThat(
            routes(
                NODES
                    + "<ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Path' toField='set_fraction'/>"
                    + "<ROUTE fromNode='Path' fromField='value_changed' toNode='T' toField='translation'/>"
                    + "<ROUTE fromNode='T' fromField='translation_changed' toNode='T' toField='set_scale'/>"))
        .containsExactly(
            "Clock.fraction_changed -> Path.set_fraction",
            "Path.value_changed -> T.translation",
            "T.translation -> T.scale");
    fixture.assertClean();
  }

  @Test
  void aRouteMayStandBeforeItsNodes() {
    assertThat(
            routes(
                "<ROUTE fromNode='A' fromField='scale' toNode='B' toField='scale'/>"
                    + "<Transform DEF='A'/><Transform DEF='B'/>"))
        .containsExactly("A.scale -> B.scale");
    fixture.assertClean();
  }

  @Test
  void aRouteMeansTheNodesThatHaveTheNamesWhereItStands() {
    X3dFile file =
        fixture.scene(
            "<Transform DEF='A'/><Transform DEF='B'/>"
                + "<ROUTE fromNode='A' fromField='scale' toNode='B' toField='scale'/>"
                + "<Transform DEF='A'/>");
    assertThat(file.routes().get(0).from()).isSameAs(file.nodes().get(0));
  }

  @Test
  void saysWhatIsWrongWithARoute() {
    assertThat(
            routes(
                NODES
                    + "<ROUTE fromNode='Cloc' fromField='time' toNode='T' toField='scale'/>\n"
                    + "<ROUTE fromNode='Clock' fromField='tim' toNode='T' toField='scale'/>\n"
                    + "<ROUTE fromNode='T' fromField='bboxSize' toNode='T' toField='scale'/>\n"
                    + "<ROUTE fromNode='T' fromField='scale' toNode='Path' toField='value_changed'/>\n"
                    + "<ROUTE fromNode='Clock' fromField='time' toNode='T' toField='scale'/>\n"
                    + "<ROUTE fromNode='Clock' fromField='time' toNode='T'/>"))
        .isEmpty();
    fixture.assertMessages(
        "test.x3d:8:1: a ROUTE needs fromNode, fromField, toNode and toField; this one is left out",
        "test.x3d:3:1: no node has the name Cloc (did you mean Clock?); the ROUTE "
            + "Cloc.time to T.scale is left out",
        "test.x3d:4:1: TimeSensor has no field tim (did you mean time?);"
            + " the ROUTE Clock.tim to T.scale is left out",
        "test.x3d:5:1: T.bboxSize does not send events; the ROUTE T.bboxSize to "
            + "T.scale is left out",
        "test.x3d:6:1: Path.value_changed does not receive events; the ROUTE T.scale "
            + "to Path.value_changed is left out",
        "test.x3d:7:1: Clock.time is SFTime and T.scale is SFVec3f;"
            + " the ROUTE Clock.time to T.scale is left out");
  }
}
