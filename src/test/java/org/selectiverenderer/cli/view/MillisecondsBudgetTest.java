package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.testing.RequiresDisplay;

/** {@code --budget ms:T} of frames that are really drawn. */
@RequiresDisplay
class MillisecondsBudgetTest extends CommandTestCase {
  private static final int OBJECTS = 6;
  private static final int SIDE = 40;
  private static final long HIGH = 2L * (SIDE - 1) * (SIDE - 1);
  private static final long LOW = 12;

  @TempDir Path folder;

  private static String version(String degree, String schema) {
    return "<MetadataSet><MetadataString name='consistencyType' value='\"consistent\"'/>"
        + "<MetadataString name='degreeOfConsistency' value='\"%s\"'/>".formatted(degree)
        + "<MetadataString name='schemaBelonginess' value='\"%s\"'/></MetadataSet>"
            .formatted(schema);
  }

  private static String object(int number) {
    String heights = "0 .1 ".repeat(SIDE * SIDE / 2);
    String high =
        "<Shape><Appearance><Material/></Appearance><ElevationGrid solid='false' xDimension='%d'"
                .formatted(SIDE)
            + " zDimension='%d' xSpacing='.02' zSpacing='.02' height='%s'/></Shape>"
                .formatted(SIDE, heights);
    return "<Transform translation='%d -1 -5'><Switch DEF='O%d' whichChoice='1'>"
            .formatted(number - OBJECTS / 2, number)
        + high
        + "<Shape><Box size='.5 .5 .5'/></Shape><MetadataSet containerField='metadata'>"
        + version("low", "near")
        + version("high", "far")
        + "</MetadataSet></Switch></Transform>";
  }

  @BeforeEach
  void files() throws IOException {
    StringBuilder scene = new StringBuilder("<X3D version='4.0' profile='Full'><Scene>");
    for (int i = 0; i < OBJECTS; i++) {
      scene.append(object(i));
    }
    Files.writeString(folder.resolve("s.x3d"), scene.append("</Scene></X3D>"));
    Files.writeString(folder.resolve("p.csv"), "t,x,y,z\n0,0,0,0\n3,0,0,0\n");
  }

  /** Returns the polygons at the beginning, at the end, and the most between. */
  private List<Long> polygons(String budget) throws IOException {
    Path timeline = folder.resolve("t.jsonl");
    int status =
        execute(
            "run",
            folder.resolve("s.x3d").toString(),
            "--offscreen",
            "--size",
            "64x48",
            "--path",
            folder.resolve("p.csv").toString(),
            "--budget",
            budget,
            "--timeline",
            timeline.toString());
    assertThat(status).as(messages()).isZero();
    List<String> lines = Files.readAllLines(timeline);
    JsonNode end = JsonTree.parse(lines.get(lines.size() - 1)).path("polygons");
    List<Long> found = new ArrayList<>();
    for (String which : new String[] {"start", "end", "max"}) {
      found.add(end.path(which).asLong());
    }
    return found;
  }

  @Test
  void aTimeThatNoFrameKeepsLeavesTheSmallestVersions() throws IOException {
    assertThat(polygons("ms:0.01"))
        .as("it begins with all")
        .containsExactly(OBJECTS * HIGH, OBJECTS * LOW, OBJECTS * HIGH);
  }

  @Test
  void aTimeThatEveryFrameKeepsLeavesTheLargest() throws IOException {
    assertThat(polygons("ms:5000"))
        .containsExactly(OBJECTS * HIGH, OBJECTS * HIGH, OBJECTS * HIGH);
  }
}
